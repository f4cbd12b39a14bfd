#include "engine/render/host_moving.h"

#include <algorithm>
#include <utility>

#include "engine/render/mover_light.h"
#include "engine/render/painted_overlay.h"

namespace onggi::render {
namespace {

// Whether nothing of what moves is left to the device.
bool draws_all(const RendererDesc& desc, const Scene& scene) {
    const auto is_shown = [](const Sphere& sphere) { return sphere.shown; };
    return desc.cached && !desc.inside_out &&
           std::none_of(scene.spheres.begin(), scene.spheres.end(), is_shown) &&
           (!scene.lathe || (!scene.lathe->cut && !scene.lathe->shows_load));
}

}  // namespace

void HostMoving::place(FrameContext& frame, const Scene& scene, const MoverPass& movers,
                       const LathePass& lathe) {
    BuiltFrame& built = frame.built;
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    built.mover_tiles.assign(grid.count(), 0);
    corners_.clear();
    parts_.clear();
    const MoverView view{built.frame, built.samples, byte_order(frame.desc.colour_format)};
    movers.for_parts(scene,
                     [&](const Mover& mover, const MoverMesh& mesh, std::span<const std::uint32_t> indices) {
                         if (indices.empty()) return;
                         const std::size_t first = corners_.size();
                         light_corners(mesh, indices, mover, view, corners_);
                         parts_.push_back({first, mesh.vertices.size(), indices});
                         want_triangles(corners_of(parts_.back()), indices, grid, built.mover_tiles);
                     });
    built.is_drawn_by_host = draws_all(frame.desc, scene);
    if (!built.is_drawn_by_host || built.faces.indices.empty()) return;
    slip_ = lathe.slip();
    light_corners({.frame = built.frame,
                   .draw = built.lathe,
                   .rows = built.rows,
                   .vertices = built.vertices,
                   .slip = {frame.desc.slip_across, frame.desc.slip_up}},
                  built.faces.indices, lathe_corners_);
}

void HostMoving::draw(const FrameContext& frame, const PictureCanvas& canvas) {
    // A pixel of clay takes several times as long as one of a hand: what a hand hides is not shaded.
    for (const Part& part : parts_)
        draw_triangles(corners_of(part), part.indices, canvas);
    const BuiltFrame& built = frame.built;
    if (!built.is_drawn_by_host) return;
    if (!built.faces.indices.empty()) {
        draw_lathe(lathe_corners_, built.faces.indices, built.faces.plain,
                   {.frame = built.frame,
                    .draw = built.lathe,
                    .normals = built.normals,
                    .slip = slip_,
                    .slip_size = {frame.desc.slip_across, frame.desc.slip_up},
                    .order = byte_order(frame.desc.colour_format)},
                   canvas);
    }
    const PixelRect& moving = built.moving;
    edges_.smooth(built.edges, {moving.x + 1, moving.y + 1, moving.width - 2, moving.height - 2}, canvas);
}

Result<void> HostMoving::fit(const FrameContext& frame) {
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    for (auto [into, name] :
         {std::pair{&picture_, "still life with what moves"}, {&depth_, "depth of what moves"}}) {
        auto buffer = vk::Buffer::create(
            frame.device, {.name = name, .size = bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
        if (!buffer) return buffer.error();
        *into = std::move(*buffer);
    }
    return {};
}

std::span<const std::uint8_t> HostMoving::tiles(const FrameContext& frame) const {
    return frame.built.is_drawn_by_host ? frame.built.moving_tiles : frame.built.mover_tiles;
}

// What clay covers wholly needs nothing under it but the greatest depth.
void HostMoving::copy_under(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                            std::span<const float> depth, const PictureCanvas& canvas) {
    const TileGrid grid{canvas.size.width, canvas.size.height};
    const std::size_t width = frame.extent.width;
    const std::span<const std::uint8_t> own = tiles(frame);
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
    if (auto fitted = fit(frame); !fitted) return fitted;
    const PictureCanvas canvas{
        .size = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)},
        .pixels = picture_.as<std::uint32_t>(),
        .depth = depth_.as<float>()};
    copy_under(frame, pixels, depth, canvas);
    draw(frame, canvas);
    return {};
}

void HostMoving::record_depth(const FrameContext& frame) {
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    rects_of_tiles(grid, frame.built.mover_tiles, rects_);
    copy_depth(frame.commands, depth_.handle(), frame.extent.width, frame.images.depth.handle(), rects_);
}

}  // namespace onggi::render
