#include "engine/ui/atlas.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::ui {
namespace {

constexpr int kGapPx = 1;  // a filter at a painting's edge must not read its neighbour
constexpr int kShelfStepPx = 12;

const std::shared_ptr<const Painting>& clear_pixel() {
    static const auto pixel =
        std::make_shared<const Painting>(Painting{.width = 1, .height = 1, .rgba = {0, 0, 0, 0}});
    return pixel;
}

}  // namespace

int Atlas::side_px_for(int width_px, int height_px) {
    constexpr double kPictures = 4.0;  // pictures per half; a screen has no more
    constexpr int kStepPx = 64;
    constexpr int kMostPx = 8192;
    const double pixels = static_cast<double>(width_px) * static_cast<double>(height_px);
    const int steps = static_cast<int>(std::ceil(std::sqrt(2.0 * kPictures * pixels) / kStepPx));
    return std::clamp(steps * kStepPx, kStepPx, kMostPx);
}

Atlas::Atlas(int side_px) : side_(side_px) {
    halves_[1].top = side_px / 2;
    for (Half& half : halves_)
        empty(half);
}

void Atlas::empty(Half& half) {
    half.next_shelf_y = half.top;
    half.shelves.clear();
    half.places.clear();
}

std::optional<Rect> Atlas::room_for(Half& half, int width, int height) const {
    const auto take = [&](Shelf& shelf) {
        const Rect rect{static_cast<float>(shelf.used), static_cast<float>(shelf.y),
                        static_cast<float>(width), static_cast<float>(height)};
        shelf.used += width + kGapPx;
        return rect;
    };
    // Rounded up, so that texts of nearly the same height share a shelf.
    const int rounded = (height + kShelfStepPx - 1) / kShelfStepPx * kShelfStepPx;
    for (Shelf& shelf : half.shelves) {
        // A shelf of more than one and a half times the height would waste more than a new one.
        const bool fits = height <= shelf.height && 3 * rounded >= 2 * shelf.height;
        if (fits && shelf.used + width <= side_) return take(shelf);
    }
    if (width > side_ || half.next_shelf_y + height > half.top + side_ / 2) return std::nullopt;
    const int shelf_height = std::min(rounded, half.top + side_ / 2 - half.next_shelf_y);
    half.shelves.push_back({.y = half.next_shelf_y, .height = shelf_height, .used = 0});
    half.next_shelf_y += shelf_height + kGapPx;
    return take(half.shelves.back());
}

std::optional<Rect> Atlas::find(std::uint64_t key) {
    for (Half& half : halves_) {
        const auto found = half.places.find(key);
        if (found == half.places.end()) continue;
        found->second.asked = asking_;
        return found->second.rect;
    }
    return std::nullopt;
}

std::optional<Rect> Atlas::place(std::uint64_t key, const std::shared_ptr<const Painting>& painting) {
    if (const std::optional<Rect> found = find(key)) return found;
    if (painting->width > side_ || painting->height > side_ / 2) return std::nullopt;
    std::optional<Rect> rect = room_for(halves_[current_], painting->width, painting->height);
    if (!rect) {
        current_ = 1 - current_;
        empty(halves_[current_]);
        ++generation_;
        std::erase_if(uploads_, [&](const Upload& upload) {
            const int top = halves_[current_].top;
            return upload.y >= top && upload.y < top + side_ / 2;
        });
        rect = room_for(halves_[current_], painting->width, painting->height);
    }
    if (!rect) return std::nullopt;
    halves_[current_].places.emplace(key, Place{*rect, asking_});
    uploads_.push_back({static_cast<int>(rect->x), static_cast<int>(rect->y), painting});
    return rect;
}

std::optional<Rect> Atlas::replace(std::uint64_t key, const std::shared_ptr<const Painting>& painting) {
    const std::optional<Rect> found = find(key);
    if (!found) return place(key, painting);
    uploads_.push_back({static_cast<int>(found->x), static_cast<int>(found->y), painting});
    return found;
}

// The space on the shelf becomes free only when the half is emptied.
void Atlas::forget_unasked() {
    for (Half& half : halves_) {
        std::erase_if(half.places, [&](const auto& entry) {
            const Place& place = entry.second;
            if (place.asked == asking_) return false;
            uploads_.push_back(
                {static_cast<int>(place.rect.x), static_cast<int>(place.rect.y), clear_pixel()});
            return true;
        });
    }
}

std::vector<Atlas::Upload> Atlas::take_uploads() {
    return std::exchange(uploads_, {});
}

}  // namespace onggi::ui
