// What is drawn round the clay itself, anew each frame: the calm belt that says where a touch takes hold, the
// arrow that says which way, the thread from a finger to hands that lag behind it, and the hatched band that
// warns. Main thread. Pixels.
#pragma once

#include <string_view>
#include <vector>

#include "engine/ui/draw_list.h"

namespace onggi::screens {

// A stretch of the clay: its upper and lower edge, from left to right.
struct Band {
    std::vector<vec2> upper{};
    std::vector<vec2> lower{};
};

// Why the clay does less than the finger asks; none: it does all.
enum class CueGuard { kNone, kNoMoreClay, kAsNarrow, kAsWide, kAsLow, kNearLimit };
constexpr int kCueGuardCount = 6;
// Key of its words; empty for none.
[[nodiscard]] std::string_view key_of(CueGuard guard);

// The way a hand goes, as the screen has it.
enum class CueWay { kNone, kLeft, kRight, kDown, kUp };

struct Thread {
    vec2 finger_px{0.0F};
    vec2 hand_px{0.0F};
    float strength = 0.0F;  // 0: none, to 1
};

struct Cue {
    Band belt{};               // empty: none
    std::vector<vec2> ring{};  // instead of it, on top of the clay: where the middle is opened; closed
    Thread thread{};
    CueWay way = CueWay::kNone;
    vec2 way_px{0.0F};  // where the arrow begins
    CueGuard guard = CueGuard::kNone;
    bool words_on_left = false;  // of the belt: where the hand is not
};

// alpha: 0 to 1, how much of it is there.
void draw_cue(ui::DrawList& list, const Cue& cue, float alpha, float px_per_u);
// drift: 0 to 1, how far the hatch has gone of one of its steps.
void draw_warning(ui::DrawList& list, const Band& band, float drift, float px_per_u);

}  // namespace onggi::screens
