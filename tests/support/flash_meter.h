// Whether a moving picture flashes, by WCAG 2.3.1: a flash is a pair of opposing changes of relative
// luminance of a tenth of the largest or more, the darker below 0.80; more than three of them within a second
// may harm. Looked at for the whole picture and for each of its tiles, of which none is as large as the area
// that the guideline lets flash (a quarter of ten degrees of view: 2.8 % of a screen).
#pragma once

#include <deque>
#include <span>
#include <string>
#include <vector>

#include "engine/asset/image.h"

namespace onggi::support {

// 0 black to 1 white, of an sRGB-encoded pixel: WCAG's definition.
[[nodiscard]] double relative_luminance(std::span<const std::uint8_t, 3> rgb);

// One brightness over time.
class FlashCount {
  public:
    static constexpr double kChange = 0.10;
    static constexpr double kDarkest = 0.80;  // the darker of the two has to be below
    static constexpr double kWindowS = 1.0;

    void see(double now_s, double luminance);
    // Opposing changes, one after another, within any second so far; two make a flash.
    [[nodiscard]] int most_changes() const { return most_; }
    [[nodiscard]] double at_s() const { return most_at_s_; }

  private:
    bool has_begun_ = false;
    double lowest_ = 0.0;   // since the last change
    double highest_ = 0.0;  // the same
    int direction_ = 0;     // of the last change
    std::deque<double> changes_s_;
    int most_ = 0;
    double most_at_s_ = 0.0;
};

class FlashMeter {
  public:
    static constexpr int kAcross = 8;
    static constexpr int kDown = 6;
    static constexpr int kMostChanges = 6;  // three flashes

    void see(double now_s, const asset::Image& picture);
    // The whole picture's and each tile's, the worst of them.
    [[nodiscard]] const FlashCount& worst() const;
    [[nodiscard]] bool is_calm() const { return worst().most_changes() <= kMostChanges; }
    // The largest step of the whole picture's luminance from one look to the next.
    [[nodiscard]] double largest_step() const { return largest_step_; }
    [[nodiscard]] int looks() const { return looks_; }
    [[nodiscard]] std::string in_words() const;

  private:
    std::vector<FlashCount> places_{std::size_t{kAcross} * kDown + 1};  // the whole picture last
    double last_ = 0.0;
    double largest_step_ = 0.0;
    int looks_ = 0;
};

}  // namespace onggi::support
