#include "game/wheel/clay_look.h"

#include <algorithm>
#include <cmath>

#include "game/finish/clay_body.h"

namespace onggi::wheel {

render::LatheMaterial clay_material(clay::ClayBody body, clay::Firing stage) {
    const finish::BodyLook& look = finish::look_of(body);
    render::LatheMaterial material{
        .albedo = vec3(look.raw), .streaks = look.streaks, .soft_edge = look.soft_edge};
    switch (stage) {
        case clay::Firing::kWet:
            material.wetness = 0.55F;
            material.film = 0.5F;
            break;
        case clay::Firing::kDry:
            material.albedo = vec3(look.bone_dry);
            material.roughness = 0.85F;
            material.streaks = 0.6F * look.streaks;
            break;
        case clay::Firing::kBisque:
            material.albedo = vec3(look.bisque);
            material.roughness = 0.8F;
            material.streaks = 0.6F * look.streaks;
            break;
        case clay::Firing::kGlaze:
            material.albedo = vec3(look.glazed);
            material.coat = 1.0F;
            material.streaks = 0.4F * look.streaks;
            material.soft_edge = std::max(look.soft_edge, 0.2F);
            break;
    }
    return material;
}

float gloss_of(float film) {
    return std::sqrt(std::clamp(film, 0.0F, 1.0F));
}

float darkness_of(float liquidity, float film) {
    return std::clamp(0.15F + 0.75F * liquidity + 0.45F * gloss_of(film), 0.0F, 1.0F);
}

vec3 section_colour(const render::LatheMaterial& material) {
    return 0.85F * (material.albedo + 0.15F * (vec3(1.0F) - material.albedo));
}

}  // namespace onggi::wheel
