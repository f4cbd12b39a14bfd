#include "game/haptic/force_test.h"

#include <algorithm>
#include <array>

namespace onggi::haptic {
namespace {

using Stage = ForceTestReport::Stage;

constexpr std::array<int, kTestPushes> kAxes{1, 0, 2};  // up first, against the hand's weight

}  // namespace

dvec3 test_force_n(double time_s) noexcept {
    dvec3 force_n(0.0);
    if (!(time_s >= 0.0) || time_s >= kTestPushes * kTestPushS) return force_n;
    const int push = std::min(static_cast<int>(time_s / kTestPushS), kTestPushes - 1);
    const double fraction = std::clamp(time_s / kTestPushS - push, 0.0, 1.0);
    // 1 in the middle, 0 with zero slope at both ends.
    const double hill = 4.0 * fraction * (1.0 - fraction);
    force_n[kAxes[static_cast<std::size_t>(push)]] = kTestForceN * hill * hill;
    return force_n;
}

void ForceTest::begin(std::size_t device) noexcept {
    report_ = {.stage = Stage::kWaits, .device = device};
    ticks_ = 0;
    push_ = seen_push_ = -1;
}

void ForceTest::end() noexcept {
    if (runs()) report_.stage = Stage::kBroken;
}

dvec3 ForceTest::step(const haptics::SafetyState& safety, std::size_t device, double dt_s) noexcept {
    if (!runs()) return dvec3(0.0);
    if (safety.fault != haptics::Fault::kNone || device != report_.device) {
        report_.stage = Stage::kBroken;
        return dvec3(0.0);
    }
    if (report_.stage == Stage::kWaits) {
        if (safety.ramp < 1.0 || safety.presence < 1.0) {
            if (static_cast<double>(++ticks_) * dt_s >= kTestWaitsS) report_.stage = Stage::kNobody;
            return dvec3(0.0);
        }
        report_.stage = Stage::kPushes;
        ticks_ = 0;
    }
    const double time_s = static_cast<double>(ticks_++) * dt_s;
    if (time_s >= kTestPushes * kTestPushS) {
        report_.stage = Stage::kDone;
        return dvec3(0.0);
    }
    push_ = std::min(static_cast<int>(time_s / kTestPushS), kTestPushes - 1);
    return test_force_n(time_s);
}

void ForceTest::see(const dvec3& position_mm, const dvec3& given_n) noexcept {
    if (report_.stage != Stage::kPushes) return;
    if (seen_push_ != push_) from_mm_ = position_mm;
    seen_push_ = push_;
    const int axis = kAxes[static_cast<std::size_t>(push_)];
    report_.given_n[axis] = std::max(report_.given_n[axis], given_n[axis]);
    report_.moved_mm[axis] = std::max(report_.moved_mm[axis], position_mm[axis] - from_mm_[axis]);
}

}  // namespace onggi::haptic
