#include "engine/render/cpu/kept_view.h"

#include <array>
#include <cmath>
#include <utility>

#include "engine/render/cpu/picture_bands.h"
#include "engine/render/frame/pipelines.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/frame_build.h"
#include "engine/vk/readback.h"
#include "shaders/shaders.h"

namespace onggi::render {

Result<void> create_pipelines(const FrameContext& frame, LayerPipelines& pipelines) {
    const std::array formats{frame.desc.colour_format, kPackedFormat};
    vk::PipelineDesc places = mesh_pipeline(frame, "places of the still life", shaders::kPlacesFrag);
    places.vertex_spirv = shaders::kBackgroundSurfaceVert;
    places.attributes = std::span(kMeshAttributes).first(2);
    places.colour_formats = formats;
    PipelineMaker maker(frame.device);
    maker.make(pipelines.places, places);
    return maker.outcome();
}

Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, LayerPipelines& pipelines) {
    if (scene.background) return {};
    const std::array formats{frame.desc.colour_format, frame.desc.colour_format, kPackedFormat};
    vk::PipelineDesc backdrop = screen_pipeline(frame, "backdrop", shaders::kBackdropLayersFrag);
    backdrop.colour_formats = formats;
    vk::PipelineDesc still = mesh_pipeline(frame, "still life", shaders::kMeshLayersFrag);
    still.colour_formats = formats;
    PipelineMaker maker(frame.device);
    maker.make(pipelines.backdrop, backdrop);
    maker.make(pipelines.still, still);
    return maker.outcome();
}

namespace {

HostPhotograph host_photograph(const FrameContext& frame, const asset::Image& picture) {
    return {picture.width, picture.height, picture.rgba, byte_order(frame.desc.colour_format)};
}

std::vector<std::shared_ptr<const Background>> backgrounds_of(const Scene& scene) {
    std::vector<std::shared_ptr<const Background>> backgrounds = scene.backgrounds_at_hand;
    if (scene.background) backgrounds.push_back(scene.background);
    if (scene.next_view && scene.next_view->background) backgrounds.push_back(scene.next_view->background);
    return backgrounds;
}

}  // namespace

Result<void> HostBackgrounds::fit(const FrameContext& frame, const Scene& scene) {
    const std::vector<std::shared_ptr<const Background>> wanted = backgrounds_of(scene);
    const auto is_wanted = [&](const std::unique_ptr<Resident>& resident) {
        return std::find(wanted.begin(), wanted.end(), resident->background) != wanted.end();
    };
    residents_.erase(std::partition(residents_.begin(), residents_.end(), is_wanted), residents_.end());
    for (const std::shared_ptr<const Background>& background : wanted) {
        if (find(background)) continue;
        const auto pair = whole_pair(*background);
        if (!pair) return pair.error();
        residents_.push_back(std::make_unique<Resident>(Resident{
            background, {host_photograph(frame, (*pair)->key), host_photograph(frame, (*pair)->ambient)}}));
        background->photographs->let_go();
    }
    return {};
}

Result<const HostBackground*> HostBackgrounds::find(
    const std::shared_ptr<const Background>& background) const {
    for (const auto& resident : residents_) {
        if (resident->background == background) return &std::as_const(resident->photographs);
    }
    return failed("background: expected one of the scene's, found another");
}

namespace {

ShadeLight shade_light(const LightLevels& levels, VkFormat format) {
    const vec3& ambient = levels.ambient;
    if (byte_order(format) == ByteOrder::kRedFirst) return {{ambient.x, ambient.y, ambient.z}, levels.key};
    return {{ambient.z, ambient.y, ambient.x}, levels.key};
}

}  // namespace

Result<void> HostShade::fit(const FrameContext& frame) {
    const VkDeviceSize bytes = VkDeviceSize{4} * frame.extent.width * frame.extent.height;
    if (shaded_.size() == bytes) return {};
    auto buffer = vk::Buffer::create(
        frame.device, {.name = "shaded still life",
                       .size = bytes,
                       .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                       .use = vk::MemoryUse::kWork});
    if (!buffer) return buffer.error();
    shaded_ = std::move(*buffer);
    touch(shaded_);
    return {};
}

void HostShade::learn(const FrameContext& frame, const ShadeLayers& layers) {
    tiles_.learn({layers.width, layers.height}, layers.places);
    edges_.forget();
    if (frame.desc.smooths_outlines) edges_.find(layers.width, layers.places);
    has_mask_ = false;
}

void HostShade::note_light(const LightLevels& levels) {
    // Per frame: the eye does not see a change this small beside tiles that have not changed yet.
    constexpr float kLittle = 0.04F;
    const vec3 ambient = glm::abs(levels.ambient - levels_.ambient);
    const float change = std::max({ambient.x, ambient.y, ambient.z, std::abs(levels.key - levels_.key)});
    if (change == 0.0F) return;
    levels_ = levels;
    tiles_.note_light(change < kLittle ? LightChange::kLittle : LightChange::kMuch);
}

bool HostShade::shade(const FrameContext& frame, const Scene& scene, const ShadeLayers& layers,
                      TileNumbers& numbers) {
    const std::uint64_t shadow = shadow_hash(scene);
    const bool is_another = !has_mask_ || mask_of_ != shadow;
    if (is_another) {
        std::swap(mask_, mask_before_);
        fill_shadow_mask(frame.built.frame, *mask_);
    }
    mask_of_ = shadow;
    if (!has_mask_) {
        levels_ = scene.levels;
        has_mask_ = true;
    } else {
        if (is_another) {
            keep_what_is_alike(*mask_before_, *mask_);
            tiles_.note_mask(*mask_before_, *mask_);
        }
        note_light(scene.levels);
    }
    tiles_.take(numbers.next(), rects_);
    const ShadeLight light = shade_light(scene.levels, frame.desc.colour_format);
    for_bands(frame, [&](int, const RowSpan& rows) {
        for (const PixelRect& rect : rects_) {
            const PixelRect part = within(rect, rows);
            if (part.height > 0) shade_pixels(layers, *mask_, light, {&part, 1}, shaded_.as<std::uint32_t>());
        }
    });
    edges_.smooth(*mask_, rects_, shaded_.as<std::uint32_t>());
    return is_another;
}

namespace {

// A band of the picture that is drawn at once: full width, these rows.
struct Band {
    VkExtent2D extent;
    std::uint32_t top = 0;
};

Result<vk::Image> layer(const FrameContext& frame, const Band& band, const char* name, VkFormat format) {
    return vk::Image::create(
        frame.device, {.name = name,
                       .format = format,
                       .extent = band.extent,
                       .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
}

Result<vk::Image> depth_layer(const FrameContext& frame, const Band& band) {
    return vk::Image::create(
        frame.device, {.name = "still life's depth",
                       .format = kDepthFormat,
                       .extent = band.extent,
                       .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                       .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
}

struct Reading {
    const vk::Image& image;
    const vk::Buffer& into;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

void record_reading(const FrameContext& frame, const Band& band, const Reading& reading,
                    const vk::ImageState& drawn) {
    vk::barrier(frame.commands, reading.image, drawn, vk::state::kCopySource);
    const VkBufferImageCopy region{.bufferOffset = VkDeviceSize{4} * band.top * band.extent.width,
                                   .imageSubresource = {reading.aspect, 0, 0, 1},
                                   .imageExtent = {band.extent.width, band.extent.height, 1}};
    vkCmdCopyImageToBuffer(frame.commands, reading.image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           reading.into.handle(), 1, &region);
}

// Runs `draw` inside a pass over cleared images, in separate commands; then reads the images and their depth
// back to the host.
template <typename Draw>
Result<void> draw_and_read(FrameContext& frame, const Band& band, std::span<const Reading> readings,
                           const vk::Buffer& depth_into, Draw&& draw) {
    const auto depth = depth_layer(frame, band);
    if (!depth) return depth.error();
    return frame.run_once([&] {
        const VkCommandBuffer commands = frame.commands;
        std::vector<PassColour> colours;
        for (const Reading& reading : readings) {
            vk::barrier(commands, reading.image, vk::state::kUndefined, vk::state::kColour);
            colours.push_back({.view = reading.image.view(), .load = VK_ATTACHMENT_LOAD_OP_CLEAR});
        }
        vk::barrier(commands, *depth, vk::state::kUndefined, vk::state::kDepth);
        begin_pass(commands, band.extent, colours,
                   {.view = depth->view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
        const VkViewport whole{0.0F,
                               -static_cast<float>(band.top),
                               static_cast<float>(frame.extent.width),
                               static_cast<float>(frame.extent.height),
                               0.0F,
                               1.0F};
        vkCmdSetViewport(commands, 0, 1, &whole);
        draw();
        vkCmdEndRendering(commands);
        record_reading(frame, band, {*depth, depth_into, VK_IMAGE_ASPECT_DEPTH_BIT}, vk::state::kDepth);
        for (const Reading& reading : readings)
            record_reading(frame, band, reading, vk::state::kColour);
        vk::barrier_to_host(commands);
    });
}

}  // namespace

Result<void> StillLayers::fit(const FrameContext& frame, Of room) {
    const VkExtent2D extent = frame.extent;
    if (extent.width == extent_.width && extent.height == extent_.height && room == of_) return {};
    let_go();
    struct Request {
        vk::Buffer& into;
        const char* name;
    };
    std::vector<Request> requests{{places_, "still life's places in the shadow mask"},
                                  {depth_, "still life's depth"}};
    if (room == Of::kModelledRoom) {
        requests.push_back({with_key_, "still life with the key light"});
        requests.push_back({without_key_, "still life without the key light"});
    } else {
        weights_.resize(std::size_t{extent.width} * extent.height);
    }
    for (const Request& request : requests) {
        auto buffer = vk::Buffer::create(
            frame.device, {.name = request.name,
                           .size = VkDeviceSize{4} * extent.width * extent.height,
                           .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                           .use = vk::MemoryUse::kReadback});
        if (!buffer) return buffer.error();
        request.into = std::move(*buffer);
        touch(request.into);
    }
    extent_ = extent;
    of_ = room;
    return {};
}

void StillLayers::let_go() {
    for (vk::Buffer* buffer : {&with_key_, &without_key_, &places_, &depth_})
        *buffer = {};
    weights_ = {};
    extent_ = {};
}

Result<void> StillLayers::draw_own(FrameContext& frame, const LayerPipelines& pipelines,
                                   const StillMeshes& meshes) {
    const Band all{extent_};
    auto with_key = layer(frame, all, "still life with the key light", frame.desc.colour_format);
    if (!with_key) return with_key.error();
    auto without_key = layer(frame, all, "still life without the key light", frame.desc.colour_format);
    if (!without_key) return without_key.error();
    auto coords = layer(frame, all, "still life's places in the shadow mask", kPackedFormat);
    if (!coords) return coords.error();
    const std::array readings{Reading{*with_key, with_key_}, Reading{*without_key, without_key_},
                              Reading{*coords, places_}};
    return draw_and_read(frame, all, readings, depth_, [&] {
        frame.bind(pipelines.still);
        meshes.draw(frame, StillMeshes::Which::kAll);
        frame.draw_screen(pipelines.backdrop);
    });
}

Result<void> StillLayers::draw_places(FrameContext& frame, const LayerPipelines& pipelines,
                                      const StillMeshes& meshes, RowSpan rows, const vk::Buffer& scratch) {
    const Band band{{extent_.width, static_cast<std::uint32_t>(rows.end - rows.first)},
                    static_cast<std::uint32_t>(rows.first)};
    auto foot = layer(frame, band, "still life's nearness to the foot", frame.desc.colour_format);
    if (!foot) return foot.error();
    auto coords = layer(frame, band, "still life's places in the shadow mask", kPackedFormat);
    if (!coords) return coords.error();
    const std::array readings{Reading{*foot, scratch}, Reading{*coords, places_}};
    auto drawn = draw_and_read(frame, band, readings, depth_, [&] {
        frame.bind(pipelines.places);
        meshes.draw(frame, StillMeshes::Which::kAll);
    });
    if (!drawn) return drawn;
    const std::span<const std::uint32_t> read = scratch.as<const std::uint32_t>();
    const std::size_t end = std::size_t{extent_.width} * static_cast<std::size_t>(rows.end);
    for (std::size_t i = std::size_t{extent_.width} * band.top; i < end; ++i)
        weights_[i] = static_cast<std::uint8_t>(read[i] >> 24U);
    return {};
}

void StillLayers::turn_into_places() {
    render::turn_into_places(places_.as<std::uint32_t>());
}

ShadeLayers StillLayers::layers(const HostBackground* photographs, vec4 window) const {
    const int width = static_cast<int>(extent_.width);
    return {.width = width,
            .height = static_cast<int>(extent_.height),
            .with_key = with_key_.as<std::uint32_t>(),
            .without_key = without_key_.as<std::uint32_t>(),
            .places = places_.as<std::uint32_t>(),
            .room = {photographs, window, width},
            .weights = weights_};
}

namespace {

std::uint64_t hash_of(const FrameContext& frame, const Scene& scene) {
    return still_hash(scene, static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height));
}

}  // namespace

bool KeptView::is_of(const FrameContext& frame, const Scene& scene) const {
    return background_ == scene.background && of_ == hash_of(frame, scene);
}

Result<void> KeptView::make_part(FrameContext& frame, const Scene& seen, const Scene& now,
                                 const KeptRoom& room, TileNumbers& numbers) {
    if (!is_of(frame, seen)) parts_made_ = 0;
    if (parts_made_ < kDrawn) {
        of_ = hash_of(frame, seen);
        background_ = seen.background;
        if (auto drawn = draw(frame, seen, room); !drawn) return drawn;
        parts_made_ = background_ ? parts_made_ + 1 : kDrawn;
    } else if (parts_made_ < kLearnt) {
        layers_.turn_into_places();
        shade_.learn(frame, layers_.layers(nullptr, window_));
        parts_made_ = kLearnt;
    } else {
        if (auto shaded = shade(frame, now, room, numbers); !shaded) return shaded.error();
        parts_made_ = kShaded;
    }
    return {};
}

Result<void> KeptView::make(FrameContext& frame, const Scene& scene, const KeptRoom& room,
                            TileNumbers& numbers) {
    while (!shows(frame, scene)) {
        if (auto made = make_part(frame, scene, scene, room, numbers); !made) return made;
    }
    return {};
}

Result<bool> KeptView::shade(const FrameContext& frame, const Scene& scene, const KeptRoom& room,
                             TileNumbers& numbers) {
    const HostBackground* photographs = nullptr;
    if (background_) {
        const auto found = room.backgrounds.find(background_);
        if (!found) return found.error();
        photographs = *found;
    }
    return shade_.shade(frame, scene, layers_.layers(photographs, window_), numbers);
}

Result<void> KeptView::fit(const FrameContext& frame, StillLayers::Of room) {
    if (auto fitted = layers_.fit(frame, room); !fitted) return fitted;
    return shade_.fit(frame);
}

void KeptView::let_go() {
    forget();
    layers_.let_go();
    shade_.let_go();
}

KeptView::Lent KeptView::lend() {
    forget();
    return {shade_.shaded(), layers_.depth()};
}

Result<void> KeptView::draw(FrameContext& frame, const Scene& seen, const KeptRoom& room) {
    const auto of = background_ ? StillLayers::Of::kPhotographedRoom : StillLayers::Of::kModelledRoom;
    if (auto fitted = fit(frame, of); !fitted) return fitted;
    const shaders::FrameData by_day =
        still_frame(seen, room.meshes.bounds(), static_cast<int>(frame.extent.width),
                    static_cast<int>(frame.extent.height));
    frame.upload_uniforms(by_day);
    frame.stats.still_life_drawn = true;
    window_ = by_day.background_window;
    if (background_) return draw_band(frame, room);
    if (auto mapped = frame.run_once([&] { record_shadow_map(frame, room.meshes); }); !mapped) return mapped;
    return layers_.draw_own(frame, room.pipelines, room.meshes);
}

Result<void> KeptView::draw_band(FrameContext& frame, const KeptRoom& room) {
    const int height = static_cast<int>(frame.extent.height);
    const RowSpan rows{parts_made_ * height / kBands, (parts_made_ + 1) * height / kBands};
    if (rows.first == rows.end) return {};
    return layers_.draw_places(frame, room.pipelines, room.meshes, rows, shade_.shaded());
}

}  // namespace onggi::render
