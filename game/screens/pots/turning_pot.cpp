#include "game/screens/pots/turning_pot.h"

#include <cmath>
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

struct TurningPot::Bent {
    pot::Section shape;
    float px_per_mm;
    float elevation_rad;
    LitPot lit;
    int step = -1;
    std::shared_ptr<const ui::Painting> shown{};

    Bent(const pot::Section& bent, const finish::GlazeMaterial& glaze, float px, float elevation)
        : shape(bent),
          px_per_mm(px),
          elevation_rad(elevation),
          lit(shape, glaze, px, elevation) {}

    const std::shared_ptr<const ui::Painting>& at(double turn) {
        const double whole = (turn - std::floor(turn)) * kBentViews;
        if (step == static_cast<int>(whole)) return shown;
        step = static_cast<int>(whole);
        const double seen = static_cast<double>(step) / kBentViews;
        ui::Painting painting = empty_painting(lit.view.extent());
        paint_view({shape, px_per_mm, elevation_rad, static_cast<float>(seen)}, lit, seen, painting);
        shown = std::make_shared<const ui::Painting>(std::move(painting));
        return shown;
    }
};

TurningPot::TurningPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                       float elevation_rad) {
    if (shape.off_round) {
        bent_ = std::make_unique<Bent>(shape, glaze, px_per_mm, elevation_rad);
        extent_ = bent_->lit.view.extent();
        return;
    }
    LitPot pot(shape, glaze, px_per_mm, elevation_rad);
    extent_ = pot.view.extent();
    pixels_ = pixels_of(pot);
    colours_.emplace(std::move(pot.colours));
}

TurningPot::~TurningPot() = default;

std::size_t TurningPot::bytes() const {
    if (!bent_) return pixels_.size() * sizeof(PotPixel) + colours_->bytes();
    return bent_->lit.colours.bytes() + (bent_->shown ? bent_->shown->rgba.size() : 0U);
}

std::shared_ptr<const ui::Painting> TurningPot::at(double turn) const {
    if (bent_) return bent_->at(turn);
    auto painting = std::make_shared<ui::Painting>(empty_painting(extent_));
    paint_pixels(pixels_, *colours_, turn, *painting);
    return painting;
}

}  // namespace onggi::screens
