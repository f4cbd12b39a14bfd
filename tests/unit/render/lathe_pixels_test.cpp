// tests/golden/backends_agree_test.cpp compares with the shader; here, coverage, and cases of light with
// known results.
#include "engine/render/pixels/lathe_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/render/shapes/detail_texture.h"
#include "tests/unit/render/exact_screen.h"
#include "tests/unit/render/triangle_pixels.h"

namespace onggi::render {
namespace {

namespace value = lathe_value;
constexpr float kAwayMm = 500.0F;

float shown(float light) {
    return static_cast<float>(255.0 * exact_shown(double{light}));
}

// A wall that faces the eye, lit from the front.
class LathePixels : public TrianglePixels {
  protected:
    LathePixels() {
        frame_.key_direction = vec4(0.0F, 0.0F, 1.0F, 0.05F);
        for (vec4& sphere : frame_.spheres)
            sphere = vec4(0.0F, -1e6F, 0.0F, 1e-3F);
        draw_.gloss = vec4(1.0F, 1.0F, 0.5F, 0.0F);
        draw_.turn = vec4(0.0F, 2.0F, 0.04F, 10.0F);
        draw_.wet.w = 0.1F;
        normals_->fill(0x7FFFFFFFU);  // straight out
        streaks_.fill(0x80808080U);
    }
    void draw(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
              std::size_t plain) {
        draw(corners, indices, plain, {.size = {kWidth, kHeight}, .pixels = pixels_, .depth = depth_});
    }
    void draw(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices, std::size_t plain,
              const PictureCanvas& canvas) {
        draw_lathe(corners, indices, plain,
                   {.frame = frame_,
                    .draw = draw_,
                    .normals = *normals_,
                    .streaks = streaks_,
                    .streak_size = {4, 4},
                    .order = order_,
                    .shows_load = shows_load_},
                   canvas);
    }
    void draw(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices) {
        draw(corners, indices, indices.size());
    }
    static LatheCorner corner(float x, float y, float depth = 0.5F) {
        LatheCorner made{.at_px = {x, y}, .away_mm = kAwayMm, .depth = depth};
        made.values[value::kToEye + 2] = 1.0F;
        made.values[value::kOutward + 1] = 1.0F;
        made.values[value::kSeen] = 1.0F;
        made.values[value::kHalf] = 0.5F;
        made.values[value::kNear] = 1.0F / kAwayMm;
        made.values[value::kDepth] = depth;
        return made;
    }
    // Two triangles over all of the picture and beyond it.
    static std::vector<LatheCorner> sheet(float depth = 0.5F) {
        return {corner(-50.0F, -50.0F, depth), corner(-50.0F, 200.0F, depth), corner(200.0F, -50.0F, depth),
                corner(200.0F, 200.0F, depth)};
    }
    // The red of a sheet's middle with some of its values.
    float red(std::initializer_list<std::pair<std::size_t, float>> values, bool is_near_spheres = false) {
        std::fill(depth_.begin(), depth_.end(), 1.0F);
        std::vector<LatheCorner> corners = sheet();
        for (LatheCorner& own : corners) {
            for (const auto& [number, amount] : values)
                own.values[number] = amount;
        }
        draw(corners, kSheet, is_near_spheres ? 0 : kSheet.size());
        return static_cast<float>(at(30, 20) & 255U);
    }

    static constexpr std::array<std::uint16_t, 6> kSheet{0, 1, 2, 2, 1, 3};
    shaders::FrameData frame_{};
    shaders::LatheDraw draw_{};
    std::unique_ptr<NormalTexels> normals_ = std::make_unique<NormalTexels>();
    static constexpr std::size_t kStreakTexels = 4 * 4;  // of a level
    std::array<std::uint32_t, kStreakLevels * kStreakTexels> streaks_{};
    ByteOrder order_ = ByteOrder::kRedFirst;
    bool shows_load_ = false;
};

TEST_F(LathePixels, AreThoseWhoseMiddleATriangleHoldsThatLooksAtTheEye) {
    const int covered = expect_those_inside({.clockwise = false}, [&](const std::array<vec2, 3>& at) {
        const std::array corners{corner(at[0].x, at[0].y), corner(at[1].x, at[1].y),
                                 corner(at[2].x, at[2].y)};
        draw(corners, std::array<std::uint16_t, 3>{0, 1, 2});
    });
    EXPECT_GT(covered, 20000);
}

TEST_F(LathePixels, AreTheSameInBands) {
    std::vector<LatheCorner> corners = sheet();
    for (LatheCorner& own : corners) {
        own.values[value::kAmbient] = 0.0013F * (own.at_px.x + 50.0F);
        own.values[value::kAmbient + 1] = 0.0017F * (own.at_px.y + 50.0F);
        own.values[value::kDepth] = 0.3F + 0.0011F * own.at_px.x + 0.0001F * own.at_px.y;
    }
    // Over the right border, with slanting edges inside.
    corners[0].at_px = {20.3F, 0.6F};
    corners[1].at_px = {2.1F, 42.2F};
    corners[2].at_px = {150.0F, 20.4F};
    expect_the_same_in_bands(
        [&](const PictureCanvas& canvas) { draw(corners, std::span(kSheet).first(3), 3, canvas); });
}

TEST_F(LathePixels, GrowEvenlyBetweenTheCornersWhicheverBlockTheyAreIn) {
    std::vector<LatheCorner> corners = sheet();
    for (LatheCorner& own : corners) {
        own.values[value::kAmbient] = 0.001F * (own.at_px.x + 50.0F);
        own.values[value::kAmbient + 1] = 0.001F * (own.at_px.y + 50.0F);
        own.values[value::kAmbient + 2] = 0.1F;
        own.values[value::kDepth] = 0.3F + 0.001F * own.at_px.x + 0.0001F * own.at_px.y;
    }
    for (const ByteOrder order : {ByteOrder::kRedFirst, ByteOrder::kBlueFirst}) {
        order_ = order;
        std::fill(depth_.begin(), depth_.end(), 1.0F);
        draw(corners, kSheet);
        const unsigned of_red = order == ByteOrder::kRedFirst ? 0U : 16U;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const float across = static_cast<float>(x) + 0.5F;
                const float down = static_cast<float>(y) + 0.5F;
                ASSERT_NEAR(at(x, y) >> of_red & 255U, shown(0.001F * (across + 50.0F)), 0.6F) << x;
                ASSERT_NEAR(at(x, y) >> 8U & 255U, shown(0.001F * (down + 50.0F)), 0.6F) << y;
                ASSERT_NEAR(at(x, y) >> (16U - of_red) & 255U, shown(0.1F), 0.6F);
                ASSERT_EQ(at(x, y) >> 24U, 255U);
                ASSERT_NEAR(depth_[static_cast<std::size_t>(y * kWidth + x)],
                            0.3F + 0.001F * across + 0.0001F * down, 1e-4F);
            }
        }
    }
}

TEST_F(LathePixels, ShowTheNearestSurface) {
    const auto of = [&](float depth, float ambient) {
        std::vector<LatheCorner> corners = sheet(depth);
        for (LatheCorner& own : corners)
            own.values[value::kAmbient] = ambient;
        draw(corners, kSheet);
    };
    depth_[100] = 0.1F;
    of(0.6F, 0.1F);
    of(0.4F, 0.3F);
    of(0.5F, 0.2F);
    EXPECT_NEAR(at(30, 20) & 255U, shown(0.3F), 0.6F);
    EXPECT_EQ(depth_[0], 0.4F);
    EXPECT_EQ(pixels_[100], kUntouched) << "the existing pixel is nearer";
    EXPECT_EQ(depth_[100], 0.1F);
    EXPECT_NEAR(pixels_[101] & 255U, shown(0.3F), 0.6F);
    EXPECT_NEAR(pixels_.back() & 255U, shown(0.3F), 0.6F) << "to the last pixel";
}

TEST_F(LathePixels, SkipTrianglesBehindTheEyeFacingAwayOrWithoutArea) {
    std::vector<LatheCorner> corners = sheet();
    corners[1].away_mm = 0.0F;
    draw(corners, kSheet);
    corners = sheet();
    draw(corners, std::array<std::uint16_t, 6>{0, 2, 1, 1, 2, 3});
    corners[1].at_px = corners[2].at_px = corners[0].at_px;
    draw(corners, std::array<std::uint16_t, 3>{0, 1, 2});
    EXPECT_EQ(std::count(pixels_.begin(), pixels_.end(), kUntouched),
              static_cast<std::ptrdiff_t>(pixels_.size()));
    std::array<std::uint32_t, 4> few{};
    std::array<float, 4> depth{1.0F, 1.0F, 1.0F, 1.0F};
    draw_lathe(
        sheet(), kSheet, kSheet.size(),
        {.frame = frame_, .draw = draw_, .normals = *normals_, .streaks = streaks_, .streak_size = {4, 4}},
        {.size = {2, 2}, .pixels = few, .depth = depth});
    EXPECT_EQ(few[0], 0U) << "a canvas that is next to nothing";
}

// Y. Fujii's and B. Karis's formulas straight on, by hand.
TEST_F(LathePixels, ThrowTheKeyBackAsRoughClayDoes) {
    frame_.key_radiance = vec4(2.0F);
    draw_.dry = vec4(0.3F, 0.3F, 0.3F, 0.0F);
    draw_.wet = vec4(0.1F, 0.1F, 0.1F, draw_.wet.w);
    const auto body = [](float albedo, float roughness) { return albedo / (1.0F + 0.288F * roughness); };
    // At normal incidence a lobe of roughness r reflects a quarter of the mirror reflectance divided by r^4.
    EXPECT_NEAR(red({}), shown(2.0F * (body(0.3F, 0.85F) + 0.04F / 4.0F)), 0.6F);
    EXPECT_NEAR(red({{value::kWater, 1.0F}}), shown(2.0F * (body(0.1F, 0.35F) + 0.04F / 4.0F)), 0.6F);
    EXPECT_NEAR(red({{value::kWater, 0.5F}}), shown(2.0F * (body(0.2F, 0.6F) + 0.04F / 4.0F)), 0.6F);
    EXPECT_NEAR(red({{value::kSeen, 0.5F}}), shown(body(0.3F, 0.85F) + 0.04F / 4.0F), 0.6F);
    draw_.gloss.x = 0.8F;
    EXPECT_NEAR(red({}), shown(2.0F * (body(0.3F, 0.85F) + 0.04F / 4.0F / std::pow(0.8F, 4.0F))), 0.6F);
    // From behind.
    frame_.key_direction.z = -1.0F;
    EXPECT_EQ(red({{value::kHalf, 50.0F}}), 0.0F);
}

TEST_F(LathePixels, GleamWhereAFilmLies) {
    frame_.key_radiance = vec4(1.0F);
    const float of_film = 0.04F / 4.0F / std::pow(0.5F, 4.0F);
    EXPECT_NEAR(red({{value::kFilm, 2.0F}}), shown(of_film), 0.6F);
    EXPECT_NEAR(red({}), shown(0.01F), 0.6F) << "none";
    draw_.gloss.w = 1.0F;
    EXPECT_NEAR(red({}), shown(of_film), 0.6F) << "a glaze";
    // The sky's reflection, and a weak one on the bare body.
    frame_.key_radiance = vec4(0.0F);
    EXPECT_NEAR(red({{value::kMirrored, 5.0F}}), shown(5.0F * 0.04F), 0.6F);
    draw_.gloss.w = 0.0F;
    EXPECT_NEAR(red({{value::kMirrored, 5.0F}}), shown(5.0F * 0.04F * 0.12F), 0.6F);
    // Stronger at a grazing angle.
    const float mirror = 0.04F + 0.96F * 0.7F * std::pow(0.4F, 5.0F);
    EXPECT_NEAR(red({{value::kMirrored, 5.0F}, {value::kToEye, 0.8F}, {value::kToEye + 2, 0.6F}}),
                shown(5.0F * mirror * 0.12F), 0.6F);
}

TEST_F(LathePixels, HaveTheTexelOfTheStreaksThatLiesThere) {
    draw_.dry.w = 0.5F;
    const auto tone = [](float byte) { return 1.0F + 0.5F * (byte / 255.0F - 0.5F) * 1.7F; };
    streaks_[2 * 4 + 3] = 0x808080FFU;
    const auto of = [&](float across, float up) {
        return red({{value::kAmbient, 0.2F},
                    {value::kStreak, across / kAwayMm},
                    {value::kStreak + 1, up / kAwayMm}});
    };
    EXPECT_NEAR(of(3.5F, 2.5F), shown(0.2F * tone(255.0F)), 0.6F);
    EXPECT_NEAR(of(7.5F, 10.5F), shown(0.2F * tone(255.0F)), 0.6F) << "it repeats";
    EXPECT_NEAR(of(2.5F, 2.5F), shown(0.2F * tone(128.0F)), 0.6F);
    EXPECT_NEAR(of(3.5F, 1.5F), shown(0.2F * tone(128.0F)), 0.6F);
    // Thick and thin places of a film.
    streaks_.fill(0xFF808080U);
    EXPECT_NEAR(red({{value::kMirrored, 5.0F}, {value::kFilm, 0.5F}}),
                shown(5.0F * 0.04F * (0.12F + 0.88F * 0.5F * (0.62F + 0.75F))), 0.6F);
}

// A wall that is seen slantwise broke into saw-toothed bands.
TEST_F(LathePixels, HaveTheMeanOfTheStreaksWhereSeveralTexelsLieUnderOne) {
    draw_.dry.w = 0.5F;
    const std::array<std::uint32_t, kStreakLevels> tones{0x80808000U, 0x80808040U, 0x808080A0U, 0x808080FFU};
    for (std::size_t level = 0; level < tones.size(); ++level)
        std::fill_n(streaks_.begin() + static_cast<std::ptrdiff_t>(level * kStreakTexels), kStreakTexels,
                    tones[level]);
    const auto shows = [&](float texels_a_pixel) {
        std::fill(depth_.begin(), depth_.end(), 1.0F);
        std::vector<LatheCorner> corners = sheet();
        for (LatheCorner& own : corners) {
            own.values[value::kAmbient] = 0.2F;
            own.values[value::kStreak + 1] = (own.at_px.y + 50.0F) * texels_a_pixel / kAwayMm;
        }
        draw(corners, kSheet);
        return static_cast<float>(at(30, 20) & 255U);
    };
    const std::array rates{1.0F, 2.0F, 4.0F, 9.0F};
    for (std::size_t level = 0; level < tones.size(); ++level) {
        const float byte = static_cast<float>(tones[level] & 255U);
        EXPECT_NEAR(shows(rates[level]), shown(0.2F * (1.0F + 0.5F * (byte / 255.0F - 0.5F) * 1.7F)), 0.6F)
            << rates[level] << " texels a pixel";
    }
}

TEST_F(LathePixels, LeanAsOutlineDentsAndStreaksSay) {
    frame_.key_radiance = vec4(1.0F);
    draw_.dry = vec4(0.5F, 0.5F, 0.5F, 0.0F);
    // From a direction almost along the wall.
    frame_.key_direction = vec4(0.0F, 1.0F, 0.0F, 0.05F);
    const float grazed = red({});
    const float wanted = red({{value::kLean, -1.0F}});
    EXPECT_GT(wanted, grazed + 50.0F) << "a dent leans it up";
    normals_->fill(0xDA82DA82U);  // both by the root of a half
    EXPECT_NEAR(red({}), wanted, 0.6F) << "and so does the outline";
    normals_->fill(0x7FFFFFFFU);
    normals_->at(7) = 0xDA82DA82U;
    EXPECT_NEAR(red({{value::kNormal, 7.5F}}), wanted, 0.6F);
    EXPECT_NEAR(red({{value::kNormal, 8.5F}}), grazed, 0.6F);
    EXPECT_NEAR(red({{value::kNormal, 1e9F}}), grazed, 0.6F) << "beyond the last";
    // Streaks lean it half as much, round the pot or up it.
    draw_.dry.w = 1.0F;
    streaks_.fill(0x80FF8080U);
    const float up = red({});
    EXPECT_GT(up, grazed + 30.0F);
    EXPECT_LT(up, wanted);
    streaks_.fill(0x8080FF80U);
    EXPECT_NEAR(red({}), grazed, 3.0F);
    frame_.key_direction = vec4(-1.0F, 0.0F, 0.0F, 0.05F);
    EXPECT_NEAR(red({}), up, 3.0F);
}

TEST_F(LathePixels, LoseTheKeyBehindASphereWhereOneMayBe) {
    frame_.key_radiance = vec4(1.0F);
    draw_.dry = vec4(0.5F, 0.5F, 0.5F, 0.0F);
    const float free = red({});
    EXPECT_EQ(red({}, true), free) << "none is there";
    frame_.spheres[3] = vec4(0.0F, 0.0F, 100.0F, 20.0F);
    EXPECT_EQ(red({}, true), 0.0F);
    EXPECT_EQ(red({}, false), free) << "it is known not to be near";
    EXPECT_EQ(red({{value::kPlace, 40.0F}}, true), free) << "beside it";
    EXPECT_EQ(red({{value::kPlace + 2, 200.0F}}, true), free) << "before it";
    // The light has a half-width of 0.05: at the sphere's silhouette half the light is visible.
    const float half = red({{value::kPlace + 1, 20.0F}}, true);
    EXPECT_NEAR(half, red({{value::kSeen, 0.5F}}), 1.0F);
}

// Load from 0 on the left to 1 on the right of a grey wall in soft light.
TEST_F(LathePixels, ShowHowNearTheClayIsToGivingWay) {
    shows_load_ = true;
    draw_.dry = draw_.wet = vec4(0.3F, 0.3F, 0.3F, 0.0F);
    draw_.wet.w = 0.1F;
    std::vector<LatheCorner> corners = sheet();
    for (LatheCorner& own : corners) {
        own.values[value::kLoad] = own.at_px.x / static_cast<float>(kWidth);
        // Three tenths of a mm along the hatch to a pixel.
        own.values[value::kStreak] = (18.0F + 0.01F * own.at_px.x) * own.values[value::kNear];
        for (std::size_t channel = 0; channel < 3; ++channel)
            own.values[value::kAmbient + channel] = 0.3F;
    }
    draw(corners, kSheet);
    const auto blue = [&](int x, int y) { return static_cast<float>(at(x, y) >> 16U & 255U); };
    const auto red = [&](int x, int y) { return static_cast<float>(at(x, y) & 255U); };
    EXPECT_NEAR(red(20, 20), shown(0.3F), 1.0F);
    EXPECT_NEAR(blue(30, 20), shown(0.3F), 1.0F) << "no warning up to six tenths";
    EXPECT_GT(red(36, 20), shown(0.6F)) << "where it begins, a pale line";
    float reddest = 0.0F;
    for (int x = 45; x < kWidth; ++x)
        reddest = std::max(reddest, red(x, 20) - blue(x, 20));
    EXPECT_GT(reddest, 60.0F);
}

TEST_F(LathePixels, HatchTheSameClayHoweverFarItHasTurned) {
    shows_load_ = true;
    draw_.dry = draw_.wet = vec4(0.3F, 0.3F, 0.3F, 0.0F);
    const auto hatched = [&](float turned) {
        std::fill(depth_.begin(), depth_.end(), 1.0F);
        std::vector<LatheCorner> corners = sheet();
        draw_.turn.x = turned;
        for (LatheCorner& own : corners) {
            own.values[value::kLoad] = 0.8F;
            own.values[value::kStreak] = 4.0F * (0.01F * (own.at_px.x + 50.0F) + turned + kStreakWidthsMore) *
                                         own.values[value::kNear];
            own.values[value::kAmbient] = 0.3F;
        }
        draw(corners, kSheet);
        return pixels_;
    };
    const std::vector<std::uint32_t> before = hatched(0.0F);
    const std::vector<std::uint32_t> after = hatched(0.375F);
    int lines = 0;
    for (int x = 1; x < kWidth; ++x) {
        const auto at = static_cast<std::size_t>(20 * kWidth + x);
        EXPECT_NEAR(before[at] & 255U, after[at] & 255U, 3) << x;
        lines += std::abs(static_cast<int>(before[at] & 255U) - static_cast<int>(before[at - 1] & 255U)) > 20;
    }
    EXPECT_GT(lines, 8) << "nothing is hatched";
}

}  // namespace
}  // namespace onggi::render
