#include "tests/visitors/kiosk_rig.h"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include "game/visit/flow/flow.h"
#include "game/visit/throw/throw.h"

namespace onggi::visitors {
namespace {

constexpr double kRateHz = 1000.0;
constexpr double kPxPerMm = 10.0 / 4.8;
constexpr dvec2 kAxisFootPx{640.0, 450.0};

// The tools on the photographed room's bench: middle and half size on the clay's plane, mm.
struct BenchPlace {
    tool::Tool tool;
    dvec2 middle_mm;
    dvec2 half_mm;
};
constexpr std::array kBench{BenchPlace{tool::Tool::kSponge, {310.0, -60.0}, {27.0, 22.0}},
                            BenchPlace{tool::Tool::kWire, {-300.0, -15.0}, {60.0, 19.0}},
                            BenchPlace{tool::Tool::kRib, {262.0, -5.0}, {19.0, 31.0}}};

std::optional<tool::Tool> bench_tool_at(const dvec3& place_mm) {
    for (const BenchPlace& lies : kBench) {
        const dvec2 off = glm::abs(dvec2(place_mm) - lies.middle_mm);
        if (off.x < lies.half_mm.x && off.y < lies.half_mm.y) return lies.tool;
    }
    return std::nullopt;
}

dvec2 px_of(const dvec2& place_mm) {
    return {kAxisFootPx.x + place_mm.x * kPxPerMm, kAxisFootPx.y - place_mm.y * kPxPerMm};
}

dvec3 place_at(const vec2& px) {
    return {(double{px.x} - kAxisFootPx.x) / kPxPerMm, (kAxisFootPx.y - double{px.y}) / kPxPerMm, 0.0};
}

haptic::HapticParameters kiosk_parameters() {
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(kRateHz);
    parameters.studio.forgiving = true;
    return parameters;
}

}  // namespace

KioskRig::KioskRig(double mass_g)
    : visit_(visit::first_state(rules_, 0.0)),
      parameters_(kiosk_parameters()),
      state_(clay::StudioClay({.mass_g = mass_g})),
      shape_(haptic::pot_of(state_)) {
    visit_.screen = kiosk::Screen::kThrow;
    // The wheel comes up to speed while the visitor looks.
    for (int i = 0; i < 60; ++i)
        frame({170.0, 120.0}, false);
}

void KioskRig::frame(const dvec2& pointer_mm, bool pressed) {
    using Kind = app::PointerNews::Kind;
    now_s_ += kFrameS;
    const dvec2 px = px_of(pointer_mm);
    std::vector<app::PointerNews> all;
    pointer_.handle(window::PointerEvent{.x_px = static_cast<float>(px.x), .y_px = static_cast<float>(px.y)},
                    now_s_, all);
    if (pressed != was_pressed_) {
        pointer_.handle(window::ButtonEvent{.button = window::MouseButton::kLeft, .pressed = pressed}, now_s_,
                        all);
        if (!pressed) released_mm_ = faces_mm();
    }
    was_pressed_ = pressed;
    pointer_.pass_time(now_s_, all);
    for (const app::PointerNews& news : all) {
        const auto tool = bench_tool_at(place_at(news.at_px));
        const bool begins_on_bench = news.kind == Kind::kFingerDown && tool;
        if (begins_on_bench) bench_.begin(*tool, news.at_px, app::kTapU);
        const bool becomes_drag = news.kind == Kind::kFingerMoved && bench_.becomes_drag(news.at_px);
        if ((news.kind == Kind::kFingerDown && !begins_on_bench) || becomes_drag) {
            dispatch(kiosk::event::ClayTouched{});
            finger_.press(place_at(news.at_px));
        }
        if (news.kind == Kind::kFingerMoved) {
            dispatch(kiosk::event::Input{});
            finger_.drag(place_at(news.at_px));
        }
        if (news.kind == Kind::kFingerUp) {
            finger_.lift();
            if (const auto tapped = bench_.lift())
                dispatch(kiosk::event::Pressed{kiosk::Button::kTakeTool,
                                               static_cast<int>(visit::tray_place(*tapped))});
        }
        if (news.kind == Kind::kHovered) finger_.hover(place_at(news.at_px));
    }
    const bool works = finger_.works() && !finger_.shows();
    if (works != visit_.pace.held) dispatch(kiosk::event::Held{works});
    if (visit_.throwing.shown && !finger_.shows()) dispatch(kiosk::event::ShowOver{});
    dispatch(kiosk::event::Progress{.steps_done = lesson_.steps_done(shape_),
                                    .is_solid = pot::is_solid(shape_),
                                    .thick_mm = app::thick_wall_mm(shape_)});
    dispatch(kiosk::event::Tick{});
    if (!outline_mm_.empty())
        finger_.set_outline(outline_mm_, app::outline_help_after(lesson_.steps_done(shape_)));
    tool::ToolState tool = finger_.request({.tool = visit_.throwing.held}, shape_, kFrameS);
    tool.wheel_button = true;
    device_.set_target(tool);
    for (; static_cast<double>(ticks_) < now_s_ * kRateHz; ++ticks_)
        haptic::tick(state_, device_.read_tool(ticks_, 1.0 / kRateHz), parameters_);
    shape_ = haptic::pot_of(state_);
    if (finger_.shows()) released_mm_ = faces_mm();
}

// Applies the effects of a demonstration; those of undo, saving and sound need the whole kiosk.
void KioskRig::dispatch(const kiosk::Event& event) {
    for (const kiosk::Effect& effect : visit::advance(visit_, event, now_s_, rules_)) {
        if (const auto* show = std::get_if<kiosk::effect::ShowStep>(&effect))
            finger_.show(show->step, shape_, 1.0);
        if (std::holds_alternative<kiosk::effect::StopShow>(effect)) finger_.stop_showing();
    }
}

WheelRig::Advice KioskRig::press_done() {
    if (!at_done_) at_done_ = clay();
    dispatch(kiosk::event::Pressed{kiosk::Button::kDone});
    switch (visit_.throwing.asks) {
        case kiosk::DoneQuestion::kSolid:
            return Advice::kOpen;
        case kiosk::DoneQuestion::kThick:
            return Advice::kDrawUp;
        case kiosk::DoneQuestion::kNone:
            break;
    }
    return Advice::kNone;
}

void KioskRig::show_outline(const std::vector<dvec2>& outline_mm) {
    outline_mm_.assign(outline_mm.begin(), outline_mm.end());
    visit_.throwing.target = outline_mm.empty() ? std::nullopt : std::optional(0);
}

double KioskRig::outer_mm(double y_mm) const {
    const clay::studio::Rings& rings = clay().rings();
    return rings.outer_mm[clay::studio::Rings::at(rings.ring_at(std::clamp(y_mm, 0.0, rings.top_mm())))];
}

double KioskRig::inner_mm(double y_mm) const {
    const clay::studio::Rings& rings = clay().rings();
    return rings.inner_mm[clay::studio::Rings::at(rings.ring_at(std::clamp(y_mm, 0.0, rings.top_mm())))];
}

std::vector<double> KioskRig::faces_mm() const {
    std::vector<double> faces(clay().outer_mm().begin(), clay().outer_mm().end());
    faces.insert(faces.end(), clay().inner_mm().begin(), clay().inner_mm().end());
    return faces;
}

}  // namespace onggi::visitors
