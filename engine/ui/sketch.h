// A picture's contents as plain data: boxes, strokes, shadows, text. A Painter turns it into pixels. Equal
// sketches yield equal pictures, so a picture is painted once and cached by its sketch's hash. Any thread.
// Lengths are u from the top left corner.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/ui/geometry.h"
#include "engine/ui/painting.h"
#include "engine/ui/text.h"

namespace onggi::ui {

// One colour, or a linear or radial gradient between two.
struct Fill {
    enum class Kind { kFlat, kDown, kAcross, kRound };
    Kind kind = Kind::kFlat;
    Colour from{};  // top, left, or centre
    Colour to{};    // bottom, right, or rim

    static Fill flat(const Colour& colour) { return {Kind::kFlat, colour, colour}; }
    static Fill down(const Colour& top, const Colour& bottom) { return {Kind::kDown, top, bottom}; }
    static Fill across(const Colour& left, const Colour& right) { return {Kind::kAcross, left, right}; }
    static Fill round(const Colour& centre, const Colour& rim) { return {Kind::kRound, centre, rim}; }
};

// Transform of a path: scaled about its own origin, then rotated, then moved.
struct Placing {
    vec2 at{0.0F};
    vec2 scale{1.0F};  // negative x mirrors
    float turn_rad = 0.0F;
};

struct Box {
    Rect rect;
    float radius = 0.0F;
    Fill fill;
};
struct Frame {  // a border inside the rect's edge
    Rect rect;
    float radius = 0.0F;
    float width = 2.0F;
    Colour colour;
};
struct Shadow {  // soft shadow of a box
    Rect rect;
    float radius = 0.0F;
    float blur = 8.0F;  // how far it extends beyond the rect
    Colour colour;
};
struct Ellipse {
    Rect rect;
    Fill fill;
};
// An SVG path (see path.h) with round ends and joins.
struct Shape {
    std::string path;
    Placing placing{};
    std::optional<Colour> fill{};
    std::optional<Colour> stroke{};
    float stroke_width = 3.6F;  // in the path's units
    float dash = 0.0F;          // 0: solid; else the distance between dots
};
struct Writing {
    vec2 at{0.0F};  // top left of the text's box
    Text text;
    float box_width = 0.0F;  // alignment is relative to it; 0: the text's own width
};
struct Picture {
    std::shared_ptr<const Painting> painting;
    std::uint64_t hash = 0;  // of its contents
    Rect rect;
    float brightness = 1.0F;
};

using SketchItem = std::variant<Box, Frame, Shadow, Ellipse, Shape, Writing, Picture>;

struct Sketch {
    vec2 size{0.0F};
    float px_per_u = 1.0F;
    std::vector<SketchItem> items{};
    // Fades the picture out: alpha 1 at `whole`, 0 at `gone`.
    struct Fade {
        vec2 whole{0.0F};
        vec2 gone{0.0F};
    };
    std::optional<Fade> fade{};

    void add(SketchItem item) { items.push_back(std::move(item)); }
    [[nodiscard]] std::uint64_t hash() const;
};

}  // namespace onggi::ui
