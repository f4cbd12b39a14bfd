#include "engine/haptics/device_group.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace onggi::haptics {

DeviceGroup::DeviceGroup(std::vector<std::unique_ptr<HapticDevice>> devices,
                         const DeviceGroupOptions& options)
    : devices_(std::move(devices)),
      options_(options),
      chooser_(options.chooser),
      samples_(devices_.size()),
      seen_(devices_.size()) {
    assert(!devices_.empty());
    for (const auto& device : devices_)
        motors_.push_back({.limits = limits_for(device->capabilities()), .state = {}});
    // The first device is present from the start, where the loop's own ramp applies.
    motors_.front().state.ramp = 1.0;
    motors_.front().state.calm_ticks = motors_.front().limits.small_force_ticks + 1;
}

DeviceCapabilities DeviceGroup::capabilities() const {
    DeviceCapabilities all = devices_.front()->capabilities();
    for (const auto& device : devices_) {
        const DeviceCapabilities one = device->capabilities();
        if (one.force_axes > 0 && one.has_motors && !one.has_own_walls && one.max_stiffness_n_per_mm > 0.0)
            all.max_stiffness_n_per_mm = std::min(all.max_stiffness_n_per_mm, one.max_stiffness_n_per_mm);
    }
    return all;
}

Result<void> DeviceGroup::open() {
    knows_a_place_ = approaches_ = false;
    for (const auto& pedal : pedals_)
        (void)pedal->open();
    for (std::size_t device = 1; device < devices_.size(); ++device)
        (void)devices_[device]->open();
    return devices_.front()->open();
}

void DeviceGroup::close() noexcept {
    for (const auto& device : devices_)
        device->close();
    for (const auto& pedal : pedals_)
        pedal->close();
}

namespace {

// A point in front of the widest work.
constexpr double kBeforeWorkMm = 180.0;

bool is_in_workspace(const dvec3& place_mm) noexcept {
    const auto is_within = [](double coordinate_mm) { return std::abs(coordinate_mm) <= kWorkspaceMm; };
    return is_within(place_mm.x) && is_within(place_mm.y) && is_within(place_mm.z);
}

// The work turns if any device requests it; the last one in the list sets the speed.
void turn_by(HandSample& sample, const HandSample& foot, bool counts) noexcept {
    if (!counts || !foot.button) return;
    sample.button = true;
    sample.rev_min = foot.rev_min;
}

}  // namespace

HandSample DeviceGroup::read(std::uint64_t tick, double dt_s) noexcept {
    dt_s_ = dt_s;
    for (std::size_t device = 0; device < devices_.size(); ++device) {
        samples_[device] = devices_[device]->read(tick, dt_s);
        // A device that reports a position outside the workspace counts as absent: the gate drops its force,
        // and another device may take the tool.
        seen_[device] = {
            .is_here = devices_[device]->is_here() && is_in_workspace(samples_[device].position_mm),
            .is_moving = devices_[device]->is_moving()};
    }
    const std::size_t before = holder_;
    holder_ = chooser_.choose(seen_, dt_s);
    if (holder_ != before) {
        shown_holder_.store(holder_, std::memory_order_relaxed);
        // A finger's position on its plane usually lies inside the work, so the tool starts from a point in
        // front of the work; at the device's own height and side, so that an arm that gives the tool away and
        // takes it back again and again does not wander.
        if (last_.on_screen) {
            const dvec3& own_mm = samples_[holder_].position_mm;
            last_.position_mm = {own_mm.x, own_mm.y, kBeforeWorkMm};
            last_.on_screen = false;
        }
        // From an invalid position there is no path: the new holder begins at its own position.
        const bool knows_the_way = knows_a_place_ && is_in_workspace(last_.position_mm);
        if (knows_the_way) devices_[holder_]->take_over(last_.position_mm);
        approaches_ = knows_the_way;
        restart_ramp(motors_[holder_].state);
    }

    HandSample sample = samples_.front();
    if (holder_ != 0) {
        const HandSample& held = samples_[holder_];
        sample.position_mm = held.position_mm;
        sample.on_screen = held.on_screen;
        sample.presses = held.presses;
        turn_by(sample, held, seen_[holder_].is_here);
    }
    bool lives = false;
    is_alone_ = true;
    std::uint32_t restless = 0;
    std::uint32_t bit = 1;  // the first device has no bit set: the window watches it
    for (std::size_t device = 1; device < devices_.size(); ++device) {
        bit <<= 1U;
        // Also a device that reports no valid position may have motors.
        is_alone_ = is_alone_ && !devices_[device]->is_here();
        if (!seen_[device].is_here) continue;
        lives = lives || devices_[device]->lives();
        restless |= devices_[device]->never_rests() ? bit : 0U;
    }
    for (const auto& pedal : pedals_) {
        bit <<= 1U;
        const HandSample foot = pedal->read(tick, dt_s);
        lives = lives || pedal->lives();
        restless |= pedal->never_rests() ? bit : 0U;
        turn_by(sample, foot, true);
    }
    restless_.store(restless, std::memory_order_relaxed);
    // No other thread writes it.
    if (lives)
        signs_of_life_.store(signs_of_life_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);

    // A finger's position on a screen is not inside the work, so it needs no approach.
    approaches_ = approaches_ && !sample.on_screen;
    if (approaches_) {
        const dvec3 way = sample.position_mm - last_.position_mm;
        const double length = std::sqrt(glm::dot(way, way));
        const double most_mm = options_.fastest_mm_s * dt_s;
        approaches_ = length > most_mm;
        if (approaches_) sample.position_mm = last_.position_mm + way * (most_mm / length);
    }
    knows_a_place_ = true;
    return last_ = sample;
}

void DeviceGroup::write(const dvec3& force_n) noexcept {
    const SafetyInput input{.position_mm = last_.position_mm, .dt_s = dt_s_};
    const double written_n = std::sqrt(glm::dot(force_n, force_n));
    for (std::size_t device = 0; device < devices_.size(); ++device) {
        Motors& motors = motors_[device];
        // The stages run for idle devices too, so that their heat budget recovers.
        const dvec3 wanted_n = device == holder_ ? force_n : dvec3(0.0);
        const dvec3 given_n = apply_stages(kMotorStages, wanted_n, input, motors.limits, motors.state);
        const double given_size_n = std::sqrt(glm::dot(given_n, given_n));
        motors.given_fraction =
            device == holder_ && written_n > 0.0 ? std::min(1.0, given_size_n / written_n) : 0.0;
        devices_[device]->write(given_n);
    }
}

std::vector<DeviceCapabilities> DeviceGroup::capabilities_of_devices() const {
    std::vector<DeviceCapabilities> all;
    for (const auto& device : devices_)
        all.push_back(device->capabilities());
    return all;
}

DeviceSigns DeviceGroup::signs() const noexcept {
    DeviceSigns signs = devices_[holder_]->signs();
    signs.position_is_new = signs.position_is_new && seen_[holder_].is_here;
    signs.hand_is_there = signs.hand_is_there && seen_[holder_].is_here;
    signs.device = holder_;
    signs.is_alone = is_alone_;
    signs.force_fraction *= motors_[holder_].given_fraction;
    return signs;
}

void DeviceGroup::silence() noexcept {
    for (const auto& device : devices_)
        device->silence();
}

void DeviceGroup::feel(const WorkFelt& work) noexcept {
    devices_[holder_]->feel(work);
}

}  // namespace onggi::haptics
