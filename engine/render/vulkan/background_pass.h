// The photographs of the room on the device, those that are shown and those that may be next. Main thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

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

}  // namespace onggi::render
