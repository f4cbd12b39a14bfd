// studio_tick/N/S/radius_mm: one tick of the studio clay at the kiosk's 4000 Hz, one hand 1 mm +- 0.2 mm deep
// in the outside of a thrown wall of N rings that stands alone, so that the wall field runs.
// studio_tick_pinch: both hands on it. studio_tick_rough: one hand on rows that are not round.
// studio_tick_idle: nobody touches the turning wall, as on an unattended wheel. Counters p50_ns and p99_ns
// are of single ticks, clock included (some 20 ns); the wall is restored between runs of ticks, outside the
// time taken.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <numbers>
#include <vector>

#include "game/clay/studio/studio_clay.h"
#include "tests/bench/bench_failure.h"

namespace onggi::bench {
namespace {

constexpr double kOuterMm = 45.0;
constexpr double kWallMm = 6.5;
constexpr double kHandMm = 100.0;
constexpr double kWheelRadS = 4.0 * std::numbers::pi;  // 120 rev/min
constexpr int kTicksARestore = 64;

enum class Hands { kNone, kOne, kPinch, kOneOnRoughRows };

class StudioTickCase {
  public:
    StudioTickCase(int rings, int sectors, double radius_mm, Hands hands)
        : clay_({.mass_g = 2500.0, .rings = rings, .sectors = sectors, .off_centre_mm = 0.0}),
          hands_(hands),
          rings_(rings),
          radius_mm_(radius_mm) {
        parameters_.rate_hz = 4000.0;
        input_.wheel_button = true;
        input_.radius_mm = radius_mm;
        input_.pressing = hands != Hands::kNone;
        if (hands == Hands::kPinch) input_.assist_gap_mm = kWallMm - 2.0;
        restore();
        for (int k = 0; k < 4; ++k)
            tick();
    }

    // The time of one tick, s.
    double tick() {
        if (++ticks_ % kTicksARestore == 0) restore();
        const double depth_mm = 1.0 + 0.2 * ((ticks_ % 16) / 7.5 - 1.0);
        input_.position_mm = {kOuterMm + radius_mm_ - depth_mm, kHandMm + 0.013, 0.0};
        const auto start = std::chrono::steady_clock::now();
        const StudioForces forces = clay_.tick(input_, parameters_);
        const auto end = std::chrono::steady_clock::now();
        contacts_ = forces.hand.contacts;
        second_contacts_ = forces.second.contacts;
        // A wall yields as a whole in every other tick at most.
        changed_ = std::max(changed_, forces.hand.touched_count);
        return std::chrono::duration<double>(end - start).count();
    }

    [[nodiscard]] const char* complaint() const {
        if (hands_ == Hands::kNone) return contacts_ != 0 ? "a hand touches the wall" : nullptr;
        if (contacts_ < 20) return "the hand does not touch the wall";
        if (hands_ == Hands::kPinch && second_contacts_ < 10)
            return "the second hand does not touch the wall";
        if (hands_ != Hands::kPinch && changed_ < 2 * contacts_)
            return "the wall did not give way as a whole";
        if (clay_.ledger_error_mm3() != 0.0) return "clay was lost";
        return nullptr;
    }
    [[nodiscard]] int contacts() const { return contacts_; }

  private:
    using StudioForces = clay::StudioForces;

    void restore() {
        clay_.set_wall(kOuterMm, kWallMm, 12.0, 200.0, rings_);
        clay_.set_wheel_speed(kWheelRadS);
        if (hands_ != Hands::kOneOnRoughRows) return;
        // A standing wheel dents every row the hand reaches.
        input_.position_mm = {kOuterMm + radius_mm_ - 2.0, kHandMm, 0.0};
        clay_.set_wheel_speed(0.0);
        input_.wheel_button = false;
        for (int k = 0; k < 20; ++k)
            clay_.tick(input_, parameters_);
        input_.wheel_button = true;
        clay_.set_wheel_speed(kWheelRadS);
    }

    clay::StudioClay clay_;
    tool::ToolState input_;
    clay::StudioParameters parameters_;
    Hands hands_;
    int rings_;
    double radius_mm_;
    int ticks_ = 0;
    int contacts_ = 0;
    int second_contacts_ = 0;
    int changed_ = 0;
};

void run(benchmark::State& state, Hands hands) {
    StudioTickCase wall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                        static_cast<double>(state.range(2)), hands);
    std::vector<double> seconds;
    seconds.reserve(1U << 20U);
    for ([[maybe_unused]] auto iteration : state) {
        const double taken = wall.tick();
        state.SetIterationTime(taken);
        if (seconds.size() < seconds.capacity()) seconds.push_back(taken);
    }
    if (const char* complaint = wall.complaint()) {
        fail(state, complaint);
        return;
    }
    std::sort(seconds.begin(), seconds.end());
    const auto percentile = [&](double part) {
        return 1e9 * seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1))];
    };
    state.counters["p50_ns"] = percentile(0.50);
    state.counters["p99_ns"] = percentile(0.99);
    state.counters["contacts"] = wall.contacts();
}

void studio_tick(benchmark::State& state) {
    run(state, Hands::kOne);
}

void studio_tick_pinch(benchmark::State& state) {
    run(state, Hands::kPinch);
}

void studio_tick_idle(benchmark::State& state) {
    run(state, Hands::kNone);
}

void studio_tick_rough(benchmark::State& state) {
    run(state, Hands::kOneOnRoughRows);
}

// The default first; then against N, S and the radius, one at a time.
BENCHMARK(studio_tick)
    ->Args({2000, 256, 10})
    ->Args({1000, 256, 10})
    ->Args({4000, 256, 10})
    ->Args({2000, 64, 10})
    ->Args({2000, 256, 5})
    ->Args({2000, 256, 20})
    ->Args({2000, 256, 40})
    ->UseManualTime();
BENCHMARK(studio_tick_idle)->Args({2000, 256, 10})->UseManualTime();
BENCHMARK(studio_tick_pinch)->Args({2000, 256, 10})->UseManualTime();
BENCHMARK(studio_tick_rough)->Args({2000, 256, 10})->Args({2000, 64, 10})->UseManualTime();

}  // namespace
}  // namespace onggi::bench
