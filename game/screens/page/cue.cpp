#include "game/screens/page/cue.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "game/screens/page/design.h"

namespace onggi::screens {
namespace {

using ui::Colour;
using ui::DrawList;

constexpr Colour kCream = ui::hex(0xfff3d9);
constexpr float kHatchStepU = 13.0F;

std::size_t points_of(const Band& band) {
    return std::min(band.upper.size(), band.lower.size());
}

// Draws slanted stripes between the edges of a band.
void draw_hatch(DrawList& list, const Band& band, const Colour& colour, float drift, float u) {
    const std::size_t count = points_of(band);
    const auto along = [&](const std::vector<vec2>& edge, float fraction) {
        const float at = std::clamp(fraction, 0.0F, 1.0F) * static_cast<float>(count - 1);
        const auto first = std::min(static_cast<std::size_t>(at), count - 2);
        return glm::mix(edge[first], edge[first + 1], at - static_cast<float>(first));
    };
    const float width = std::max(1.0F, glm::length(band.upper.back() - band.upper.front()));
    const float step = kHatchStepU * u / width;
    const float slant = 0.9F * glm::length(band.lower[count / 2] - band.upper[count / 2]) / width;
    for (float fraction = -slant + drift * step; fraction < 1.0F; fraction += step) {
        const float end = fraction + 0.4F * step;
        if (end <= 0.0F && end + slant <= 0.0F) continue;
        const std::array corners{along(band.upper, fraction + slant), along(band.upper, end + slant),
                                 along(band.lower, end), along(band.lower, fraction)};
        list.add_polygon(corners, colour);
    }
}

}  // namespace

float facing(std::size_t segment, std::size_t points) {
    constexpr float kTurns = 0.3F;
    const float across = (static_cast<float>(segment) + 0.5F) / static_cast<float>(points - 1);
    return std::min(1.0F, std::min(across, 1.0F - across) / kTurns);
}

void draw_across(std::span<const vec2> edge, const std::function<void(std::span<const vec2>, float)>& draw) {
    constexpr float kHidden = 0.02F;
    constexpr float kWhole = 0.12F;
    constexpr float kFadeSteps = 4.0F;
    if (edge.size() < 2) return;
    const float width = std::max(1.0F, edge.back().x - edge.front().x);
    const auto strength = [&](std::size_t segment) {
        const float at = (0.5F * (edge[segment].x + edge[segment + 1].x) - edge.front().x) / width;
        const float inward = (std::min(at, 1.0F - at) - kHidden) / (kWhole - kHidden);
        return std::ceil(kFadeSteps * std::clamp(inward, 0.0F, 1.0F)) / kFadeSteps;
    };
    for (std::size_t first = 0, end = 1; end < edge.size(); first = end++) {
        const float here = strength(first);
        while (end + 1 < edge.size() && strength(end) == here)
            ++end;
        if (here > 0.0F) draw(edge.subspan(first, end - first + 1), here);
    }
}

namespace {

void draw_ring(DrawList& list, std::span<const vec2> edge, float alpha, float u) {
    list.add_line(edge, 7.0F * u, design::kNight.with_alpha(0.55F * alpha));
    list.add_line(edge, 3.4F * u, design::kOutline.with_alpha(alpha));
}

void draw_edge(DrawList& list, const std::vector<vec2>& edge, float alpha, float u) {
    draw_across(edge, [&](std::span<const vec2> part, float strength) {
        draw_ring(list, part, alpha * strength, u);
    });
}

// Draws the belt as slip, thinner at the sides where the wall turns away.
void draw_slip(DrawList& list, const Band& belt, float alpha) {
    const std::size_t count = points_of(belt);
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const std::array corners{belt.upper[i], belt.upper[i + 1], belt.lower[i + 1], belt.lower[i]};
        list.add_polygon(corners, kCream.with_alpha(0.3F * facing(i, count) * alpha));
    }
}

// Draws dots from the hands to the finger, and a ring round the finger.
void draw_thread(DrawList& list, const Thread& thread, float alpha, float u) {
    constexpr float kPitchU = 11.0F;
    constexpr float kRingU = 12.0F;
    const float length = glm::length(thread.finger_px - thread.hand_px);
    if (!(thread.strength > 0.0F) || !(length > 2.0F * kRingU * u)) return;
    const vec2 along = (thread.hand_px - thread.finger_px) / length;
    const float strength = thread.strength * alpha;
    std::array<vec2, 25> ring;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const float angle = kTurnF * static_cast<float>(i) / (ring.size() - 1);
        ring[i] = thread.finger_px + kRingU * u * vec2(std::cos(angle), std::sin(angle));
    }
    const auto both = [&](float line_u, const Colour& colour) {
        list.add_line(ring, line_u * u, colour);
        for (float way = (kRingU + kPitchU) * u; way < length; way += kPitchU * u)
            list.add_disc(thread.finger_px + way * along, 0.5F * line_u * u, colour);
    };
    both(7.0F, design::kNight.with_alpha(0.5F * strength));
    both(3.4F, design::kOutline.with_alpha(strength));
}

// Draws an arrow of dots with a head, cream over dark.
void draw_way(DrawList& list, CueWay way, vec2 from, float alpha, float u) {
    constexpr int kDots = 5;
    constexpr float kPitchU = 17.0F;
    const vec2 along = way == CueWay::kLeft    ? vec2(-1.0F, 0.0F)
                       : way == CueWay::kRight ? vec2(1.0F, 0.0F)
                       : way == CueWay::kDown  ? vec2(0.0F, 1.0F)
                                               : vec2(0.0F, -1.0F);
    const vec2 across(-along.y, along.x);
    const vec2 tip = from + ((kDots - 1) * kPitchU + 25.0F) * u * along;
    const std::array head{tip + u * (-13.0F * along + 13.0F * across), tip,
                          tip + u * (-13.0F * along - 13.0F * across)};
    const Colour dark = design::kNight.with_alpha(0.6F * alpha);
    const Colour pale = kCream.with_alpha(alpha);
    const auto both = [&](float line_u, const Colour& colour) {
        for (int dot = 0; dot < kDots; ++dot)
            list.add_disc(from + static_cast<float>(dot) * kPitchU * u * along, 0.5F * line_u * u, colour);
        list.add_line(head, line_u * u, colour);
        list.add_disc(head.front(), 0.5F * line_u * u, colour);
        list.add_disc(head.back(), 0.5F * line_u * u, colour);
    };
    both(13.0F, dark);
    both(7.5F, pale);
}

}  // namespace

std::string_view key_of(CueGuard guard) {
    constexpr std::array<std::string_view, kCueGuardCount> kKeys{
        "", "guard.clay", "guard.narrow", "guard.wide", "guard.low", "guard.limit", "guard.high"};
    return kKeys[static_cast<std::size_t>(guard)];
}

void draw_cue(DrawList& list, const Cue& cue, float alpha, float px_per_u) {
    const float u = px_per_u;
    if (cue.ring.size() > 2) {
        draw_ring(list, cue.ring, alpha, u);
    } else if (points_of(cue.belt) > 1) {
        draw_slip(list, cue.belt, alpha);
        if (cue.guard != CueGuard::kNone)
            draw_hatch(list, cue.belt, design::kNight.with_alpha(0.3F * alpha), 0.0F, u);
        draw_edge(list, cue.belt.upper, alpha, u);
        draw_edge(list, cue.belt.lower, alpha, u);
    }
    draw_thread(list, cue.thread, alpha, u);
    if (cue.way != CueWay::kNone) draw_way(list, cue.way, cue.way_px, alpha, u);
}

void draw_warning(DrawList& list, const Band& band, float drift, float px_per_u) {
    const float u = px_per_u;
    const std::size_t count = points_of(band);
    if (count < 2) return;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const std::array corners{band.upper[i], band.upper[i + 1], band.lower[i + 1], band.lower[i]};
        list.add_polygon(corners, ui::hex(0xe4672c, 0.26F));
    }
    draw_hatch(list, band, design::kHatch.with_alpha(0.8F), drift, u);
    for (const std::vector<vec2>* edge : {&band.upper, &band.lower}) {
        list.add_line(*edge, 8.0F * u, design::kNight.with_alpha(0.65F));
        list.add_line(*edge, 3.5F * u, ui::hex(0xfff1d6));
    }
}

}  // namespace onggi::screens
