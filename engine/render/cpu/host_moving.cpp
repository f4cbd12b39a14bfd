#include "engine/render/cpu/host_moving.h"

#include <algorithm>
#include <cstring>

#include "engine/render/pixels/prop_light.h"
#include "engine/render/shapes/detail_texture.h"

namespace onggi::render {

void HostMoving::create(const RendererDesc& desc) {
    streak_size_ = {desc.streaks_across, desc.streaks_up};
    const std::vector<std::uint8_t> texels =
        streak_levels(coarser_detail(detail_texture(), desc.streaks_across, desc.streaks_up),
                      desc.streaks_across, desc.streaks_up);
    streaks_.resize(texels.size() / sizeof(std::uint32_t));
    std::memcpy(streaks_.data(), texels.data(), texels.size());
}

void HostMoving::place(FrameContext& frame, const Scene& scene, const PropModels& models) {
    BuiltFrame& built = frame.built;
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    built.prop_tiles.assign(grid.count(), 0);
    corners_.clear();
    parts_.clear();
    const PropView view{built.frame, built.samples, byte_order(frame.desc.colour_format)};
    models.for_parts(scene,
                     [&](const Prop& prop, std::size_t number, std::span<const std::uint32_t> indices) {
                         if (indices.empty()) return;
                         const PropMesh& mesh = (*scene.prop_library)[prop.model].meshes[number];
                         const std::size_t first = corners_.size();
                         light_corners(mesh, indices, prop, view, corners_);
                         parts_.push_back({first, mesh.vertices.size(), indices});
                         want_triangles(corners_of(parts_.back()), indices, grid, built.prop_tiles);
                     });
    place_section(std::span(built.vertices).subspan(built.section_first, built.section_count), built.frame,
                  section_corners_);
    if (built.faces.indices.empty()) return;
    light_corners({.frame = built.frame,
                   .draw = built.lathe,
                   .rows = built.rows,
                   .vertices = std::span(built.vertices).first(built.section_first),
                   .streaks = streak_size_,
                   .shows_load = built.shows_load},
                  built.faces.indices, lathe_corners_);
}

void HostMoving::draw(const FrameContext& frame, const PictureCanvas& canvas) {
    // A pixel of the lathe takes several times as long as one of a hand: what a hand hides is not shaded.
    for (const Part& part : parts_)
        draw_triangles(corners_of(part), part.indices, canvas);
    const BuiltFrame& built = frame.built;
    const ByteOrder order = byte_order(frame.desc.colour_format);
    if (!built.faces.indices.empty()) {
        draw_lathe(lathe_corners_, built.faces.indices, built.faces.plain,
                   {.frame = built.frame,
                    .draw = built.lathe,
                    .normals = built.normals,
                    .streaks = streaks_,
                    .streak_size = streak_size_,
                    .order = order,
                    .shows_load = built.shows_load,
                    .marks = built.marks != nullptr ? std::span<const LatheMark>(built.marks->texels)
                                                    : std::span<const LatheMark>()},
                   canvas);
    }
    draw_section(section_corners_,
                 {.colour = vec3(built.section.dry), .shows_load = built.shows_load, .order = order}, canvas);
    const PixelRect& moving = built.moving;
    edges_.smooth(built.edges, {moving.x + 1, moving.y + 1, moving.width - 2, moving.height - 2}, canvas);
}

// What the lathe covers wholly needs nothing under it but the greatest depth.
void HostMoving::copy_under(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                            std::span<const float> depth, const PictureCanvas& canvas) {
    const TileGrid grid{canvas.size.width, canvas.size.height};
    const std::size_t width = frame.extent.width;
    const std::span<const std::uint8_t> own = frame.built.moving_tiles;
    wanted_.resize(own.size());
    const auto for_rects = [&](auto is_wanted, auto visit) {
        std::transform(own.begin(), own.end(), wanted_.begin(),
                       [&](std::uint8_t tile) { return static_cast<std::uint8_t>(is_wanted(tile)); });
        rects_of_tiles(grid, wanted_, rects_);
        for (const PixelRect& rect : rects_)
            visit(rect);
    };
    for_rects([](std::uint8_t tile) { return tile == kCovered; },
              [&](const PixelRect& rect) {
                  for (int y = rect.y; y < rect.y + rect.height; ++y) {
                      const auto first = std::ptrdiff_t{y} * grid.width_px + rect.x;
                      std::fill_n(canvas.depth.begin() + first, rect.width, 1.0F);
                  }
              });
    for_rects([](std::uint8_t tile) { return tile == kMoves; },
              [&](const PixelRect& rect) {
                  copy_rect(pixels, rect, width, canvas.pixels);
                  copy_rect(depth, rect, width, canvas.depth);
              });
}

Result<void> HostMoving::draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                                   std::span<const float> depth) {
    if (auto fitted = canvas_.fit(frame, "still life with what moves"); !fitted) return fitted;
    const PictureCanvas canvas = canvas_.canvas();
    copy_under(frame, pixels, depth, canvas);
    draw(frame, canvas);
    return {};
}

}  // namespace onggi::render
