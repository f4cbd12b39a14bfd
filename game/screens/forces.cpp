#include "game/screens/forces.h"

#include <algorithm>
#include <cmath>

#include "game/screens/page/design.h"

namespace onggi::screens {
namespace {

using ui::Colour;
using ui::DrawList;
using ui::Rect;

constexpr float kShaftU = 6.0F;
constexpr float kHeadU = 24.0F;
constexpr float kCasingU = 3.0F;
constexpr float kLeastSeen = 0.35F;  // of an arrow's length; below it stands the sign for into or out of
constexpr float kSignU = 13.0F;

Colour colour_of(Force force) {
    switch (force) {
        case Force::kStiffness:
            return design::kStiffness;
        case Force::kViscosity:
            return design::kViscosity;
        case Force::kFriction:
            return design::kFriction;
        case Force::kTotal:
            break;
    }
    return design::kNight;
}

Colour casing_of(Force force) {
    return force == Force::kTotal ? design::kOutline : design::kNight.with_alpha(0.8F);
}

void draw_head(DrawList& list, vec2 tip, vec2 along, float length, float half, const Colour& colour) {
    const vec2 across(-along.y, along.x);
    const std::array corners{tip, tip - length * along + half * across, tip - length * along - half * across};
    list.add_polygon(corners, colour);
    const std::array edge{corners[0], corners[1], corners[2], corners[0]};
    list.add_line(edge, 0.5F, colour);  // soft edges
}

// As in physics books: a dot is an arrow's tip, a cross its feathers.
void draw_sign(DrawList& list, Force force, vec2 at, bool towards, float u) {
    const Colour colour = force == Force::kTotal ? design::kOutline : colour_of(force);
    list.add_disc(at, (kSignU + kCasingU + 1.0F) * u, design::kNight.with_alpha(0.85F));
    list.add_disc(at, kSignU * u, colour);
    list.add_disc(at, (kSignU - 3.5F) * u, design::kNight);
    if (towards) {
        list.add_disc(at, 4.5F * u, colour);
        return;
    }
    const float arm = 0.62F * (kSignU - 3.5F) * u;
    for (const vec2 way : {vec2(arm, arm), vec2(arm, -arm)}) {
        const std::array line{at - way, at + way};
        list.add_line(line, 3.0F * u, colour);
    }
}

void draw_rings(DrawList& list, const ForceTouch& touch, float u) {
    const std::size_t count = std::min(touch.upper_px.size(), touch.lower_px.size());
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const std::array corners{touch.upper_px[i], touch.upper_px[i + 1], touch.lower_px[i + 1],
                                 touch.lower_px[i]};
        list.add_polygon(corners, design::kAmber.with_alpha(0.30F));
    }
    for (const std::vector<vec2>& ring : touch.rings_px)
        list.add_line(ring, 1.0F * u, design::kWhiteSlip.with_alpha(0.75F));
    for (const std::vector<vec2>* edge : {&touch.upper_px, &touch.lower_px}) {
        list.add_line(*edge, 5.0F * u, design::kNight.with_alpha(0.5F));
        list.add_line(*edge, 2.5F * u, design::kWhiteSlip);
    }
}

struct Named {
    Force force;
    vec2 tip;
};

// In a column beside the touch, on the side away from the pot's middle, each led to from its arrow's tip: at
// the tips themselves names would lie over one another's arrows.
void draw_names(const std::vector<Named>& named, const ForceParts& parts, const ForcePainter& painter) {
    if (named.empty()) return;
    const float u = painter.px_per_u;
    float left = named.front().tip.x;
    float right = left;
    for (const Named& one : named) {
        left = std::min(left, one.tip.x);
        right = std::max(right, one.tip.x);
    }
    const bool is_right = 0.5F * (left + right) >= painter.bounds_px.centre().x;
    constexpr float kAsideU = 34.0F;
    std::vector<Rect> boxes;
    for (const Named& one : named) {
        const Item& item = parts.names[static_cast<std::size_t>(one.force)];
        const vec2 size = u * vec2(item.rect.width, item.rect.height);
        boxes.push_back({is_right ? right + kAsideU * u : left - kAsideU * u - size.x,
                         one.tip.y - 0.5F * size.y, size.x, size.y});
    }
    keep_apart(boxes, painter.bounds_px, 4.0F * u);
    for (std::size_t i = 0; i < named.size(); ++i) {
        const std::array leader{named[i].tip,
                                vec2(is_right ? boxes[i].x : boxes[i].right(), boxes[i].centre().y)};
        painter.list.add_line(leader, 3.5F * u, design::kNight.with_alpha(0.7F));
        painter.list.add_line(leader, 1.5F * u, design::kOutline);
    }
    for (std::size_t i = 0; i < named.size(); ++i) {
        const auto from = painter.place(parts.names[static_cast<std::size_t>(named[i].force)]);
        if (!from) continue;
        painter.list.add_picture({boxes[i].x, boxes[i].y}, *from, 1.0F);
    }
}

}  // namespace

void keep_apart(std::span<Rect> boxes, const Rect& bounds, float gap) {
    const auto onto_screen = [&](Rect& box) {
        box.x = std::clamp(box.x, bounds.x, std::max(bounds.x, bounds.right() - box.width));
        box.y = std::clamp(box.y, bounds.y, std::max(bounds.y, bounds.bottom() - box.height));
    };
    std::for_each(boxes.begin(), boxes.end(), onto_screen);
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
        bool moved = false;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const Rect shared = overlap(boxes[i].grown(0.5F * gap), boxes[k].grown(0.5F * gap));
                if (shared.width <= 0.0F || shared.height <= 0.0F) continue;
                moved = true;
                const bool is_below = boxes[i].centre().y >= boxes[k].centre().y;
                const float step = (0.5F * shared.height + 0.01F) * (is_below ? 1.0F : -1.0F);
                boxes[i].y += step;
                boxes[k].y -= step;
                onto_screen(boxes[i]);
                onto_screen(boxes[k]);
            }
        }
        if (!moved) return;
    }
}

void draw_arrow(DrawList& list, Force force, vec2 from_px, vec2 to_px, float px_per_u) {
    const float u = px_per_u;
    const float length = glm::length(to_px - from_px);
    if (length < 1.0F) return;
    const vec2 along = (to_px - from_px) / length;
    const float head = std::min(kHeadU * u, 0.7F * length);
    const float half = 0.5F * head;
    const vec2 neck = to_px - 0.8F * head * along;
    const Colour colour = colour_of(force);
    const Colour casing = casing_of(force);
    const std::array whole{from_px, neck};
    list.add_line(whole, (kShaftU + 2.0F * kCasingU) * u, casing);
    draw_head(list, to_px + 1.8F * kCasingU * u * along, along, head + 2.8F * kCasingU * u,
              half + 2.0F * kCasingU * u, casing);
    if (force == Force::kViscosity) {  // dashes
        const float step = 13.0F * u;
        const float end = glm::length(neck - from_px);
        for (float at = 0.0F; at < end; at += step) {
            const std::array dash{from_px + at * along, from_px + std::min(at + 0.6F * step, end) * along};
            list.add_line(dash, kShaftU * u, colour);
        }
    } else {
        list.add_line(whole, kShaftU * u, colour);
    }
    draw_head(list, to_px, along, head, half, colour);
    if (force == Force::kFriction && length > 2.2F * head)  // a second head
        draw_head(list, to_px - 0.85F * head * along, along, head, half, colour);
}

void draw_touches(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter) {
    const float u = painter.px_per_u;
    std::vector<Named> named;
    for (std::size_t i = 0; i < frame.touches.size(); ++i) {
        const ForceTouch& touch = frame.touches[i];
        draw_rings(painter.list, touch, u);
        for (std::size_t k = kForceCount; k-- > 0;) {  // the sum lies lowest
            const auto force = static_cast<Force>(k);
            const ForceArrow& arrow = touch.arrows[k];
            if (!arrow.shown || (force == Force::kTotal && !frame.with_sum)) continue;
            const vec2 way = arrow.to_px - arrow.from_px;
            const float length = glm::length(way);
            const vec2 along = length > 0.5F ? way / length : vec2(0.0F, -1.0F);
            vec2 tip = arrow.to_px;
            if (arrow.seen < kLeastSeen) {
                // Beside the touch, where the other arrows begin, it would be lost.
                tip = arrow.from_px + std::max(length, 2.6F * kSignU * u) * along;
                draw_sign(painter.list, force, tip, arrow.towards, u);
                tip += kSignU * u * along;
            } else {
                draw_arrow(painter.list, force, arrow.from_px, arrow.to_px, u);
            }
            if (i == 0) named.push_back({force, tip});
        }
    }
    draw_names(named, parts, painter);
}

}  // namespace onggi::screens
