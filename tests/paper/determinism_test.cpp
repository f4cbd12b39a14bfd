// The same movement gives the same bits: in Debug and Release, with g++ and clang++, with every kernel.
#include <gtest/gtest.h>

#include "engine/core/hash.h"
#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

constexpr KernelVariant kVariants[] = {KernelVariant::kPlain, KernelVariant::kWide};

// The state after a gesture, and every force during it.
struct Outcome {
    std::uint64_t state = 0;
    std::uint64_t forces = 0;

    friend bool operator==(const Outcome&, const Outcome&) = default;
};

void add(StateHash& hash, const ContactForces& forces) {
    hash.add_word(static_cast<std::uint64_t>(forces.contacts));
    hash.add_word(static_cast<std::uint64_t>(forces.first_touched));
    hash.add_word(static_cast<std::uint64_t>(forces.touched_count));
    for (const dvec3& part : {forces.stiffness_n, forces.viscosity_n, forces.friction_n}) {
        hash.add(part.x);
        hash.add(part.y);
        hash.add(part.z);
    }
}

Outcome play(PaperClay clay, std::span<const ToolInput> gesture, const PaperParameters& parameters) {
    StateHash forces;
    for (const ToolInput& tool : gesture)
        add(forces, clay.tick(tool, parameters));
    return {clay.state_hash(), forces.value()};
}

// An intended change of the equations changes these values and every stored session: raise the session
// version.
TEST(Determinism, GivesTheBitsItAlwaysGave) {
    const Outcome vase = play(PaperClay(), vase_gesture(1000.0), {});
    EXPECT_EQ(vase.state, 0x926c7c2389d40d9bULL) << std::hex << "found 0x" << vase.state;
    EXPECT_EQ(vase.forces, 0x49cac5e86e9a3dc1ULL) << std::hex << "found 0x" << vase.forces;

    const PaperParameters fast{.rate_hz = 4000.0};  // with our own power function
    const Outcome finer = play(PaperClay({.element_count = 3001}), vase_gesture(4000.0), fast);
    EXPECT_EQ(finer.state, 0x17c2d05f4b97f49aULL) << std::hex << "found 0x" << finer.state;
    EXPECT_EQ(finer.forces, 0x7b2381430770e2e7ULL) << std::hex << "found 0x" << finer.forces;
}

TEST(Determinism, HoldsForEveryKernel) {
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U}) {
        const std::vector<ToolInput> gesture = random_gesture(seed, 10000);
        for (const int element_count : {100, 1003, 2000, 5006}) {
            PaperClay clay({.element_count = element_count});
            clay.use_kernel(KernelVariant::kPlain);
            const Outcome expected = play(clay, gesture, {.rate_hz = 1500.0});
            for (const KernelVariant variant : kVariants) {
                if (!is_supported(variant)) continue;
                clay.use_kernel(variant);
                EXPECT_EQ(play(clay, gesture, {.rate_hz = 1500.0}), expected)
                    << name(variant) << ", seed " << seed << ", " << element_count << " elements";
            }
        }
    }
}

TEST(Determinism, HoldsAcrossASavedState) {
    const std::vector<ToolInput> gesture = random_gesture(21, 12000);
    const std::span<const ToolInput> all(gesture);
    for (const std::size_t cut : {0U, 1U, 777U, 6001U}) {
        PaperClay clay;
        for (const ToolInput& tool : all.first(cut))
            clay.tick(tool, {});
        const auto restored = PaperClay::from_start_state(clay.start_state());
        ASSERT_TRUE(restored) << restored.error().message;
        EXPECT_EQ(restored->state_hash(), clay.state_hash());
        EXPECT_EQ(play(*restored, all.subspan(cut), {}), play(clay, all.subspan(cut), {}))
            << "cut at " << cut;
    }
}

TEST(Determinism, DoesNotDependOnTheCachedFraction) {
    // The fraction of Eq. (2) is kept while tool and rate stay: going back and forth must not change a bit.
    const ToolInput large = tool_in_wall(1.0, true, 20.0);
    const ToolInput small = tool_in_wall(1.0, true, 5.0, 150.0);
    const PaperParameters parameters{.rate_hz = 3333.0};
    PaperClay remembering;
    for (int tick = 0; tick < 100; ++tick)
        remembering.tick(tick % 3 == 0 ? small : large, parameters);
    PaperClay forgetting;
    for (int tick = 0; tick < 100; ++tick) {
        forgetting = *PaperClay::from_start_state(forgetting.start_state());
        forgetting.tick(tick % 3 == 0 ? small : large, parameters);
    }
    EXPECT_EQ(remembering.state_hash(), forgetting.state_hash());
}

}  // namespace
}  // namespace onggi::clay
