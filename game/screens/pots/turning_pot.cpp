#include "game/screens/pots/turning_pot.h"

#include <utility>

namespace onggi::screens {
namespace {

std::vector<PotPixel> pixels_of(const LitPot& pot) {
    std::vector<PotPixel> pixels;
    pot.view.visit_bands([&](const PotSamples& samples) { add_pixels(samples, pot, pixels); });
    pixels.shrink_to_fit();
    return pixels;
}

}  // namespace

TurningPot::TurningPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                       float elevation_rad)
    : TurningPot(LitPot(shape, glaze, px_per_mm, elevation_rad)) {}

TurningPot::TurningPot(LitPot&& pot)
    : extent_(pot.view.extent()),
      pixels_(pixels_of(pot)),
      colours_(std::move(pot.colours)) {}

std::shared_ptr<const ui::Painting> TurningPot::at(double turn) const {
    auto painting = std::make_shared<ui::Painting>(empty_painting(extent_));
    paint_pixels(pixels_, colours_, turn, *painting);
    return painting;
}

}  // namespace onggi::screens
