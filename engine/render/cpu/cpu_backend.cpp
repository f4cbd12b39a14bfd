#include "engine/render/cpu/cpu_backend.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/render/cpu/picture_bands.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/pixels/mix_pixels.h"
#include "engine/render/pixels/prop_pixels.h"
#include "engine/render/shapes/detail_texture.h"
#include "engine/render/shapes/moving_tiles.h"

namespace onggi::render {

void CrossFade::begin(const FrameContext& frame, const HostPicture& last, const KeptView::Lent& lent) {
    grid_ = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    before_ = &lent.first;
    mixed_ = &lent.second;
    for_parts(frame, last, grid_, wanted_, rects_, [&](const vk::Buffer& part, const PixelRect& rect) {
        if (&part == before_) return;
        copy_rect(part.as<const std::uint32_t>(), rect, static_cast<std::size_t>(grid_.width_px),
                  before_->as<std::uint32_t>());
    });
}

void CrossFade::mix(const FrameContext& frame, const HostPicture& now, float fraction, TileNumbers& numbers) {
    const auto before = before_->as<const std::uint32_t>();
    const auto into = mixed_->as<std::uint32_t>();
    for_parts(frame, now, grid_, wanted_, rects_, [&](const vk::Buffer& part, const PixelRect& rect) {
        mix_pixels(before, part.as<const std::uint32_t>(), fraction, rect, grid_.width_px, into);
    });
    numbers_.assign(grid_.count(), numbers.next());
}

Result<void> RestingScene::fit(const FrameContext& frame) {
    grid_ = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (picture_.size() == bytes) return {};
    auto picture = vk::Buffer::create(frame.device, {.name = "resting scene",
                                                     .size = bytes,
                                                     .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                     .use = vk::MemoryUse::kWork});
    if (!picture) return picture.error();
    picture_ = std::move(*picture);
    return {};
}

Result<void> RestingScene::keep(const FrameContext& frame, const HostPicture& scene, TileNumbers& numbers) {
    if (is_here_) return {};
    if (auto fitted = fit(frame); !fitted) return fitted;
    copy_whole(frame, scene, grid_, picture_.as<std::uint32_t>());
    numbers_.assign(grid_.count(), numbers.next());
    is_here_ = true;
    return {};
}

Result<void> Framebuffer::fit(const FrameContext& frame, std::string_view name) {
    const PictureSize size{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    if (size == size_) return {};
    const std::size_t pixels = std::size_t{frame.extent.width} * frame.extent.height;
    auto picture = vk::Buffer::create(frame.device, {.name = name,
                                                     .size = sizeof(std::uint32_t) * pixels,
                                                     .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                                     .use = vk::MemoryUse::kWork});
    if (!picture) return picture.error();
    picture_ = std::move(*picture);
    depth_ = std::make_unique_for_overwrite<float[]>(pixels);
    size_ = size;
    return {};
}

PictureCanvas Framebuffer::canvas() {
    const std::span<std::uint32_t> pixels = picture_.as<std::uint32_t>();
    return {.size = size_, .pixels = pixels, .depth = {depth_.get(), pixels.size()}};
}

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
    indices_.clear();
    const PropView view{built.frame, built.samples, byte_order(frame.desc.colour_format)};
    models.for_parts(
        scene, [&](const Prop& prop, std::size_t number, std::span<const std::uint32_t> indices) {
            if (indices.empty()) return;
            const PropMesh& mesh = (*scene.prop_library)[prop.model].meshes[number];
            const std::size_t first = indices_.size();
            std::transform(indices.begin(), indices.end(), std::back_inserter(indices_),
                           [of = static_cast<std::uint32_t>(corners_.size())](std::uint32_t index) {
                               return of + index;
                           });
            light_corners(mesh, indices, prop, view, corners_);
            want_triangles(corners_, std::span(indices_).subspan(first), grid, built.prop_tiles);
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

void HostMoving::draw(const FrameContext& frame, const Triangles& triangles,
                      const PictureCanvas& canvas) const {
    // A lathe pixel costs several times a hand's pixel, so hands are drawn first and hide what need not be
    // shaded.
    draw_triangles(corners_, triangles.props, canvas);
    const BuiltFrame& built = frame.built;
    const ByteOrder order = byte_order(frame.desc.colour_format);
    if (!triangles.lathe.empty()) {
        draw_lathe(lathe_corners_, triangles.lathe, triangles.plain,
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
}

void HostMoving::sort_into_bands(const FrameContext& frame) {
    const int height = static_cast<int>(frame.extent.height);
    bands_.resize(static_cast<std::size_t>(band_count(frame)));
    for (Band& band : bands_) {
        band.props.clear();
        band.lathe.clear();
    }
    const auto add_three = [](const auto& indices, std::size_t first, auto& into) {
        into.insert(into.end(), {indices[first], indices[first + 1], indices[first + 2]});
    };
    for_bands_of_triangles(
        std::span<const PropCorner>(corners_), std::span<const std::uint32_t>(indices_), height,
        [&](std::size_t band, std::size_t first) { add_three(indices_, first, bands_[band].props); });
    const std::span<const std::uint16_t> lathe = frame.built.faces.indices;
    const std::size_t plain = frame.built.faces.plain;
    const auto sort_lathe = [&](std::span<const std::uint16_t> some) {
        for_bands_of_triangles(
            std::span<const LatheCorner>(lathe_corners_), some, height,
            [&](std::size_t band, std::size_t first) { add_three(some, first, bands_[band].lathe); });
    };
    sort_lathe(lathe.first(plain));
    for (Band& band : bands_)
        band.plain = band.lathe.size();
    sort_lathe(lathe.subspan(plain));
}

Result<void> HostMoving::draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                                   std::span<const float> depth) {
    if (auto fitted = canvas_.fit(frame, "still life with what moves"); !fitted) return fitted;
    const PictureCanvas canvas = canvas_.canvas();
    const BuiltFrame& built = frame.built;
    const bool is_shared = band_count(frame) > 1;
    if (is_shared) sort_into_bands(frame);
    rects_of_tiles({canvas.size.width, canvas.size.height}, built.moving_tiles, rects_);
    for_bands(frame, [&](int number, const RowSpan& rows) {
        PictureCanvas own = canvas;
        own.rows = rows;
        for (const PixelRect& rect : rects_) {
            copy_rect(pixels, within(rect, rows), frame.extent.width, canvas.pixels);
            copy_rect(depth, within(rect, rows), frame.extent.width, canvas.depth);
        }
        if (is_shared) {
            const Band& band = bands_[static_cast<std::size_t>(number)];
            draw(frame, {band.props, band.lathe, band.plain}, own);
        } else {
            draw(frame, {indices_, built.faces.indices, built.faces.plain}, own);
        }
    });
    const PixelRect& moving = built.moving;
    edges_.smooth(built.edges, {moving.x + 1, moving.y + 1, moving.width - 2, moving.height - 2}, canvas);
    return {};
}

namespace {

// Returns the scene's static contents as seen from the next view.
Scene seen_next(const Scene& scene) {
    Scene seen = scene;
    seen.camera = scene.next_view->camera;
    seen.background = scene.next_view->background;
    return seen;
}

}  // namespace

Result<void> CpuBackend::create() {
    if (auto created = frame_.create(shaders::kBindingsOfLayers); !created) return created;
    if (auto made = create_pipelines(frame_, room_.pipelines); !made) return made;
    moving_.create(frame_.desc);
    return {};
}

void CpuBackend::fit_size(VkExtent2D target) {
    if (target.width == frame_.extent.width && target.height == frame_.extent.height) return;
    frame_.extent = target;
    resting_.forget();
    fade_.end();
    shown_.forget();
    next_.forget();
    has_picture_ = false;
}

Result<void> CpuBackend::fit(const Scene& scene, VkExtent2D target) {
    fit_size(target);
    if (!scene.background) {
        if (auto fitted = fit_shadow_map(frame_); !fitted) return fitted;
    }
    if (auto made = fit_pipelines(frame_, scene, room_.pipelines); !made) return made;
    if (auto fitted = room_.backgrounds.fit(frame_, scene); !fitted) return fitted;
    const auto is_another = room_.meshes.fit(frame_.device, scene.still_life);
    if (!is_another) return is_another.error();
    if (*is_another) {
        shown_.forget();
        next_.forget();
    }
    return {};
}

CpuBackend::Under CpuBackend::look_under(const Scene& scene, const Overlay* overlay) {
    const bool covers = overlay != nullptr && overlay->covers;
    will_rest_ = overlay != nullptr && overlay->scene_rests;
    if (!will_rest_) {
        resting_.forget();
        if (!covers) return Under::kScene;
        // Prepare the covered scene, so that its first frame takes no longer than any other.
        return shown_.shows(frame_, scene) ? Under::kNothing : Under::kCoveredScene;
    }
    if (covers) return resting_.is_here() ? Under::kNothing : Under::kCoveredScene;
    return resting_.is_here() ? Under::kRestingScene : Under::kScene;
}

Result<bool> CpuBackend::draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) {
    const Under under = look_under(scene, overlay);
    std::optional<HostPicture> picture;
    if (under == Under::kScene || under == Under::kCoveredScene) {
        auto made = make(scene);
        if (!made) return made.error();
        picture.emplace(*made);
        if (will_rest_) {
            if (auto kept = resting_.keep(frame_, *picture, numbers_); !kept) return kept.error();
        }
    } else if (under == Under::kNothing) {
        // Any part of the next view may take long now, because no visitor sees the scene.
        frame_.stats.next_view_ready = scene.next_view.has_value();
        fade_.end();
        next_.let_go();
    }
    if (auto fitted = overlay_.fit(frame_, overlay); !fitted) return fitted.error();
    if (auto begun = frame_.begin(); !begun) return begun.error();
    frame_.enter("copies");
    if (under == Under::kScene || under == Under::kRestingScene) {
        const HostPicture& shown = under == Under::kScene ? *picture : resting_.picture();
        if (auto brought = bringing_.record(frame_, target, shown, overlay_); !brought)
            return brought.error();
    } else {
        bringing_.record_covered(frame_, target, overlay_);
    }
    if (auto ended = frame_.end(target); !ended) return ended.error();
    return under == Under::kScene;
}

// The picture of a view without a fade. Moving things are taken as they were last drawn.
HostPicture CpuBackend::picture_of(const KeptView& view) const {
    return {.pixels = view.shaded(),
            .numbers = view.numbers(),
            .instead = &moving_.picture(),
            .instead_on = frame_.built.moving_tiles};
}

HostPicture CpuBackend::picture() const {
    return fade_.is_on() ? fade_.picture() : picture_of(shown_);
}

void CpuBackend::change_view(const Scene& scene) {
    if (!scene.fade_in) fade_.end();
    if (shown_.shows(frame_, scene)) return;
    const bool is_made = next_.shows(frame_, scene);
    if (is_made) std::swap(shown_, next_);
    if (!scene.fade_in || !has_picture_) return;
    const HostPicture last = fade_.is_on() ? fade_.picture() : picture_of(is_made ? next_ : shown_);
    fade_.begin(frame_, last, next_.lend());
}

Result<void> CpuBackend::make_next_view(const Scene& scene) {
    if (fade_.is_on()) return {};  // the fade uses the next view's memory
    const Scene seen = seen_next(scene);
    if (!next_.shows(frame_, seen)) {
        if (auto made = next_.make_part(frame_, seen, scene, room_, numbers_); !made) return made;
    }
    frame_.stats.next_view_ready = next_.shows(frame_, seen);
    return {};
}

Result<HostPicture> CpuBackend::make(const Scene& scene) {
    change_view(scene);
    frame_.clock.enter_host("shapes");
    frame_.build(scene, room_.meshes.bounds());
    models_.choose(scene, frame_.desc, frame_.view(scene), frame_.built);
    moving_.place(frame_, scene, models_);
    find_moving_tiles(scene, frame_.view(scene), frame_.built);
    frame_.clock.enter_host("room");
    // A cut to another view may come with any frame, so its memory is allocated in advance.
    if (scene.background) {
        if (auto fitted = next_.fit(frame_, StillLayers::Of::kPhotographedRoom); !fitted)
            return fitted.error();
    }
    if (auto made = shown_.make(frame_, scene, room_, numbers_); !made) return made.error();
    const auto shaded = shown_.shade(frame_, scene, room_, numbers_);
    if (!shaded) return shaded.error();
    frame_.stats.shadow_drawn = *shaded;
    frame_.clock.enter_host("hands and lathe");
    auto drawn = moving_.draw_over(frame_, shown_.shaded().as<const std::uint32_t>(), shown_.depth());
    if (!drawn) return drawn.error();
    if (scene.next_view) {
        frame_.clock.enter_host("next view");
        if (auto made = make_next_view(scene); !made) return made.error();
    }
    if (fade_.is_on()) {
        frame_.clock.enter_host("fade");
        fade_.mix(frame_, picture_of(shown_), *scene.fade_in, numbers_);
    }
    frame_.clock.end_host();
    has_picture_ = true;
    return picture();
}

}  // namespace onggi::render
