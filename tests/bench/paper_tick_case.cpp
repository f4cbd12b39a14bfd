#include "tests/bench/paper_tick_case.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace onggi::bench {
namespace {

constexpr double kWallMm = 60.0;
constexpr double kToolHeightMm = 100.0;
constexpr double kDepthMm = 1.0;
constexpr double kDepthSwingMm = 0.2;
constexpr int kPeriodTicks = 64;
constexpr double kForceToleranceN = 0.002;

double seconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

// Keeps the compiler from moving memory accesses of the tick out of the timed part.
void compiler_barrier() {
    asm volatile("" ::: "memory");
}

}  // namespace

StopWatch::StopWatch() {
    // The least of many: the clock's undisturbed cost, so that not too much is subtracted.
    double least_s = 1.0;
    for (int i = 0; i < 1000; ++i) {
        start();
        compiler_barrier();
        least_s = std::min(least_s, seconds(std::chrono::steady_clock::now() - start_));
    }
    overhead_s_ = least_s;
}

double StopWatch::stop_s() const {
    return std::max(seconds(std::chrono::steady_clock::now() - start_) - overhead_s_, 1e-9);
}

PaperTickCase::PaperTickCase(int element_count, double tool_radius_mm)
    : clay_({.element_count = element_count, .radius_mm = kWallMm}),
      scan_({.element_count = element_count, .radius_mm = kWallMm}) {
    const double deepest_half_width_mm = tool_radius_mm - (kDepthMm + kDepthSwingMm);
    const double half_height_mm =
        std::sqrt(tool_radius_mm * tool_radius_mm - deepest_half_width_mm * deepest_half_width_mm);
    const double pitch_mm = clay_.element_height_mm();
    first_ = static_cast<int>((kToolHeightMm - half_height_mm) / pitch_mm) - 1;
    const int end = static_cast<int>((kToolHeightMm + half_height_mm) / pitch_mm) + 2;
    straight_wall_mm_.assign(static_cast<std::size_t>(end - first_), static_cast<float>(kWallMm));

    for (int i = 0; i < kPeriodTicks; ++i) {
        const double phase = 2.0 * std::numbers::pi * i / kPeriodTicks;
        const double depth_mm = kDepthMm + kDepthSwingMm * std::sin(phase);
        path_.push_back({.position_mm = {kWallMm + tool_radius_mm - depth_mm, kToolHeightMm, 0.0},
                         .radius_mm = tool_radius_mm,
                         .wheel_turning = true});
    }
}

clay::ToolInput PaperTickCase::next_tool() {
    step_ = (step_ + 1) % path_.size();
    return path_[step_];
}

double PaperTickCase::tick_clay() {
    const clay::ToolInput tool = next_tool();
    watch_.start();
    compiler_barrier();
    forces_ = clay_.tick(tool, parameters_);
    compiler_barrier();
    const double taken_s = watch_.stop_s();
    clay_.set_radii_mm(straight_wall_mm_, first_);
    return taken_s;
}

double PaperTickCase::tick_scan() {
    const clay::ToolInput tool = next_tool();
    watch_.start();
    compiler_barrier();
    forces_ = scan_.tick(tool, parameters_);
    compiler_barrier();
    const double taken_s = watch_.stop_s();
    scan_.set_radius_mm(first_, static_cast<int>(straight_wall_mm_.size()), kWallMm);
    return taken_s;
}

bool PaperTickCase::both_agree() {
    for (std::size_t i = 0; i < path_.size(); ++i) {
        const std::size_t before = step_;
        tick_scan();
        const clay::ContactForces scanned = forces_;
        step_ = before;
        tick_clay();
        if (forces_.contacts != scanned.contacts || forces_.contacts == 0) return false;
        if (glm::length(forces_.total_n() - scanned.total_n()) > kForceToleranceN) return false;
    }
    return true;
}

}  // namespace onggi::bench
