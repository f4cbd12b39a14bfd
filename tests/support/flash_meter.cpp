#include "tests/support/flash_meter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::support {
namespace {

const std::array<double, 256>& linear_light() {
    static const std::array<double, 256> light = [] {
        std::array<double, 256> made{};
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double encoded = static_cast<double>(i) / 255.0;
            made[i] = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
        }
        return made;
    }();
    return light;
}

}  // namespace

double relative_luminance(std::span<const std::uint8_t, 3> rgb) {
    const auto& light = linear_light();
    return 0.2126 * light[rgb[0]] + 0.7152 * light[rgb[1]] + 0.0722 * light[rgb[2]];
}

void FlashCount::see(double now_s, double luminance) {
    if (!has_begun_) lowest_ = highest_ = luminance;
    has_begun_ = true;
    lowest_ = std::min(lowest_, luminance);
    highest_ = std::max(highest_, luminance);
    const auto change = [&](int direction, double darker) {
        // A continuing slope is not another change, and a change ends only where the slope ends.
        lowest_ = highest_ = luminance;
        if (direction == direction_ || darker >= kDarkest) return;
        direction_ = direction;
        changes_s_.push_back(now_s);
    };
    if (luminance - lowest_ >= kChange) {
        change(1, lowest_);
    } else if (highest_ - luminance >= kChange) {
        change(-1, luminance);
    }
    while (!changes_s_.empty() && changes_s_.front() <= now_s - kWindowS)
        changes_s_.pop_front();
    if (static_cast<int>(changes_s_.size()) <= most_) return;
    most_ = static_cast<int>(changes_s_.size());
    most_at_s_ = now_s;
}

void FlashMeter::see(double now_s, const asset::Image& picture) {
    std::array<double, std::size_t{kAcross} * kDown> sums{};
    std::array<int, std::size_t{kAcross} * kDown> counts{};
    const auto width = static_cast<std::size_t>(picture.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
        const std::size_t row = y * kDown / static_cast<std::size_t>(picture.height);
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t place = row * kAcross + x * kAcross / width;
            sums[place] += relative_luminance(std::span<const std::uint8_t, 3>(
                picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * (y * width + x)), 3));
            ++counts[place];
        }
    }
    double all = 0.0;
    for (std::size_t place = 0; place < sums.size(); ++place) {
        all += sums[place];
        if (counts[place] > 0) places_[place].see(now_s, sums[place] / counts[place]);
    }
    const double mean = all / static_cast<double>(width * static_cast<std::size_t>(picture.height));
    places_.back().see(now_s, mean);
    if (looks_++ > 0) largest_step_ = std::max(largest_step_, std::abs(mean - last_));
    last_ = mean;
}

const FlashCount& FlashMeter::worst() const {
    return *std::max_element(places_.begin(), places_.end(), [](const FlashCount& a, const FlashCount& b) {
        return a.most_changes() < b.most_changes();
    });
}

std::string FlashMeter::in_words() const {
    return fmt::format(
        "{} looks; at most {} changes of a tenth within a second, at {:.2f} s; the whole "
        "picture by {:.3f} from one look to the next",
        looks_, worst().most_changes(), worst().at_s(), largest_step_);
}

}  // namespace onggi::support
