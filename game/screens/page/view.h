// The complete input of a screen: the state of the visit and other data of the program. Plain values, passed
// to the composer's thread. Lengths: pixels, mm, u, as named.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/finish/drawn_with.h"
#include "game/kiosk/state.h"
#include "game/kiosk/strings.h"
#include "game/screens/pots/pot_picture.h"

namespace onggi::screens {

// The card of a museum's pot.
struct ExhibitCard {
    // Three lines for each of View::languages: use, making, what to look for.
    std::vector<std::array<std::string, 3>> lines;
    // source of each line: 0 the pot's own record, 1 pots of its kind, 2 general knowledge
    std::array<int, 3> known_by{};
    std::string source;
    int published_points = 0;  // number of published points of its outline
    int drawn_points = 0;
};

// A pot of a museum, in the order of the choose screen.
struct Exhibit {
    std::string name_key;    // "pot.moon"
    std::string museum_key;  // "mus.nmk"
    std::string date_key;
    double height_mm = 0.0;
    double diameter_mm = 0.0;  // 0: not published
    std::string part;  // "1/3": the scale at which it is thrown if there is too little clay; empty: full size
    int glaze = 0;
    pot::Section shape;
    std::shared_ptr<const ExhibitCard> card{};  // may be null
    std::string record{};  // "Moon jar, Joseon, 18th c., British Museum (1333756)", as the tables name it
    std::string source{};  // of its dimensions
};

// The visitor's pot, as fired.
struct FiredPot {
    pot::Section shape{};
    double height_mm = 0.0;
    double width_mm = 0.0;
    double weight_g = 0.0;
    double capacity_l = 0.0;
    // The museum's pot that was the target, or else the most similar one; may be null.
    std::shared_ptr<const Exhibit> relative{};
    bool is_after_relative = false;
    // The score of a pot that was thrown after the relative: see heritage::profile_rms_mm().
    std::optional<double> off_outline_mm{};
    std::string good_key{};  // keys of the texts beside it: a strength, and what to try next
    std::string next_key{};
    std::optional<double> off_round_mm{};  // set for a jar of two bowls, which has no good_key and next_key
    finish::DrawnWith drawn_with{};        // the decoration under the glaze
};

// Another pot on the day's shelf.
struct ShelfPot {
    pot::Section shape;
    int glaze = 0;
};

// A QR code: rows of modules from the top, without the quiet zone.
struct PhoneCode {
    int side = 0;
    std::vector<bool> dark;
};

// The data for taking a kept pot home by phone.
struct PhoneWay {
    PhoneCode page;                   // the address of the pot's page
    std::string code;                 // "K73F\u00b7Q9TX", for typing
    std::optional<PhoneCode> wifi{};  // the code that joins the Wi-Fi first, and the Wi-Fi's name
    std::string wifi_name{};
};

// A line of the staff's panel.
struct StaffLine {
    std::string name;
    std::string value;
    std::string status;  // "ok", "warn", "fault", or nothing
    int pot = -1;        // number of a gallery pot, for the delete key
    int code = -1;       // number of a shared pot, for the withdraw key

    friend bool operator==(const StaffLine&, const StaffLine&) = default;
};

// Frame times of several seconds, oldest first; each is the maximum of its interval. ms.
struct FramePlot {
    std::vector<float> frame_ms;   // from one frame to the next
    std::vector<float> device_ms;  // time of the graphics device; 0: not measured

    friend bool operator==(const FramePlot&, const FramePlot&) = default;
};

// A tool on the bench and its touch target.
struct BenchTool {
    tool::Tool held = tool::Tool::kHand;
    vec2 centre_px{0.0F};
    vec2 size_px{0.0F};

    friend bool operator==(const BenchTool&, const BenchTool&) = default;
};

// The view determines the picture: equal views give equal compositions, and the composer composes only when
// the view differs. Turning, blinking and hand-following items are drawn over it in each frame by the stage.
struct View {
    kiosk::ScreenState state;
    int width_px = 1280;
    int height_px = 720;
    double px_per_mm = 3.613;    // of the panel
    double distance_mm = 600.0;  // from the visitor's eyes
    bool own_digits = true;
    int seconds_left = 0;       // of the countdown, or until the next PIN attempt
    double countdown_s = 20.0;  // its full duration
    // In the order of the configuration; at least one.
    std::shared_ptr<const std::vector<kiosk::Language>> languages;
    std::shared_ptr<const std::vector<Exhibit>> exhibits;
    std::shared_ptr<const FiredPot> pot;
    std::shared_ptr<const pot::Section> left_over;  // the pot of an interrupted visit; null if unknown
    std::shared_ptr<const std::vector<ShelfPot>> shelf;
    // The wall of the day, oldest first. Null or not empty; unless null, shown in place of the throwing.
    std::shared_ptr<const std::vector<ShelfPot>> wall;
    bool offers_speech = false;  // it can be switched on and off
    bool has_wall = false;       // the pot may be put on the wall
    bool wall_is_new = false;    // the newest pot was just added
    int attract_turn = 0;        // number of completed attract turns; each shows the throwing, then a pot
    int attract_exhibit = -1;    // shown turning in place of the throwing, or -1
    // The target's outline over the scene, pixels: left and right side from the bottom, then the rim.
    std::vector<std::vector<vec2>> outline_px;
    // The photographed room's edges: left, top and right.
    vec3 scene_edges_px{0.0F, 0.0F, 1e6F};
    // The bowl that was set aside on the bench; null if there is none.
    std::shared_ptr<const pot::Section> aside;
    vec2 aside_foot_px{0.0F};
    float aside_px_per_mm = 0.0F;
    bool can_look_in = false;           // there is a view from above into the pot
    double thinnest_mm = 0.0;           // thickness of the wall, for the warning
    std::optional<vec2> warning_at_px;  // its place on the pot's edge, for the leader line
    std::vector<BenchTool> bench;       // marked with rings while the tray is open
    int wire_off_mm = 0;                // the height that the held wire would cut off
    std::optional<vec2> wire_at_px;     // right of the pot, at the wire's height, while a wire is held
    int focus = -1;                     // target with the ring, or -1
    bool scans = false;                 // the ring moves automatically
    std::string heard;                  // key of a sound's caption; may be empty
    std::string staff_title;
    std::vector<StaffLine> staff_lines;
    std::string staff_pot;                  // the pot in the staff's confirmation
    std::string staff_notice;               // the result of a test
    FramePlot staff_plot;                   // empty without a plot
    bool closed = false;                    // outside the opening hours: attract is dim
    std::shared_ptr<const PhoneWay> phone;  // null until its files are complete, or without sharing

    friend bool operator==(const View&, const View&) = default;
};

}  // namespace onggi::screens
