// Accumulates many renders of a static scene, each with a different sub-pixel shift and light direction. The
// mean in linear light has anti-aliased edges and soft shadows as wide as the light. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/asset/image.h"
#include "engine/render/scene.h"

namespace onggi::render {

// Returns the scene for sample `index` of a picture; deterministic. Over many samples, the shifts fill one
// pixel evenly and the light directions fill the light's disc evenly.
[[nodiscard]] Scene beauty_sample(const Scene& scene, int index, int width_px, int height_px);

// Encodes linear light as an 8-bit sRGB value, IEC 61966-2-1.
[[nodiscard]] std::uint8_t srgb_byte(float light);

// Averages sRGB pictures in linear light (exact sRGB curves). Those added are `across` times as large each
// way: each of their blocks of pixels becomes one pixel of the mean.
class Accumulation {
  public:
    Accumulation(int width_px, int height_px, int across = 1);
    // Precondition: `rgba` has four bytes for each pixel of the larger picture.
    void add(std::span<const std::uint8_t> rgba);
    [[nodiscard]] int count() const { return count_; }
    // Precondition: count() >= 1.
    [[nodiscard]] asset::Image mean() const;

  private:
    int width_px_;
    int height_px_;
    int across_;
    int count_ = 0;
    std::vector<float> light_;  // three floats per pixel
};

}  // namespace onggi::render
