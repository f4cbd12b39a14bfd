#include "tests/visitors/kiosk_rig.h"

#include <algorithm>

namespace onggi::visitors {
namespace {

constexpr double kRateHz = 1000.0;
constexpr double kPxPerMm = 10.0 / 4.8;
constexpr dvec2 kAxisFootPx{640.0, 450.0};
constexpr app::HeldTool kHeld;

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
    : parameters_(kiosk_parameters()),
      state_(clay::StudioClay({.mass_g = mass_g})),
      shape_(haptic::pot_of(state_)) {
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
        if (news.kind == Kind::kFingerDown) finger_.press(place_at(news.at_px));
        if (news.kind == Kind::kFingerMoved) finger_.drag(place_at(news.at_px));
        if (news.kind == Kind::kFingerUp) finger_.release();
        if (news.kind == Kind::kHovered) finger_.hover(place_at(news.at_px));
    }
    if (!outline_mm_.empty())
        finger_.set_outline(outline_mm_, app::outline_help_after(lesson_.steps_done(shape_)));
    tool::ToolState tool = finger_.request(kHeld, shape_, kFrameS);
    tool.wheel_button = true;
    device_.set_target(tool);
    for (; static_cast<double>(ticks_) < now_s_ * kRateHz; ++ticks_)
        haptic::tick(state_, device_.read_tool(ticks_, 1.0 / kRateHz), parameters_);
    shape_ = haptic::pot_of(state_);
}

void KioskRig::show_outline(const std::vector<dvec2>& outline_mm) {
    outline_mm_.assign(outline_mm.begin(), outline_mm.end());
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
