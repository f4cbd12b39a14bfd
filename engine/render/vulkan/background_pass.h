// The photographs of the room on the device, those that are shown and those that may be next. Main thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

// Where in the frame's set a background is bound.
struct BackgroundSlots {
    int key;
    int ambient;
    int depth;
};

class BackgroundPass {
  public:
    // Binds something to every slot that a shader might read before there is a background.
    static void bind_placeholders(const VulkanFrame& frame);

    // The scene's backgrounds to where they are used, unless they are there. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Scene& scene);

    // The relief of the background that is nearer to the gliding camera, inside the caller's pass.
    void draw_relief(const VulkanFrame& frame, const CameraTransition& transition) const;

  private:
    // What a background is brought in, so that no frame has to wait for all of it.
    enum Part { kReliefPart, kDepthPart, kKeyPart, kAmbientPart, kParts };
    struct Resident {
        int parts = 0;                                 // that are here, in this order
        std::shared_ptr<const Background> background;  // held, so that no other can have its address
        vk::Image key{};
        vk::Image ambient{};
        vk::Image depth{};  // of the relief's corners, mm
        vk::Buffer relief_positions{};
        vk::Buffer relief_indices{};
        std::uint32_t relief_index_count = 0;

        [[nodiscard]] bool is_whole() const { return parts == kParts; }
    };
    // The next of them; some ms.
    static Result<void> upload_part(const VulkanFrame& frame, Resident& resident);
    // The one of that background, perhaps still without a part.
    Resident& begin(std::shared_ptr<const Background> background);
    // Whole.
    Result<const Resident*> resident(const VulkanFrame& frame,
                                     const std::shared_ptr<const Background>& background);
    void let_go(const VulkanFrame& frame, const BackgroundSlots& slots,
                std::shared_ptr<const Background>& bound) const;
    [[nodiscard]] const Resident* find(const std::shared_ptr<const Background>& background) const;

    std::vector<std::unique_ptr<Resident>> residents_;
    std::shared_ptr<const Background> from_;  // as bound
    std::shared_ptr<const Background> to_;
};

}  // namespace onggi::render
