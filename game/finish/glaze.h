// The materials of the six glazes for visitors. Any thread; constant. Linear light, mm.
#pragma once

#include <span>
#include <string_view>

#include "engine/math/math.h"

namespace onggi::finish {

// Names and order as on the glaze screen and in stored files.
enum class Glaze { kCeladon, kPorcelain, kBuncheong, kIron, kAsh, kBare };

// Colours of marks below the glaze, or on raw clay. Chosen by eye after fired pieces; linear.
struct MarkPalette {
    vec3 white_slip{0.7F};
    vec3 black_slip{0.1F};
    vec3 iron{0.1F};
    vec3 cobalt{0.1F};
    vec3 coat{0.7F};    // coat of slip or glaze that fingers wipe through
    vec3 finger{0.3F};  // where fingers wiped it off
};

struct GlazeMaterial {
    Glaze glaze = Glaze::kBare;
    std::string_view id{};        // identifier in files: "celadon"
    std::string_view name_key{};  // key in the language files
    std::string_view line_key{};
    vec3 body{0.5F};          // the fired clay below
    vec3 colour{0.5F};        // where the glaze is thick
    vec3 thin_colour{0.5F};   // where the glaze is thin: rims and ridges
    float roughness = 0.5F;   // of the surface below the coat
    float clear_coat = 0.0F;  // the layer of glass, 0 (none) to 1
    float coat_roughness = 0.1F;
    float ior = 1.5F;
    float breaks = 0.0F;        // 0 to 1: how much thinner the glaze is on ridges
    float brushed = 0.0F;       // 0 to 1: slip applied with a brush, in streaks
    float runs = 0.0F;          // 0 to 1: drops running down the wall
    float foot_bare_mm = 3.0F;  // wiped off before firing, so that the pot does not stick
    MarkPalette marks{};
};

constexpr int kGlazeCount = 6;
[[nodiscard]] std::span<const GlazeMaterial, kGlazeCount> glazes();
// Index after the six: the loquat skin of Ido bowls, used only for museum pots.
constexpr int kIdoGlaze = kGlazeCount;
// One of the six, or kIdoGlaze; other indices are clamped.
[[nodiscard]] const GlazeMaterial& glaze_at(int place);
// The glaze with that identifier among the six; null if unknown.
[[nodiscard]] const GlazeMaterial* find_glaze(std::string_view id);
// Wet clay on the wheel, for pictures of lumps.
[[nodiscard]] const GlazeMaterial& wet_clay();

}  // namespace onggi::finish
