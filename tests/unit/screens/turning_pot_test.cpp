// A turning pot: at rest as painted; its colours rotate while its light stays.
#include "game/screens/pots/turning_pot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

const pot::Section& bowl() {
    return sample_exhibits()->at(0).shape;
}

// The mean difference of two pictures of one size, in levels, where both show pot.
double difference(const ui::Painting& a, const ui::Painting& b) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t at = 0; at < a.rgba.size(); at += 4) {
        if (a.rgba[at + 3] < 255 || b.rgba[at + 3] < 255) continue;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum += std::abs(int{a.rgba[at + channel]} - int{b.rgba[at + channel]});
        count += 3;
    }
    return count == 0 ? 255.0 : sum / count;
}

// Each sample shaded by itself, with no table of colours in between.
ui::Painting shaded_by_sample(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                              float elevation_rad) {
    const DrawnOn drawn_on(shape);
    const PotShading shading(glaze, shape.height_mm(), elevation_rad, drawn_on);
    const PotView view(shape, px_per_mm, elevation_rad);
    const PotSamples samples = view.samples();
    constexpr int kSamples = kScreenSamples * kScreenSamples;
    ui::Painting painting{.width = view.extent().width_px, .height = view.extent().height_px, .rgba = {}};
    for (int y = 0; y < painting.height; ++y) {
        for (int x = 0; x < painting.width; ++x) {
            vec3 sum(0.0F);
            const int count = samples.visit_pixel(x, y, [&](const PotSurface& surface) {
                const PotLight light = shading.light(surface);
                sum += encoded_pot_light(shading.colour(surface) * light.factor + light.gloss);
            });
            for (int channel = 0; channel < 3; ++channel)
                painting.rgba.push_back(static_cast<std::uint8_t>(sum[channel] * 255.0F / kSamples + 0.5F));
            painting.rgba.push_back(static_cast<std::uint8_t>(count * 255 / kSamples));
        }
    }
    return painting;
}

TEST(TurningPot, StandsAsItsSamplesLook) {
    for (int glaze = 0; glaze < finish::kGlazeCount; ++glaze) {
        const ui::Painting shaded = shaded_by_sample(bowl(), finish::glaze_at(glaze), 1.4F, 0.12F);
        const auto painting = TurningPot(bowl(), finish::glaze_at(glaze), 1.4F, 0.12F).at(0.0);
        ASSERT_EQ(painting->width, shaded.width);
        ASSERT_EQ(painting->height, shaded.height);
        // Brushed slip has lines finer than pixels.
        const bool is_fine = finish::glaze_at(glaze).id == "buncheong";
        EXPECT_LT(difference(*painting, shaded), is_fine ? 8.0 : 1.0) << finish::glaze_at(glaze).id;
    }
}

TEST(TurningPot, HasNoStepsInItsRings) {
    constexpr int kBrushedSlip = 2;  // thin dark lines round it
    const auto painting =
        TurningPot(sample_exhibits()->at(3).shape, finish::glaze_at(kBrushedSlip), 1.2F, 0.12F).at(0.0);
    int steps = 0;
    int count = 0;
    for (int y = painting->height / 4; y < 3 * painting->height / 4; ++y) {
        for (int x = painting->width / 4; x < 3 * painting->width / 4; ++x, ++count) {
            const std::uint8_t* const here = painting->rgba.data() + 4 * (y * painting->width + x);
            steps += std::abs(int{here[1]} - int{here[5]}) > 24 ? 1 : 0;
        }
    }
    EXPECT_LT(steps, count / 1000) << "levels between neighbours of a row of pixels";
}

// The pot with its rim beside the axis, and a dent.
pot::Section bent_bowl() {
    pot::OffRound map{.centre_mm = {{0.0F, 0.0F}, {6.0F, 0.0F}},
                      .dents_mm = std::vector<float>(2 * pot::OffRound::kCorners, 0.0F)};
    map.dents_mm[pot::OffRound::kCorners + 32] = -5.0F;
    pot::Section shape = bowl();
    shape.off_round = std::make_shared<const pot::OffRound>(std::move(map));
    return shape;
}

// The middle of the topmost rows that show pot, pixels.
float rim_middle_px(const ui::Painting& painting) {
    float sum = 0.0F;
    int count = 0;
    for (int y = 0; y < painting.height / 3; ++y) {
        for (int x = 0; x < painting.width; ++x) {
            if (painting.rgba[static_cast<std::size_t>(4 * (y * painting.width + x) + 3)] < 128) continue;
            sum += static_cast<float>(x);
            ++count;
        }
    }
    return sum / static_cast<float>(std::max(count, 1));
}

TEST(TurningPot, SwaysWhereItIsNotRound) {
    const TurningPot turning(bent_bowl(), finish::glaze_at(2), 1.0F, 0.12F);
    const float middle_px = turning.foot_px().x;
    // At rest the clay's direction 0 is to the right; the pot turns as its colours do.
    EXPECT_GT(rim_middle_px(*turning.at(0.0)), middle_px + 2.0F);
    EXPECT_LT(rim_middle_px(*turning.at(0.5)), middle_px - 2.0F);
    EXPECT_NEAR(rim_middle_px(*turning.at(0.25)), middle_px, 1.5F);
    EXPECT_EQ(turning.at(1.0)->rgba, turning.at(0.0)->rgba);
    const PotPicture still = paint_pot(bent_bowl(), finish::glaze_at(2), 1.0F, 0.12F, 0.5);
    EXPECT_EQ(turning.at(0.5)->rgba, still.painting.rgba);
}

TEST(TurningPot, ComesBackAfterAWholeTurn) {
    const TurningPot turning(bowl(), finish::glaze_at(4), 1.0F, 0.12F);
    EXPECT_EQ(turning.at(0.25)->rgba, turning.at(1.25)->rgba);
    EXPECT_EQ(turning.at(0.0)->rgba, turning.at(3.0)->rgba);
}

TEST(TurningPot, MovesALittleInALittleTimeAndHasNoSeam) {
    const TurningPot turning(bowl(), finish::glaze_at(2), 1.0F, 0.12F);
    constexpr int kSteps = 72;
    const double quarter = difference(*turning.at(0.0), *turning.at(0.25));
    EXPECT_GT(quarter, 1.5);
    for (int step = 0; step < kSteps; ++step) {
        const double moved = difference(*turning.at(static_cast<double>(step) / kSteps),
                                        *turning.at(static_cast<double>(step + 1) / kSteps));
        EXPECT_LT(moved, 0.75 * quarter) << step;
    }
}

TEST(TurningPot, KeepsItsLightWhereTheWindowIs) {
    const TurningPot turning(bowl(), finish::glaze_at(5), 1.0F, 0.12F);
    for (const double turn : {0.0, 0.3, 0.6}) {
        const auto painting = turning.at(turn);
        double left = 0.0;
        double right = 0.0;
        for (int y = 0; y < painting->height; ++y) {
            for (int x = 0; x < painting->width; ++x) {
                const std::size_t at =
                    4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(painting->width) +
                         static_cast<std::size_t>(x));
                (x < painting->width / 2 ? left : right) += painting->rgba[at + 1];
            }
        }
        EXPECT_GT(left, 1.05 * right);
    }
}

}  // namespace
}  // namespace onggi::screens
