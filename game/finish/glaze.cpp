#include "game/finish/glaze.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::finish {
namespace {

// Converts a colour from a museum's photographs to linear light.
vec3 linear(int rgb) {
    const auto one = [&](int shift) {
        const float value = static_cast<float>((rgb >> shift) & 255) / 255.0F;
        return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
    };
    return {one(16), one(8), one(0)};
}

MarkPalette palette(const std::array<int, 6>& rgb) {
    return {linear(rgb[0]), linear(rgb[1]), linear(rgb[2]), linear(rgb[3]), linear(rgb[4]), linear(rgb[5])};
}

const MarkPalette& bare_palette() {
    static const MarkPalette bare = palette({0xeadac0, 0x3c2a20, 0x5b2c18, 0x4a4c5c, 0xe6d5ba, 0xa86a42});
    return bare;
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
              .breaks = 0.5F,
              .marks = palette({0xd3ddcb, 0x2c352e, 0x4c4429, 0x2f5468, 0xcfdac6, 0x6f8d70})};
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
              .breaks = 0.2F,
              .marks = palette({0xecebe4, 0x33302c, 0x6a3a1f, 0x2f4c8c, 0xeceae2, 0xd0d3d0})};
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
              .brushed = 0.9F,
              .marks = palette({0xe9e2d0, 0x2f2a25, 0x4d2f1c, 0x3a4a6b, 0xe4dcc9, 0x7c7466})};
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
              .runs = 0.25F,
              .marks = palette({0x4d2b19, 0x150d09, 0x180e09, 0x17161c, 0x33190d, 0x7a4423})};
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
              .runs = 0.9F,
              .marks = palette({0xd6cf9d, 0x33301a, 0x4b3a16, 0x37503f, 0xc9c28e, 0x7f7f4b})};
    all[5] = {.glaze = Glaze::kBare,
              .id = "bare",
              .name_key = "glz.bare",
              .line_key = "glz.line.bare",
              .body = linear(0xb5794e),
              .colour = linear(0xb87c50),
              .thin_colour = linear(0xc98f62),
              .roughness = 0.85F,
              .breaks = 0.4F,
              .foot_bare_mm = 0.0F,
              .marks = bare_palette()};
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
                                   .breaks = 0.6F,
                                   .marks = bare_palette()};
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
    static const GlazeMaterial clay{
        .id = "wet",
        .body = linear(0xa88d6c),
        .colour = linear(0xa88d6c),
        .thin_colour = linear(0xbba283),
        .roughness = 0.5F,
        .clear_coat = 0.3F,
        .coat_roughness = 0.3F,
        .breaks = 0.3F,
        .foot_bare_mm = 0.0F,
        .marks = palette({0xded3c0, 0x4a3d34, 0x55311f, 0x4a5a80, 0xd8ccb8, 0x8f7a64})};
    return clay;
}

}  // namespace onggi::finish
