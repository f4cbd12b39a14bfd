// The vertices that an overlay draws: boxes shaded between their corners, pictures from the atlas, and
// anti-aliased lines. Any thread; one writer. Pixels from the top left corner of the picture, y down.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/ui/colour.h"
#include "engine/ui/geometry.h"

namespace onggi::ui {

struct Vertex {
    vec2 position_px{0.0F};
    vec2 atlas_px{0.0F};
    std::uint32_t rgba = 0;  // red lowest; premultiplied
};

// A range of indices that one pipeline draws.
struct Run {
    bool from_atlas = false;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
};

class DrawList {
  public:
    void clear();

    void add_box(const Rect& rect, const Colour& colour);
    // Corners: top left, top right, bottom right, bottom left.
    void add_box(const Rect& rect, const std::array<Colour, 4>& corners);
    // Convex, in either winding order.
    void add_polygon(std::span<const vec2> corners, const Colour& colour);
    // The line fades out over one more pixel on each side.
    void add_line(std::span<const vec2> points, float width_px, const Colour& colour);
    // Has a soft edge.
    void add_disc(vec2 centre, float radius_px, const Colour& colour);
    // Draws a whole picture of the atlas, unscaled, with its upper left corner rounded to whole pixels;
    // `alpha` multiplies it.
    void add_picture(vec2 corner_px, const Rect& in_atlas_px, float alpha);

    [[nodiscard]] std::span<const Vertex> vertices() const { return vertices_; }
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }
    [[nodiscard]] std::span<const Run> runs() const { return runs_; }
    // Hash of everything that is drawn: lists with equal hashes draw the same, as long as the atlas's
    // contents do not change.
    [[nodiscard]] std::uint64_t hash() const;

  private:
    std::uint32_t begin(bool from_atlas);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<Run> runs_;
};

// Premultiplied, eight bits per channel, red lowest.
[[nodiscard]] std::uint32_t packed(const Colour& colour);

}  // namespace onggi::ui
