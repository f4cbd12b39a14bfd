#include "engine/render/vulkan/background_pass.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/render/frame/background_pair.h"

namespace onggi::render {
namespace {

constexpr VkFormat kBackgroundFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr std::size_t kTexelBytes = 4;
// What a frame uploads of a photograph that is not needed yet: all at once would be a frame that is late.
constexpr std::size_t kStripBytes = std::size_t{2} << 20;

void bind_background(const VulkanFrame& frame, const vk::Image& key, const vk::Image& ambient) {
    const auto bind = [&](std::uint32_t binding, const vk::Image& image) {
        vk::write_image(frame.device, frame.set(), binding, image.view(), frame.pipelines.clamped.get());
    };
    bind(shaders::kBindBackgroundKey, key);
    bind(shaders::kBindBackgroundAmbient, ambient);
}

Result<vk::Image> create_picture(const VulkanFrame& frame, const asset::Image& picture, const char* name) {
    return vk::Image::create(
        frame.device,
        {.name = name,
         .format = kBackgroundFormat,
         .extent = {static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height)},
         .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
}

// Rows of a picture, from the first on; the image lies as they left it until its last one is there.
void copy_rows(VkCommandBuffer commands, const vk::Buffer& strip, const vk::Image& image, int first,
               int rows) {
    const auto height = static_cast<int>(image.extent().height);
    if (first == 0) vk::barrier(commands, image, vk::state::kUndefined, vk::state::kCopyTarget);
    const VkBufferImageCopy region{
        .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageOffset = {0, first, 0},
        .imageExtent = {image.extent().width, static_cast<std::uint32_t>(rows), 1}};
    vkCmdCopyBufferToImage(commands, strip.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
    if (first + rows == height) vk::barrier(commands, image, vk::state::kCopyTarget, vk::state::kSampled);
}

bool names(const Scene& scene, const std::shared_ptr<const Background>& background) {
    const auto& at_hand = scene.backgrounds_at_hand;
    return background == scene.background || (scene.next_view && background == scene.next_view->background) ||
           std::find(at_hand.begin(), at_hand.end(), background) != at_hand.end();
}

}  // namespace

void BackgroundPass::bind_placeholders(const VulkanFrame& frame) {
    bind_background(frame, frame.images.mask, frame.images.mask);
}

Result<void> BackgroundPass::upload_strip(const VulkanFrame& frame, Resident& resident) {
    const Background& background = *resident.background;
    const auto pair = whole_pair(background);
    if (!pair) return pair.error();
    const bool is_key = resident.rows < background.height_px;
    const asset::Image& picture = is_key ? (*pair)->key : (*pair)->ambient;
    vk::Image& image = is_key ? resident.key : resident.ambient;
    const int first = is_key ? resident.rows : resident.rows - background.height_px;
    if (first == 0) {
        auto made = create_picture(
            frame, picture, is_key ? "background with the key light" : "background without the key light");
        if (!made) return made.error();
        image = std::move(*made);
    }
    const std::size_t row_bytes = kTexelBytes * static_cast<std::size_t>(picture.width);
    const std::size_t strip_bytes = std::max(kStripBytes, row_bytes);
    if (strip_.size() < strip_bytes) {
        auto made = vk::Buffer::create(
            frame.device,
            {.name = "background upload", .size = strip_bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
        if (!made) return made.error();
        strip_ = std::move(*made);
    }
    const int rows = std::min(static_cast<int>(strip_bytes / row_bytes), picture.height - first);
    strip_.write(std::as_bytes(std::span(picture.rgba))
                     .subspan(static_cast<std::size_t>(first) * row_bytes,
                              static_cast<std::size_t>(rows) * row_bytes));
    auto copied =
        frame.device.run_once([&](VkCommandBuffer once) { copy_rows(once, strip_, image, first, rows); });
    if (!copied) return copied;
    resident.rows += rows;
    if (resident.is_whole()) background.photographs->let_go();
    return {};
}

BackgroundPass::Resident& BackgroundPass::begin(std::shared_ptr<const Background> background) {
    for (const auto& resident : residents_) {
        if (resident->background == background) return *resident;
    }
    residents_.push_back(std::make_unique<Resident>());
    residents_.back()->background = std::move(background);
    return *residents_.back();
}

bool BackgroundPass::has(const Background* background) const {
    return std::any_of(residents_.begin(), residents_.end(), [&](const std::unique_ptr<Resident>& resident) {
        return resident->background.get() == background && resident->is_whole();
    });
}

void BackgroundPass::let_go_of_others(const VulkanFrame& frame, const Scene& scene) {
    if (bound_ && !names(scene, bound_)) {
        bind_placeholders(frame);
        bound_ = nullptr;
    }
    std::erase_if(residents_, [&](const std::unique_ptr<Resident>& resident) {
        return !names(scene, resident->background);
    });
}

Result<void> BackgroundPass::fit(const VulkanFrame& frame, const Scene& scene) {
    let_go_of_others(frame, scene);
    std::vector<std::shared_ptr<const Background>> soon = scene.backgrounds_at_hand;
    if (scene.next_view && scene.next_view->background) soon.push_back(scene.next_view->background);
    for (const auto& background : soon) {
        if (has(background.get())) continue;
        if (auto sent = upload_strip(frame, begin(background)); !sent) return sent;
        break;
    }
    if (scene.background == nullptr || scene.background == bound_) return {};
    Resident& shown = begin(scene.background);
    while (!shown.is_whole()) {
        if (auto sent = upload_strip(frame, shown); !sent) return sent;
    }
    bind_background(frame, shown.key, shown.ambient);
    bound_ = scene.background;
    return {};
}

}  // namespace onggi::render
