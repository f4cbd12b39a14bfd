#include "engine/render/pixels/photograph_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/pixels/bend_rows.h"

namespace onggi::render {
namespace {

struct Layers {
    vec4 window;
    std::size_t width = 0;
    std::size_t height = 0;
    std::uint32_t* with_key = nullptr;
    std::uint32_t* without_key = nullptr;
};

// Where a row of the picture lies in a photograph.
bend::Place place_of(const Layers& layers, const HostPhotograph& photograph, std::size_t y) {
    const vec4& window = layers.window;
    const auto width = static_cast<float>(photograph.width());
    const auto height = static_cast<float>(photograph.height());
    const float down = (static_cast<float>(y) + 0.5F) * window.y + window.w;
    return {.u = {.first = (0.5F * window.x + window.z) * width - 0.5F, .step = window.x * width},
            .v = {.first = down * height - 0.5F, .step = 0.0F}};
}

[[gnu::always_inline]] inline void take_row(const HostPhotograph& photograph, const bend::Place& place,
                                            std::uint32_t* pixels, int count) {
    // A texel a pixel, as nearly as one can see at the end of a row.
    constexpr float kAlike = 1.0F / 65536.0F;
    if (std::abs(place.u.step - 1.0F) > kAlike || !bend::lies_in(photograph, place, count)) {
        bend::take_one(photograph, place, pixels, count);
        return;
    }
    const bend::FixedRow row{bend::fixed(std::max(place.u.first, 0.0F)), bend::kOne,
                             bend::fixed(std::max(place.v.first, 0.0F)), 0};
    bend::take_inside(photograph, row, pixels, count);
}

[[gnu::always_inline]] inline void lay(const HostPlate& plate, const Layers& layers) {
    // So short that both pieces are still at hand when they are brought together.
    constexpr std::size_t kPiece = 256;
    std::array<std::uint32_t, kPiece> unlit;
    for (std::size_t y = 0; y < layers.height; ++y) {
        const bend::Place lit_from = place_of(layers, plate.key, y);
        const bend::Place unlit_from = place_of(layers, plate.ambient, y);
        for (std::size_t x = 0; x < layers.width; x += kPiece) {
            const std::size_t count = std::min(kPiece, layers.width - x);
            const auto take = [&](const HostPhotograph& photograph, const bend::Place& place,
                                  std::uint32_t* pixels) __attribute__((always_inline)) {
                take_row(photograph, {{place.u.at(static_cast<int>(x)), place.u.step}, place.v}, pixels,
                         static_cast<int>(count));
            };
            std::uint32_t* const with_key = layers.with_key + y * layers.width + x;
            std::uint32_t* const without_key = layers.without_key + y * layers.width + x;
            take(plate.key, lit_from, with_key);
            take(plate.ambient, unlit_from, unlit.data());
            for (std::size_t i = 0; i < count; ++i) {
                constexpr std::uint32_t kColours = 0x00FFFFFFU;
                without_key[i] = (without_key[i] & ~kColours) | (unlit[i] & kColours);
                // Compression may leave the lit picture the darker one by a level.
                std::uint32_t lit = 0xFF000000U;
                for (std::uint32_t shift = 0; shift < 24U; shift += 8U) {
                    const std::uint32_t channel = 0xFFU << shift;
                    lit |= std::max(with_key[i] & channel, unlit[i] & channel);
                }
                with_key[i] = lit;
            }
        }
    }
}

#if defined(__x86_64__)
// The same lines with better instructions; without fused multiply-add, so the same bits.
[[gnu::target("avx2")]] void lay_avx2(const HostPlate& plate, const Layers& layers) {
    lay(plate, layers);
}
#endif

}  // namespace

void lay_photographs(const HostPlate& plate, vec4 window, int width, std::span<std::uint32_t> with_key,
                     std::span<std::uint32_t> without_key) {
    const auto across = static_cast<std::size_t>(width);
    const Layers layers{.window = window,
                        .width = across,
                        .height = with_key.size() / across,
                        .with_key = with_key.data(),
                        .without_key = without_key.data()};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") != 0) return lay_avx2(plate, layers);
#endif
    lay(plate, layers);
}

}  // namespace onggi::render
