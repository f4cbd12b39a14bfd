#include "engine/render/pass_clock.h"

#include <utility>

namespace onggi::render {

Result<PassClock> PassClock::create(const vk::Device& device, const RendererDesc& desc) {
    constexpr std::uint32_t kMostParts = 16;
    PassClock clock;
    auto timestamps = vk::Timestamps::create(device, kMostParts + 1, "frame times");
    if (!timestamps) return timestamps.error();
    clock.timestamps_ = std::move(*timestamps);
    clock.measures_parts_ = desc.measures_parts;
    clock.host_clock_ = desc.host_clock;
    return clock;
}

void PassClock::enter_host(const char* name) {
    end_host();
    if (!measures_parts_ || host_clock_ == nullptr) return;
    host_parts_.push_back({.name = name, .is_on_host = true});
    host_entered_ns_ = host_clock_();
    is_in_host_part_ = true;
}

void PassClock::end_host() {
    if (!is_in_host_part_) return;
    host_parts_.back().ms = 1e-6 * static_cast<double>(host_clock_() - host_entered_ns_);
    is_in_host_part_ = false;
}

void PassClock::begin(const vk::Device& device, VkCommandBuffer commands) {
    names_.clear();
    is_inside_ = false;
    parts_are_marked_ = measures_parts_;
    timestamps_.begin(commands);
    device.begin_region(commands, "frame");
    timestamps_.mark(commands);
}

void PassClock::enter(const vk::Device& device, VkCommandBuffer commands, const char* name) {
    if (is_inside_) {
        device.end_region(commands);
        if (parts_are_marked_) timestamps_.mark(commands);
    }
    device.begin_region(commands, name);
    names_.push_back(name);
    is_inside_ = true;
}

void PassClock::end(const vk::Device& device, VkCommandBuffer commands) {
    if (is_inside_) device.end_region(commands);
    timestamps_.mark(commands);
    device.end_region(commands);
}

double PassClock::read(const vk::Device& device, std::vector<PassTime>& parts) {
    parts = std::move(host_parts_);
    host_parts_.clear();
    const std::vector<double>& ms = timestamps_.read(device);
    if (ms.size() < 2) return 0.0;
    for (std::size_t part = 0; parts_are_marked_ && part < names_.size() && part + 1 < ms.size(); ++part)
        parts.push_back({.name = names_[part], .ms = ms[part + 1] - ms[part]});
    return ms.back();
}

}  // namespace onggi::render
