#include "engine/render/cached/host_glide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/render/pixels/enlarge_pixels.h"

namespace onggi::render {
namespace {

// kDims of shaders/glide.frag for one byte, with the square-root transfer.
std::uint8_t dimmed(std::size_t value, float left) {
    const float shown = static_cast<float>(value) / 255.0F;
    const float curve = shown * shown;
    const float light = left * 0.35F * curve / (1.0F - 0.8F * curve);
    return static_cast<std::uint8_t>(std::sqrt(light / (light * 0.8F + 0.35F)) * 255.0F + 0.5F);
}

}  // namespace

void HostGlide::fit_mesh(const Scene& scene) {
    const std::uint64_t revision = scene.still_life ? scene.still_life->revision : 0;
    if (scene.still_life == mesh_of_ && revision == mesh_revision_) return;
    mesh_ = scene.still_life ? bendable_mesh(*scene.still_life) : BendableMesh{};
    mesh_of_ = scene.still_life;
    mesh_revision_ = revision;
}

void HostGlide::rest() {
    canvas_.clear();
    half_picture_ = {};
    half_depth_ = {};
    is_fast_ = false;
    places_of_ = nullptr;
}

void HostGlide::fill_dimmed(const LightLevels& levels, ByteOrder order) {
    for (int channel = 0; channel < 3; ++channel) {
        const float left = 0.4F * levels.ambient[channel] + 0.6F * levels.key;
        const int at = order == ByteOrder::kRedFirst ? channel : 2 - channel;
        auto& table = dimmed_[static_cast<std::size_t>(at)];
        for (std::size_t value = 0; value < table.size(); ++value)
            table[value] = dimmed(value, left);
    }
}

// How far the room went in the picture since the frame before says whether the next may be coarse.
void HostGlide::note_speed(const FrameContext& frame, const BendablePlate& plate, float scale) {
    constexpr std::size_t kEvery = 16;
    constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
    const std::size_t looked_at = (relief_.size() + kEvery - 1) / kEvery;
    const bool is_same = places_of_ == &plate && places_px_.size() == looked_at;
    places_of_ = &plate;
    places_px_.resize(looked_at, vec2(kNowhere));
    const vec2 size(frame.extent.width, frame.extent.height);
    float sum_px = 0.0F;
    int count = 0;
    for (std::size_t i = 0; i < looked_at; ++i) {
        const ReliefCorner& corner = relief_[i * kEvery];
        const vec2 at = corner.away_mm > 0.0F ? corner.at_px / scale : vec2(kNowhere);
        const float went_px = glm::length(at - std::exchange(places_px_[i], at));
        const bool is_seen = at.x >= 0.0F && at.y >= 0.0F && at.x < size.x && at.y < size.y;
        if (!is_same || !is_seen || !std::isfinite(went_px)) continue;
        sum_px += went_px;
        ++count;
    }
    if (count == 0) return;
    // Coarse frames come quicker, so each goes less far: hence two bounds.
    constexpr float kFast = 2.0F / 720.0F;  // of the picture's height a frame
    constexpr float kSlow = 1.0F / 720.0F;
    is_fast_ = sum_px / static_cast<float>(count) > (is_fast_ ? kSlow : kFast) * size.y;
}

void HostGlide::draw(std::span<const Quad> cells, BentPicture& picture) {
    float nearest_mm = std::numeric_limits<float>::infinity();
    for (const SurfaceCorner& corner : surface_)
        nearest_mm = std::min(nearest_mm, corner.away_mm);
    order_relief(cells, relief_, nearest_mm, order_);
    std::fill(picture.depth.begin(), picture.depth.end(), 1.0F);
    const std::span<const Quad> sheet = order_.quads;
    bend_relief(relief_, sheet.first(order_.behind), picture);
    bend_surface(surface_, mesh_.triangles, picture);
    bend_relief(relief_, sheet.subspan(order_.behind), picture);
}

Result<void> HostGlide::bend(const FrameContext& frame, const Scene& scene, const PlatePass& plates) {
    if (auto fitted = canvas_.fit(frame, "bent photographs"); !fitted) return fitted;
    const PictureCanvas canvas = canvas_.canvas();
    const Glide& glide = *scene.glide;
    const auto from = plates.bendable(scene.plate);
    if (!from) return from.error();
    const auto to = plates.bendable(glide.towards);
    if (!to) return to.error();
    const shaders::FrameData& data = frame.built.frame;
    fill_shadow_mask(data, *mask_);

    const auto [width, height] = canvas.size;
    BentPicture picture{.width = width,
                        .height = height,
                        .pixels = canvas.pixels,
                        .depth = canvas.depth,
                        .from = &(*from)->photographs,
                        .to = &(*to)->photographs,
                        .mask = mask_.get(),
                        .order = byte_order(frame.desc.colour_format)};
    const bool is_coarse = frame.desc.softens_glides && is_fast_;
    if (is_coarse) {
        picture.width = half_of(width);
        picture.height = half_of(height);
        const auto count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
        half_picture_.resize(count);
        half_depth_.resize(count);
        picture.pixels = half_picture_;
        picture.depth = half_depth_;
        picture.from = &(*from)->halved;
        picture.to = &(*to)->halved;
    }
    const bool is_day = scene.levels.ambient == vec3(1.0F) && scene.levels.key == 1.0F;
    if (!is_day) {
        fill_dimmed(scene.levels, picture.order);
        picture.dimmed = &dimmed_;
    }

    const float scale = is_coarse ? 0.5F : 1.0F;
    const BendView view{data, *scene.plate, *glide.towards, *mask_, scale};
    const BendablePlate& nearer = **(glide.share < 0.5F ? from : to);
    bend_corners(nearer.relief_mm, view, relief_);
    fit_mesh(scene);
    bend_corners(mesh_, view, surface_);
    draw(nearer.cells, picture);
    note_speed(frame, nearer, scale);
    if (is_coarse) {
        enlarge_pixels(half_picture_, width, height, canvas.pixels);
        enlarge_depth(half_depth_, width, height, canvas.depth);
    }

    const TileGrid grid{width, height};
    constexpr std::uint64_t kNoOtherTile = std::uint64_t{1} << 62U;
    numbers_.assign(grid.count(), kNoOtherTile | ++last_number_);
    return {};
}

}  // namespace onggi::render
