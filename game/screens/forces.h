// The forces of a touch, made visible: an arrow for each where the hand touches the clay, the rings it
// touches lit, and how force and tick rate went lately. Drawn anew every frame. Main thread. Pixels, N.
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

// How force and tick rate went in the last few seconds, for their plots: a ring of samples, one a frame. Main
// thread. s, N, Hz.
class ForceTrace {
  public:
    static constexpr double kWindowS = 4.0;
    static constexpr std::size_t kMost = 512;  // 120 frames a second fill less

    struct Sample {
        double time_s = 0.0;
        double force_n = 0.0;
        double rate_hz = 0.0;
    };

    // Times ascend; ticks: how many the loop has run since it began.
    void add(double time_s, double force_n, std::uint64_t ticks);

    // Oldest first; those older than the window are gone.
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] const Sample& at(std::size_t place) const { return kept(place).sample; }
    // Of the last quarter of a second; 0 before there was one.
    [[nodiscard]] double rate_hz() const { return count_ == 0 ? 0.0 : at(count_ - 1).rate_hz; }
    // What a plot's height stands for: the next of 0.1, 0.2, 0.5, 1, 2, 5 up to 100 N that nothing in the
    // window passes.
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
    // How much of its length is seen; little: it points into the picture, or out of it.
    float seen = 1.0F;
    bool towards = false;  // out of it
    bool shown = false;    // there is such a force
};

// Where one hand touches.
struct ForceTouch {
    std::array<ForceArrow, kForceCount> arrows{};
    std::vector<std::vector<vec2>> rings_px{};  // a line for each that is lit, or for some of many
    // The stretch of clay they fill; empty: seen through its mouth.
    std::vector<vec2> upper_px{};
    std::vector<vec2> lower_px{};
};

struct ForceFrame {
    std::vector<ForceTouch> touches{};  // the first has names at its arrows
    std::array<double, kForceCount> size_n{};
    const ForceTrace* trace = nullptr;
    bool with_sum = true;  // else the three alone, as a lesson
};

// What drawing needs of its surroundings.
struct ForcePainter {
    ui::DrawList& list;
    float px_per_u = 1.0F;
    ui::Rect bounds_px;
    std::function<std::optional<ui::Rect>(const Item&)> place;  // in the atlas
};

// The line and head of one force; they differ in form too, so that colour is never the only sign.
void draw_arrow(ui::DrawList& list, Force force, vec2 from_px, vec2 to_px, float px_per_u);
void draw_touches(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter);
// What forces are shown with on a page, and the panel where the visitor asked for it. The composer's thread.
void add_forces(Page& page);
// Nothing but that, over a picture that plays by itself.
[[nodiscard]] Composition compose_forces(const View& view, ui::Painter& painter, PaintingStore& store);
// What changes in the panel: its numbers and plots.
void draw_force_panel(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter);

// Boxes side by side on a screen: each moved as little as possible so that none covers another. Those that
// cannot be kept apart on the screen stay on it.
void keep_apart(std::span<ui::Rect> boxes, const ui::Rect& bounds, float gap);

}  // namespace onggi::screens
