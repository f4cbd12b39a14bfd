#include "engine/haptics/hands.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace onggi::haptics {

Hands::Hands(std::vector<std::unique_ptr<Hand>> hands, const HandsOptions& options)
    : hands_(std::move(hands)),
      options_(options),
      chooser_(options.chooser),
      tools_(hands_.size()),
      seen_(hands_.size()) {
    assert(!hands_.empty());
    for (const auto& hand : hands_)
        motors_.push_back({.limits = limits_for(hand->capabilities()), .state = {}});
    // The first is there from the start, and the start has the loop's own ramp.
    motors_.front().state.ramp = 1.0;
    motors_.front().state.calm_ticks = motors_.front().limits.small_force_ticks + 1;
}

DeviceCapabilities Hands::capabilities() const {
    DeviceCapabilities all = hands_.front()->capabilities();
    for (const auto& hand : hands_) {
        const DeviceCapabilities one = hand->capabilities();
        if (one.force_axes > 0 && one.has_motors && !one.has_own_walls && one.max_stiffness_n_per_mm > 0.0)
            all.max_stiffness_n_per_mm = std::min(all.max_stiffness_n_per_mm, one.max_stiffness_n_per_mm);
    }
    return all;
}

Result<void> Hands::open() {
    knows_a_tool_ = approaches_ = false;
    for (const auto& pedal : pedals_)
        (void)pedal->open();
    for (std::size_t hand = 1; hand < hands_.size(); ++hand)
        (void)hands_[hand]->open();
    return hands_.front()->open();
}

void Hands::close() noexcept {
    for (const auto& hand : hands_)
        hand->close();
    for (const auto& pedal : pedals_)
        pedal->close();
}

namespace {

// In front of the widest work.
constexpr double kBeforeWorkMm = 180.0;

bool is_in_workspace(const dvec3& place_mm) noexcept {
    const auto is_within = [](double coordinate_mm) { return std::abs(coordinate_mm) <= kWorkspaceMm; };
    return is_within(place_mm.x) && is_within(place_mm.y) && is_within(place_mm.z);
}

// The wheel turns while anybody wants it to; who came last in the list says how fast.
void turn_by(ToolState& tool, const ToolState& foot, bool counts) noexcept {
    if (!counts || !foot.wheel_button) return;
    tool.wheel_button = true;
    tool.wheel_speed_rev_min = foot.wheel_speed_rev_min;
}

}  // namespace

ToolState Hands::read(std::uint64_t tick, double dt_s) noexcept {
    dt_s_ = dt_s;
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        tools_[hand] = hands_[hand]->read(tick, dt_s);
        // Who says nonsense is not here: the gate drops its force, and another may take the tool.
        seen_[hand] = {.is_here = hands_[hand]->is_here() && is_in_workspace(tools_[hand].position_mm),
                       .is_moving = hands_[hand]->is_moving()};
    }
    const std::size_t before = holder_;
    holder_ = chooser_.choose(seen_, dt_s);
    if (holder_ != before) {
        shown_holder_.store(holder_, std::memory_order_relaxed);
        // Where a finger is on its plane is most often in the work: a ball comes from before it.
        if (tool_.guided) {
            tool_.position_mm.z = kBeforeWorkMm;
            tool_.guided = false;
        }
        // There is no way back from nonsense: the new hand begins where it is.
        const bool knows_the_way = knows_a_tool_ && is_in_workspace(tool_.position_mm);
        if (knows_the_way) hands_[holder_]->take_over(tool_);
        approaches_ = knows_the_way;
        restart_ramp(motors_[holder_].state);
    }

    ToolState tool = tools_.front();
    if (holder_ != 0) {
        const ToolState& held = tools_[holder_];
        tool.position_mm = held.position_mm;
        tool.guided = held.guided;
        tool.pressing = held.pressing;
        turn_by(tool, held, seen_[holder_].is_here);
    }
    bool lives = false;
    for (std::size_t hand = 1; hand < hands_.size(); ++hand)
        lives = lives || (seen_[hand].is_here && seen_[hand].is_moving);
    for (const auto& pedal : pedals_) {
        const ToolState foot = pedal->read(tick, dt_s);
        lives = lives || foot.wheel_button;
        turn_by(tool, foot, true);
    }
    // This thread alone writes it.
    if (lives)
        signs_of_life_.store(signs_of_life_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);

    // A finger on a screen has no way through the work to go.
    approaches_ = approaches_ && !tool.guided;
    if (approaches_) {
        const dvec3 way = tool.position_mm - tool_.position_mm;
        const double length = std::sqrt(glm::dot(way, way));
        const double most_mm = options_.fastest_mm_s * dt_s;
        approaches_ = length > most_mm;
        if (approaches_) tool.position_mm = tool_.position_mm + way * (most_mm / length);
    }
    knows_a_tool_ = true;
    return tool_ = tool;
}

void Hands::write(const dvec3& force_n) noexcept {
    const SafetyInput input{.position_mm = tool_.position_mm, .dt_s = dt_s_};
    const double written_n = std::sqrt(glm::dot(force_n, force_n));
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        Motors& motors = motors_[hand];
        // In and out of use, so that motors cool while another works.
        const dvec3 wanted_n = hand == holder_ ? force_n : dvec3(0.0);
        const dvec3 given_n = apply_stages(kMotorStages, wanted_n, input, motors.limits, motors.state);
        const double given_size_n = std::sqrt(glm::dot(given_n, given_n));
        motors.given_fraction =
            hand == holder_ && written_n > 0.0 ? std::min(1.0, given_size_n / written_n) : 0.0;
        hands_[hand]->write(given_n);
    }
}

std::vector<DeviceCapabilities> Hands::capabilities_of_hands() const {
    std::vector<DeviceCapabilities> all;
    for (const auto& hand : hands_)
        all.push_back(hand->capabilities());
    return all;
}

HandSigns Hands::signs() const noexcept {
    HandSigns signs = hands_[holder_]->signs();
    signs.position_is_new = signs.position_is_new && seen_[holder_].is_here;
    signs.hand_is_there = signs.hand_is_there && seen_[holder_].is_here;
    signs.hand = holder_;
    signs.force_fraction *= motors_[holder_].given_fraction;
    return signs;
}

void Hands::silence() noexcept {
    for (const auto& hand : hands_)
        hand->silence();
}

void Hands::feel(const WorkFelt& work) noexcept {
    hands_[holder_]->feel(work);
}

}  // namespace onggi::haptics
