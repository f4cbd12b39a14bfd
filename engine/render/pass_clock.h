// Names the parts of a frame for frame debuggers, and measures them: the whole always, each part on request,
// since a mark between two parts costs a software device its batching. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/renderer_desc.h"
#include "engine/vk/timestamps.h"

namespace onggi::render {

// What a part of a frame took, on the device or before the device had anything to do.
struct PassTime {
    const char* name = "";
    double ms = 0.0;
    bool is_on_host = false;
};

class PassClock {
  public:
    // Without a host's clock the host's parts are not measured.
    static Result<PassClock> create(const vk::Device& device, const RendererDesc& desc);
    // From the next frame on.
    void measure_parts(bool measures) { measures_parts_ = measures; }

    // What the host works out or draws itself, before begin(). enter_host() ends the part before.
    void enter_host(const char* name);
    void end_host();

    // In a command buffer, outside of rendering. enter() ends the part before; inside of rendering too.
    void begin(const vk::Device& device, VkCommandBuffer commands);
    void enter(const vk::Device& device, VkCommandBuffer commands, const char* name);
    void end(const vk::Device& device, VkCommandBuffer commands);

    // Of the frame that has left the device: what all of it took there, 0 where nothing was measured, and its
    // parts, the host's first.
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
