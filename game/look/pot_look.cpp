#include "game/look/pot_look.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/render/shapes/detail_texture.h"
#include "engine/render/shapes/frame_build.h"
#include "game/finish/glaze_surface.h"
#include "game/finish/mark_colour.h"
#include "shaders/lathe.h"

namespace onggi::look {
namespace {

vec4 texel(int x, int y) {
    const std::vector<std::uint8_t>& texels = render::detail_texture();
    constexpr int kLast = render::kDetailTexels - 1;
    const auto first = static_cast<std::size_t>(4 * ((y & kLast) * render::kDetailTexels + (x & kLast)));
    vec4 value;
    for (int channel = 0; channel < 4; ++channel)
        value[channel] = static_cast<float>(texels[first + static_cast<std::size_t>(channel)]) / 255.0F;
    return value;
}

// The texture of streaks, read as a sampler does, between four texels.
vec4 streaks(float across, float up) {
    const float x = across * render::kDetailTexels - 0.5F;
    const float y = up * render::kDetailTexels - 0.5F;
    const auto left = static_cast<int>(std::floor(x));
    const auto top = static_cast<int>(std::floor(y));
    const float right_fraction = x - static_cast<float>(left);
    const float low_fraction = y - static_cast<float>(top);
    return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), right_fraction),
                    glm::mix(texel(left, top + 1), texel(left + 1, top + 1), right_fraction), low_fraction);
}

}  // namespace

PotLook lathe_look(const render::LatheMaterial& material, std::string name) {
    const vec3 wet = render::wet_albedo(material.albedo, 1.0F);
    const float wet_roughness = render::wet_roughness(material);
    const auto at = [=](const Place& place) {
        // Two of the texture go round, clockwise seen from above, as lathe.vert lays them.
        const vec4 mark =
            streaks(-place.angle * std::numbers::inv_pi_v<float>, place.along_mm / shaders::kStreakMm);
        const vec3 body = glm::mix(material.albedo, wet, material.wetness);
        return Surface{
            .colour = body * shaders::lathe_tone(material.streaks, mark.x),
            .roughness = shaders::lathe_roughness(material.roughness, wet_roughness, material.wetness),
            .coat = shaders::lathe_film(material.film, mark.w, material.coat),
            .lean_round = -shaders::lathe_lean(material.streaks, mark.y),
            .lean_up = shaders::lathe_lean(material.streaks, mark.z)};
    };
    return {.name = std::move(name), .coat_roughness = render::film_roughness(material), .at = at};
}

PotLook glaze_look(const finish::GlazeMaterial& glaze, float height_mm) {
    const auto at = [=](const Place& place) {
        const finish::GlazePlace here{
            .height_mm = place.height_mm, .angle = place.angle, .inside = place.inside};
        constexpr float kBareRoughness = 0.85F;
        const bool is_bare = finish::is_bare(glaze, here);
        return Surface{.colour = finish::glaze_colour(glaze, height_mm, here),
                       .roughness = is_bare ? kBareRoughness : glaze.roughness,
                       .coat = is_bare ? 0.0F : glaze.clear_coat,
                       .lean_up = finish::kFingerLean * finish::finger_ring(here)};
    };
    return {.name = std::string(glaze.id), .coat_roughness = glaze.coat_roughness, .at = at};
}

PotLook marked_look(PotLook look, const decoration::Marks& marks, const finish::MarkPalette& palette,
                    float height_mm) {
    const auto texture = std::make_shared<const decoration::Texture>(decoration::texture_of(marks));
    const auto at = [=, wall = marks.wall, plain = std::move(look.at)](const Place& place) {
        Surface surface = plain(place);
        if (place.inside) return surface;
        const int column = decoration::column_at(0.5F * place.angle * std::numbers::inv_pi_v<float>);
        const int row = decoration::row_at(place.height_mm / height_mm);
        surface.colour =
            finish::marked(surface.colour, finish::mark_colour(palette, texture->at(column, row)));
        const vec2 lean = finish::relief_lean(*texture, wall, column, row);
        surface.lean_round += lean.x;
        surface.lean_up += lean.y;
        return surface;
    };
    return {.name = std::move(look.name), .coat_roughness = look.coat_roughness, .at = at};
}

}  // namespace onggi::look
