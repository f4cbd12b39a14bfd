#include "engine/render/frame/background_pair.h"

#include <cmath>

namespace onggi::render {
namespace {

bool is_whole(const Background& background, const PhotographPair& pair) {
    const auto is_whole_picture = [&](const asset::Image& image) {
        return image.width > 0 && image.height > 0 && image.width == background.width_px &&
               image.height == background.height_px &&
               image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                        static_cast<std::size_t>(image.height);
    };
    const Relief& relief = background.relief;
    const bool has_relief = !relief.depth_mm.empty();
    return is_whole_picture(pair.key) && is_whole_picture(pair.ambient) &&
           (!has_relief || (relief.columns >= 2 && relief.rows >= 2 &&
                            relief.depth_mm.size() == static_cast<std::size_t>(relief.columns) *
                                                          static_cast<std::size_t>(relief.rows)));
}

}  // namespace

std::array<std::uint8_t, 256> transfer_table(Transfer transfer) {
    std::array<std::uint8_t, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double v = static_cast<double>(i) / 255.0;
        const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        const double shown = transfer == Transfer::kExactSrgb ? v : std::sqrt(linear);
        table[i] = static_cast<std::uint8_t>(std::lround(255.0 * shown));
    }
    return table;
}

Result<const PhotographPair*> whole_pair(const Background& background) {
    if (!background.photographs) return failed("plate: expected its photographs, found none");
    const auto pair = background.photographs->pair();
    if (!pair) return pair.error();
    if (!is_whole(background, **pair)) {
        return failed("plate: expected two whole pictures of one size and a whole relief, found others");
    }
    return pair;
}

}  // namespace onggi::render
