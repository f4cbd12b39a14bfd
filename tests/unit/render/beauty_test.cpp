#include "engine/render/beauty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/eight_bits.h"
#include "engine/math/light.h"

namespace onggi::render {
namespace {

TEST(Accumulation, GivesEveryValueBackThatAllPicturesAgreeOn) {
    Accumulation mean(256, 1);
    std::vector<std::uint8_t> picture;
    for (int value = 0; value < 256; ++value) {
        for (int channel = 0; channel < 4; ++channel)
            picture.push_back(static_cast<std::uint8_t>(channel == 3 ? 255 : value));
    }
    for (int time = 0; time < 64; ++time)
        mean.add(picture);
    EXPECT_EQ(mean.mean().rgba, picture);
}

TEST(Accumulation, MixesLightAndNotNumbers) {
    Accumulation mean(1, 1);
    mean.add(std::vector<std::uint8_t>{0, 0, 0, 255});
    mean.add(std::vector<std::uint8_t>{255, 255, 255, 255});
    EXPECT_EQ(mean.mean().rgba, (std::vector<std::uint8_t>{188, 188, 188, 255}));
}

TEST(Accumulation, MixesBlocksOfALargerPicture) {
    Accumulation mean(2, 1, 2);
    std::vector<std::uint8_t> picture;
    for (const int value : {0, 255, 90, 90, 255, 0, 90, 90}) {  // two rows of four
        for (int channel = 0; channel < 4; ++channel)
            picture.push_back(static_cast<std::uint8_t>(channel == 3 ? 255 : value));
    }
    mean.add(picture);
    EXPECT_EQ(mean.mean().rgba, (std::vector<std::uint8_t>{188, 188, 188, 255, 90, 90, 90, 255}));
}

TEST(EightBits, RoundsAsTheLibraryDoes) {
    for (int step = -20; step <= 255 * 64 + 20; ++step) {
        const float exact = static_cast<float>(step) / (255.0F * 64.0F);
        for (const float fraction : {std::nextafter(exact, -1.0F), exact, std::nextafter(exact, 2.0F)}) {
            const auto rounded = std::lround(255.0F * std::clamp(fraction, 0.0F, 1.0F));
            ASSERT_EQ(eight_bits(fraction), static_cast<std::uint8_t>(rounded)) << fraction;
        }
    }
}

TEST(SrgbByte, IsThatOfTheCurve) {
    for (int step = -100; step <= 1100 * 1000; ++step) {
        const float light = static_cast<float>(step) * 1e-6F;
        ASSERT_EQ(srgb_byte(light), eight_bits(srgb_from_linear(light))) << light;
    }
}

TEST(BeautySample, FillsThePixelAndTheLightEvenly) {
    Scene scene;
    scene.key.towards_light = glm::normalize(vec3(-0.7F, 0.6F, 0.4F));
    scene.key.angular_radius_rad = 0.1F;
    dvec2 middle(0.0);
    dvec3 light(0.0);
    constexpr int kSamples = 64;
    for (int i = 0; i < kSamples; ++i) {
        const Scene sample = beauty_sample(scene, i, 200, 100);
        const dvec2 aside(sample.camera.shift.x * 100.0, sample.camera.shift.y * 50.0);
        EXPECT_LE(std::abs(aside.x), 0.5);
        EXPECT_LE(std::abs(aside.y), 0.5);
        middle += aside / double{kSamples};
        light += dvec3(sample.key.towards_light) / double{kSamples};
        EXPECT_NEAR(glm::length(sample.key.towards_light), 1.0F, 1e-5F);
        EXPECT_LT(std::acos(std::min(1.0F, glm::dot(sample.key.towards_light, scene.key.towards_light))),
                  0.1001F);
    }
    EXPECT_LT(glm::length(middle), 0.02);
    EXPECT_LT(glm::distance(glm::normalize(light), dvec3(scene.key.towards_light)), 0.01);
}

TEST(BeautySample, ShiftsThePictureByItsSubPixelOffset) {
    Camera camera;
    const vec4 at = view_projection(camera, 200, 100) * vec4(3.0F, 5.0F, 7.0F, 1.0F);
    camera.shift = vec2(0.01F, -0.02F);
    const vec4 aside = view_projection(camera, 200, 100) * vec4(3.0F, 5.0F, 7.0F, 1.0F);
    EXPECT_NEAR(aside.x / aside.w - at.x / at.w, 0.01F, 1e-5F);
    EXPECT_NEAR(aside.y / aside.w - at.y / at.w, -0.02F, 1e-5F);
    EXPECT_NEAR(aside.z / aside.w, at.z / at.w, 1e-6F);
}

}  // namespace
}  // namespace onggi::render
