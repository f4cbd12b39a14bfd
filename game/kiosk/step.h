// A visit as a pure function: state x event x time -> state and effects. It draws nothing, saves nothing and
// reads no clock; screens show the state, and the program carries out the effects. Any thread.
#pragma once

#include <vector>

#include "game/kiosk/state.h"

namespace onggi::kiosk {

// The buttons of all screens.
enum class Button {
    kNone,
    kBegin,
    kLanguages,
    kBack,
    kFree,
    kTarget,       // value: index of the pot
    kShelfBefore,  // value: first visible card; also of kShelfNext
    kShelfNext,
    kCard,  // value: index of the pot
    kCardClose,
    kCardThrow,  // throw the pot of the card
    kNewClay,
    kUndo,
    kTools,     // opens or closes the tray of tools
    kTakeTool,  // value: a place in kTrayTools
    kCut,       // cuts the rim at the wire
    kToolLess,
    kToolMore,
    kWaterLess,
    kWaterMore,
    kSpeedLess,
    kSpeedMore,
    kDone,
    kHandUp,
    kHandDown,
    kHandLeft,  // all four are directions on the screen
    kHandRight,
    kLookIn,  // toggles the camera: from above into the pot, or from the front
    kJoinBowls,
    kShowMe,  // the wheel's own hands demonstrate the next step
    kMyTurn,  // ends the demonstration
    kBeforeCollapse,
    kKeepSlump,
    kSkip,
    kDrawingTool,  // value: index of the tool
    kMotif,        // value: index of the motif
    kAllRound,     // toggles repeating the motif
    kSlip,         // value: 1 black, 0 white
    kTurning,      // toggles turning
    kPutBrush,     // puts the brush down where the keys moved it, or lifts it
    kClear,        // removes all strokes
    kGlaze,        // value: index of the glaze
    kTakeGlaze,
    kDecorateAgain,  // takes the glaze off again
    kOtherGlaze,
    kKeep,
    kOnWifi,      // the phone has joined the museum's Wi-Fi; next is the pot's code
    kShareAgain,  // retries, or asks for another code
    kOnWall,      // puts the pot on the wall of the day, or takes it down
    kAnother,
    kFinish,
    kStay,
    kFresh,
    kLanguage,  // value: index of the language
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
    kStaffPage,  // value: a StaffPage
    kStaffList,  // value: top line
    kStaffForceTest,
    kStaffSoundTest,
    kStaffLanguage,      // makes the next language the default of every visit
    kStaffDeletePot,     // value: pot of the gallery; asks first, as do the next three
    kStaffWithdrawCode,  // value: the pot
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
        kInput,        // pointer, key, or a device's motion above its noise; value 1: a key
        kPressed,      // a button, on its release
        kClayTouched,  // by the visitor's hand; value 1: the touch continues
        kHeld,         // value: 1 while the visitor's hand works the clay, 0 on release
        kShowOver,     // the demonstration has ended
        kSoaked,       // one turn of the sponge: water drops by one dot
        kProgress,     // value: number of teaching steps done, judged by the pot
        kWarned,       // value: a Warning
        kCollapsed,    // value: the Warning that names the cause
        kBowl,         // value: 1 if the clay on the wheel could be a half of a jar
        kSetAside,     // the first bowl has been set aside
        kRims,         // value: mm between the rims of the two bowls, close enough to join
        kRimsApart,    // the rims are too far apart to join
        kJoined,       // the two bowls are one jar, on the wheel
        kJarStays,     // the requested move of the bowls failed
        kUndoneAll,    // the clay on the wheel has nothing left to undo
        kThickFoot,    // the pot that was cut off has spare clay at its foot
        kTrimmed,      // value: grams trimmed off so far
        kDrawn,        // value: strokes on the pot
        kSaved,        // value: the pot's number of the day
        kShared,       // value: the pot's number of the day; its code is ready
        kShareFailed,  // value: the pot's number of the day
        kShareOver,    // value: the pot's number of the day; its code has ended
        kSaveFailed,   // disk full, no permission: the visitor sees "shelf full", the staff the reason
        kDeviceLost,
        kDeviceBack,
        kForceRests,  // a device fault stopped the force; throwing goes on
        kForceBack,
        kFault,  // the wheel cannot work
        kFaultOver,
        kInterruptedSession,  // an interrupted pot was found; value: interrupted_jar(), or 0 for an ordinary
                              // pot
        kCornerHeld,          // the staff's corner was held long enough
        kCloseAsked,          // the window's close button, Esc, Alt+F4, Ctrl+Q, Ctrl+C
    };
    Kind kind = Kind::kTick;
    Button button = Button::kNone;
    int value = 0;

    static Event pressed(Button button, int value = 0) { return {Kind::kPressed, button, value}; }
};
constexpr int kEventKindCount = static_cast<int>(Event::Kind::kCloseAsked) + 1;

constexpr int kInterruptedJarStride = kJarSteps + 1;
// Packs the jar step and the target of an interrupted visit into one value.
[[nodiscard]] constexpr int interrupted_jar(JarStep step, int target) {
    return kInterruptedJarStride * (target + 1) + static_cast<int>(step);
}

struct Effect {
    enum class Kind {
        kStartDemo,       // attract: recorded sessions on the wheel
        kFreshClay,       // value: target, or -1 for free throwing
        kUndo,            // undoes the last touch
        kBeforeCollapse,  // back to 2 s before the collapse began
        kBeginJar,        // value: target; the lump on the wheel becomes the first bowl
        kSetAside,        // sets the first bowl aside and makes room for the second
        kTakeBack,        // value: 1 or 2, the bowl to put back on the wheel as it was
        kHoldTogether,    // holds the first bowl over the bowl on the wheel
        kJoinBowls,       // value: mm by which the upper bowl is shifted to the right
        kMoveHand,        // value: a Button of the pad
        kCutRim,          // cuts the rim at the wire
        kShowStep,        // value: step from 0 that the wheel's hands demonstrate on the visitor's clay
        kStopShow,        // ends the demonstration; the clay stays as it is
        kCutOff,          // turns the clay into a pot: stop the wheel, take its profile
        kBeginTrim,       // the pot is leather hard and stands on its rim
        kEndTrim,         // value: 1 if clay was taken off, so the pot has a new profile
        kBeginDrawing,    // the pot has dried and is on the wheel
        kUndoStroke,
        kClearDrawing,
        kPutBrush,    // value: 1 down, 0 up; places a motif
        kEndDrawing,  // the decoration is final and goes to the kiln
        kSave,
        kShare,      // offers the kept pot to phones
        kWall,       // value: 1 puts the kept pot on the wall of the day, 0 takes it down
        kForgetPot,  // drops everything of the last visit
        kResume,
        kDropInterrupted,
        kSetVolume,   // value: 0 to kMostVolume
        kKeepHouse,   // stores the default volume and language that the staff set
        kVisitBegan,  // for the statistics, which hold only counts
        kVisitEnded,  // value: dwell in whole seconds
        kTestForce,
        kTestSound,
        kDeletePot,     // value: the pot
        kWithdrawCode,  // value: the pot; phones no longer find it
        kRestart,
        kQuit,
    };
    Kind kind = Kind::kStartDemo;
    int value = 0;

    friend bool operator==(const Effect&, const Effect&) = default;
};

// The parameters of the flow, from the configuration.
struct Rules {
    double idle_s = 45.0;
    double countdown_s = 20.0;
    double hint_again_s = 6.0;     // time without progress until the cue for the next move returns
    bool shows_by_itself = true;   // the wheel's hands demonstrate a step unasked
    double show_after_s = 8.0;     // time without progress until they do
    double show_rests_s = 3.0;     // pause after a touch or a demonstration
    double show_most_s = 6.0;      // longest demonstration
    double aside_s = 6.0;          // how long the bowl that was set aside is shown
    double jar_idle_s = 180.0;     // replaces idle_s while a jar of two bowls is made
    double staff_locks_s = 120.0;  // without a touch
    double cut_s = 1.2;
    double dry_s = 1.4;
    double fire_s = 2.4;
    int language_count = 3;
    int default_language = 0;
    int default_volume = 3;
    int default_text_size = 1;
    int target_count = 4;
    std::vector<int> jars{};  // the targets that are made of two bowls
    int glaze_count = 6;
    bool shares = false;    // kept pots can go home by phone
    bool has_wifi = false;  // the phone must join the museum's Wi-Fi first
    bool has_wall = false;  // there is a wall of the day
    bool locked = false;    // only the staff can quit
    int pin = 0;            // of pin_digits; with 0 digits the staff panel cannot be opened
    int pin_digits = 0;
    int pin_tries = 3;         // from this many wrong PINs in a row on, each costs a wait
    double pin_wait_s = 15.0;  // doubles with each wrong PIN
    double pin_longest_wait_s = 900.0;
};

std::vector<Effect> step(State& state, const Event& event, double now_s, const Rules& rules);

// The state of a kiosk at its start: attract, everything at its default. Its first effect is kStartDemo.
[[nodiscard]] State first_state(const Rules& rules, double now_s);

// Whether the cue for the next move is visible now.
[[nodiscard]] bool shows_hint(const State& state, double now_s, const Rules& rules);

}  // namespace onggi::kiosk
