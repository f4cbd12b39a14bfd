// The places in which screens stand: the museum's wall and shelf, the ledge of the bench.
#include <algorithm>
#include <cmath>

#include "game/screens/page/page.h"

namespace onggi::screens {
namespace {

using ui::Colour;
using ui::Rect;

constexpr float kMuseumElevationRad = 0.12F;

}  // namespace

void Page::museum(vec2 light, vec2 reach, float strength) {
    covers();
    // A radial fall-off as a grid of shaded boxes: a processor fills those five times as fast as a texture.
    constexpr int kColumns = 32;
    constexpr int kRows = 18;
    const Rect& bounds = composition_.bounds;
    const vec2 wall_centre(0.5F * bounds.width, 0.34F * bounds.height);
    const vec2 wall_reach(0.75F * bounds.width, 0.85F * bounds.height);
    const auto colour_at = [&](int column, int row) {
        const vec2 at(bounds.width * static_cast<float>(column) / kColumns,
                      bounds.height * static_cast<float>(row) / kRows);
        const float away = std::min(1.0F, glm::length((at - wall_centre) / wall_reach));
        const Colour wall = away < 0.48F ? ui::mix(design::kWallLight, design::kWall, away / 0.48F)
                                         : ui::mix(design::kWall, design::kWallDark, (away - 0.48F) / 0.52F);
        const float near = std::max(0.0F, 1.0F - glm::length((at - light) / reach));
        return ui::mix(wall, ui::hex(0xffe6be), strength * near).with_alpha(1.0F);
    };
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const Rect cell{bounds.width * static_cast<float>(column) / kColumns,
                            bounds.height * static_cast<float>(row) / kRows, bounds.width / kColumns,
                            bounds.height / kRows};
            box(cell, {colour_at(column, row), colour_at(column + 1, row), colour_at(column + 1, row + 1),
                       colour_at(column, row + 1)});
        }
    }
}

void Page::shelf(float top, float thickness) {
    const float wide = width();
    // The upper face lit towards its middle, and a paler front edge.
    const Colour middle = design::kShelf;
    const Colour end = ui::mix(design::kShelf, design::kNight, 0.45F);
    const float face = thickness * 0.72F;
    across({0.0F, top, 0.5F * wide, face}, end, middle);
    across({0.5F * wide, top, 0.5F * wide, face}, middle, end);
    const Colour edge = design::kShelfEdge;
    const Colour dark_edge = ui::mix(edge, design::kNight, 0.5F);
    across({0.0F, top + face, 0.5F * wide, thickness - face}, dark_edge, edge);
    across({0.5F * wide, top + face, 0.5F * wide, thickness - face}, edge, dark_edge);
    down({0.0F, top + thickness, wide, 64.0F}, ui::hex(0x0a0603, 0.62F), ui::hex(0x0a0603, 0.0F));
}

void Page::pot_shadow(float centre_x, float y, float radius, float height) {
    ui::Sketch sketch;
    const Rect rect{centre_x - radius, y - height, 2.0F * radius, 2.0F * height};
    sketch.add(ui::Ellipse{{0.0F, 0.0F, rect.width, rect.height},
                           ui::Fill::round(ui::hex(0x0c0703, 0.72F), ui::hex(0x0c0703, 0.0F))});
    sprite(rect, std::move(sketch));
}

Rect Page::stand(const pot::Section& shape, float u_per_mm, vec2 foot) {
    const float px_per_u = composition_.px_per_u;
    const PotExtent extent = pot_extent(shape, u_per_mm * px_per_u, kMuseumElevationRad);
    const float foot_radius = shape.outside.empty() ? 0.0F : shape.outside.front().x * u_per_mm;
    pot_shadow(foot.x + 0.18F * foot_radius, foot.y, 1.9F * foot_radius + 6.0F, 5.0F + 0.09F * foot_radius);
    return {foot.x - extent.foot_px.x / px_per_u, foot.y - extent.foot_px.y / px_per_u,
            static_cast<float>(extent.width_px) / px_per_u, static_cast<float>(extent.height_px) / px_per_u};
}

Rect Page::pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm, vec2 foot,
               float brightness) {
    const Rect rect = stand(shape, u_per_mm, foot);
    const auto picture = store_.pot(shape, glaze, u_per_mm * composition_.px_per_u, kMuseumElevationRad);
    ui::Sketch sketch;
    ui::Picture item;
    // The store keeps the picture; the sketch only borrows its pixels.
    item.painting = std::shared_ptr<const ui::Painting>(picture, &picture->painting);
    item.hash = shape.hash() ^ static_cast<std::uint64_t>(std::lround(brightness * 1000.0F)) ^
                (static_cast<std::uint64_t>(glaze.glaze) << 40U) ^ glaze.id.size();
    item.rect = {0.0F, 0.0F, rect.width, rect.height};
    item.brightness = brightness;
    sketch.add(item);
    sprite(rect, std::move(sketch));
    return rect;
}

Rect Page::turning_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm,
                       vec2 foot) {
    const Rect rect = stand(shape, u_per_mm, foot);
    std::uint64_t key = 0;
    auto turning = store_.turning(shape, glaze, u_per_mm * composition_.px_per_u, kMuseumElevationRad, key);
    if (!turning) return rect;
    picture(rect, turning->at(0.0), key);
    composition_.items.back().turning = std::move(turning);
    return rect;
}

void Page::scene_ends() {
    const vec3 edges = view_.scene_edges_px / composition_.px_per_u;
    constexpr float kSoft = 110.0F;
    const Colour night = design::kNight;
    const Colour clear = design::kNight.with_alpha(0.0F);
    if (edges.y > 1.0F) {
        down({0.0F, 0.0F, width(), edges.y}, night, night);
        down({0.0F, edges.y, width(), kSoft}, night, clear);
    }
    if (edges.x > 1.0F) {
        across({0.0F, 0.0F, edges.x, height()}, night, night);
        across({edges.x, 0.0F, kSoft, height()}, night, clear);
    }
    if (edges.z < width() - 1.0F) {
        across({edges.z, 0.0F, width() - edges.z, height()}, night, night);
        across({edges.z - kSoft, 0.0F, kSoft, height()}, clear, night);
    }
}

void Page::ledge(float y) {
    const float wide = width();
    const float deep = height() - y;
    down({0.0F, y - 46.0F, wide, 46.0F}, design::kNight.with_alpha(0.0F), design::kNight.with_alpha(0.42F));
    down({0.0F, y, wide, 26.0F}, design::kNightTop, ui::hex(0x211812));
    down({0.0F, y + 26.0F, wide, deep - 26.0F}, ui::hex(0x211812), design::kNight);
    const Colour dim = ui::hex(0xdeba8c, 0.15F);
    const Colour lit = ui::hex(0xdeba8c, 0.75F);
    across({0.0F, y, 0.45F * wide, 3.0F}, dim, lit);
    across({0.45F * wide, y, 0.55F * wide, 3.0F}, lit, dim);
}

}  // namespace onggi::screens
