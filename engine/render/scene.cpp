#include "engine/render/scene.h"

namespace onggi::render {
namespace {

bool is_whole(const Background& background, const PhotographPair& pair) {
    const auto is_whole_picture = [&](const asset::Image& image) {
        return image.width > 0 && image.height > 0 && image.width == background.width_px &&
               image.height == background.height_px &&
               image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                        static_cast<std::size_t>(image.height);
    };
    return is_whole_picture(pair.key) && is_whole_picture(pair.ambient);
}

}  // namespace

Result<const PhotographPair*> whole_pair(const Background& background) {
    if (!background.photographs) return failed("background: expected its photographs, found none");
    const auto pair = background.photographs->pair();
    if (!pair) return pair.error();
    if (!is_whole(background, **pair)) {
        return failed("background: expected two whole pictures of one size, found others");
    }
    return pair;
}

Result<const PhotographPair*> Photographs::pair() {
    if (!pair_) {
        auto again = read_();
        if (!again) return again.error();
        pair_ = std::move(*again);
    }
    return static_cast<const PhotographPair*>(&*pair_);
}

void Photographs::let_go() {
    if (read_) pair_.reset();
}

}  // namespace onggi::render
