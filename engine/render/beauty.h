// Many pictures of a scene that stands still, each seen from a fraction of a pixel aside and lit from another
// point of its light, put together in linear light: edges without steps, shadows as soft as the light is
// wide. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/asset/image.h"
#include "engine/render/scene.h"

namespace onggi::render {

// The scene as sample `index` of a picture sees it: the same every time. Over many, the shifts fill one pixel
// and the light's directions its disc evenly.
[[nodiscard]] Scene beauty_sample(const Scene& scene, int index, int width_px, int height_px);

// Light as a value of the screen, IEC 61966-2-1.
[[nodiscard]] std::uint8_t srgb_byte(float light);

// The mean of pictures with exact sRGB values, taken of the light they stand for.
class Accumulation {
  public:
    Accumulation(int width_px, int height_px);
    // Precondition: as many bytes as the picture has.
    void add(std::span<const std::uint8_t> rgba);
    [[nodiscard]] int count() const { return count_; }
    // Precondition: at least one was added.
    [[nodiscard]] asset::Image mean() const;

  private:
    int width_px_;
    int height_px_;
    int count_ = 0;
    std::vector<float> light_;  // three a pixel
};

}  // namespace onggi::render
