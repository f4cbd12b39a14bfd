#include "game/finish/glaze.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::finish {
namespace {

// From the colours a museum's photographs show, taken back to linear light.
vec3 linear(int rgb) {
    const auto one = [&](int shift) {
        const float value = static_cast<float>((rgb >> shift) & 255) / 255.0F;
        return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
    };
    return {one(16), one(8), one(0)};
}

std::array<GlazeMaterial, kGlazeCount> made() {
    std::array<GlazeMaterial, kGlazeCount> all;
    all[0] = {.glaze = Glaze::kCeladon,
              .id = "celadon",
              .name_key = "glz.celadon",
              .line_key = "glz.line.celadon",
              .body = linear(0xb79a7a),
              .colour = linear(0x9db79c),
              .thin_colour = linear(0xb9cbb0),
              .roughness = 0.35F,
              .clear_coat = 0.9F,
              .coat_roughness = 0.10F,
              .breaks = 0.5F};
    all[1] = {.glaze = Glaze::kPorcelain,
              .id = "porcelain",
              .name_key = "glz.porcelain",
              .line_key = "glz.line.porcelain",
              .body = linear(0xe4d9c6),
              .colour = linear(0xe6e3da),
              .thin_colour = linear(0xefece4),
              .roughness = 0.30F,
              .clear_coat = 0.9F,
              .coat_roughness = 0.08F,
              .breaks = 0.2F};
    all[2] = {.glaze = Glaze::kBuncheong,
              .id = "buncheong",
              .name_key = "glz.buncheong",
              .line_key = "glz.line.buncheong",
              .body = linear(0x8b8478),
              .colour = linear(0xd8d2c4),
              .thin_colour = linear(0x857e72),
              .roughness = 0.55F,
              .clear_coat = 0.55F,
              .coat_roughness = 0.25F,
              .breaks = 0.5F,
              .brushed = 0.9F};
    all[3] = {.glaze = Glaze::kIron,
              .id = "iron",
              .name_key = "glz.iron",
              .line_key = "glz.line.iron",
              .body = linear(0x8a6a4c),
              .colour = linear(0x3a2519),
              .thin_colour = linear(0x7a3c1f),
              .roughness = 0.30F,
              .clear_coat = 0.95F,
              .coat_roughness = 0.09F,
              .breaks = 0.9F,
              .runs = 0.25F};
    all[4] = {.glaze = Glaze::kAsh,
              .id = "ash",
              .name_key = "glz.ash",
              .line_key = "glz.line.ash",
              .body = linear(0x8c6d4d),
              .colour = linear(0x8f8f5e),
              .thin_colour = linear(0xa9895c),
              .roughness = 0.45F,
              .clear_coat = 0.75F,
              .coat_roughness = 0.18F,
              .breaks = 0.7F,
              .runs = 0.9F};
    all[5] = {.glaze = Glaze::kBare,
              .id = "bare",
              .name_key = "glz.bare",
              .line_key = "glz.line.bare",
              .body = linear(0xb5794e),
              .colour = linear(0xb87c50),
              .thin_colour = linear(0xc98f62),
              .roughness = 0.85F,
              .breaks = 0.4F,
              .foot_bare_mm = 0.0F};
    return all;
}

}  // namespace

std::span<const GlazeMaterial, kGlazeCount> glazes() {
    static const std::array<GlazeMaterial, kGlazeCount> all = made();
    return all;
}

const GlazeMaterial& glaze_at(int place) {
    static const GlazeMaterial ido{.id = "ido",
                                   .body = linear(0x9a7450),
                                   .colour = linear(0xc9a97f),
                                   .thin_colour = linear(0xd8bf98),
                                   .roughness = 0.5F,
                                   .clear_coat = 0.45F,
                                   .coat_roughness = 0.28F,
                                   .breaks = 0.6F};
    if (place >= kIdoGlaze) return ido;
    return glazes()[static_cast<std::size_t>(std::clamp(place, 0, kGlazeCount - 1))];
}

const GlazeMaterial* find_glaze(std::string_view id) {
    const auto all = glazes();
    const auto found =
        std::find_if(all.begin(), all.end(), [id](const GlazeMaterial& one) { return one.id == id; });
    return found == all.end() ? nullptr : &*found;
}

const GlazeMaterial& wet_clay() {
    static const GlazeMaterial clay{.id = "wet",
                                    .body = linear(0xa88d6c),
                                    .colour = linear(0xa88d6c),
                                    .thin_colour = linear(0xbba283),
                                    .roughness = 0.5F,
                                    .clear_coat = 0.3F,
                                    .coat_roughness = 0.3F,
                                    .breaks = 0.3F,
                                    .foot_bare_mm = 0.0F};
    return clay;
}

}  // namespace onggi::finish
