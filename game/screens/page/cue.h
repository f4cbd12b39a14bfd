// Draws the cues on the clay in every frame: the belt where a touch acts, the arrow in the direction of
// motion, the thread from a finger to hands that lag behind it, and the hatched band of a warning. Main
// thread. Pixels.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/ui/draw_list.h"

namespace onggi::screens {

// A band of the clay: its upper and lower edge, from left to right.
struct Band {
    std::vector<vec2> upper{};
    std::vector<vec2> lower{};
};

// The reason why the clay follows the finger only in part; kNone if it follows fully.
enum class CueGuard { kNone, kNoMoreClay, kAsNarrow, kAsWide, kAsLow, kNearLimit, kAsHigh };
constexpr int kCueGuardCount = 7;
// The language tables' key of the reason; empty for kNone.
[[nodiscard]] std::string_view key_of(CueGuard guard);

// The direction of a hand's motion on the screen.
enum class CueWay { kNone, kLeft, kRight, kDown, kUp };

struct Thread {
    vec2 finger_px{0.0F};
    vec2 hand_px{0.0F};
    float strength = 0.0F;  // 0 to 1
};

struct Cue {
    Band belt{};  // may be empty
    std::vector<vec2>
        ring{};  // a closed line on top of the clay, which replaces the belt when the middle is opened
    Thread thread{};
    CueWay way = CueWay::kNone;
    vec2 way_px{0.0F};  // start of the arrow
    CueGuard guard = CueGuard::kNone;
    bool words_on_left = false;  // words left of the belt, away from the hand
};

// How far a segment of a line across the clay faces the viewer, 0 at both sides to 1.
[[nodiscard]] float facing(std::size_t segment, std::size_t points);
// Draws the parts of a line across the clay, from left to right, with their strengths: it fades out at both
// sides, where the wall turns away and hands stand before it.
void draw_across(std::span<const vec2> edge, const std::function<void(std::span<const vec2>, float)>& draw);

// alpha is its opacity, 0 to 1.
void draw_cue(ui::DrawList& list, const Cue& cue, float alpha, float px_per_u);
// drift is the hatch's offset in steps, 0 to 1.
void draw_warning(ui::DrawList& list, const Band& band, float drift, float px_per_u);

}  // namespace onggi::screens
