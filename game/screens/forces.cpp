#include "game/screens/forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::screens {
namespace {

// A frame has a whole number of ticks, so a rate over a single frame would fluctuate.
constexpr double kRateOverS = 0.25;
// Without a force device a hand may press into the clay with tens of newtons.
constexpr std::array kSteps{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};

using ui::Colour;
using ui::DrawList;
using ui::Rect;

constexpr float kShaftU = 6.0F;
constexpr float kHeadU = 24.0F;
constexpr float kCasingU = 3.0F;
constexpr float kLeastSeen =
    0.35F;  // with a shorter visible fraction, an arrow gets the sign for into or out of the picture
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

// The signs of physics books: a dot for an arrow's tip, a cross for its feathers.
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
        list.add_polygon(corners, design::kAmber.with_alpha(0.30F * facing(i, count)));
    }
    const bool is_inside = touch.upper_px.empty();
    const auto line = [&](const std::vector<vec2>& points, float width_u, const Colour& colour) {
        if (is_inside) return list.add_line(points, width_u * u, colour);  // whole circles
        draw_across(points, [&](std::span<const vec2> part, float strength) {
            list.add_line(part, width_u * u, colour.with_alpha(colour.a * strength));
        });
    };
    for (const std::vector<vec2>& ring : touch.rings_px)
        line(ring, 1.0F, design::kWhiteSlip.with_alpha(0.75F));
    for (const std::vector<vec2>* edge : {&touch.upper_px, &touch.lower_px}) {
        line(*edge, 5.0F, design::kNight.with_alpha(0.5F));
        line(*edge, 2.5F, design::kWhiteSlip);
    }
}

struct Named {
    Force force;
    vec2 tip;
};

// Draws the names in a column beside the contact, away from the pot's middle and above a hand that comes from
// there, with a leader line to each arrow's tip: names at the tips would cover other arrows.
void draw_names(const std::vector<Named>& named, bool is_beside, const ForceParts& parts,
                const ForcePainter& painter) {
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
    const float above_u = is_beside ? 128.0F : 0.0F;
    std::vector<Rect> boxes;
    for (const Named& one : named) {
        const Item& item = parts.names[static_cast<std::size_t>(one.force)];
        const vec2 size = u * vec2(item.rect.width, item.rect.height);
        boxes.push_back({is_right ? right + kAsideU * u : left - kAsideU * u - size.x,
                         one.tip.y - above_u * u - 0.5F * size.y, size.x, size.y});
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

// The panel of forces: a composed part, and a part that changes in each frame.

constexpr std::array kNames{"force.stiffness", "force.viscosity", "force.friction", "force.sum"};
constexpr float kRow = 38.0F;
constexpr float kPlotHeight = 58.0F;
constexpr float kNewtonWidth = 26.0F;
constexpr float kUnitWidth = 44.0F;
constexpr float kNumberWidth = 78.0F;
constexpr float kRateWidth = 90.0F;
constexpr float kAir = 16.0F;

struct Places {
    Rect panel;
    Rect forces;  // four rows
    Rect force_plot;
    Rect rate_plot;
};

// Beside the pot on a wide screen, above it on a tall one.
Places places_on(const Page& page) {
    if (page.is_tall()) {
        const Rect panel{24.0F, 124.0F, page.width() - 48.0F, 4.0F * kRow + 2.0F * kAir};
        const float half = 0.5F * (panel.width - 3.0F * kAir);
        const float plot_y = panel.y + kAir;
        const float plot_x = panel.x + 2.0F * kAir + half;
        return {panel,
                {panel.x + kAir, panel.y + kAir, half, 4.0F * kRow},
                {plot_x, plot_y + 34.0F, half, 38.0F},
                {plot_x, plot_y + 114.0F, half, 38.0F}};
    }
    const float width = page.is_square() ? 308.0F : 330.0F;
    // Larger text raises the ledge, whose controls must not be covered.
    constexpr float kTop = 124.0F;
    constexpr float kRows = 2.0F * kAir + 6.0F * kRow + 20.0F;
    const float ledge = ledge_y(page.shape(), page.height(), page.view().state.comfort);
    const float plot_height = std::min(kPlotHeight, 0.5F * (ledge - 8.0F - kTop - kRows));
    const Rect panel{24.0F, kTop, width, kRows + 2.0F * plot_height};
    const Rect forces{panel.x + kAir, panel.y + kAir, width - 2.0F * kAir, 4.0F * kRow};
    const float first_y = forces.bottom() + 8.0F + kRow;
    const Rect plot{forces.x, first_y, forces.width, plot_height};
    return {panel, forces, plot, plot.moved({0.0F, plot_height + kRow + 12.0F})};
}

// Adds name, number and unit in one line. Returns the number's place. The panel is mirrored as a whole.
vec2 line(Page& page, const Rect& rect, const std::string& name, const std::string& unit, float unit_width,
          float number_width, float name_x) {
    const bool rtl = page.right_to_left();
    const Rect unit_box{rtl ? rect.x : rect.right() - unit_width, rect.y, unit_width, kRow};
    page.fixed_words(
        unit_box,
        {.text = unit, .type = design::kLabel, .colour = design::kSlip2, .align = ui::Align::kStart});
    const Rect name_box{rtl ? rect.x + unit_width + number_width : rect.x + name_x, rect.y,
                        rect.width - name_x - unit_width - number_width, kRow};
    page.fixed_words(name_box, {.text = name, .type = design::kLabel});
    const float right = rtl ? unit_box.right() + number_width - 6.0F : unit_box.x - 6.0F;
    return {right, rect.y + 16.0F};
}

// Draws the legend: an arrow, as over the clay.
ui::Sketch key_of(std::size_t force) {
    ui::Sketch sketch;
    constexpr std::array kColours{design::kStiffness, design::kViscosity, design::kFriction, design::kNight};
    const ui::Colour casing = force == 3 ? design::kOutline : design::kNight;
    const std::string shaft = "M5 16 H30";
    const std::string head =
        force == 2 ? "M30 8 L46 16 L30 24 Z M18 8 L34 16 L18 24 Z" : "M28 7 L46 16 L28 25 Z";
    sketch.add(ui::Shape{.path = shaft, .stroke = casing, .stroke_width = 10.0F});
    sketch.add(ui::Shape{.path = head, .fill = casing, .stroke = casing, .stroke_width = 5.0F});
    sketch.add(ui::Shape{.path = force == 1 ? "M5 16 H10 M18 16 H23" : shaft,
                         .stroke = kColours[force],
                         .stroke_width = 5.0F});
    sketch.add(ui::Shape{.path = head, .fill = kColours[force]});
    return sketch;
}

void add_panel(Page& page, ForceParts& parts) {
    Places at = places_on(page);
    if (page.right_to_left()) {
        for (Rect* rect : {&at.panel, &at.forces, &at.force_plot, &at.rate_plot})
            *rect = page.mirrored(*rect);
    }
    ui::Sketch back;
    back.add(ui::Box{{0.0F, 0.0F, at.panel.width, at.panel.height},
                     20.0F,
                     ui::Fill::flat(design::kNight.with_alpha(0.86F))});
    page.sprite(at.panel, std::move(back));
    constexpr float kKeyWidth = 52.0F;
    for (std::size_t force = 0; force < kForceCount; ++force) {
        const Rect row{at.forces.x, at.forces.y + kRow * static_cast<float>(force), at.forces.width, kRow};
        const float key_x = page.right_to_left() ? row.right() - kKeyWidth : row.x;
        page.sprite({key_x, row.y, kKeyWidth, 32.0F}, key_of(force));
        parts.value_at[force] = line(page, row, page.t(kNames[force]), page.t("unit.n"), kNewtonWidth,
                                     kNumberWidth, kKeyWidth + 4.0F);
    }
    const auto above = [](const Rect& plot) { return Rect{plot.x, plot.y - kRow + 2.0F, plot.width, kRow}; };
    parts.full_at = line(page, above(at.force_plot), page.t("force.plot"), page.t("unit.n"), kNewtonWidth,
                         kNumberWidth, 0.0F);
    parts.rate_at = line(page, above(at.rate_plot), page.t("force.rate"), page.t("unit.hz"), kUnitWidth,
                         kRateWidth, 0.0F);
    for (const Rect& plot : {at.force_plot, at.rate_plot}) {
        ui::Sketch frame;
        frame.add(
            ui::Box{{0.0F, 0.0F, plot.width, plot.height}, 4.0F, ui::Fill::flat(ui::hex(0x000000, 0.4F))});
        page.sprite(plot, std::move(frame));
    }
    // Records the widest numbers for the audit, with the room that line() leaves for them.
    const auto loose = [&](const std::string& number, vec2 right_middle, float room) {
        float wide = 0.0F;
        for (const char letter : number)
            wide += letter == '.' ? parts.point.rect.width : parts.digits[8].rect.width;
        const Rect within{right_middle.x - room + 6.0F, right_middle.y - 16.0F, room - 6.0F, kRow};
        page.keep_loose({.words = page.digits(number),
                         .rect = {right_middle.x - wide, within.y, wide, 30.0F},
                         .size = 26.0F,
                         .colour = design::kWhiteSlip,
                         .within = within,
                         .on_pot = true});
    };
    for (const vec2& at_value : parts.value_at)
        loose("8.88", at_value, kNumberWidth);
    loose("88.8", parts.full_at, kNumberWidth);
    loose("8888", parts.rate_at, kRateWidth);
    parts.force_plot = at.force_plot;
    parts.rate_plot = at.rate_plot;
    parts.has_panel = true;
}

void draw_number(const std::string& number, vec2 right_middle, const ForceParts& parts,
                 const ForcePainter& painter) {
    vec2 at = right_middle * painter.px_per_u;
    for (std::size_t i = number.size(); i-- > 0;) {
        const bool is_digit = number[i] >= '0' && number[i] <= '9';
        const Item& item = is_digit ? parts.digits[static_cast<std::size_t>(number[i] - '0')] : parts.point;
        const auto from = painter.place(item);
        if (!from) continue;
        at.x -= from->width;
        painter.list.add_picture({at.x, at.y - 0.5F * from->height}, *from, 1.0F);
    }
}

// Plots one value; the window's start is at the left edge, now is at the right.
template <typename ValueOf>
void draw_plot(const ForceTrace& trace, const Rect& plot_u, double full, const ui::Colour& colour,
               const ForcePainter& painter, const ValueOf& value_of) {
    const float u = painter.px_per_u;
    const Rect plot = plot_u.scaled(u);
    std::vector<vec2> course;
    for (std::size_t place = 0; place < trace.size(); ++place) {
        const ForceTrace::Sample& sample = trace.at(place);
        const double age = (trace.at(trace.size() - 1).time_s - sample.time_s) / ForceTrace::kWindowS;
        const double height = full > 0.0 ? std::clamp(value_of(sample) / full, 0.0, 1.0) : 0.0;
        course.emplace_back(plot.right() - static_cast<float>(age) * plot.width,
                            plot.bottom() - static_cast<float>(height) * (plot.height - 4.0F * u) - 2.0F * u);
    }
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
        const std::array under{course[i], course[i + 1], vec2(course[i + 1].x, plot.bottom()),
                               vec2(course[i].x, plot.bottom())};
        painter.list.add_polygon(under, colour.with_alpha(0.22F));
    }
    painter.list.add_line(course, 2.0F * u, colour);
    const std::array base{vec2(plot.x, plot.bottom()), vec2(plot.right(), plot.bottom())};
    painter.list.add_line(base, 1.0F * u, design::kSlip2.with_alpha(0.6F));
}

}  // namespace

void ForceTrace::add(double time_s, double force_n, std::uint64_t ticks) {
    while (count_ > 0 && (count_ == kMost || at(0).time_s < time_s - kWindowS)) {
        first_ = (first_ + 1) % kMost;
        --count_;
    }
    double rate_hz = 0.0;
    for (std::size_t back = count_; back-- > 0;) {
        const Kept& before = kept(back);
        const double since_s = time_s - before.sample.time_s;
        if (since_s > 0.0 && ticks >= before.ticks)
            rate_hz = static_cast<double>(ticks - before.ticks) / since_s;
        if (since_s >= kRateOverS) break;
    }
    ring_[(first_ + count_) % kMost] = {{time_s, force_n, rate_hz}, ticks};
    ++count_;
    double most_n = 0.0;
    for (std::size_t place = 0; place < count_; ++place)
        most_n = std::max(most_n, at(place).force_n);
    full_n_ = kSteps.back();
    for (std::size_t step = kSteps.size(); step-- > 0;)
        if (most_n <= kSteps[step]) full_n_ = kSteps[step];
}

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
        for (std::size_t k = kForceCount; k-- > 0;) {  // draws the sum first, below the others
            const auto force = static_cast<Force>(k);
            const ForceArrow& arrow = touch.arrows[k];
            if (!arrow.shown || (force == Force::kTotal && !frame.with_sum)) continue;
            const vec2 way = arrow.to_px - arrow.from_px;
            const float length = glm::length(way);
            const vec2 along = length > 0.5F ? way / length : vec2(0.0F, -1.0F);
            vec2 tip = arrow.to_px;
            if (arrow.seen < kLeastSeen) {
                // At the contact itself, other arrows would hide the sign.
                tip = arrow.from_px + std::max(length, 2.6F * kSignU * u) * along;
                draw_sign(painter.list, force, tip, arrow.towards, u);
                tip += kSignU * u * along;
            } else {
                draw_arrow(painter.list, force, arrow.from_px, arrow.to_px, u);
            }
            if (i == 0) named.push_back({force, tip});
        }
    }
    draw_names(named, !frame.touches.empty() && frame.touches.front().is_beside, parts, painter);
}

void add_forces(Page& page) {
    auto parts = std::make_shared<ForceParts>();
    const Words words{.text = "8", .type = design::bold(26.0F, 32.0F), .colour = design::kWhiteSlip};
    float width = 0.0F;
    const auto digit = [&](int value) {
        Words one = words;
        one.text = page.digits(std::to_string(value));
        return one;
    };
    for (int value = 0; value < 10; ++value)
        width = std::max(width, page.words_width(digit(value)));
    for (int value = 0; value < 10; ++value)
        parts->digits[static_cast<std::size_t>(value)] = page.loose_words(digit(value), width, false);
    Words point = words;
    point.text = page.digits(".");
    parts->point = page.loose_words(point, 0.0F, false);
    constexpr std::array kColours{design::kStiffness, design::kViscosity, design::kFriction,
                                  design::kWhiteSlip};
    for (std::size_t force = 0; force < kForceCount; ++force) {
        Words name = words;
        name.text = page.t(kNames[force]);
        name.colour = kColours[force];
        parts->names[force] = page.loose_words(name, 0.0F, true);
    }
    // On a tall screen a warning or the notice of a lost device takes the panel's place.
    const kiosk::ScreenState& state = page.view().state;
    const bool has_room = page.shape() != Shape::kTall || (state.throwing.warning == kiosk::Warning::kNone &&
                                                           !state.device_lost && !state.force_rests);
    if (state.comfort.forces && has_room) add_panel(page, *parts);
    page.keep_forces(std::move(parts));
}

Composition compose_forces(const View& view, ui::Painter& painter, PaintingStore& store) {
    Page page(view, painter, store);
    add_forces(page);
    store.forget_unused();
    return page.take();
}

void draw_force_panel(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter) {
    for (std::size_t force = 0; force < kForceCount; ++force)
        draw_number(fmt::format("{:.2f}", frame.size_n[force]), parts.value_at[force], parts, painter);
    if (frame.trace == nullptr) return;
    const ForceTrace& trace = *frame.trace;
    draw_number(fmt::format("{:.1f}", trace.full_n()), parts.full_at, parts, painter);
    draw_number(fmt::format("{:.0f}", trace.rate_hz()), parts.rate_at, parts, painter);
    draw_plot(trace, parts.force_plot, trace.full_n(), design::kAmber, painter,
              [](const ForceTrace::Sample& sample) { return sample.force_n; });
    double most_hz = 0.0;
    for (std::size_t place = 0; place < trace.size(); ++place)
        most_hz = std::max(most_hz, trace.at(place).rate_hz);
    draw_plot(trace, parts.rate_plot, 1.15 * most_hz, design::kCeladonLo, painter,
              [](const ForceTrace::Sample& sample) { return sample.rate_hz; });
}

}  // namespace onggi::screens
