// The panel of forces: what it is composed of once, and what in it changes from frame to frame.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "game/screens/forces.h"
#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using ui::Rect;

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
    // Larger text lifts the ledge, and what stands on it is not to be covered.
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

// Name, number, unit in one line; gives the place of the number. Never mirrored inside: the panel is.
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

// An arrow as it is drawn over the clay, so that its form is known again.
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
    // The widest that the numbers become, in the room that line() leaves them.
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

// The course of one value from the left edge, as old as the window, to the right one, now.
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
    // On a tall screen a warning, or that the hand control is gone, stands where the panel would.
    const kiosk::ScreenState& state = page.view().state;
    const bool has_room = page.shape() != Shape::kTall || (state.throwing.warning == kiosk::Warning::kNone &&
                                                           !state.device_lost && !state.force_rests);
    if (state.comfort.forces && has_room) add_panel(page, *parts);
    page.keep_forces(std::move(parts));
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
