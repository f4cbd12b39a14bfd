#include "game/finish/glaze_surface.h"

#include <cmath>
#include <numbers>

#include "engine/math/lattice.h"

namespace onggi::finish {
namespace {

// Smooth noise at (x, y), 0 to 1.
float noise(float x, float y) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const int ix = static_cast<int>(fx);
    const int iy = static_cast<int>(fy);
    const float u = glm::smoothstep(0.0F, 1.0F, x - fx);
    const float v = glm::smoothstep(0.0F, 1.0F, y - fy);
    return glm::mix(glm::mix(lattice(ix, iy), lattice(ix + 1, iy), u),
                    glm::mix(lattice(ix, iy + 1), lattice(ix + 1, iy + 1), u), v);
}

// Makes the look periodic in the angle. The noise is not, so across the seam behind the pot one end is
// blended into the continuation of the other end.
template <typename Look>
auto closed(GlazePlace at, const Look& look) {
    constexpr float kHalfTurn = std::numbers::pi_v<float>;
    constexpr float kSeamRad = 0.24F * kHalfTurn;
    at.angle -= 2.0F * kHalfTurn * std::floor((at.angle + kHalfTurn) / (2.0F * kHalfTurn));
    const auto here = look(at);
    const float past_seam = (at.angle + kHalfTurn) / kSeamRad;
    if (past_seam >= 1.0F) return here;
    at.angle += 2.0F * kHalfTurn;
    return glm::mix(look(at), here, glm::smoothstep(0.0F, 1.0F, past_seam));
}

float open_finger_ring(const GlazePlace& at) {
    return std::sin(at.height_mm * 1.05F + 1.3F * noise(at.height_mm * 0.11F, 2.0F)) * 0.5F +
           (noise(at.height_mm * 0.8F, at.angle * 0.6F) - 0.5F);
}

vec3 open_glaze_colour(const GlazeMaterial& glaze, float height_mm, const GlazePlace& at) {
    const float ring = open_finger_ring(at);
    float thick =
        0.5F + 0.5F * noise(at.height_mm * 0.05F, at.angle * 1.5F + 7.0F) - glaze.breaks * 0.20F * ring;
    // Glaze recedes from a rim.
    thick -= glaze.breaks * 0.9F * std::exp(-(height_mm - at.height_mm) / 2.2F);
    if (glaze.brushed > 0.0F) {
        const float streak = noise(at.height_mm * 1.15F, at.angle * 0.9F + 0.04F * at.height_mm) * 0.62F +
                             noise(at.height_mm * 3.1F, at.angle * 0.5F) * 0.38F;
        thick = glm::mix(thick, glm::smoothstep(0.30F, 0.58F, streak), glaze.brushed);
    }
    if (glaze.runs > 0.0F) {
        const float drop =
            noise(at.angle * 9.0F, 1.0F) * 0.6F + noise(at.angle * 23.0F, at.height_mm * 0.03F) * 0.4F;
        const float high = at.height_mm / height_mm;
        thick += glaze.runs * (drop - 0.5F) * 0.9F + glaze.runs * (high - 0.55F) * 0.5F;
    }
    thick = glm::clamp(thick, 0.0F, 1.0F);
    const float grain = 0.97F + 0.06F * noise(at.height_mm * 2.3F, at.angle * 31.0F);
    return glm::mix(glaze.thin_colour, glaze.colour, thick) * grain;
}

}  // namespace

float finger_ring(const GlazePlace& at) {
    return closed(at, open_finger_ring);
}

vec3 glaze_colour(const GlazeMaterial& glaze, float height_mm, const GlazePlace& at) {
    if (is_bare(glaze, at)) return glaze.body;
    return closed(at, [&](const GlazePlace& place) { return open_glaze_colour(glaze, height_mm, place); });
}

}  // namespace onggi::finish
