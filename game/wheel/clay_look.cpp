#include "game/wheel/clay_look.h"

#include <algorithm>

namespace onggi::wheel {
namespace {

// Chosen by eye against photographs of the three bodies. raw is the colour of the clay without its water.
struct BodyLook {
    vec3 raw;
    vec3 bone_dry;  // with dust on it
    vec3 bisque;
    vec3 glazed;      // with the body's usual glaze: celadon on stoneware and porcelain, clear on earthenware
    float streaks;    // slip is as fine as the body
    float soft_edge;  // porcelain is translucent
};

const BodyLook& look_of(clay::ClayBody body) {
    static const BodyLook kStoneware{.raw = {0.36F, 0.29F, 0.215F},
                                     .bone_dry = {0.42F, 0.36F, 0.29F},
                                     .bisque = {0.56F, 0.37F, 0.25F},
                                     .glazed = {0.30F, 0.40F, 0.31F},
                                     .streaks = 0.35F,
                                     .soft_edge = 0.14F};
    static const BodyLook kPorcelain{.raw = {0.72F, 0.69F, 0.63F},
                                     .bone_dry = {0.80F, 0.785F, 0.75F},
                                     .bisque = {0.83F, 0.79F, 0.735F},
                                     .glazed = {0.80F, 0.815F, 0.795F},
                                     .streaks = 0.10F,
                                     .soft_edge = 0.32F};
    static const BodyLook kEarthenware{.raw = {0.40F, 0.155F, 0.075F},
                                       .bone_dry = {0.48F, 0.245F, 0.15F},
                                       .bisque = {0.60F, 0.27F, 0.14F},
                                       .glazed = {0.36F, 0.11F, 0.045F},
                                       .streaks = 0.30F,
                                       .soft_edge = 0.14F};
    switch (body) {
        case clay::ClayBody::kPorcelain:
            return kPorcelain;
        case clay::ClayBody::kEarthenware:
            return kEarthenware;
        case clay::ClayBody::kStoneware:
            break;
    }
    return kStoneware;
}

}  // namespace

render::LatheMaterial clay_material(clay::ClayBody body, clay::Firing stage) {
    const BodyLook& look = look_of(body);
    render::LatheMaterial material{.albedo = look.raw, .streaks = look.streaks, .soft_edge = look.soft_edge};
    switch (stage) {
        case clay::Firing::kWet:
            material.wetness = 0.55F;
            material.film = 0.5F;
            break;
        case clay::Firing::kDry:
            material.albedo = look.bone_dry;
            material.roughness = 0.85F;
            material.streaks = 0.6F * look.streaks;
            break;
        case clay::Firing::kBisque:
            material.albedo = look.bisque;
            material.roughness = 0.8F;
            material.streaks = 0.6F * look.streaks;
            break;
        case clay::Firing::kGlaze:
            material.albedo = look.glazed;
            material.coat = 1.0F;
            material.streaks = 0.4F * look.streaks;
            material.soft_edge = std::max(look.soft_edge, 0.2F);
            break;
    }
    return material;
}

float darkness_of(float liquidity) {
    return std::clamp(0.15F + 0.75F * liquidity, 0.0F, 1.0F);
}

vec3 section_colour(const render::LatheMaterial& material) {
    return 0.85F * (material.albedo + 0.15F * (vec3(1.0F) - material.albedo));
}

}  // namespace onggi::wheel
