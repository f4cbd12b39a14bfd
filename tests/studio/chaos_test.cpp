// Two wild hands, every tool, wires and fresh lumps: the ledger stays at zero and no ring leaves its bounds.
#include <cstdlib>
#include <random>
#include <string>

#include "tests/studio/bench.h"

namespace onggi::clay::studio {
namespace {

#ifdef NDEBUG
constexpr int kTicks = 1000000;
constexpr int kTicksASeed = 20000;
#else
constexpr int kTicks = 100000;
constexpr int kTicksASeed = 1000;
#endif
constexpr unsigned kSeeds = 50;

struct Wildness {
    std::uint64_t splits = 0;
    std::uint64_t joins = 0;
    int lumps = 0;
    int wires = 0;
};

// Throws wildly for `ticks` ticks; test failures are fatal here.
void throw_wildly(unsigned seed, int ticks, Wildness& seen) {
    Bench bench({.mass_g = 1000.0, .rings = 1000, .sectors = 64});
    bench.parameters.wheel = WheelParameters();  // which a hand slows
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::array<dvec3, 2> goal{};
    std::array<dvec3, 2> place{dvec3(0.0, 200.0, 0.0), dvec3(0.0, 200.0, 0.0)};
    for (int k = 0; k < ticks; ++k) {
        if (k % 500 == 0) {
            for (std::size_t h = 0; h < 2; ++h) {
                const double spread = uniform(5.0, 90.0);
                goal[h] = {uniform(-spread, spread), uniform(-20.0, 250.0), uniform(-spread, spread)};
                if (random() % 20 == 0) place[h] = goal[h];  // a jump
            }
            const bool is_first = random() % 2 == 0;
            (is_first ? bench.input.radius_mm : bench.input.second.radius_mm) = uniform(2.0, 40.0);
            (is_first ? bench.input.tool : bench.input.second.tool) =
                static_cast<tool::Tool>(random() % 8 == 0 ? random() % tool::kClayTools : 0);
            bench.input.second.present = random() % 3 != 0;
            bench.input.assist_gap_mm = random() % 3 == 0 ? uniform(2.0, 12.0) : 0.0;
            bench.pedal(random() % 8 == 0 ? 0.0 : uniform(2.0, 25.0));
            bench.input.water = random() % 2 == 0 ? 1.0 : 0.0;
            bench.parameters.sponge_water_ml_s = random() % 2 == 0 ? uniform(0.0, 2.0) : 0.0;
            bench.input.shaft_mm = random() % 4 == 0 ? 9.0 : 0.0;
        }
        if (random() % 20000 == 0) {
            bench.input.wire = tool::Wire::kCutRim;
            bench.input.wire_height_mm = uniform(0.2, 1.1) * bench.clay.height_mm();
            ++seen.wires;
        } else {
            bench.input.wire = tool::Wire::kNone;
        }
        if (random() % 40000 == 0 || bench.clay.ring_count() < 20 || bench.clay.height_mm() < 8.0) {
            seen.splits += bench.clay.splits();
            seen.joins += bench.clay.joins();
            bench.clay.restart();
            ++seen.lumps;
        }
        for (std::size_t h = 0; h < 2; ++h)
            place[h] += (goal[h] - place[h]) * 0.01;
        bench.input.position_mm = place[0];
        bench.input.second.position_mm = place[1];
        const StudioForces forces = bench.tick();
        const dvec3 total = forces.total_n();
        ASSERT_TRUE(std::isfinite(total.x) && std::isfinite(total.y) && std::isfinite(total.z))
            << "seed " << seed << ", tick " << k;
        if (k % 1000 == 0) {
            ASSERT_EQ(bench.clay.ledger_error_mm3(), 0.0) << "seed " << seed << ", tick " << k;
            expect_sound(bench.clay);
            if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed << ", tick " << k;
        }
    }
    seen.splits += bench.clay.splits();
    seen.joins += bench.clay.joins();
    ASSERT_EQ(bench.clay.ledger_error_mm3(), 0.0) << "seed " << seed;
}

void print(const char* what, const Wildness& seen) {
    std::printf("%s: %llu splits, %llu joins, %d lumps, %d wires\n", what,
                static_cast<unsigned long long>(seen.splits), static_cast<unsigned long long>(seen.joins),
                seen.lumps, seen.wires);
}

TEST(Chaos, TheLedgerErrorIsExactlyZeroAfterAMillionTicks) {
    Wildness seen;
    throw_wildly(20240229, kTicks, seen);
    print("one long throw", seen);
    EXPECT_GT(seen.splits, 100U);
    EXPECT_GT(seen.joins, 100U);
    EXPECT_GT(seen.wires, 1);
}

// Fifty seeds, each for as many ticks as a check has time for: a million between them. ONGGI_CHAOS_TICKS sets
// how many each gets; README.md says how to give each a million.
TEST(Chaos, FiftySeedsLoseNoClay) {
    const char* wanted = std::getenv("ONGGI_CHAOS_TICKS");
    const int ticks = wanted != nullptr ? std::stoi(wanted) : kTicksASeed;
    Wildness seen;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        throw_wildly(seed, ticks, seen);
        if (testing::Test::HasFatalFailure()) return;
    }
    print("fifty seeds", seen);
    EXPECT_GT(seen.splits, 50U);
    EXPECT_GT(seen.joins, 50U);
}

}  // namespace
}  // namespace onggi::clay::studio
