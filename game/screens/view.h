// All that a screen is made from: the state of the visit, and what the program knows besides. Plain values,
// handed to the composer's thread. Lengths: pixels, mm, u, as named.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/kiosk/state.h"
#include "game/kiosk/strings.h"
#include "game/screens/pot_picture.h"

namespace onggi::screens {

// A pot of a museum, in the order of the choose screen.
struct Exhibit {
    std::string name_key;    // "pot.moon"
    std::string museum_key;  // "mus.nmk"
    std::string date_key;
    double height_mm = 0.0;
    double diameter_mm = 0.0;  // 0: not published
    bool half_size = false;    // thrown at half size, because the clay would not do
    int glaze = 0;
    PotShape shape;
};

// The visitor's pot, as fired.
struct FiredPot {
    PotShape shape{};
    double height_mm = 0.0;
    double width_mm = 0.0;
    double weight_g = 0.0;
    double capacity_l = 0.0;
    int nearest = -1;  // exhibit; -1: none
};

// Another pot on the day's shelf.
struct ShelfPot {
    PotShape shape;
    int glaze = 0;
};

// A line of the staff's panel.
struct StaffLine {
    std::string name;
    std::string value;
    std::string status;  // "ok", "warn", "fault", or nothing
    int pot = -1;        // of the gallery, for the delete key

    friend bool operator==(const StaffLine&, const StaffLine&) = default;
};

struct View {
    kiosk::State state;
    int width_px = 1280;
    int height_px = 720;
    double px_per_mm = 3.613;  // of the panel
    bool own_digits = true;
    bool hint = true;
    int seconds_left = 0;
    // In the order of the configuration; at least one.
    std::shared_ptr<const std::vector<kiosk::Language>> languages;
    std::shared_ptr<const std::vector<Exhibit>> exhibits;
    std::shared_ptr<const FiredPot> pot;
    std::shared_ptr<const std::vector<ShelfPot>> shelf;
    int attract_exhibit = -1;  // shown turning, instead of the throwing; -1: none
    // The target's outline over the scene, pixels: left side and right side from below, then the rim.
    std::vector<std::vector<vec2>> outline_px;
    vec2 hint_at_px{0.0F};              // where the hand works now
    vec2 second_hint_at_px{0.0F};       // and the one inside
    double thinnest_mm = 0.0;           // of the wall, for the warning
    std::optional<vec2> warning_at_px;  // its place on the pot's edge, for the leader
    int focus = -1;                     // target with the ring; -1: none
    bool scans = false;                 // the ring moves by itself
    std::string heard;                  // key of a caption for sound; empty: none
    std::string staff_title;
    std::vector<StaffLine> staff_lines;
    bool closed = false;       // outside the opening hours: attract is dim
    bool saves_phone = false;  // there is a way to take the pot home by phone
};

}  // namespace onggi::screens
