// The streaks that fingers leave on what turns, as a texture made when it is first asked for: long
// round the pot and thin up it, a fine grain, a few pits. Any thread; the same bytes every time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace onggi::render {

constexpr int kDetailTexels = 512;

// kDetailTexels squared, RGBA: lighter or darker, lean round, lean up, thickness of the film; 128 is the
// mean. It repeats both ways.
[[nodiscard]] const std::vector<std::uint8_t>& detail_texture();

// The same with fewer texels, each the mean of those it stands for: finer than the pixels it is seen by, a
// texture flickers, and falls out of the processor's cache. Both numbers divide kDetailTexels.
[[nodiscard]] std::vector<std::uint8_t> coarser_detail(std::span<const std::uint8_t> texels, int across,
                                                       int up);

// That many, one after another: each texel of a level is the mean of twice as many above one another as in
// the level before, the first as it is. For walls that are seen so slantwise that several texels lie under a
// pixel.
constexpr int kStreakLevels = 4;
[[nodiscard]] std::vector<std::uint8_t> streak_levels(std::span<const std::uint8_t> texels, int across,
                                                      int up);

}  // namespace onggi::render
