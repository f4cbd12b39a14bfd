#include "engine/render/beauty.h"

#include <array>
#include <cmath>

#include "engine/math/eight_bits.h"
#include "engine/math/light.h"

namespace onggi::render {
namespace {

// The additive recurrence of M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018:
// every prefix of the sequence is evenly distributed.
dvec2 spread(int index, double offset) {
    constexpr double kStepX = 0.7548776662466927;
    constexpr double kStepY = 0.5698402909980532;
    const double n = static_cast<double>(index) + offset;
    return {n * kStepX - std::floor(n * kStepX), n * kStepY - std::floor(n * kStepY)};
}

}  // namespace

std::uint8_t srgb_byte(float light) {
    // A power for most channels of a picture is spared: where both ends of a step encode to the same byte, so
    // does all between.
    constexpr int kSteps = 4096;
    const auto exact = [](float of) { return eight_bits(srgb_from_linear(of)); };
    static const auto ends = [&] {
        std::array<std::uint8_t, kSteps + 1> bytes{};
        for (int i = 0; i <= kSteps; ++i)
            bytes[static_cast<std::size_t>(i)] = exact(static_cast<float>(i) / kSteps);
        return bytes;
    }();
    if (!(light > 0.0F)) return 0;
    if (light >= 1.0F) return 255;
    const auto step = static_cast<std::size_t>(light * kSteps);
    return ends[step] == ends[step + 1] ? ends[step] : exact(light);
}

Scene beauty_sample(const Scene& scene, int index, int width_px, int height_px) {
    Scene sample = scene;
    const dvec2 aside = spread(index, 0.5) - 0.5;  // fraction of a pixel
    sample.camera.shift = vec2(2.0 * aside.x / width_px, 2.0 * aside.y / height_px);

    // Samples the light's disc evenly. Each sample keeps a smaller light, which covers the gaps between the
    // samples.
    const dvec2 on_light = spread(index, 0.25);
    const double angle = kTurn * on_light.x;
    const double off = std::sqrt(on_light.y) * std::tan(double{scene.key.angular_radius_rad});
    const dvec3 l(scene.key.towards_light);
    const dvec3 side =
        glm::normalize(glm::cross(l, std::abs(l.y) < 0.9 ? dvec3(0.0, 1.0, 0.0) : dvec3(1.0, 0.0, 0.0)));
    const dvec3 up = glm::cross(side, l);
    sample.key.towards_light =
        vec3(glm::normalize(l + off * (std::cos(angle) * side + std::sin(angle) * up)));
    sample.key.angular_radius_rad = 0.5F * scene.key.angular_radius_rad;
    return sample;
}

Accumulation::Accumulation(int width_px, int height_px, int across)
    : width_px_(width_px),
      height_px_(height_px),
      across_(across),
      light_(std::size_t{3} * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px),
             0.0F) {}

void Accumulation::add(std::span<const std::uint8_t> rgba) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (int value = 0; value < 256; ++value)
            values[static_cast<std::size_t>(value)] = linear_from_srgb(static_cast<float>(value) / 255.0F);
        return values;
    }();
    const std::uint8_t* from = rgba.data();
    for (int y = 0; y < height_px_ * across_; ++y) {
        float* to = light_.data() + std::ptrdiff_t{3} * (y / across_) * width_px_;
        for (int x = 0; x < width_px_; ++x, to += 3) {
            for (int k = 0; k < across_; ++k, from += 4) {
                for (int channel = 0; channel < 3; ++channel)
                    to[channel] += table[from[channel]];
            }
        }
    }
    ++count_;
}

asset::Image Accumulation::mean() const {
    asset::Image image{.width = width_px_, .height = height_px_, .rgba = {}};
    image.rgba.resize(light_.size() / 3 * 4, 255);
    const float fraction = 1.0F / static_cast<float>(count_ * across_ * across_);
    for (std::size_t pixel = 0; pixel < light_.size() / 3; ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            image.rgba[4 * pixel + channel] = srgb_byte(fraction * light_[3 * pixel + channel]);
    }
    return image;
}

}  // namespace onggi::render
