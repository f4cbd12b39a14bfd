// The copy of moving clay for the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "game/haptic/pot_copy.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {
namespace {

// One finger that opens a lump and draws the wall far out, the same at every rate.
tool::ToolState finger_at(double t_s) {
    struct Place {
        double t_s;
        dvec2 at_mm;
        bool pressing;
    };
    constexpr std::array kWay{Place{0.0, {0.0, 52.0}, false}, Place{0.1, {0.0, 50.0}, true},
                              Place{1.5, {0.0, 15.0}, true},  Place{2.3, {30.0, 15.0}, false},
                              Place{2.5, {62.0, 40.0}, true}, Place{3.5, {110.0, 45.0}, true}};
    std::size_t i = 1;
    while (i + 1 < kWay.size() && kWay[i].t_s <= t_s)
        ++i;
    const double fraction = std::clamp((t_s - kWay[i - 1].t_s) / (kWay[i].t_s - kWay[i - 1].t_s), 0.0, 1.0);
    tool::ToolState tool;
    tool.guided = true;
    tool.pressing = kWay[i - 1].pressing;
    tool.position_mm = dvec3(glm::mix(kWay[i - 1].at_mm, kWay[i].at_mm, fraction), 0.0);
    tool.wheel_button = true;
    tool.water = 0.5;
    return tool;
}

class PotCopies : public testing::TestWithParam<double> {
  protected:
    PotCopies() { parameters_.set_rate_hz(GetParam()); }
    // Whether a copy was finished in this tick.
    bool copies_after(const tool::ToolState& tool) {
        tick(state_, tool, parameters_);
        return copier_.step(pot_, state_, parameters_.dt_s());
    }

    HapticParameters parameters_;
    HapticState state_{clay::StudioClay(clay::StudioLump{})};
    pot::Pot pot_ = pot_of(state_);
    PotCopier copier_;
};

TEST_P(PotCopies, AreOfOneMomentHoweverTheClayMoves) {
    double last_widest_mm = 0.0;
    int moved = 0;
    for (double t_s = 0.0; t_s < 3.5; t_s += parameters_.dt_s()) {
        if (!copies_after(finger_at(t_s))) continue;
        const clay::studio::Rings& rings = state_.studio()->rings();
        ASSERT_EQ(pot_.ring_count(), rings.count);
        ASSERT_EQ(pot_.height_mm, rings.top_mm());
        for (int i = 0; i < rings.count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            ASSERT_EQ(pot_.outer_mm[at], static_cast<float>(rings.outer_mm[at])) << t_s << " s, ring " << i;
            ASSERT_EQ(pot_.inner_mm[at], static_cast<float>(rings.inner_mm[at])) << t_s << " s, ring " << i;
            ASSERT_EQ(pot_.top_mm[at], static_cast<float>(rings.bottom_mm(i) + rings.height_mm[at]));
        }
        const double widest_mm =
            *std::max_element(rings.outer_mm.begin(), rings.outer_mm.begin() + rings.count);
        if (std::abs(widest_mm - last_widest_mm) > 0.1) ++moved;
        last_widest_mm = widest_mm;
    }
    EXPECT_GT(moved, 20) << "or nothing was tried";
}

TEST_P(PotCopies, ComeTwiceAFrame) {
    int finished = 0;
    for (double t_s = 0.0; t_s < 1.0; t_s += parameters_.dt_s()) {
        finished += copies_after(finger_at(0.0)) ? 1 : 0;
    }
    EXPECT_GE(finished, 110);
    EXPECT_LE(finished, 130);
}

INSTANTIATE_TEST_SUITE_P(OfBothRates, PotCopies, testing::Values(1000.0, 4000.0),
                         [](const auto& tested) { return std::to_string(static_cast<int>(tested.param)); });

}  // namespace
}  // namespace onggi::haptic
