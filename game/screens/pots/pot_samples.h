// The visible samples of a pot's surface: a depth buffer on the processor. Any thread; pure.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "game/screens/pots/pot_picture.h"
#include "game/screens/pots/pot_shading.h"

namespace onggi::screens {

// The samples of the picture or of a band.
struct PotSamples {
    int width = 0;  // in samples, a whole number of pixels
    int height = 0;
    int top = 0;     // its first row of samples in the picture
    int across = 1;  // samples per pixel in each direction
    std::vector<PotSurface> surface{};
    std::vector<char> covered{};

    // Calls visit(surface) for each sample of a pixel that shows the pot. Returns their number.
    template <typename Visit>
    int visit_pixel(int x, int y, Visit visit) const {
        int count = 0;
        for (int k = 0; k < across * across; ++k) {
            const std::size_t at =
                static_cast<std::size_t>(y * across + k / across) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x * across + k % across);
            if (covered[at] == 0) continue;
            visit(surface[at]);
            ++count;
        }
        return count;
    }
};

// Rows of samples per band. A band of a large picture takes 5 MB, all of its samples 80 MB.
constexpr int kBandRows = 64;

// Rows of pixels.
struct PotBand {
    int top_px = 0;
    int height_px = std::numeric_limits<int>::max();  // to the picture's end
};

// A pot in an orthographic view, elevation_rad above the horizon, turned by `turn` turns. The surface is
// built once, the samples per band. A sample is bit-identical in every band.
class PotView {
  public:
    PotView(const pot::Section& shape, float px_per_mm, float elevation_rad, float turn = 0.0F,
            int samples_across = kScreenSamples);

    [[nodiscard]] const PotExtent& extent() const { return extent_; }
    [[nodiscard]] PotSamples samples(const PotBand& band = {}) const;
    // Calls visit(samples) for each band of some kBandRows rows, from the top.
    template <typename Visit>
    void visit_bands(Visit visit) const {
        const int band_px = std::max(1, kBandRows / samples_across_);
        for (int top = 0; top < extent_.height_px; top += band_px)
            visit(samples({top, band_px}));
    }

    struct Corner {
        vec2 px{0.0F};  // in samples
        float depth = 0.0F;
        PotSurface surface{};
    };

  private:
    int samples_across_;
    PotExtent extent_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> indices_;  // of triangles; back faces are hidden by front faces
};

}  // namespace onggi::screens
