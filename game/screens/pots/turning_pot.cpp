#include "game/screens/pots/turning_pot.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "game/screens/pots/pot_samples.h"

namespace onggi::screens {
namespace {

constexpr float kHalfTurn = std::numbers::pi_v<float>;
// Of the colours, round the pot: a power of two, one for each pixel that is seen in front or two.
int columns_for(int width_px) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(width_px * 16 / 5, 64, 1024))));
}
// And up it: about as many as pixels.
int rows_for(int height_px) {
    return std::clamp(height_px * 9 / 10, 64, 1024);
}

constexpr float kWhole = 65535.0F;

std::array<std::uint16_t, 3> packed(const vec3& colour) {
    const vec3 numbers = glm::clamp(colour, 0.0F, 1.0F) * kWhole + 0.5F;
    return {static_cast<std::uint16_t>(numbers.x), static_cast<std::uint16_t>(numbers.y),
            static_cast<std::uint16_t>(numbers.z)};
}

// encoded_pot_light(), channel by channel, from a table: pixels are painted by the hundred thousand.
class Encoding {
  public:
    Encoding() {
        for (std::size_t i = 0; i < table_.size(); ++i) {
            const vec3 light(kMost * static_cast<float>(i) / static_cast<float>(table_.size() - 1));
            table_[i] = 255.0F * encoded_pot_light(light * light / kMost).x;
        }
    }
    // Finer in the dark, as eyes are: the table goes by the root of the light.
    [[nodiscard]] float operator()(float light) const {
        const float root = std::sqrt(std::clamp(light, 0.0F, kMost) / kMost);
        return table_[static_cast<std::size_t>(root * static_cast<float>(table_.size() - 1) + 0.5F)];
    }

  private:
    static constexpr float kMost = 8.0F;
    std::array<float, 4096> table_{};
};

}  // namespace

TurningPot::TurningPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                       float elevation_rad) {
    const DrawnOn drawn_on(shape);
    const PotShading shading(glaze, shape.height_mm(), elevation_rad, drawn_on);
    const PotView view(shape, px_per_mm, elevation_rad);
    width_ = view.extent().width_px;
    height_ = view.extent().height_px;
    foot_px_ = view.extent().foot_px;
    columns_ = columns_for(width_);
    rows_ = rows_for(height_);
    fill_colours(shape, shading, drawn_on.texture() != nullptr);
    std::fill_n(colours_.begin() + static_cast<std::ptrdiff_t>(rows_) * columns_, columns_,
                packed(glaze.body));
    view.visit_bands(
        [&](const PotSamples& samples) { add_pixels(samples, shading, shape, glaze.foot_bare_mm); });
    pixels_.shrink_to_fit();
}

void TurningPot::add_pixels(const PotSamples& samples, const PotShading& shading, const pot::Section& shape,
                            float foot_bare_mm) {
    const int first_row = samples.top / kSamplesAcross;
    const auto columns = static_cast<float>(columns_);
    const float row_per_mm = static_cast<float>(rows_ - 1) / std::max(1.0F, shape.height_mm());
    constexpr int kSamples = kSamplesAcross * kSamplesAcross;
    for (int y = 0; y < samples.height / kSamplesAcross; ++y) {
        for (int x = 0; x < width_; ++x) {
            Pixel pixel;
            std::optional<bool> inside;
            const int count = samples.visit_pixel(x, y, [&](const PotSurface& surface) {
                // Colours are of the first sample's side: where the rim runs through a pixel, both are near.
                if (!inside) inside = surface.inside;
                const PotLight light = shading.light(surface);
                pixel.factor += light.factor;
                pixel.gloss += light.gloss;
                const bool is_foot = !*inside && surface.height_mm < foot_bare_mm;
                pixel.row =
                    is_foot ? static_cast<float>(rows_)
                            : std::clamp(surface.height_mm * row_per_mm, 0.0F, static_cast<float>(rows_ - 1));
                if (*inside) pixel.row += static_cast<float>(inside_from_);
                pixel.column = (surface.angle + kHalfTurn) / (2.0F * kHalfTurn) * columns;
            });
            if (count == 0) continue;
            pixel.factor /= static_cast<float>(count) * kWhole;
            pixel.gloss /= static_cast<float>(count);
            pixel.cover = static_cast<float>(count) / kSamples;
            pixel.place = 4U * static_cast<std::uint32_t>((first_row + y) * width_ + x);
            pixels_.push_back(pixel);
        }
    }
}

// `differs`: where nothing is drawn outside, it looks there as it does inside.
void TurningPot::fill_colours(const pot::Section& shape, const PotShading& shading, bool differs) {
    inside_from_ = differs ? rows_ + 1 : 0;
    colours_.resize(static_cast<std::size_t>((rows_ + 1 + (differs ? rows_ : 0)) * columns_));
    const auto fill = [&](int first_row, bool inside) {
        PotSurface at;
        at.inside = inside;
        for (int row = 0; row < rows_; ++row) {
            at.height_mm = shape.height_mm() * static_cast<float>(row) / static_cast<float>(rows_ - 1);
            for (int column = 0; column < columns_; ++column) {
                const float fraction = (static_cast<float>(column) + 0.5F) / static_cast<float>(columns_);
                at.angle = 2.0F * kHalfTurn * fraction - kHalfTurn;
                colours_[static_cast<std::size_t>((first_row + row) * columns_ + column)] =
                    packed(shading.colour(at));
            }
        }
    };
    fill(inside_from_, true);  // glazed down to the foot; the foot has a row of its own
    if (differs) fill(0, false);
}

std::shared_ptr<const ui::Painting> TurningPot::at(double turn) const {
    static const Encoding encode;
    auto painting = std::make_shared<ui::Painting>();
    painting->width = width_;
    painting->height = height_;
    painting->rgba.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
    const auto shift = static_cast<float>(turn - std::floor(turn)) * static_cast<float>(columns_);
    const auto columns = static_cast<std::size_t>(columns_);
    const auto last_column = static_cast<std::uint32_t>(columns_ - 1);
    for (const Pixel& pixel : pixels_) {
        // Between two columns, so that it turns smoothly, and two rows, so that its rings have no steps.
        const float along = pixel.column + shift;
        const auto column = static_cast<std::uint32_t>(along);
        const float right = along - static_cast<float>(column);
        const auto row = static_cast<std::uint32_t>(pixel.row);
        const float up = pixel.row - static_cast<float>(row);
        const Colour* const here = colours_.data() + static_cast<std::size_t>(row) * columns;
        const Colour* const above = up > 0.0F ? here + columns : here;
        const std::size_t first = column & last_column;
        const std::size_t second = (column + 1U) & last_column;
        std::uint8_t* const to = painting->rgba.data() + pixel.place;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto between = [&](const Colour* side) {
                const auto left = static_cast<float>(side[first][channel]);
                return left + right * (static_cast<float>(side[second][channel]) - left);
            };
            const float low = between(here);
            const float high = between(above);
            const float own = low + up * (high - low);
            const auto of = static_cast<int>(channel);
            const float light = own * pixel.factor[of] + pixel.gloss[of];
            to[channel] = static_cast<std::uint8_t>(encode(light) * pixel.cover + 0.5F);
        }
        to[3] = static_cast<std::uint8_t>(255.0F * pixel.cover + 0.5F);
    }
    return painting;
}

}  // namespace onggi::screens
