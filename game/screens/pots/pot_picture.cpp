#include "game/screens/pots/pot_picture.h"

#include <algorithm>
#include <cmath>

#include "game/screens/pots/pot_samples.h"

namespace onggi::screens {

PotExtent pot_extent(const pot::Section& shape, float px_per_mm, float elevation_rad) {
    constexpr float kMarginPx = 2.0F;
    const float sine = std::sin(elevation_rad);
    const float half_width = shape.radius_mm() * px_per_mm + kMarginPx;
    const float above =
        (shape.height_mm() * std::cos(elevation_rad) + shape.radius_mm() * sine) * px_per_mm + kMarginPx;
    const float below = shape.radius_mm() * sine * px_per_mm + kMarginPx;
    const auto whole = [](float value) { return std::max(1, static_cast<int>(std::ceil(value))); };
    PotExtent extent{.width_px = whole(2.0F * half_width), .height_px = whole(above + below)};
    extent.foot_px = {0.5F * static_cast<float>(extent.width_px), above};
    return extent;
}

namespace {

// The band's pixels, below those that are there.
void add_band(const PotSamples& samples, const PotShading& shading, std::vector<std::uint8_t>& rgba) {
    constexpr int kSamples = kSamplesAcross * kSamplesAcross;
    for (int y = 0; y < samples.height / kSamplesAcross; ++y) {
        for (int x = 0; x < samples.width / kSamplesAcross; ++x) {
            vec3 sum(0.0F);
            const int count = samples.visit_pixel(x, y, [&](const PotSurface& surface) {
                const PotLight light = shading.light(surface);
                sum += encoded_pot_light(shading.colour(surface) * light.factor + light.gloss);
            });
            for (int channel = 0; channel < 3; ++channel)
                rgba.push_back(static_cast<std::uint8_t>(sum[channel] * 255.0F / kSamples + 0.5F));
            rgba.push_back(static_cast<std::uint8_t>(count * 255 / kSamples));
        }
    }
}

}  // namespace

PotPicture paint_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                     float elevation_rad) {
    const DrawnOn drawn_on(shape);
    const PotShading shading(glaze, shape.height_mm(), elevation_rad, drawn_on);
    const PotView view(shape, px_per_mm, elevation_rad);
    PotPicture picture;
    picture.foot_px = view.extent().foot_px;
    ui::Painting& painting = picture.painting;
    painting.width = view.extent().width_px;
    painting.height = view.extent().height_px;
    painting.rgba.reserve(static_cast<std::size_t>(painting.width) *
                          static_cast<std::size_t>(painting.height) * 4);
    view.visit_bands([&](const PotSamples& samples) { add_band(samples, shading, painting.rgba); });
    return picture;
}

}  // namespace onggi::screens
