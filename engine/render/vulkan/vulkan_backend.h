// The backend for GPUs, and for screenshots on any device: the device draws everything in every frame. Main
// thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/vulkan/overlay_pass.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

// The room's photographs on the device: those that are shown and those that may be next.
class BackgroundPass {
  public:
    // Binds a placeholder to each slot that a shader might read before there is a background.
    static void bind_placeholders(const VulkanFrame& frame);

    // Uploads the scene's background completely if it is missing, binds it, and uploads one strip of a
    // background that may be shown soon. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // Whether the whole background is on the device.
    [[nodiscard]] bool has(const Background* background) const;

  private:
    struct Resident {
        std::shared_ptr<const Background> background;  // keeps its address from being reused
        vk::Image key{};
        vk::Image ambient{};
        int rows = 0;  // uploaded so far: first those of `key`, then those of `ambient`

        [[nodiscard]] bool is_whole() const { return rows == 2 * background->height_px; }
    };
    // Uploads the next strip of rows.
    Result<void> upload_strip(const VulkanFrame& frame, Resident& resident);
    // Returns the resident of that background; creates an empty one if there is none.
    Resident& begin(std::shared_ptr<const Background> background);
    // Releases backgrounds that the scene no longer names, after unbinding them: lavapipe counts references
    // to whatever is bound, even if nothing is drawn with it.
    void let_go_of_others(const VulkanFrame& frame, const Scene& scene);

    std::vector<std::unique_ptr<Resident>> residents_;
    std::shared_ptr<const Background> bound_;
    vk::Buffer strip_{};
};

// The static background, drawn into every frame.
class RoomPass {
  public:
    // Call once, after the pipelines and fixed-size images are created.
    static void create(const VulkanFrame& frame) { BackgroundPass::bind_placeholders(frame); }
    // Uploads the scene's still life and backgrounds if they have changed. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // Draws the still life's shadow map if it has changed.
    void record(const VulkanFrame& frame, const Scene& scene);
    // Draws meshes and backdrop inside the caller's pass. Call it after drawing what stands in front of them.
    void draw(const VulkanFrame& frame, const Scene& scene) const;

    [[nodiscard]] const StillBounds& bounds() const { return still_.bounds(); }

    // Whether everything that a view of this background needs is on the device. Null: it needs nothing.
    [[nodiscard]] bool has(const Background* background) const {
        return background == nullptr || background_.has(background);
    }

  private:
    BackgroundPass background_;
    StillMeshes still_;
    std::optional<mat4> mapped_;  // key light's view-projection at the time of the map's drawing
};

// The shadow of moving things on the still life: a small mask, drawn when they change.
class ShadowPass {
  public:
    // Decides whether the mask must be drawn again, and notes it in the stats.
    void update(VulkanFrame& frame, const Scene& scene);
    // Draws the mask if update() decided so.
    void record(const VulkanFrame& frame);

  private:
    std::uint64_t drawn_ = 0;  // hash of the scene that the mask shows
    bool has_mask_ = false;
};

// Draws the lathe on the device, from its rings.
class LathePass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // Uploads what has changed since the previous frame, which the device has finished. Errors: no memory for
    // the marks.
    Result<void> upload(const VulkanFrame& frame);

    // Draws the lathe inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    Result<void> upload_marks(const VulkanFrame& frame);
    static Result<void> upload_streaks(const VulkanFrame& frame);

    // A buffer and a host copy of its contents: comparing with the copy avoids slow reads from device memory.
    struct Kept {
        vk::Buffer buffer;
        std::vector<std::byte> there;
        void write(const VulkanFrame& frame, std::span<const std::byte> bytes);
    };

    Kept outline_;
    Kept rows_;
    Kept vertices_;
    Kept normals_;
    vk::BufferView normal_texels_;
    Kept indices_;
    vk::Buffer marks_;
    std::uint64_t marks_revision_ = 0;  // revision of the marks in marks_; 0: no marks
};

// Draws hands and tools on the device.
class PropPass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // Uploads the scene's library if it is another one. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);
    // Draws the scene's props inside the caller's pass. Props with a model that is not in the library are
    // skipped.
    void draw(const VulkanFrame& frame, const Scene& scene) const;

  private:
    // Where a mesh is in the buffers.
    struct Range {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t first_vertex = 0;
    };

    vk::Pipeline pipeline_;
    MeshBuffers buffers_;
    std::vector<std::vector<Range>> ranges_;  // by model, then by mesh
    std::shared_ptr<const PropLibrary> uploaded_;
};

// Fades over a cut: lays the last picture of the previous view over the first pictures of the next.
class ViewFade {
  public:
    // Binds a placeholder; the slot must not be empty.
    static void bind_placeholder(const VulkanFrame& frame);

    // Call once a frame, before recording. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // The image to draw this frame's scene into, in the colour layout, because the frame may be the last of
    // its view. Null: the frame is not kept.
    [[nodiscard]] const vk::Image* keeps() const { return keeps_ ? &kept_ : nullptr; }
    // Marks the picture as kept; `used` is the image's last use in this frame.
    void keep(VkCommandBuffer commands, const vk::ImageState& used);
    // Draws the rest of the previous view inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    vk::Image kept_{};
    bool keeps_ = false;  // this frame's picture
    bool shows_ = false;  // the kept picture
    bool has_ = false;    // a picture is kept
};

class VulkanBackend : public RenderBackend {
  public:
    VulkanBackend(vk::Device& device, const RendererDesc& desc) : frame_{{.device = device, .desc = desc}} {}

    Result<void> create() override;
    Result<void> fit(const Scene& scene, VkExtent2D target) override;
    Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) override;
    [[nodiscard]] FrameContext& frame() override { return frame_; }

  private:
    Result<void> fit_size(VkExtent2D target);
    Result<void> upload(const Scene& scene);
    void record(const Scene& scene, const vk::TargetImage& target);
    // The image to draw the scene into before it is stretched over the target, because it is smaller or must
    // be kept. Null: the scene is drawn directly into the target.
    [[nodiscard]] const vk::Image* picture_apart() const;
    // Blits a picture that was just drawn over the target.
    void stretch(const vk::Image& picture, const vk::TargetImage& target) const;

    VulkanFrame frame_;
    RoomPass room_;
    ShadowPass shadow_;
    LathePass lathe_;
    PropPass props_;
    OverlayPass overlay_;
    ViewFade fade_;
};

}  // namespace onggi::render
