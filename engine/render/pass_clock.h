// Names the parts of a frame for frame debuggers and measures them. The whole frame is always measured, the
// parts only on request: a timestamp between two parts breaks up a software device's batches. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/renderer_desc.h"
#include "engine/vk/timestamps.h"

namespace onggi::render {

// Time that a part of a frame took on the device, or on the host before the device's work.
struct PassTime {
    const char* name = "";
    double ms = 0.0;
    bool is_on_host = false;
};

class PassClock {
  public:
    // Without a host clock in `desc`, the host's parts are not measured.
    static Result<PassClock> create(const vk::Device& device, const RendererDesc& desc);
    // Takes effect with the next frame.
    void measure_parts(bool measures) { measures_parts_ = measures; }

    // For work of the host before begin(). enter_host() ends the previous part.
    void enter_host(const char* name);
    void end_host();

    // begin() and end() record outside of rendering. enter() ends the previous part and may be called inside
    // of rendering.
    void begin(const vk::Device& device, VkCommandBuffer commands);
    void enter(const vk::Device& device, VkCommandBuffer commands, const char* name);
    void end(const vk::Device& device, VkCommandBuffer commands);

    // Reads the previous frame, which the device has finished. Fills in its parts, the host's first. Returns
    // its total device time; 0 if nothing was measured.
    double read(const vk::Device& device, std::vector<PassTime>& parts);

  private:
    vk::Timestamps timestamps_;
    std::vector<PassTime> host_parts_;
    std::int64_t host_entered_ns_ = 0;
    HostClock host_clock_ = nullptr;
    bool is_in_host_part_ = false;
    std::vector<const char*> names_;
    bool measures_parts_ = false;
    bool parts_are_marked_ = false;  // in the frame that was begun last
    bool is_inside_ = false;
};

}  // namespace onggi::render
