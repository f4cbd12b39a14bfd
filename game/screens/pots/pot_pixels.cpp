#include "game/screens/pots/pot_pixels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace onggi::screens {
namespace {

constexpr float kWhole = 65535.0F;
// The number of columns round the pot: a power of two, one or two per visible pixel in front.
int columns_for(int width_px) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(width_px * 16 / 5, 64, 1024))));
}
// The number of rows up the pot: about one per pixel.
int rows_for(int height_px) {
    return std::clamp(height_px * 9 / 10, 64, 1024);
}

std::array<std::uint16_t, 3> packed(const vec3& colour) {
    const vec3 numbers = glm::clamp(colour, 0.0F, 1.0F) * kWhole + 0.5F;
    return {static_cast<std::uint16_t>(numbers.x), static_cast<std::uint16_t>(numbers.y),
            static_cast<std::uint16_t>(numbers.z)};
}

// Tabulates encoded_pot_light() for one channel, because hundreds of thousands of pixels need it.
class Encoding {
  public:
    Encoding() {
        for (std::size_t i = 0; i < table_.size(); ++i) {
            const vec3 light(kMost * static_cast<float>(i) / static_cast<float>(table_.size() - 1));
            table_[i] = 255.0F * encoded_pot_light(light * light / kMost).x;
        }
    }
    // Indexed by the square root of the light, for finer steps in the dark.
    [[nodiscard]] float operator()(float light) const {
        const float root = std::sqrt(std::clamp(light, 0.0F, kMost) / kMost);
        return table_[static_cast<std::size_t>(root * static_cast<float>(table_.size() - 1) + 0.5F)];
    }

  private:
    static constexpr float kMost = 8.0F;
    std::array<float, 4096> table_{};
};

}  // namespace

// Without a decoration, outside and inside share their rows.
PotColours::PotColours(float height_mm, const finish::GlazeMaterial& glaze, const PotShading& shading,
                       const PotExtent& extent, bool is_drawn_on)
    : columns_(columns_for(extent.width_px)),
      rows_(rows_for(extent.height_px)),
      height_mm_(std::max(1.0F, height_mm)),
      foot_bare_mm_(glaze.foot_bare_mm),
      inside_from_(is_drawn_on ? rows_ + 1 : 0) {
    colours_.resize(static_cast<std::size_t>((rows_ + 1 + (is_drawn_on ? rows_ : 0)) * columns_));
    fill(inside_from_, true, shading);  // glazed down to the foot, which has its own row
    if (is_drawn_on) fill(0, false, shading);
    std::fill_n(colours_.begin() + static_cast<std::ptrdiff_t>(rows_) * columns_, columns_,
                packed(glaze.body));
}

void PotColours::fill(int first_row, bool inside, const PotShading& shading) {
    PotSurface at;
    at.inside = inside;
    for (int row = 0; row < rows_; ++row) {
        at.height_mm = height_mm_ * static_cast<float>(row) / static_cast<float>(rows_ - 1);
        for (int column = 0; column < columns_; ++column) {
            const float fraction = (static_cast<float>(column) + 0.5F) / static_cast<float>(columns_);
            at.angle = kTurnF * fraction - kPiF;
            colours_[static_cast<std::size_t>((first_row + row) * columns_ + column)] =
                packed(shading.colour(at));
        }
    }
}

float PotColours::row_of(const PotSurface& surface, bool inside) const {
    if (!inside && surface.height_mm < foot_bare_mm_) return static_cast<float>(rows_);
    const auto last = static_cast<float>(rows_ - 1);
    const float row = std::clamp(surface.height_mm / height_mm_ * last, 0.0F, last);
    return inside ? row + static_cast<float>(inside_from_) : row;
}

float PotColours::column_of(const PotSurface& surface) const {
    return (surface.angle + kPiF) / kTurnF * static_cast<float>(columns_);
}

float PotColours::columns_turned(double turn) const {
    return static_cast<float>(turn - std::floor(turn)) * static_cast<float>(columns_);
}

vec3 PotColours::at(float row, float column) const {
    const auto lower = static_cast<std::uint32_t>(row);
    const float up = row - static_cast<float>(lower);
    const auto left = static_cast<std::uint32_t>(column);
    const float right = column - static_cast<float>(left);
    const auto last_column = static_cast<std::uint32_t>(columns_ - 1);
    const Colour* const here = colours_.data() + static_cast<std::size_t>(lower) * (last_column + 1U);
    const Colour* const above = up > 0.0F ? here + columns_ : here;
    const std::size_t first = left & last_column;
    const std::size_t second = (left + 1U) & last_column;
    vec3 colour;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto between = [&](const Colour* side) {
            const auto from = static_cast<float>(side[first][channel]);
            return from + right * (static_cast<float>(side[second][channel]) - from);
        };
        const float low = between(here);
        colour[static_cast<int>(channel)] = (low + up * (between(above) - low)) * (1.0F / kWhole);
    }
    return colour;
}

LitPot::LitPot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
               float elevation_rad, double turn, int samples_across)
    : drawn_on(shape),
      shading(glaze, shape.height_mm(), elevation_rad, drawn_on),
      view(shape, px_per_mm, elevation_rad, static_cast<float>(turn), samples_across),
      colours(shape.height_mm(), glaze, shading, view.extent(), drawn_on.texture() != nullptr) {}

void add_pixels(const PotSamples& samples, const LitPot& pot, std::vector<PotPixel>& pixels) {
    const auto whole = static_cast<float>(samples.across * samples.across);
    const int first_row = samples.top / samples.across;
    const int width = samples.width / samples.across;
    for (int y = 0; y < samples.height / samples.across; ++y) {
        for (int x = 0; x < width; ++x) {
            PotPixel pixel;
            std::optional<bool> inside;
            const int count = samples.visit_pixel(x, y, [&](const PotSurface& surface) {
                // Uses the colours of the first sample's side; on the rim, where a pixel shows both, they are
                // similar.
                if (!inside) inside = surface.inside;
                const PotLight light = pot.shading.light(surface);
                pixel.factor += light.factor;
                pixel.gloss += light.gloss;
                pixel.row = pot.colours.row_of(surface, *inside);
                pixel.column = pot.colours.column_of(surface);
            });
            if (count == 0) continue;
            pixel.factor /= static_cast<float>(count);
            pixel.gloss /= static_cast<float>(count);
            pixel.cover = static_cast<float>(count) / whole;
            pixel.place = 4U * static_cast<std::uint32_t>((first_row + y) * width + x);
            pixels.push_back(pixel);
        }
    }
}

void paint_pixels(const std::vector<PotPixel>& pixels, const PotColours& colours, double turn,
                  ui::Painting& painting) {
    static const Encoding encode;
    const float turned = colours.columns_turned(turn);
    for (const PotPixel& pixel : pixels) {
        const vec3 light = colours.at(pixel.row, pixel.column + turned) * pixel.factor + pixel.gloss;
        std::uint8_t* const to = painting.rgba.data() + pixel.place;
        for (int channel = 0; channel < 3; ++channel)
            to[channel] = static_cast<std::uint8_t>(encode(light[channel]) * pixel.cover + 0.5F);
        to[3] = static_cast<std::uint8_t>(255.0F * pixel.cover + 0.5F);
    }
}

void paint_view(const PotView& view, const LitPot& pot, double turn, ui::Painting& painting) {
    std::vector<PotPixel> pixels;
    view.visit_bands([&](const PotSamples& samples) {
        pixels.clear();
        add_pixels(samples, pot, pixels);
        paint_pixels(pixels, pot.colours, turn, painting);
    });
}

ui::Painting empty_painting(const PotExtent& extent) {
    ui::Painting painting{.width = extent.width_px, .height = extent.height_px, .rgba = {}};
    painting.rgba.resize(static_cast<std::size_t>(painting.width) *
                         static_cast<std::size_t>(painting.height) * 4);
    return painting;
}

}  // namespace onggi::screens
