// The experience as a pure function: state x event x time -> state and effects. It draws nothing, saves
// nothing and reads no clock; screens show the state, and the program carries the effects out. Any thread.
#pragma once

#include <vector>

#include "game/kiosk/state.h"

namespace onggi::kiosk {

// Everything that can be pressed, on all screens together.
enum class Button {
    kNone,
    kBegin,
    kLanguages,
    kBack,
    kFree,
    kTarget,       // value: which
    kShelfBefore,  // value: the first to be seen, as of the next
    kShelfNext,
    kCard,  // value: which pot's
    kCardClose,
    kCardThrow,  // that pot
    kNewClay,
    kUndo,
    kTools,     // the tray of what there is to hold, and away again
    kTakeTool,  // value: a Held
    kCut,       // the rim, where the wire is
    kToolLess,
    kToolMore,
    kWaterLess,
    kWaterMore,
    kSpeedLess,
    kSpeedMore,
    kDone,
    kHandUp,
    kHandDown,
    kHandLeft,  // on the screen, as are all four
    kHandRight,
    kLookIn,  // from above into the pot, or from the front again
    kJoinBowls,
    kShowMe,  // the wheel's own hands do the next step
    kMyTurn,  // and leave off
    kBeforeCollapse,
    kKeepSlump,
    kSkip,
    kDrawingTool,  // value: which
    kMotif,        // value: which
    kAllRound,     // or just one
    kSlip,         // value: 1 black, 0 white
    kTurning,      // or resting
    kPutBrush,     // where the keys have led it, or lift it
    kClear,        // all that was drawn
    kGlaze,        // value: which
    kTakeGlaze,
    kDecorateAgain,  // the glaze comes off once more
    kOtherGlaze,
    kKeep,
    kOnWifi,      // the phone has joined the museum's: the pot's code now
    kShareAgain,  // another try, or another code
    kOnWall,      // the pot goes to the wall of the day, or comes down again
    kAnother,
    kFinish,
    kStay,
    kFresh,
    kLanguage,  // value: which
    kTextLess,
    kTextMore,
    kSoundLess,
    kSoundMore,
    kReach,
    kLeftHand,
    kStill,
    kForces,
    kComfortDone,
    kResumeGo,
    kResumeFresh,
    kDigit,  // value: 0 to 9
    kPinClear,
    kPinClose,
    kStaffPage,  // value: which
    kStaffList,  // value: the line at the top
    kStaffForceTest,
    kStaffSoundTest,
    kStaffLanguage,      // the next of them, for every visit to begin with
    kStaffDeletePot,     // value: which of the gallery's; asks first, as do the next three
    kStaffWithdrawCode,  // value: of which pot
    kStaffRestart,
    kStaffQuit,
    kStaffYes,
    kStaffNo,
    kStaffClose,
};
constexpr int kButtonCount = static_cast<int>(Button::kStaffClose) + 1;

struct Event {
    enum class Kind {
        kTick,         // time has passed
        kInput,        // a sign of life: pointer, key, or a device's motion above its noise; value 1: a key
        kPressed,      // a button, on its release
        kClayTouched,  // by the visitor's hand; value 1: by a touch that goes on
        kHeld,         // value: 1 while the visitor's hand is at work, 0 when it lets go
        kShowOver,     // the wheel's hands have shown what they were to show
        kSoaked,       // the sponge has gone round once: the hands are a dot less wet
        kProgress,     // value: teaching steps that the pot shows as done
        kWarned,       // value: a Warning
        kCollapsed,    // value: the Warning that says what it gave way by
        kBowl,         // value: 1 where what is on the wheel could be a half of a jar
        kSetAside,     // the first bowl is
        kRims,         // value: mm between those of the two bowls, which can be joined
        kRimsApart,    // they cannot
        kJoined,       // the two bowls are one jar, on the wheel
        kJarStays,     // what was asked of the bowls cannot be done
        kUndoneAll,    // nothing is left to take back of what is on the wheel
        kThickFoot,    // the pot that was cut off has clay to spare there
        kTrimmed,      // value: g that the trimmer has taken
        kDrawn,        // value: strokes on the pot
        kSaved,        // value: the pot's number of the day
        kShared,       // value: the pot's number of the day; its code may be shown
        kShareFailed,  // value: likewise
        kShareOver,    // value: likewise; there was a code
        kSaveFailed,   // disk full, no permission: the visitor hears of the shelf, the staff of the reason
        kDeviceLost,
        kDeviceBack,
        kForceRests,  // by a fault of the hand's; throwing goes on
        kForceBack,
        kFault,  // the wheel cannot work
        kFaultOver,
        kInterruptedSession,  // an interrupted pot was found; value: interrupted_jar(), else 0
        kCornerHeld,          // the staff's corner, for long enough
        kCloseAsked,          // the window's cross, Esc, Alt+F4, Ctrl+Q, Ctrl+C
    };
    Kind kind = Kind::kTick;
    Button button = Button::kNone;
    int value = 0;

    static Event pressed(Button button, int value = 0) { return {Kind::kPressed, button, value}; }
};
constexpr int kEventKindCount = static_cast<int>(Event::Kind::kCloseAsked) + 1;

constexpr int kInterruptedJarStride = kJarSteps + 1;
// Of an interrupted visit that made a jar of two bowls after that target, and was at that step.
[[nodiscard]] constexpr int interrupted_jar(JarStep step, int target) {
    return kInterruptedJarStride * (target + 1) + static_cast<int>(step);
}

struct Effect {
    enum class Kind {
        kStartDemo,       // attract: recorded sessions on the wheel
        kFreshClay,       // value: target, -1 none
        kUndo,            // the last touch
        kBeforeCollapse,  // back to 2 s before it began
        kBeginJar,        // value: after which target; the lump that was put on is its first bowl's
        kSetAside,        // the bowl on the wheel, for the other one to come
        kTakeBack,        // value: 1 or 2, the bowl that is on the wheel again, as it was
        kHoldTogether,    // the bowl that was set aside over the one on the wheel
        kJoinBowls,       // value: mm that the upper one stands to the right
        kMoveHand,        // value: a Button of the pad
        kCutRim,          // by the wire, where it is
        kShowStep,        // value: the step, from 0, that the wheel's hands do on the visitor's clay
        kStopShow,        // they leave the clay as it is
        kCutOff,          // the clay is a pot now: stop the wheel, take its profile
        kBeginTrim,       // the pot has dried to leather hard, and stands on its rim
        kEndTrim,         // value: 1 where something was taken, and it is another pot that goes on
        kBeginDrawing,    // the pot has dried, and waits on the wheel
        kUndoStroke,
        kClearDrawing,
        kPutBrush,    // value: 1 down, 0 up; a motif is placed
        kEndDrawing,  // what was drawn is fired
        kSave,
        kShare,      // the kept pot, for phones
        kWall,       // the kept pot; value: 1 to the wall of the day, 0 down again
        kForgetPot,  // nothing of the visit before may be seen again
        kResume,
        kDropInterrupted,
        kSetVolume,   // value: 0 to kMostVolume
        kKeepHouse,   // the house's volume and language, as the staff has set them: for all visits to come
        kVisitBegan,  // for the measured use: no person, only counts
        kVisitEnded,  // value: dwell in whole seconds
        kTestForce,
        kTestSound,
        kDeletePot,     // value: which
        kWithdrawCode,  // value: of which pot; phones find it no more
        kRestart,
        kQuit,
    };
    Kind kind = Kind::kStartDemo;
    int value = 0;

    friend bool operator==(const Effect&, const Effect&) = default;
};

// What the configuration says about the flow.
struct Rules {
    double idle_s = 45.0;
    double countdown_s = 20.0;
    double hint_again_s = 6.0;     // without progress, until the cue for the next move shows again
    bool shows_by_itself = true;   // the wheel's hands show a step that nobody asked to see
    double show_after_s = 8.0;     // without progress, until they do
    double show_rests_s = 3.0;     // after a touch or a show, until they begin another
    double show_most_s = 6.0;      // of one show
    double aside_s = 6.0;          // that a bowl which was set aside is looked at
    double jar_idle_s = 180.0;     // instead of idle_s, over a jar of two bowls
    double staff_locks_s = 120.0;  // without a touch
    double cut_s = 1.2;
    double dry_s = 1.4;
    double fire_s = 2.4;
    int language_count = 3;
    int default_language = 0;
    int default_volume = 3;
    int default_text_size = 1;
    int target_count = 4;
    std::vector<int> jars{};  // those of them that are made of two bowls
    int glaze_count = 6;
    bool shares = false;    // a kept pot can be taken home by phone
    bool has_wifi = false;  // after joining the museum's Wi-Fi
    bool has_wall = false;  // of the day's pots
    bool locked = false;    // no way out but the staff's
    int pin = 0;            // of pin_digits; 0 digits: the staff panel cannot be opened
    int pin_digits = 0;
    int pin_tries = 3;         // wrong ones in a row; from the last of them on each wrong one costs a wait
    double pin_wait_s = 15.0;  // doubles with each
    double pin_longest_wait_s = 900.0;
};

std::vector<Effect> step(State& state, const Event& event, double now_s, const Rules& rules);

// What a kiosk starts with: attract, everything at its default. Its first effect is kStartDemo.
[[nodiscard]] State first_state(const Rules& rules, double now_s);

// Whether the cue for the next move is to be seen now.
[[nodiscard]] bool shows_hint(const State& state, double now_s, const Rules& rules);

}  // namespace onggi::kiosk
