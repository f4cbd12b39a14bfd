#include "engine/render/host_movers.h"

#include <algorithm>
#include <utility>

#include "engine/render/mover_light.h"
#include "engine/render/painted_overlay.h"

namespace onggi::render {
namespace {

// One rectangle of a picture into the same place of another.
template <typename T>
void copy_rect(std::span<const T> from, const PixelRect& rect, std::size_t width, std::span<T> into) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        const auto first =
            static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width) + std::ptrdiff_t{rect.x};
        std::copy_n(from.begin() + first, rect.width, into.begin() + first);
    }
}

}  // namespace

void HostMovers::place(FrameContext& frame, const Scene& scene, const MoverPass& pass) {
    BuiltFrame& built = frame.built;
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    built.mover_tiles.assign(grid.count(), 0);
    corners_.clear();
    parts_.clear();
    const MoverView view{built.frame, built.samples, byte_order(frame.desc.colour_format)};
    pass.for_parts(scene,
                   [&](const Mover& mover, const MoverMesh& mesh, std::span<const std::uint32_t> indices) {
                       if (indices.empty()) return;
                       const std::size_t first = corners_.size();
                       light_corners(mesh, mover, view, corners_);
                       parts_.push_back({first, mesh.vertices.size(), indices});
                       want_triangles(corners_of(parts_.back()), indices, grid, built.mover_tiles);
                   });
    rects_of_tiles(grid, built.mover_tiles, rects_);
}

void HostMovers::draw(const MoverCanvas& canvas) const {
    for (const Part& part : parts_)
        draw_triangles(corners_of(part), part.indices, canvas);
}

Result<void> HostMovers::fit(const FrameContext& frame) {
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    for (auto [into, name] :
         {std::pair{&picture_, "still life with hands and tools"}, {&depth_, "hands' and tools' depth"}}) {
        auto buffer = vk::Buffer::create(
            frame.device, {.name = name, .size = bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
        if (!buffer) return buffer.error();
        *into = std::move(*buffer);
    }
    return {};
}

Result<void> HostMovers::draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                                   std::span<const float> depth) {
    if (auto fitted = fit(frame); !fitted) return fitted;
    const MoverCanvas canvas{
        .size = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)},
        .pixels = picture_.as<std::uint32_t>(),
        .depth = depth_.as<float>()};
    for (const PixelRect& rect : rects_) {
        copy_rect(pixels, rect, frame.extent.width, canvas.pixels);
        copy_rect(depth, rect, frame.extent.width, canvas.depth);
    }
    draw(canvas);
    return {};
}

void HostMovers::record_depth(const FrameContext& frame) const {
    copy_depth(frame.commands, depth_.handle(), frame.extent.width, frame.images.depth.handle(), rects_);
}

}  // namespace onggi::render
