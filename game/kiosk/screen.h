// The screens of a visit, the panels over them and all their buttons, by name. Any thread.
#pragma once

namespace onggi::kiosk {

enum class Screen {
    kAttract,  // the wheel throws by itself
    kChoose,
    kJarStart,  // introduces a jar that is made of two bowls
    kThrow,
    kJoin,  // one bowl upside down on the other bowl
    kFailure,
    kFiring,  // the pot is cut off and dried, and fired after decorating
    kTrim,    // the visitor trims the foot of the upturned pot
    kDecorate,
    kGlaze,
    kYourPot,
    kKeep,
    kResume,  // a power cut left a pot on the wheel
    kFault,
};
constexpr int kScreenCount = static_cast<int>(Screen::kFault) + 1;

// The overlay on the screen.
enum class Panel { kNone, kLanguage, kIdle, kPin, kStaff, kCard };
constexpr int kPanelCount = static_cast<int>(Panel::kCard) + 1;

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
    kTakeTool,  // value: a place in kTray
    kCut,       // cuts the rim at the wire
    kToolLess,
    kToolMore,
    kWaterLess,
    kWaterMore,
    kSpeedLess,
    kSpeedMore,
    kDone,
    kToWheel,  // takes back the last "done"
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
    kSpeech,
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

}  // namespace onggi::kiosk
