#include "engine/render/pixels/photograph_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/render/pixels/photograph_rows.h"
#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

struct Layers {
    vec4 window;
    std::size_t width = 0;
    std::size_t first_row = 0;
    std::size_t end_row = 0;
    std::uint32_t* with_key = nullptr;
    std::uint32_t* without_key = nullptr;
};

// Where a row of the picture lies in a photograph.
rows::Place place_of(const Layers& layers, const HostPhotograph& photograph, std::size_t y) {
    const vec4& window = layers.window;
    const auto width = static_cast<float>(photograph.width());
    const auto height = static_cast<float>(photograph.height());
    const float down = (static_cast<float>(y) + 0.5F) * window.y + window.w;
    return {.u = {.first = (0.5F * window.x + window.z) * width - 0.5F, .step = window.x * width},
            .v = {.first = down * height - 0.5F, .step = 0.0F}};
}

[[gnu::always_inline]] inline void take_row(const HostPhotograph& photograph, const rows::Place& place,
                                            std::uint32_t* pixels, int count) {
    // A texel a pixel, as nearly as one can see at the end of a row.
    constexpr float kAlike = 1.0F / 65536.0F;
    if (std::abs(place.u.step - 1.0F) > kAlike || !rows::lies_in(photograph, place, count)) {
        rows::take_stretched(photograph, place, pixels, count);
        return;
    }
    const rows::FixedPlace first{rows::fixed(std::max(place.u.first, 0.0F)),
                                 rows::fixed(std::max(place.v.first, 0.0F))};
    rows::take_as_it_is(photograph, first, pixels, count);
}

[[gnu::always_inline]] inline void lay(const HostPlate& plate, const Layers& layers) {
    // So short that both pieces are still at hand when they are brought together.
    constexpr std::size_t kPiece = 256;
    std::array<std::uint32_t, kPiece> unlit;
    for (std::size_t y = layers.first_row; y < layers.end_row; ++y) {
        const rows::Place lit_from = place_of(layers, plate.key, y);
        const rows::Place unlit_from = place_of(layers, plate.ambient, y);
        for (std::size_t x = 0; x < layers.width; x += kPiece) {
            const std::size_t count = std::min(kPiece, layers.width - x);
            const auto take = [&](const HostPhotograph& photograph, const rows::Place& place,
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

void lay_plain(const HostPlate& plate, const Layers& layers) {
    lay(plate, layers);
}

ONGGI_WIDE_VECTORS void lay_wide(const HostPlate& plate, const Layers& layers) {
    lay(plate, layers);
}

}  // namespace

void lay_photographs(const HostPlate& plate, vec4 window, int width, RowSpan rows,
                     std::span<std::uint32_t> with_key, std::span<std::uint32_t> without_key) {
    const Layers layers{.window = window,
                        .width = static_cast<std::size_t>(width),
                        .first_row = static_cast<std::size_t>(rows.first),
                        .end_row = static_cast<std::size_t>(rows.end),
                        .with_key = with_key.data(),
                        .without_key = without_key.data()};
    static auto* const best = best_of(lay_plain, lay_wide);
    best(plate, layers);
}

}  // namespace onggi::render
