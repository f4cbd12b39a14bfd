#include "engine/render/cpu/damage_tracker.h"

#include <algorithm>
#include <cstddef>

namespace onggi::render {

void DamageTracker::take_work(const TileContents& wanted, TileWork& work) {
    const std::size_t count = wanted.picture.size();
    if (picture_.size() != count) {
        picture_.assign(count, 0);
        overlay_.assign(count, 0);
    }
    work.bare.assign(count, 0);
    work.laid_over.assign(count, 0);
    work.moves.assign(count, 0);
    work.moves_under.assign(count, 0);
    for (std::size_t tile = 0; tile < count; ++tile) {
        const std::uint64_t overlay = wanted.overlay.empty() ? 0 : wanted.overlay[tile];
        if (!wanted.moving.empty() && wanted.moving[tile] != 0) {
            (overlay == 0 ? work.moves : work.moves_under)[tile] = 1;
            picture_[tile] = overlay_[tile] = 0;
            continue;
        }
        const bool is_there = picture_[tile] == wanted.picture[tile] && overlay_[tile] == overlay;
        if (!is_there) (overlay == 0 ? work.bare : work.laid_over)[tile] = 1;
        picture_[tile] = wanted.picture[tile];
        overlay_[tile] = overlay;
    }
}

DamageTracker& HeldTargets::held_by(const vk::TargetImage& target) {
    const auto is_it = [&](const Known& known) { return known.image == target.image; };
    const auto known = std::find_if(known_.begin(), known_.end(), is_it);
    auto at = static_cast<std::size_t>(known - known_.begin());
    if (known == known_.end()) {
        // Handles of images that are gone are used again, so that few are ever known.
        constexpr std::size_t kMostTargets = 16;
        if (known_.size() == kMostTargets) known_.erase(known_.begin());
        at = known_.size();
        known_.emplace_back();
    }
    Known& found = known_[at];
    // Another handle's image, or one in which a frame was made in another way since.
    const bool is_as_left = target.frames_before > 0 && target.frames_before == found.frame + 1;
    if (!is_as_left) found.held.forget();
    found.image = target.image;
    found.frame = target.frames_before;
    return found.held;
}

}  // namespace onggi::render
