// All that a screen is made from: the state of the visit, and what the program knows besides. Plain values,
// handed to the composer's thread. Lengths: pixels, mm, u, as named.
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

// What is told of a museum's pot on request.
struct ExhibitCard {
    // What it was for, how it was made, what to look for; in the order of View::languages.
    std::vector<std::array<std::string, 3>> lines;
    std::array<int, 3> known_by{};  // 0: by its own record, 1: by pots of its kind, 2: generally
    std::string source;
    int published_points = 0;  // of its outline
    int drawn_points = 0;
};

// A pot of a museum, in the order of the choose screen.
struct Exhibit {
    std::string name_key;    // "pot.moon"
    std::string museum_key;  // "mus.nmk"
    std::string date_key;
    double height_mm = 0.0;
    double diameter_mm = 0.0;  // 0: not published
    std::string part;  // "1/3": thrown at so much of its size, because the clay would not do; empty: all
    int glaze = 0;
    pot::Section shape;
    std::shared_ptr<const ExhibitCard> card{};  // null: there is none
};

// The visitor's pot, as fired.
struct FiredPot {
    pot::Section shape{};
    double height_mm = 0.0;
    double width_mm = 0.0;
    double weight_g = 0.0;
    double capacity_l = 0.0;
    // The museum's pot that it was thrown after, or else that it resembles most; null: none.
    std::shared_ptr<const Exhibit> relative{};
    bool is_after_relative = false;
    std::string good_key{};  // beside it: what is good, and what to try next
    std::string next_key{};
    std::optional<double> off_round_mm{};  // of a jar of two bowls, instead of those two
    finish::DrawnWith drawn_with{};        // what lies under the glaze
};

// Another pot on the day's shelf.
struct ShelfPot {
    pot::Section shape;
    int glaze = 0;
};

// A square code for a phone's camera: QR modules, rows from the top, without the quiet zone.
struct PhoneCode {
    int side = 0;
    std::vector<bool> dark;
};

// How a kept pot goes home by phone.
struct PhoneWay {
    PhoneCode page;                   // the address of the pot's page
    std::string code;                 // "K73F\u00b7Q9TX", for who types it
    std::optional<PhoneCode> wifi{};  // to join before, and its name
    std::string wifi_name{};
};

// A line of the staff's panel.
struct StaffLine {
    std::string name;
    std::string value;
    std::string status;  // "ok", "warn", "fault", or nothing
    int pot = -1;        // of the gallery, for the delete key
    int code = -1;       // of which pot, for the key that withdraws it

    friend bool operator==(const StaffLine&, const StaffLine&) = default;
};

// Times of the frames of some seconds, each the worst of its fraction of them; the oldest first. ms.
struct FramePlot {
    std::vector<float> frame_ms;   // from one frame to the next
    std::vector<float> device_ms;  // that the graphics device took; 0: not measured

    friend bool operator==(const FramePlot&, const FramePlot&) = default;
};

// A tool on the bench, as large as what can be touched of it.
struct BenchTool {
    tool::Tool held = tool::Tool::kHand;
    vec2 centre_px{0.0F};
    vec2 size_px{0.0F};

    friend bool operator==(const BenchTool&, const BenchTool&) = default;
};

// Two that are equal look the same, and nothing in it changes that is not seen: what asks for a new screen is
// a View that differs. What turns, blinks or follows the hand is drawn over it, frame by frame.
struct View {
    kiosk::ScreenState state;
    int width_px = 1280;
    int height_px = 720;
    double px_per_mm = 3.613;    // of the panel
    double distance_mm = 600.0;  // from the visitor's eyes
    bool own_digits = true;
    int seconds_left = 0;       // of the countdown, or until a PIN may be tried again
    double countdown_s = 20.0;  // the whole of it
    // In the order of the configuration; at least one.
    std::shared_ptr<const std::vector<kiosk::Language>> languages;
    std::shared_ptr<const std::vector<Exhibit>> exhibits;
    std::shared_ptr<const FiredPot> pot;
    std::shared_ptr<const std::vector<ShelfPot>> shelf;
    // The wall of the day, the oldest first, never empty: shown instead of the throwing; null: it is not.
    std::shared_ptr<const std::vector<ShelfPot>> wall;
    bool has_wall = false;     // it may be put there
    bool wall_is_new = false;  // its newest was put there just now
    int attract_turn = 0;      // how many times the throwing and then a pot have been shown
    int attract_exhibit = -1;  // shown turning, instead of the throwing; -1: none
    // The target's outline over the scene, pixels: left side and right side from below, then the rim.
    std::vector<std::vector<vec2>> outline_px;
    // Where the photographed room ends to the left, above and to the right.
    vec3 scene_edges_px{0.0F, 0.0F, 1e6F};
    // The bowl that was set aside, on the bench; null: none.
    std::shared_ptr<const pot::Section> aside;
    vec2 aside_foot_px{0.0F};
    float aside_px_per_mm = 0.0F;
    bool can_look_in = false;           // there is a view from above into the pot
    double thinnest_mm = 0.0;           // of the wall, for the warning
    std::optional<vec2> warning_at_px;  // its place on the pot's edge, for the leader
    std::vector<BenchTool> bench;       // ringed while the tray is open
    int wire_off_mm = 0;                // what the wire that is held would take off
    std::optional<vec2> wire_at_px;     // right of the pot, at its height; none: no wire is held
    int focus = -1;                     // target with the ring; -1: none
    bool scans = false;                 // the ring moves by itself
    std::string heard;                  // key of a caption for sound; empty: none
    std::string staff_title;
    std::vector<StaffLine> staff_lines;
    std::string staff_pot;                  // that the staff is asked about
    std::string staff_notice;               // what came of a test
    FramePlot staff_plot;                   // empty: none on this page
    bool closed = false;                    // outside the opening hours: attract is dim
    std::shared_ptr<const PhoneWay> phone;  // once its files are all there; null: not yet, or not at all

    friend bool operator==(const View&, const View&) = default;
};

}  // namespace onggi::screens
