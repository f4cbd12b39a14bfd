// The state of a visit: one plain value, which visit::advance() takes on. Main thread, or a test's thread.
// Times are seconds of the caller's monotonic clock.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "game/kiosk/screen.h"

#include "game/tool/tool.h"

namespace onggi::kiosk {

// The card of the pot that stands beside the visitor's own.
constexpr int kRelativesCard = -1;

// The visitor's settings. Every visit starts from the defaults.
struct Comfort {
    int language = 0;   // place in Rules::languages
    int text_size = 1;  // 1 to 3: 100, 150, 200 %
    int volume = 3;     // 0 to 5
    bool reach = false;
    bool left_hand = false;
    bool still = false;   // less motion
    bool speech = false;  // screens, buttons and clay are spoken
    bool forces = false;  // show the forces on the hand as arrows, numbers and plots

    friend bool operator==(const Comfort&, const Comfort&) = default;
};

constexpr int kTeachingSteps = 3;  // press, open, raise
// The content of a demonstration: a teaching step, or the held tool.
enum class ShownStep { kPress, kOpen, kRaise, kDrawTool };
constexpr int kMostTool = 3;
constexpr int kMostWater = 5;
constexpr int kMostSpeed = 5;
constexpr int kMostVolume = 5;
constexpr int kMostTextSize = 3;

enum class Warning { kNone, kThin, kWet, kFast };
// What "done" asks before the pot is cut off; pressed again, the pot is kept as it is.
enum class DoneQuestion { kNone, kSolid, kThick };
enum class FiringStage { kCut, kDry, kFire };

// The steps of making a jar from two bowls, joined rim to rim. All but kAside and kJoin throw clay.
enum class JarStep {
    kNone,
    kFirstBowl,
    kAside,  // the first bowl is set aside, and new clay is on the wheel
    kSecondBowl,
    kJoin,
    kSeam,
};
constexpr int kJarSteps = 5;
constexpr int kMostShiftMm = 8;

// The jar of an interrupted visit.
struct InterruptedJar {
    JarStep step = JarStep::kNone;
    int target = 0;  // index of the heritage pot
};

// The choices of an interrupted visit, besides its clay and its decoration.
struct InterruptedPot {
    std::optional<int> target{};  // index of the heritage pot
    int glaze = 0;
    bool is_cut_off = false;
};

struct JarMaking {
    JarStep step = JarStep::kNone;
    bool touched = false;     // the clay was touched in this step
    bool is_bowl = false;     // the clay on the wheel could be a half of the jar
    bool waits = false;       // a request to move or join the bowls is pending
    bool is_low = false;      // the visitor pressed "done" before the clay was a bowl
    bool rims_apart = false;  // the rims are too far apart to be joined
    int rims_mm = 0;          // distance between the rims, once the bowls are held together
    int shift_mm = 0;         // shift of the upper bowl, to the right on the screen

    friend bool operator==(const JarMaking&, const JarMaking&) = default;
};

struct Throwing {
    std::optional<int> target{};       // index of the heritage pot; empty: free throwing
    int steps_done = 0;                // 0 to kTeachingSteps; at the end: "now make it yours"
    bool looks_in = false;             // the camera looks from above into the pot
    std::optional<ShownStep> shown{};  // the demonstration on the visitor's clay
    tool::Tool held = tool::Tool::kHand;
    bool tray = false;  // the ledge shows the tray of tools
    int tool = 2;
    int water = 3;
    int speed = 3;
    bool is_solid = false;  // the clay has no hollow
    DoneQuestion asks = DoneQuestion::kNone;
    int asked_mm = 0;  // the thickness in the last question about the wall; 0: not asked yet
    Warning warning = Warning::kNone;
    Warning collapse = Warning::kNone;  // cause of the collapse, for the failure screen
    JarMaking jar{};

    friend bool operator==(const Throwing&, const Throwing&) = default;
};

// Trimming the foot of a leather-hard pot.
struct Trimming {
    bool is_offered = false;  // the foot has spare clay
    bool touched = false;     // some clay was taken off
    int taken_g = 0;
    int loop = 2;  // size of the loop tool, 1 to kMostTool

    friend bool operator==(const Trimming&, const Trimming&) = default;
};

constexpr int kDrawingTools = 6;  // finger, iron, cobalt, inlay, white brush, motif
constexpr int kMotifTool = 5;
constexpr int kInlayTool = 3;
constexpr int kMotifs = 6;  // crane, cloud, chrysanthemum, fish, grass, wave
constexpr int kMostBrush = 3;

// The settings of the decorating screen.
struct Decorating {
    int tool = 0;
    int motif = 0;
    bool all_round = false;  // repeat the motif around the pot
    bool black = false;      // colour of the inlay slip; else white
    int brush = 2;
    bool turns = true;        // the pot turns slowly; else it rests
    bool touched = false;     // something was drawn with this tool
    bool brush_down = false;  // put down and lifted by keys
    int strokes = 0;          // number of strokes that can be undone

    friend bool operator==(const Decorating&, const Decorating&) = default;
};

// When the visitor or the wheel's own hands last worked the clay; hints and demonstrations depend on it.
struct Pace {
    double progress_s = 0.0;   // time of the pot's last progress, or the start of the visit
    double touched_s = -1.0;   // time of the last touch; -1 before the first touch
    double works_s = 0.0;      // since when the visitor works without a rest
    bool held = false;         // the visitor's hand works the clay now
    double shown_s = 0.0;      // start of the current demonstration
    double show_over_s = 0.0;  // end of the last demonstration
    std::optional<ShownStep> seen_since_touch{};  // last demonstrated step; reset by a touch
};

// The state of sharing a kept pot with a phone.
enum class Phone {
    kNone,     // sharing is off
    kPacking,  // the pot's files are being written
    kWifi,     // shows the code of the museum's Wi-Fi
    kReady,
    kResting,  // sharing failed: disk full, no network
    kOver,     // the code expired, or the staff withdrew it
};

// The outcome of an attempt to share a pot.
enum class ShareOutcome { kReady, kFailed, kOver };

struct Keeping {
    enum class Outcome { kSaving, kKept, kFull } outcome = Outcome::kSaving;
    int number = 0;  // the pot's number of the day, once kept
    Phone phone = Phone::kNone;
    bool on_wall = false;  // on the wall of the day, by the visitor's choice

    friend bool operator==(const Keeping&, const Keeping&) = default;
};

// The pages of the staff's panel.
enum class StaffPage { kHealth, kVisits, kGallery, kDevices };
constexpr int kStaffPageCount = 4;

// The staff actions that ask for confirmation.
enum class StaffQuestion { kNone, kDeletePot, kWithdrawCode, kRestart, kQuit };

struct Staff {
    int typed = 0;  // value of the PIN digits typed so far
    int digits = 0;
    bool was_wrong = false;
    StaffPage page = StaffPage::kHealth;
    int first_line = 0;  // top line of the page's list
    StaffQuestion question = StaffQuestion::kNone;
    int pot = 0;  // the pot in question

    friend bool operator==(const Staff&, const Staff&) = default;
};

// Delays repeated wrong PINs, longer each time. It outlives panels and visits.
struct PinGuard {
    int wrong = 0;         // wrong PINs in a row
    double opens_s = 0.0;  // digits are ignored before this time
};

// The part of the state that screens show. It holds no times, so equal values look the same.
struct ScreenState {
    Screen screen = Screen::kAttract;
    Panel panel = Panel::kNone;
    Comfort comfort;
    Throwing throwing;
    int shelf_first = 0;  // choose: first visible card of the shelf; 0 is free throwing
    int card = 0;         // index of the pot on the shelf, or kRelativesCard
    FiringStage firing = FiringStage::kCut;
    Trimming trimming;
    Decorating decorating;
    int glaze = 0;
    Keeping keeping;
    Staff staff;
    // The language at the start of every visit, from the configuration or the staff.
    int house_language = 0;
    bool device_lost = false;  // a haptic device was disconnected
    bool force_rests = false;  // a fault stopped the device's force; throwing goes on

    friend bool operator==(const ScreenState&, const ScreenState&) = default;
};

struct State : ScreenState {
    double screen_s = 0.0;  // start of this screen
    double panel_s = 0.0;
    double input_s = 0.0;       // last input of any device
    double ticked_s = 0.0;      // last tick
    double listened_s = 0.0;    // for how long a voice has spoken since the last input
    double works_s = 0.0;       // since when the program works for the visitor, or now if it does not
    double visit_s = 0.0;       // start of this visit
    double staff_used_s = 0.0;  // last use of the staff panel, for its timeout
    Pace pace;
    int thick_mm = 0;  // of the wall on the wheel, if another pull would do it good; 0: it is thin enough
    PinGuard pin_guard;
    int house_volume = 3;                             // as house_language, for the volume
    bool headphones = false;                          // are plugged in
    bool speaks = false;                              // a voice is speaking
    bool interrupted_session = false;                 // an interrupted pot can be resumed
    std::optional<InterruptedJar> interrupted_jar{};  // empty: an ordinary pot
    InterruptedPot interrupted_pot{};
    bool was_cut_off = false;  // the resumed pot, which goes on to the kiln once it is on the wheel
};

}  // namespace onggi::kiosk
