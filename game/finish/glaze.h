// The six glazes a visitor chooses from, as materials. Any thread; constant. Linear light, mm.
#pragma once

#include <span>
#include <string_view>

#include "engine/math/math.h"

namespace onggi::finish {

// The names and order of the columns on the glaze screen, and of what is stored.
enum class Glaze { kCeladon, kPorcelain, kBuncheong, kIron, kAsh, kBare };

// What is seen of what was drawn below the glaze, or on raw clay. By eye, after fired pieces; linear.
struct MarkPalette {
    vec3 white_slip{0.7F};
    vec3 black_slip{0.1F};
    vec3 iron{0.1F};
    vec3 cobalt{0.1F};
    vec3 coat{0.7F};    // of slip or of the glaze itself, through which fingers went
    vec3 finger{0.3F};  // where they did
};

struct GlazeMaterial {
    Glaze glaze = Glaze::kBare;
    std::string_view id{};        // in files: "celadon"
    std::string_view name_key{};  // of the languages
    std::string_view line_key{};
    vec3 body{0.5F};          // the fired clay below
    vec3 colour{0.5F};        // where the glaze lies thick
    vec3 thin_colour{0.5F};   // where it runs thin: rims and ridges
    float roughness = 0.5F;   // of the surface below the coat
    float clear_coat = 0.0F;  // 0 none to 1: the layer of glass
    float coat_roughness = 0.1F;
    float ior = 1.5F;
    float breaks = 0.0F;        // 0 to 1: how much thinner on ridges
    float brushed = 0.0F;       // 0 to 1: slip laid on with a brush, streak by streak
    float runs = 0.0F;          // 0 to 1: run down the wall in drops
    float foot_bare_mm = 3.0F;  // wiped off before firing, so that the pot does not stick
    MarkPalette marks{};
};

constexpr int kGlazeCount = 6;
[[nodiscard]] std::span<const GlazeMaterial, kGlazeCount> glazes();
// Behind the six: what only a museum's pot wears, the loquat skin of Ido bowls.
constexpr int kIdoGlaze = kGlazeCount;
// One of the six, or kIdoGlaze; any other place is the nearest.
[[nodiscard]] const GlazeMaterial& glaze_at(int place);
// The one of the six that files call so; null: there is none.
[[nodiscard]] const GlazeMaterial* find_glaze(std::string_view id);
// Of wet clay on the wheel, for pictures of lumps.
[[nodiscard]] const GlazeMaterial& wet_clay();

}  // namespace onggi::finish
