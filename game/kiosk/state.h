// Where a visit stands: one plain value that a step takes on. Main thread, or a test's. Times are seconds of
// the caller's monotonic clock.
#pragma once

#include <optional>
#include <string_view>

namespace onggi::kiosk {

enum class Screen {
    kAttract,  // the wheel throws by itself
    kChoose,
    kJarStart,  // of a jar that is made of two bowls: what lies ahead
    kThrow,
    kJoin,  // the one bowl upside down on the other
    kFailure,
    kFiring,  // cut off, dried; and after the decorating fired
    kTrim,    // its foot is turned, upside down
    kDecorate,
    kGlaze,
    kYourPot,
    kKeep,
    kResume,  // a pot was left on the wheel when the power went
    kFault,
};
constexpr int kScreenCount = 14;

// What lies over the screen.
enum class Panel { kNone, kLanguage, kIdle, kPin, kStaff, kCard };
constexpr int kPanelCount = 6;

// The card of the pot that stands beside the visitor's own.
constexpr int kRelativesCard = -1;

// What a visitor may set, and what every visit begins with again.
struct Comfort {
    int language = 0;   // place in Rules::languages
    int text_size = 1;  // 1 to 3: 100, 150, 200 %
    int volume = 3;     // 0 to 5
    bool reach = false;
    bool left_hand = false;
    bool still = false;   // less motion
    bool forces = false;  // arrows, numbers and plots of what the hand feels

    friend bool operator==(const Comfort&, const Comfort&) = default;
};

constexpr int kTeachingSteps = 3;  // press, open, raise
constexpr int kMostTool = 3;
constexpr int kMostWater = 5;
constexpr int kMostSpeed = 5;
constexpr int kMostVolume = 5;
constexpr int kMostTextSize = 3;

enum class Warning { kNone, kThin, kWet, kFast };
enum class FiringStage { kCut, kDry, kFire };

// What the hand holds while it throws.
enum class Held { kHand, kRib, kSponge, kWire };
constexpr int kHeldCount = 4;

// A jar of two bowls, rim to rim: where its maker stands. Each step but two is a throwing of its own.
enum class JarStep {
    kNone,
    kFirstBowl,
    kAside,  // the first one is put aside, and new clay is there
    kSecondBowl,
    kJoin,
    kSeam,
};
constexpr int kJarSteps = 5;
constexpr int kMostShiftMm = 8;

struct JarMaking {
    JarStep step = JarStep::kNone;
    bool touched = false;     // the clay, in this step
    bool is_bowl = false;     // what is on the wheel could be a half of the jar
    bool waits = false;       // until the bowls are where they were asked to be
    bool is_low = false;      // asked for, before it was a bowl
    bool rims_apart = false;  // too far to be joined
    int rims_mm = 0;          // how far, once they are held together
    int shift_mm = 0;         // of the upper bowl, to the right as it is seen

    friend bool operator==(const JarMaking&, const JarMaking&) = default;
};

struct Throwing {
    std::optional<int> target{};  // place among the heritage pots; none: as you like
    int steps_done = 0;           // of kTeachingSteps; all: "now make it yours"
    bool looks_in = false;        // the camera, from above into the pot
    // What the wheel's own hands are showing on the visitor's clay: a step, counted from 0, or behind the
    // last what is held.
    std::optional<int> shown{};
    Held held = Held::kHand;
    bool tray = false;  // the ledge shows what there is to hold
    int tool = 2;
    int water = 3;
    int speed = 3;
    Warning warning = Warning::kNone;
    Warning collapse = Warning::kNone;  // what it gave way by, on the failure screen
    JarMaking jar{};

    friend bool operator==(const Throwing&, const Throwing&) = default;
};

// Turning the foot of a pot that has dried to leather hard.
struct Trimming {
    bool is_offered = false;  // there is clay to spare at the foot
    bool touched = false;     // something was taken
    int taken_g = 0;
    int loop = 2;  // how large it is, of kMostTool

    friend bool operator==(const Trimming&, const Trimming&) = default;
};

constexpr int kDrawingTools = 6;  // finger, iron, cobalt, inlay, white brush, motif
constexpr int kMotifTool = 5;
constexpr int kInlayTool = 3;
constexpr int kMotifs = 6;  // crane, cloud, chrysanthemum, fish, grass, wave
constexpr int kMostBrush = 3;

// How the visitor decorates.
struct Decorating {
    int tool = 0;
    int motif = 0;
    bool all_round = false;  // a motif, again and again
    bool black = false;      // what an inlay is filled with; else white
    int brush = 2;
    bool turns = true;        // the pot, slowly; else it rests
    bool touched = false;     // something was drawn since this tool was taken up
    bool brush_down = false;  // by keys, which lift it again
    int strokes = 0;          // that can be undone

    friend bool operator==(const Decorating&, const Decorating&) = default;
};

// When the clay was worked, and by whom: what decides about hints and shows.
struct Pace {
    double progress_s = 0.0;                // when the pot last came on, or the visit began
    double touched_s = -1.0;                // when the clay was last touched; before the first touch: -1
    bool held = false;                      // a hand works the clay now
    double shown_s = 0.0;                   // since when the wheel's own hands show a step
    double show_over_s = 0.0;               // when they were last done
    std::optional<int> seen_since_touch{};  // the step last shown, until the visitor touches the clay
};

// The way home by phone, of a pot that is kept.
enum class Phone {
    kNone,     // not in this house
    kPacking,  // its files are being made
    kWifi,     // first the museum's Wi-Fi
    kReady,
    kResting,  // nothing to be had: no room on the disk, no network
    kOver,     // its time is over, or the staff took it back
};

struct Keeping {
    enum class Outcome { kSaving, kKept, kFull } outcome = Outcome::kSaving;
    int number = 0;  // of the day, when kept
    Phone phone = Phone::kNone;
    bool on_wall = false;  // of the day, for all to see, because its maker wants it there

    friend bool operator==(const Keeping&, const Keeping&) = default;
};

// The pages of the staff's panel.
enum class StaffPage { kHealth, kVisits, kGallery, kDevices };
constexpr int kStaffPageCount = 4;

// What the staff is asked again before it is done.
enum class StaffQuestion { kNone, kDeletePot, kWithdrawCode, kRestart, kQuit };

struct Staff {
    int typed = 0;  // digits of the PIN, so far
    int digits = 0;
    bool was_wrong = false;
    StaffPage page = StaffPage::kHealth;
    int first_line = 0;  // of the page's list, at the top
    StaffQuestion question = StaffQuestion::kNone;
    int pot = 0;  // that is asked about

    friend bool operator==(const Staff&, const Staff&) = default;
};

// Whoever tries one PIN after another waits longer each time. It outlives panels and visits.
struct PinGuard {
    int wrong = 0;         // in a row
    double opens_s = 0.0;  // no digit counts before
};

// What a screen shows of a visit: no times, so that two that are equal look the same.
struct ScreenState {
    Screen screen = Screen::kAttract;
    Panel panel = Panel::kNone;
    Comfort comfort;
    Throwing throwing;
    int shelf_first = 0;  // choose: the first that is seen of the shelf; 0 is throwing as one likes
    int card = 0;         // of which pot of the shelf, or kRelativesCard
    FiringStage firing = FiringStage::kCut;
    Trimming trimming;
    Decorating decorating;
    int glaze = 0;
    Keeping keeping;
    Staff staff;
    // What every visit begins with: the configuration's, or what the staff set.
    int house_language = 0;
    bool device_lost = false;  // a hand control that was there is gone
    bool force_rests = false;  // a fault took the hand's force away; the clay goes on

    friend bool operator==(const ScreenState&, const ScreenState&) = default;
};

struct State : ScreenState {
    double screen_s = 0.0;  // since when
    double panel_s = 0.0;
    double input_s = 0.0;       // any device, any sign of life
    double visit_s = 0.0;       // when this visit began
    double staff_used_s = 0.0;  // the panel locks again a while after
    Pace pace;
    PinGuard pin_guard;
    int house_volume = 3;              // as house_language
    bool interrupted_session = false;  // an interrupted pot waits to be offered
    int interrupted_jar = 0;           // what kind, as interrupted_jar() says; 0: a pot like any other
};

// One word for each, for titles and logs: "attract".
[[nodiscard]] std::string_view name_of(Screen screen);
[[nodiscard]] std::string_view name_of(Panel panel);  // empty for none
[[nodiscard]] std::string_view name_of(Held held);    // empty for the bare hand

// Whole seconds left of the idle panel's countdown.
[[nodiscard]] int seconds_left(const State& state, double countdown_s, double now_s);

// Whole seconds until a digit of the PIN counts again; 0: it does.
[[nodiscard]] int pin_seconds_left(const State& state, double now_s);

}  // namespace onggi::kiosk
