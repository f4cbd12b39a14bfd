#include "engine/render/pass_clock.h"

namespace onggi::render {

Result<PassClock> PassClock::create(const vk::Device& device, bool measures_parts) {
    constexpr std::uint32_t kMostParts = 16;
    PassClock clock;
    auto timestamps = vk::Timestamps::create(device, kMostParts + 1, "frame times");
    if (!timestamps) return timestamps.error();
    clock.timestamps_ = std::move(*timestamps);
    clock.measures_parts_ = measures_parts;
    return clock;
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
    parts.clear();
    const std::vector<double>& ms = timestamps_.read(device);
    if (ms.size() < 2) return 0.0;
    for (std::size_t part = 0; parts_are_marked_ && part < names_.size() && part + 1 < ms.size(); ++part)
        parts.push_back({names_[part], ms[part + 1] - ms[part]});
    return ms.back();
}

}  // namespace onggi::render
