#include "game/wheel/clay_look.h"

#include <gtest/gtest.h>

#include <array>

#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {
namespace {

using clay::ClayBody;
using clay::Firing;

constexpr std::array kBodies{ClayBody::kStoneware, ClayBody::kPorcelain, ClayBody::kEarthenware};

TEST(ClayLook, ShinesOnlyWetOrGlazed) {
    for (const ClayBody body : kBodies) {
        EXPECT_GT(clay_material(body, Firing::kWet).film, 0.0F);
        EXPECT_EQ(clay_material(body, Firing::kGlaze).coat, 1.0F);
        for (const Firing stage : {Firing::kDry, Firing::kBisque}) {
            const render::LatheMaterial material = clay_material(body, stage);
            EXPECT_EQ(material.film + material.wetness + material.coat, 0.0F);
            EXPECT_GT(material.roughness, clay_material(body, Firing::kWet).roughness);
        }
    }
}

TEST(ClayLook, ReflectsLessThanAllLightAndDiffersBetweenBodies) {
    for (const Firing stage : {Firing::kWet, Firing::kDry, Firing::kBisque, Firing::kGlaze}) {
        for (const ClayBody body : kBodies) {
            const vec3 albedo = clay_material(body, stage).albedo;
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_GT(albedo[channel], 0.0F);
                EXPECT_LT(albedo[channel], 0.9F);
            }
        }
        const vec3 porcelain = clay_material(ClayBody::kPorcelain, stage).albedo;
        const vec3 earthenware = clay_material(ClayBody::kEarthenware, stage).albedo;
        EXPECT_GT(porcelain.y, 1.5F * earthenware.y);
        EXPECT_GT(earthenware.x / earthenware.z, 2.0F * porcelain.x / porcelain.z) << "earthenware is red";
    }
}

TEST(ClayLook, DarkensWithWaterUpToItsFill) {
    EXPECT_GT(darkness_of(0.0F, 0.0F), 0.0F) << "leather-hard clay is damp";
    EXPECT_LT(darkness_of(0.2F, 0.0F), darkness_of(0.8F, 0.0F));
    EXPECT_LT(darkness_of(0.5F, 0.0F) + 0.2F, darkness_of(0.5F, 0.25F)) << "a wet hand leaves a dark wall";
    EXPECT_EQ(darkness_of(9.0F, 1.0F), 1.0F);
    EXPECT_EQ(darkness_of(-9.0F, 0.0F), 0.0F);
}

TEST(ClayLook, BringsEveryColumnOfASnapshotToTheLathe) {
    const std::vector<float> outer(4, 50.0F);
    const std::vector<float> inner{0.0F, 45.0F, 45.0F, 45.0F};
    const std::vector<float> top{10.0F, 30.0F, 60.0F, 100.0F};
    const std::vector<vec2> centre{{1.0F, 2.0F}, {3.0F, 4.0F}, {5.0F, 6.0F}, {7.0F, 8.0F}};
    const std::vector<float> half(4, 0.5F);
    const std::vector<float> dents(2 * kDentSectors, -1.0F);
    pot::Pot pot{.outer_mm = outer,
                 .inner_mm = inner,
                 .top_mm = top,
                 .centre_mm = centre,
                 .film = half,
                 .liquidity = half,
                 .load_index = half,
                 .dents_mm = dents,
                 .height_mm = 100.0};
    WheelScene scene;
    const render::Lathe lathe = *scene.apply({.pot = &pot}, 640, 480).lathe;
    EXPECT_EQ(std::vector<float>(lathe.inner_mm.begin(), lathe.inner_mm.end()), inner);
    EXPECT_EQ(std::vector<float>(lathe.top_mm.begin(), lathe.top_mm.end()), top);
    ASSERT_EQ(lathe.centre_mm.size(), 4U);
    EXPECT_EQ(lathe.centre_mm[2], vec2(5.0F, 6.0F));
    EXPECT_EQ(lathe.film[3], gloss_of(0.5F));
    EXPECT_EQ(lathe.load[0], 0.5F);
    EXPECT_EQ(lathe.wetness[1], darkness_of(0.5F, 0.5F));
    EXPECT_EQ(lathe.dents_mm.size(), dents.size());
    pot.stage = Firing::kBisque;
    EXPECT_TRUE(scene.apply({.pot = &pot}, 640, 480).lathe->film.empty()) << "fired clay holds no water";
}

}  // namespace
}  // namespace onggi::wheel
