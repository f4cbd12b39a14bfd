#include "engine/render/vulkan/background_pass.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/render/frame/background_pair.h"
#include "engine/render/shapes/relief.h"

namespace onggi::render {
namespace {

constexpr VkFormat kBackgroundFormat = VK_FORMAT_R8G8B8A8_UNORM;

struct Texels {
    const char* name;
    VkFormat format;
    VkExtent2D extent;
    std::size_t bytes;
};

// `fill` writes them all.
template <typename Fill>
Result<vk::Image> upload_texels(const VulkanFrame& frame, const Texels& texels, Fill&& fill) {
    auto staging = vk::Buffer::create(
        frame.device,
        {.name = "plate upload", .size = texels.bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    if (!staging) return staging.error();
    fill(staging->mapped());
    auto image = vk::Image::create(frame.device,
                                   {.name = texels.name,
                                    .format = texels.format,
                                    .extent = texels.extent,
                                    .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    if (!image) return image.error();
    const auto copied = frame.device.run_once([&](VkCommandBuffer once) {
        vk::barrier(once, *image, vk::state::kUndefined, vk::state::kCopyTarget);
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {texels.extent.width, texels.extent.height, 1};
        vkCmdCopyBufferToImage(once, staging->handle(), image->handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               1, &region);
        vk::barrier(once, *image, vk::state::kCopyTarget, vk::state::kSampled);
    });
    if (!copied) return copied.error();
    return image;
}

VkExtent2D extent_of(int width, int height) {
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

Result<vk::Image> upload_picture(const VulkanFrame& frame, const asset::Image& picture, const char* name) {
    return upload_texels(
        frame, {name, kBackgroundFormat, extent_of(picture.width, picture.height), picture.rgba.size()},
        [&](std::byte* texels) { std::ranges::copy(std::as_bytes(std::span(picture.rgba)), texels); });
}

// Depths of the relief's corners; of a background without one, that it hides nothing.
Result<vk::Image> upload_depth(const VulkanFrame& frame, const Relief& relief) {
    constexpr float kFarMm = 1e9F;
    const Relief nothing{.columns = 1, .rows = 1, .depth_mm = {kFarMm}};
    const Relief& used = relief.depth_mm.empty() ? nothing : relief;
    const auto bytes = std::as_bytes(std::span(used.depth_mm));
    return upload_texels(
        frame, {"plate's depth", VK_FORMAT_R32_SFLOAT, extent_of(used.columns, used.rows), bytes.size()},
        [&](std::byte* texels) { std::copy(bytes.begin(), bytes.end(), texels); });
}

template <typename T>
Result<vk::Buffer> upload_buffer(const VulkanFrame& frame, const std::vector<T>& data, const char* name,
                                 VkBufferUsageFlags usage) {
    const auto bytes = std::as_bytes(std::span(data));
    auto buffer = vk::Buffer::create(frame.device, {.name = name, .size = bytes.size(), .usage = usage});
    if (buffer) buffer->write(bytes);
    return buffer;
}

constexpr BackgroundSlots kFrom{shaders::kBindBackgroundKey, shaders::kBindBackgroundAmbient,
                                shaders::kBindFromDepth};
constexpr BackgroundSlots kTo{shaders::kBindNextKey, shaders::kBindNextAmbient, shaders::kBindToDepth};

void bind_background(const VulkanFrame& frame, const BackgroundSlots& slots, const vk::Image& key,
                     const vk::Image& ambient, const vk::Image& depth) {
    const auto bind = [&](int binding, const vk::Image& image, const vk::Sampler& sampler) {
        vk::write_image(frame.device, frame.set(), static_cast<std::uint32_t>(binding), image.view(),
                        sampler.get());
    };
    bind(slots.key, key, frame.pipelines.clamped);
    bind(slots.ambient, ambient, frame.pipelines.clamped);
    bind(slots.depth, depth, frame.pipelines.exact);
}

void bind_nothing(const VulkanFrame& frame, const BackgroundSlots& slots) {
    const vk::Image& any = frame.images.mask;
    bind_background(frame, slots, any, any, any);
}

}  // namespace

void BackgroundPass::bind_placeholders(const VulkanFrame& frame) {
    for (const BackgroundSlots& slots : {kFrom, kTo})
        bind_nothing(frame, slots);
}

// No slot keeps an image that is gone: lavapipe counts references in whatever is bound, drawn from or not.
void BackgroundPass::let_go(const VulkanFrame& frame, const BackgroundSlots& slots,
                            std::shared_ptr<const Background>& bound) const {
    if (!bound || find(bound) != nullptr) return;
    bind_nothing(frame, slots);
    bound = nullptr;
}

Result<void> BackgroundPass::upload_part(const VulkanFrame& frame, Resident& resident) {
    const Background& background = *resident.background;
    const auto take = [&](auto&& made, auto& into) -> Result<void> {
        if (!made) return made.error();
        into = std::move(*made);
        ++resident.parts;
        return {};
    };
    if (resident.parts == kReliefPart) {
        const ReliefMesh mesh = relief_mesh(background);
        auto positions =
            upload_buffer(frame, mesh.positions_mm, "relief corners", VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
        if (!positions) return positions.error();
        resident.relief_positions = std::move(*positions);
        resident.relief_index_count = static_cast<std::uint32_t>(mesh.indices.size());
        return take(upload_buffer(frame, mesh.indices, "relief indices", VK_BUFFER_USAGE_INDEX_BUFFER_BIT),
                    resident.relief_indices);
    }
    if (resident.parts == kDepthPart) return take(upload_depth(frame, background.relief), resident.depth);
    const auto pair = whole_pair(background);
    if (!pair) return pair.error();
    if (resident.parts == kKeyPart)
        return take(upload_picture(frame, (*pair)->key, "plate with the key light"), resident.key);
    auto sent =
        take(upload_picture(frame, (*pair)->ambient, "plate without the key light"), resident.ambient);
    if (sent) background.photographs->let_go();
    return sent;
}

BackgroundPass::Resident& BackgroundPass::begin(std::shared_ptr<const Background> background) {
    for (const auto& resident : residents_) {
        if (resident->background == background) return *resident;
    }
    residents_.push_back(std::make_unique<Resident>());
    residents_.back()->background = std::move(background);
    return *residents_.back();
}

const BackgroundPass::Resident* BackgroundPass::find(
    const std::shared_ptr<const Background>& background) const {
    for (const auto& resident : residents_) {
        if (resident->background == background) return resident.get();
    }
    return nullptr;
}

Result<const BackgroundPass::Resident*> BackgroundPass::resident(
    const VulkanFrame& frame, const std::shared_ptr<const Background>& background) {
    Resident& there = begin(background);
    while (!there.is_whole()) {
        if (auto sent = upload_part(frame, there); !sent) return sent.error();
    }
    return static_cast<const Resident*>(&there);
}

Result<void> BackgroundPass::fit(const VulkanFrame& frame, const Scene& scene) {
    const std::shared_ptr<const Background> to = scene.transition ? scene.transition->towards : nullptr;
    const auto is_wanted = [&](const std::unique_ptr<Resident>& resident) {
        const auto& at_hand = scene.backgrounds_at_hand;
        return resident->background == scene.background || resident->background == to ||
               std::find(at_hand.begin(), at_hand.end(), resident->background) != at_hand.end();
    };
    const bool changed = scene.background != from_;
    residents_.erase(std::partition(residents_.begin(), residents_.end(), is_wanted), residents_.end());
    let_go(frame, kFrom, from_);
    let_go(frame, kTo, to_);
    // What may be seen soon comes a part a frame: all at once would be a frame that is late.
    for (const auto& background : scene.backgrounds_at_hand) {
        Resident& there = begin(background);
        if (there.is_whole()) continue;
        if (auto sent = upload_part(frame, there); !sent) return sent;
        break;
    }
    if (changed && scene.background) {
        auto there = resident(frame, scene.background);
        if (!there) return there.error();
        bind_background(frame, kFrom, (*there)->key, (*there)->ambient, (*there)->depth);
    }
    if (to && to != to_) {
        auto there = resident(frame, to);
        if (!there) return there.error();
        bind_background(frame, kTo, (*there)->key, (*there)->ambient, (*there)->depth);
    }
    from_ = scene.background;
    if (to) to_ = to;
    return {};
}

void BackgroundPass::draw_relief(const VulkanFrame& frame, const CameraTransition& transition) const {
    const Resident* nearer = find(transition.fraction < 0.5F ? from_ : transition.towards);
    if (nearer == nullptr) return;
    const VkBuffer buffer = nearer->relief_positions.handle();
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(frame.commands, 0, 1, &buffer, &offset);
    vkCmdBindIndexBuffer(frame.commands, nearer->relief_indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(frame.commands, nearer->relief_index_count, 1, 0, 0, 0);
    frame.count_draw(nearer->relief_index_count);
}

}  // namespace onggi::render
