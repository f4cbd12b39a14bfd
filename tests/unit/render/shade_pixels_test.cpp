#include "engine/render/pixels/shade_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "engine/render/shapes/frame_build.h"
#include "shaders/transfer.h"

namespace onggi::render {
namespace {

// A light from the left, and a mask for everything within 100 mm of the axis.
shaders::FrameData frame_of(vec3 towards_light) {
    const DirectionalLight light{.towards_light = glm::normalize(towards_light), .angular_radius_rad = 0.05F};
    const MaskPlacement placed = place_mask({.half_width_mm = 200.0F, .height_mm = 200.0F}, light);
    shaders::FrameData frame{};
    frame.key_direction = vec4(light.towards_light, std::tan(light.angular_radius_rad));
    frame.mask_u = placed.u;
    frame.mask_v = placed.v;
    frame.mask_origin = vec4(placed.origin.x, placed.origin.y, 0.0F, 0.0F);
    frame.mask_axes = vec4(placed.axis_u.x, placed.axis_u.y, placed.axis_v.x, placed.axis_v.y);
    for (vec4& sphere : frame.spheres)
        sphere = vec4(0.0F, -1e6F, 0.0F, 1e-3F);
    return frame;
}

std::uint32_t texel_at(const shaders::FrameData& frame, const ShadowMask& mask, vec3 ground_mm) {
    const vec4 p(ground_mm, 1.0F);
    const auto texel = [](float at) {
        return static_cast<std::size_t>(at * static_cast<float>(shaders::kMaskTexels));
    };
    return mask[texel(glm::dot(frame.mask_v, p)) * shaders::kMaskTexels + texel(glm::dot(frame.mask_u, p))];
}

TEST(ShadowMaskOnTheHost, LeavesAnEmptyWheelInTheLight) {
    ShadowMask mask{};
    fill_shadow_mask(frame_of({-0.7F, 0.6F, 0.0F}), mask);
    for (const std::uint32_t texel : mask)
        ASSERT_EQ(texel, kUnshaded);
}

TEST(ShadowMaskOnTheHost, CastsTheLatheAwayFromTheLightAndShadesItsFoot) {
    shaders::FrameData frame = frame_of({-1.0F, 1.0F, 0.0F});
    constexpr float kRadiusMm = 40.0F;
    constexpr float kHeightMm = 150.0F;
    frame.lathe = vec4(kHeightMm, 1.0F, 512.0F, kRadiusMm);
    for (int i = 0; i < shaders::kShadowSteps; ++i) {
        const float t =
            kHeightMm * static_cast<float>(i) / (shaders::kShadowSteps - 1) / frame.key_direction.y;
        frame.shadow_steps[i] = vec4(frame.key_direction.x * t, frame.key_direction.z * t, kRadiusMm, 0.5F);
    }
    ShadowMask mask{};
    fill_shadow_mask(frame, mask);
    // The shadow is as long as the lathe is high: light at 45 degrees from -X.
    EXPECT_EQ(texel_at(frame, mask, {100.0F, 0.0F, 0.0F}) & 0xFFU, 0U);
    EXPECT_EQ(texel_at(frame, mask, {-100.0F, 0.0F, 0.0F}) & 0xFFU, 255U);
    EXPECT_EQ(texel_at(frame, mask, {100.0F, 0.0F, 90.0F}) & 0xFFU, 255U);
    // Close to the foot the sky is half gone, 70 mm away it is whole.
    EXPECT_LT(texel_at(frame, mask, {-44.0F, 0.0F, 0.0F}) >> 16U, 130U);
    EXPECT_EQ(texel_at(frame, mask, {-112.0F, 0.0F, 0.0F}) >> 16U, 255U);
}

TEST(MaskPlace, IsATexelAndTheWayToTheNext) {
    // The middle of texel 10, 20, in sixteen bits.
    const auto middle = [](std::uint32_t texel) {
        return static_cast<std::uint32_t>(std::ceil((texel + 0.5) / shaders::kMaskTexels * 65535.0));
    };
    const auto packed = [](std::uint32_t u, std::uint32_t v) {
        return (u >> 8U) | ((u & 0xFFU) << 8U) | ((v >> 8U) << 16U) | ((v & 0xFFU) << 24U);
    };
    const std::uint32_t place = mask_place(packed(middle(10), middle(20)));
    EXPECT_EQ(place >> 16U, 20U * shaders::kMaskTexels + 10U);
    EXPECT_LE(place & 0xFFU, 1U);
    EXPECT_LE((place >> 8U) & 0xFFU, 1U);
    EXPECT_EQ(mask_place(packed(0, 0)), 0U);
    // The last texel is reached from the one before it, so that four can always be read.
    EXPECT_EQ(mask_place(packed(65535, 65535)), (94U * shaders::kMaskTexels + 94U) << 16U | 0xFFFFU);
}

TEST(MaskPlace, IsExactForEveryCoordinate) {
    std::vector<std::uint32_t> coords;
    for (std::uint32_t across = 0; across < 65536; ++across) {
        const std::uint32_t down = across * 40503U & 0xFFFFU;
        coords.push_back((across >> 8U) | ((across & 0xFFU) << 8U) | ((down >> 8U) << 16U) |
                         (down & 0xFFU) << 24U);
    }
    std::vector<std::uint32_t> places = coords;
    turn_into_places(places);
    for (std::uint32_t across = 0; across < 65536; ++across) {
        const double texels = across / 65535.0 * shaders::kMaskTexels - 0.5;
        const double steps =
            std::clamp(std::floor(texels * 256.0), 0.0, 256.0 * (shaders::kMaskTexels - 1) - 1.0);
        const std::uint32_t place = places[across];
        ASSERT_EQ(place, mask_place(coords[across]));
        ASSERT_EQ((place >> 16U) % shaders::kMaskTexels * 256U + (place & 0xFFU),
                  static_cast<std::uint32_t>(steps))
            << across;
    }
}

// formula_test.cpp tests the transfer function against the standard.
double light_of(double value) {
    const double c = double{shaders::untransferred(static_cast<float>(value))};
    return 0.35 * c / (1.0 - 0.8 * c);
}

// The exact mix of both lights, in double.
double shaded(double with_key, double without_key, double ambient, double key, double left) {
    const double unlit = light_of(without_key);
    const double light = std::max(unlit * ambient + (light_of(with_key) - unlit) * key, 0.0) * left;
    return double{shaders::transferred(static_cast<float>(light / (0.8 * light + 0.35)))};
}

class ShadePixels : public testing::TestWithParam<ShadeLight> {};

TEST_P(ShadePixels, MixesLightAndLeavesTheRestAlone) {
    const ShadeLight& light = GetParam();
    constexpr int kWidth = 70;
    constexpr int kHeight = 40;
    constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
    std::mt19937 random(5);
    std::vector<std::uint32_t> with_key(kPixels);
    std::vector<std::uint32_t> without_key(kPixels);
    std::vector<std::uint32_t> places(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) {
        with_key[i] = static_cast<std::uint32_t>(random()) | 0xFF000000U;
        without_key[i] = static_cast<std::uint32_t>(random());
        places[i] = mask_place(static_cast<std::uint32_t>(random()));
    }
    auto mask = std::make_unique<ShadowMask>();
    for (std::uint32_t& texel : *mask)
        texel = static_cast<std::uint32_t>(random()) & 0x00FF00FFU;
    constexpr std::uint32_t kUntouched = 0x01020304U;
    std::vector<std::uint32_t> into(kPixels, kUntouched);
    const std::vector<PixelRect> rects{{3, 2, 58, 7}, {40, 20, 30, 20}};
    shade_pixels({kWidth, kHeight, with_key, without_key, places}, *mask, light, rects, into);

    const auto byte = [](std::uint32_t texel, unsigned at) { return (texel >> (8U * at)) & 0xFFU; };
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
            const bool inside = (x >= 3 && x < 61 && y >= 2 && y < 9) || (x >= 40 && y >= 20);
            if (!inside) {
                ASSERT_EQ(into[i], kUntouched) << x << ", " << y;
                continue;
            }
            const std::uint32_t* const texel = mask->data() + (places[i] >> 16U);
            const double across = (places[i] & 0xFFU) / 256.0;
            const double down = ((places[i] >> 8U) & 0xFFU) / 256.0;
            const auto mixed = [&](unsigned half) {
                const auto at = [&](std::size_t k) { return byte(texel[k], half) / 255.0; };
                return std::lerp(std::lerp(at(0), at(1), across),
                                 std::lerp(at(shaders::kMaskTexels), at(shaders::kMaskTexels + 1), across),
                                 down);
            };
            const double left = std::lerp(1.0, mixed(2), byte(without_key[i], 3) / 255.0);
            for (unsigned channel = 0; channel < 3; ++channel) {
                const double expected =
                    shaded(byte(with_key[i], channel) / 255.0, byte(without_key[i], channel) / 255.0,
                           light.ambient[channel], light.key * mixed(0), left);
                ASSERT_NEAR(byte(into[i], channel), 255.0 * expected, 0.51) << x << ", " << y;
            }
            ASSERT_EQ(byte(into[i], 3), 255U);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ByDayAndInTheEvening, ShadePixels,
                         testing::Values(ShadeLight{}, ShadeLight{{0.36F, 0.30F, 0.26F}, 0.3F},
                                         ShadeLight{{1.0F, 0.9F, 0.8F}, 0.0F}));

TEST(ShadedBlocks, StayInThePictureWhereARectangleIsNarrowerThanThey) {
    constexpr int kWidth = kShadeBlockPx;
    constexpr std::size_t kPixels = 2 * std::size_t{kWidth};
    const std::vector<std::uint32_t> layer(kPixels, 0xFF808080U);
    const std::vector<std::uint32_t> places(kPixels, mask_place(0x80808080U));
    auto mask = std::make_unique<ShadowMask>();
    mask->fill(0U);
    constexpr std::uint32_t kUntouched = 0x01020304U;
    std::vector<std::uint32_t> into(kPixels + kShadeBlockPx, kUntouched);
    const std::vector<PixelRect> rects{{0, 0, 1, 1}, {15, 1, 1, 1}};
    shade_pixels({kWidth, 2, layer, layer, places}, *mask, {}, rects, into);
    EXPECT_NE(into.front(), kUntouched);
    EXPECT_NE(into[kPixels - 1], kUntouched);
    for (std::size_t beyond = kPixels; beyond < into.size(); ++beyond)
        EXPECT_EQ(into[beyond], kUntouched);
}

TEST(ShadedBlocks, CopyUnshadedPixelsByteForByte) {
    constexpr int kWidth = 64;
    std::vector<std::uint32_t> with_key(kWidth);
    for (std::size_t i = 0; i < with_key.size(); ++i)
        with_key[i] = 0xFF000000U | static_cast<std::uint32_t>(i * 0x030507U);
    const std::vector<std::uint32_t> without_key(kWidth, 0xFF101010U);
    const std::vector<std::uint32_t> places(kWidth, mask_place(0x80808080U));
    auto mask = std::make_unique<ShadowMask>();
    mask->fill(kUnshaded);
    std::vector<std::uint32_t> into(kWidth, 0U);
    const std::vector<PixelRect> whole{{0, 0, 64, 1}};
    shade_pixels({kWidth, 1, with_key, without_key, places}, *mask, {}, whole, into);
    EXPECT_EQ(into, with_key);
    // In the evening they are darker all the same.
    shade_pixels({kWidth, 1, with_key, without_key, places}, *mask, {{0.5F, 0.5F, 0.5F}, 0.5F}, whole, into);
    for (std::size_t i = 1; i < into.size(); ++i)
        EXPECT_LT(into[i] & 0xFFU, with_key[i] & 0xFFU) << i;
}

TEST(ShadedBlocks, CopyAPictureThatIsNarrowerThanThey) {
    constexpr int kWidth = kShadeBlockPx - 1;
    std::vector<std::uint32_t> with_key(2 * std::size_t{kWidth}, 0xFF406080U);
    const std::vector<std::uint32_t> places(with_key.size(), mask_place(0x80808080U));
    auto mask = std::make_unique<ShadowMask>();
    mask->fill(0U);
    std::vector<std::uint32_t> into(with_key.size(), 0U);
    const std::vector<PixelRect> whole{{0, 0, kWidth, 2}};
    shade_pixels({kWidth, 2, with_key, with_key, places}, *mask, {}, whole, into);
    EXPECT_EQ(into, with_key);
}

}  // namespace
}  // namespace onggi::render
