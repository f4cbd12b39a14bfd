// The picture as GPUs draw it, and as screenshots are drawn everywhere: everything by the device in every
// frame. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/render_backend.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/vulkan/overlay_pass.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

// The photographs of the room on the device, those that are shown and those that may be next.
class BackgroundPass {
  public:
    // Binds something to every slot that a shader might read before there is a background.
    static void bind_placeholders(const VulkanFrame& frame);

    // The scene's background to where it is used, unless it is there, and some rows of what may be seen soon.
    // The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // All of it is on the device.
    [[nodiscard]] bool has(const Background* background) const;

  private:
    struct Resident {
        std::shared_ptr<const Background> background;  // held, so that no other can have its address
        vk::Image key{};
        vk::Image ambient{};
        int rows = 0;  // that are here: first those of the one, then of the other

        [[nodiscard]] bool is_whole() const { return rows == 2 * background->height_px; }
    };
    // The next strip of it, some rows.
    Result<void> upload_strip(const VulkanFrame& frame, Resident& resident);
    // The one of that background, perhaps still without a row.
    Resident& begin(std::shared_ptr<const Background> background);
    // What the scene does not name goes, and out of every slot before that: lavapipe counts references in
    // whatever is bound, drawn from or not.
    void let_go_of_others(const VulkanFrame& frame, const Scene& scene);

    std::vector<std::unique_ptr<Resident>> residents_;
    std::shared_ptr<const Background> bound_;
    vk::Buffer strip_{};
};

// The background: what stands still, drawn into every frame.
class RoomPass {
  public:
    // Once, with the pipelines and images of fixed size there.
    static void create(const VulkanFrame& frame) { BackgroundPass::bind_placeholders(frame); }
    // The still life of the scene and its backgrounds onto the device, if they are others. The device is
    // idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // The still life's shadow map, where it is another than the one that is there.
    void record(const VulkanFrame& frame, const Scene& scene);
    // Meshes and backdrop inside the caller's pass; front to back, so after what stands before them.
    void draw(const VulkanFrame& frame, const Scene& scene) const;

    [[nodiscard]] const StillBounds& bounds() const { return still_.bounds(); }

    // What a view of this background would be drawn from is on the device; null: it needs nothing.
    [[nodiscard]] bool has(const Background* background) const {
        return background == nullptr || background_.has(background);
    }

  private:
    BackgroundPass background_;
    StillMeshes still_;
    std::optional<mat4> mapped_;  // as the key light saw the still life when its map was drawn
};

// The shadow that moving things cast on what stands still: a small mask, drawn when they change.
class ShadowPass {
  public:
    // Decides whether the mask has to be drawn again, and notes it in the stats.
    void update(VulkanFrame& frame, const Scene& scene);
    // The mask, if update() asked for it.
    void record(const VulkanFrame& frame);

  private:
    std::uint64_t drawn_ = 0;  // hash of what the mask shows
    bool has_mask_ = false;
};

// The lathe, drawn by the device from its rings, with what it needs there.
class LathePass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // What has changed since the frame before, which has left the device. Errors: no memory for the marks,
    // where there are some.
    Result<void> upload(const VulkanFrame& frame);

    // The lathe, inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    Result<void> upload_marks(const VulkanFrame& frame);
    static Result<void> upload_streaks(const VulkanFrame& frame);

    // A buffer, and what was written to it: the host does not read it back, where that is slow.
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
    std::uint64_t marks_revision_ = 0;  // that it holds, 0: none
};

// Hands and tools, drawn by the device.
class PropPass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // The library of the scene onto the device, if it is another one. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);
    // The scene's, inside the caller's pass; those of a model that the library does not have are left out.
    void draw(const VulkanFrame& frame, const Scene& scene) const;

  private:
    // Where a mesh lies in the buffers.
    struct Range {
        std::uint32_t first_index = 0;
        std::uint32_t index_count = 0;
        std::int32_t first_vertex = 0;
    };

    vk::Pipeline pipeline_;
    MeshBuffers buffers_;
    std::vector<std::vector<Range>> ranges_;  // of each mesh of each model
    std::shared_ptr<const PropLibrary> uploaded_;
};

// The last picture of a view that the camera is cut from, laid over the first of the next.
class ViewFade {
  public:
    // Binds something to the slot, which must not be empty.
    static void bind_placeholder(const VulkanFrame& frame);

    // Once a frame, before it is recorded. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // Where this frame's picture of the scene is to be drawn, laid out as colour, because it may be the last
    // of its view; null: nowhere.
    [[nodiscard]] const vk::Image* keeps() const { return keeps_ ? &kept_ : nullptr; }
    // It was, and was last used so.
    void keep(VkCommandBuffer commands, const vk::ImageState& used);
    // What is left of the view before, inside the caller's pass.
    void draw(const VulkanFrame& frame) const;

  private:
    vk::Image kept_{};
    bool keeps_ = false;  // this frame's
    bool shows_ = false;  // the one that was kept
    bool has_ = false;    // there is one
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
    // Where the scene's picture is drawn if not into the target, over which it is then stretched: it is
    // smaller, or may be wanted again. Else null.
    [[nodiscard]] const vk::Image* picture_apart() const;
    // A picture that was just drawn, over the target.
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
