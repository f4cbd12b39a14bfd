// The texture of the streaks that fingers leave on the turning pot, created on first use: streaks long around
// and thin upwards, a fine grain, a few pits. Any thread; deterministic.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace onggi::render {

constexpr int kDetailTexels = 512;

// kDetailTexels squared, RGBA: brightness, slope around, slope upwards, thickness of the film; 128 is the
// mean. Tiles in both directions.
[[nodiscard]] const std::vector<std::uint8_t>& detail_texture();

// Returns the texture with fewer texels, each the mean of a block. A texture finer than the pixels would
// flicker and would not fit into the processor's cache. `across` and `up` divide kDetailTexels.
[[nodiscard]] std::vector<std::uint8_t> coarser_detail(std::span<const std::uint8_t> texels, int across,
                                                       int up);

// Returns kStreakLevels copies of full size, back to back; each texel of level n is the mean of 2^n texels in
// a column. For walls at grazing angles, where several texels fall on one pixel.
constexpr int kStreakLevels = 4;
[[nodiscard]] std::vector<std::uint8_t> streak_levels(std::span<const std::uint8_t> texels, int across,
                                                      int up);

}  // namespace onggi::render
