#include "game/screens/pots/pot_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "game/screens/pots/pot_samples.h"
#include "game/screens/pots/pot_shading.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

struct Mean {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;
    int count = 0;
};

Mean mean_of(const ui::Painting& painting, int left, int right) {
    Mean mean;
    for (int y = 0; y < painting.height; ++y) {
        for (int x = left; x < right; ++x) {
            const std::uint8_t* pixel = painting.rgba.data() + (y * painting.width + x) * 4;
            if (pixel[3] < 255) continue;
            mean.r += pixel[0], mean.g += pixel[1], mean.b += pixel[2];
            ++mean.count;
        }
    }
    mean.r /= mean.count, mean.g /= mean.count, mean.b /= mean.count;
    return mean;
}

const pot::Section& moon_jar() {
    return sample_exhibits()->at(3).shape;
}

TEST(PotPicture, IsAsLargeAsThePot) {
    const PotPicture picture = paint_pot(moon_jar(), finish::glaze_at(1), 1.0F, 0.12F);
    EXPECT_NEAR(static_cast<float>(picture.painting.width), 2.0F * 151.0F, 8.0F);
    EXPECT_NEAR(static_cast<float>(picture.painting.height),
                305.0F * std::cos(0.12F) + 151.0F * std::sin(0.12F) * 2.0F, 10.0F);
    EXPECT_NEAR(picture.foot_px.x, 0.5F * static_cast<float>(picture.painting.width), 1.0F);
}

TEST(PotPicture, IsSampledAlikeInBandsAndAtOnce) {
    constexpr float kPxPerMm = 1.3F;
    const PotView view(moon_jar(), kPxPerMm, 0.3F);
    const PotSamples whole = view.samples();
    const int height_px = whole.height / kScreenSamples;
    int covered = 0;
    for (int top_px = 0; top_px < height_px; top_px += 100) {
        const PotSamples band = view.samples({top_px, 100});
        ASSERT_EQ(band.width, whole.width);
        ASSERT_EQ(band.height, std::min(100, height_px - top_px) * kScreenSamples);
        const auto first =
            static_cast<std::size_t>(top_px * kScreenSamples) * static_cast<std::size_t>(whole.width);
        for (std::size_t i = 0; i < band.covered.size(); ++i) {
            ASSERT_EQ(band.covered[i], whole.covered[first + i]) << top_px << ", " << i;
            if (band.covered[i] == 0) continue;
            ++covered;
            ASSERT_EQ(band.surface[i].height_mm, whole.surface[first + i].height_mm) << top_px << ", " << i;
            ASSERT_EQ(band.surface[i].angle, whole.surface[first + i].angle) << top_px << ", " << i;
        }
    }
    EXPECT_GT(covered, 100'000);
}

TEST(PotPicture, ShowsTheRimAsTheFlatRingThatItIs) {
    const pot::Section cup = pot::hollowed({{40, 0}, {50, 50}, {45, 100}}, 8.0F, 8.0F);
    const PotSamples samples = PotView(cup, 2.0F, 0.6F).samples();
    int on_rim = 0;
    int not_flat = 0;
    for (std::size_t i = 0; i < samples.covered.size(); ++i) {
        if (samples.covered[i] == 0 || samples.surface[i].height_mm < 99.999F) continue;
        ++on_rim;
        if (samples.surface[i].normal.y < 0.99999F) ++not_flat;
    }
    EXPECT_GT(on_rim, 10'000) << "of 2,061 mm2, seen from 34 degrees above, 16 samples a mm2";
    EXPECT_LT(not_flat, 20) << "on the very edge of the wall";
}

// As a wall that collapses: ridges finer than a pixel, which few samples break into dots.
TEST(PotPicture, ThatLeavesShowsRidgesFinerThanItsPixels) {
    pot::Section ridged;
    for (int i = 0; i <= 300; ++i)
        ridged.outside.push_back({60.0F + 1.2F * static_cast<float>(i % 2), 0.4F * static_cast<float>(i)});
    const auto painted = [&](int samples_across) {
        return paint_pot(ridged, finish::glaze_at(5), 1.0F, 0.2F, 0.0, samples_across).painting;
    };
    constexpr int kExact = 16;
    const ui::Painting exact = painted(kExact);
    const auto off = [&](int samples_across) {
        const ui::Painting painting = painted(samples_across);
        double sum = 0.0;
        for (std::size_t i = 0; i < exact.rgba.size(); i += 4)
            sum += std::abs(int{painting.rgba[i]} - int{exact.rgba[i]});
        return sum;
    };
    EXPECT_LT(off(kLeavingSamples), 0.6 * off(kScreenSamples));
}

TEST(PotPicture, IsWholeWithNoHoleInItsMiddle) {
    const PotPicture picture = paint_pot(moon_jar(), finish::glaze_at(1), 1.0F, 0.12F);
    const int x = picture.painting.width / 2;
    int first = -1;
    int last = -1;
    int covered = 0;
    for (int y = 0; y < picture.painting.height; ++y) {
        if (picture.painting.rgba[static_cast<std::size_t>(y * picture.painting.width + x) * 4 + 3] < 200)
            continue;
        if (first < 0) first = y;
        last = y;
        ++covered;
    }
    EXPECT_EQ(covered, last - first + 1);
    EXPECT_GT(covered, 290);
}

TEST(PotPicture, IsLitFromTheLeft) {
    const ui::Painting painting = paint_pot(moon_jar(), finish::glaze_at(5), 1.0F, 0.12F).painting;
    const Mean left = mean_of(painting, painting.width / 8, 3 * painting.width / 8);
    const Mean right = mean_of(painting, 5 * painting.width / 8, 7 * painting.width / 8);
    EXPECT_GT(left.g, right.g + 10.0);
}

// What lies behind the pot is no window.
TEST(PotPicture, ReflectsTheWindowInFrontAlone) {
    constexpr float kElevationRad = 0.15F;
    const PotShading shading(finish::glaze_at(0), 100.0F, kElevationRad, DrawnOn(moon_jar()));
    const vec3 to_eye(0.0F, std::sin(kElevationRad), std::cos(kElevationRad));
    int behind = 0;
    float brightest = 0.0F;
    for (float turn = -1.55F; turn < 1.55F; turn += 0.05F) {
        for (float up = -1.5F; up < 1.5F; up += 0.05F) {
            const vec3 normal(std::cos(up) * std::sin(turn), std::sin(up), std::cos(up) * std::cos(turn));
            const vec3 seen = glm::reflect(-to_eye, normal);
            if (glm::dot(normal, to_eye) < 0.0F || seen.z > -0.1F) continue;
            ++behind;
            brightest = std::max(brightest, shading.light({.height_mm = 80.0F, .normal = normal}).gloss.y);
        }
    }
    EXPECT_GT(behind, 100);
    EXPECT_LT(brightest, 0.25F) << "as bright as the room, not as its window";
}

TEST(PotPicture, ShowsSixGlazesThatDiffer) {
    std::vector<Mean> means;
    for (int glaze = 0; glaze < finish::kGlazeCount; ++glaze) {
        const ui::Painting painting = paint_pot(moon_jar(), finish::glaze_at(glaze), 0.5F, 0.12F).painting;
        means.push_back(mean_of(painting, 0, painting.width));
        for (int other = 0; other < glaze; ++other) {
            const Mean& a = means[static_cast<std::size_t>(other)];
            const Mean& b = means.back();
            EXPECT_GT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 18.0)
                << glaze << ' ' << other;
        }
    }
    EXPECT_GT(means[0].g, means[0].r) << "celadon is green";
    EXPECT_GT(means[1].r, 160.0) << "porcelain is white";
    EXPECT_LT(means[3].g, 90.0) << "iron is dark";
    EXPECT_GT(means[5].r, means[5].b + 40.0) << "bare clay is warm";
}

TEST(PotPicture, IsTheSameEachTime) {
    EXPECT_EQ(paint_pot(moon_jar(), finish::glaze_at(4), 0.4F, 0.12F).painting.rgba,
              paint_pot(moon_jar(), finish::glaze_at(4), 0.4F, 0.12F).painting.rgba);
}

TEST(PotPicture, HollowsAnOutline) {
    const pot::Section shape = pot::hollowed({{40, 0}, {50, 50}, {45, 100}}, 5.0F, 8.0F);
    ASSERT_GE(shape.inside.size(), 3U);
    EXPECT_EQ(shape.inside.front(), vec2(40.0F, 100.0F));
    EXPECT_EQ(shape.inside.back(), vec2(0.0F, 8.0F));
    EXPECT_TRUE(pot::hollowed({{3, 0}, {3, 50}}, 5.0F, 8.0F).inside.empty()) << "too thin to be hollow";
}

}  // namespace
}  // namespace onggi::screens
