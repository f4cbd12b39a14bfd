// Shows the forces of a touch: an arrow for each at the hand's contact, the touched rings lit, and plots of
// force and tick rate. Redrawn every frame. Main thread. Pixels, N.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/ui/draw_list.h"
#include "game/screens/page/page.h"

namespace onggi::screens {

// Force and tick rate of the last few seconds for the plots: a ring buffer with one sample a frame. Main
// thread. s, N, Hz.
class ForceTrace {
  public:
    static constexpr double kWindowS = 4.0;
    static constexpr std::size_t kMost = 512;  // enough for 120 frames a second

    struct Sample {
        double time_s = 0.0;
        double force_n = 0.0;
        double rate_hz = 0.0;
    };

    // Times must ascend; `ticks` is the loop's count since its start.
    void add(double time_s, double force_n, std::uint64_t ticks);

    // Oldest first; samples older than the window are dropped.
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const Sample& at(std::size_t place) const { return kept(place).sample; }
    // The rate over the last quarter of a second; 0 before the first sample.
    [[nodiscard]] double rate_hz() const { return count_ == 0 ? 0.0 : at(count_ - 1).rate_hz; }
    // The force at the plot's full height: the smallest of 0.1, 0.2, 0.5, 1, 2, 5 up to 100 N that covers all
    // samples.
    [[nodiscard]] double full_n() const { return full_n_; }

  private:
    struct Kept {
        Sample sample;
        std::uint64_t ticks = 0;
    };
    [[nodiscard]] const Kept& kept(std::size_t place) const { return ring_[(first_ + place) % kMost]; }

    std::array<Kept, kMost> ring_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    double full_n_ = 0.1;
};

struct ForceArrow {
    vec2 from_px{0.0F};
    vec2 to_px{0.0F};
    // The visible fraction of its length: small if the arrow points into or out of the picture.
    float seen = 1.0F;
    bool towards = false;  // points out of the picture
    bool shown = false;    // the force exists
};

// The contact of one hand.
struct ForceTouch {
    std::array<ForceArrow, kForceCount> arrows{};
    std::vector<std::vector<vec2>> rings_px{};  // a line per lit ring; a selection if many are touched
    // The upper and lower edge of the touched band; empty if seen through the pot's mouth.
    std::vector<vec2> upper_px{};
    std::vector<vec2> lower_px{};
    bool is_beside = true;  // the hand comes from beside, not from above
};

struct ForceFrame {
    std::vector<ForceTouch> touches{};  // only the first one's arrows are named
    std::array<double, kForceCount> size_n{};
    const ForceTrace* trace = nullptr;
    bool with_sum = true;  // false: only the three parts, for a lesson
};

// The context for drawing.
struct ForcePainter {
    ui::DrawList& list;
    float px_per_u = 1.0F;
    ui::Rect bounds_px;
    std::function<std::optional<ui::Rect>(const Item&)> place;  // in the atlas
};

// Draws the line and head of one force. Each force has its own shape too, so that colour is not the only
// sign.
void draw_arrow(ui::DrawList& list, Force force, vec2 from_px, vec2 to_px, float px_per_u);
void draw_touches(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter);
// Adds to a page the parts that show forces, and the panel if the visitor asked for it. The composer's
// thread.
void add_forces(Page& page);
// Composes only those parts, over a picture that plays by itself.
[[nodiscard]] Composition compose_forces(const View& view, ui::Painter& painter, PaintingStore& store);
// Draws the changing parts of the panel: its numbers and plots.
void draw_force_panel(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter);

// Moves boxes as little as possible so that they do not overlap and stay within the bounds. If there is not
// enough room, they overlap.
void keep_apart(std::span<ui::Rect> boxes, const ui::Rect& bounds, float gap);

}  // namespace onggi::screens
