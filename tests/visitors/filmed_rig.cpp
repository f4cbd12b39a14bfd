#include "tests/visitors/filmed_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "game/app/kiosk/finger/kiosk_touch.h"

namespace onggi::visitors {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds kFrame(16'667);
constexpr double kJustInsideMm = 0.01;

void put_cross(asset::Image& picture, const dvec2& at_px, bool pressed) {
    constexpr int kArm = 6;
    const auto put = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
        std::uint8_t* px =
            picture.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                       static_cast<std::size_t>(x));
        px[0] = pressed ? 255 : 40;
        px[1] = pressed ? 30 : 160;
        px[2] = pressed ? 60 : 255;
    };
    const auto x = static_cast<int>(std::lround(at_px.x));
    const auto y = static_cast<int>(std::lround(at_px.y));
    for (int i = -kArm; i <= kArm; ++i) {
        put(x + i, y);
        put(x, y + i);
    }
}

}  // namespace

FilmedRig::FilmedRig(const std::filesystem::path& gallery, double every_s)
    : kiosk_(gallery, {.plain = false, .width = kFilmWidth, .height = kFilmHeight}),
      every_s_(every_s) {
    kiosk_.touch();
    kiosk_.frame();
    EXPECT_TRUE(kiosk_.until([&] { return kiosk_.screen() == kiosk::Screen::kChoose; }));
    EXPECT_TRUE(kiosk_.press(kiosk::Button::kFree));
    EXPECT_TRUE(kiosk_.until([&] { return kiosk_.shown_screen() == kiosk::Screen::kThrow; }));
    began_s_ = kiosk_.now_s();
    last_ = Clock::now();
}

void FilmedRig::frame(const dvec2& pointer_mm, bool pressed) {
    const auto px = kiosk_.seen({pointer_mm.x, pointer_mm.y, 0.0});
    const dvec2 at_px = px.value_or(dvec2(0.0));
    kiosk_.point(at_px.x, at_px.y);
    if (pressed != was_pressed_) kiosk_.hold(pressed);
    was_pressed_ = pressed;
    pass_frame();
    if (kiosk_.now_s() - began_s_ < next_s_) return;
    next_s_ = kiosk_.now_s() - began_s_ + every_s_;
    take_picture(at_px, pressed);
}

void FilmedRig::pass_frame() {
    std::this_thread::sleep_until(last_ + kFrame);
    const Clock::time_point now = Clock::now();
    kiosk_.frame(std::chrono::duration<double>(now - last_).count());
    last_ = now;
}

bool FilmedRig::comes_to(kiosk::Screen screen, double looks_s) {
    constexpr double kWaitsS = 30.0;
    last_ = Clock::now();
    const double until_s = kiosk_.now_s() + kWaitsS;
    std::optional<double> came_s;
    while (kiosk_.now_s() < (came_s ? *came_s + looks_s : until_s)) {
        pass_frame();
        if (!came_s && kiosk_.shown_screen() == screen) came_s = kiosk_.now_s();
        if (kiosk_.now_s() - began_s_ < next_s_) continue;
        next_s_ = kiosk_.now_s() - began_s_ + every_s_;
        film_.push_back({.at_s = kiosk_.now_s() - began_s_, .pressed = false, .picture = kiosk_.picture()});
    }
    return came_s.has_value();
}

bool FilmedRig::finishes() {
    using kiosk::Button;
    using kiosk::Screen;
    if (!kiosk_.ends_throwing() || !comes_to(Screen::kFiring, 3.0)) return false;
    const bool trims = kiosk_.state().screen == Screen::kTrim;
    if (trims && !(comes_to(Screen::kTrim, 1.0) && kiosk_.press(Button::kSkip))) return false;
    return comes_to(Screen::kDecorate, 1.0) && kiosk_.press(Button::kDone) && comes_to(Screen::kGlaze, 3.0) &&
           kiosk_.press(Button::kTakeGlaze) && comes_to(Screen::kYourPot, 3.0) &&
           kiosk_.press(Button::kKeep) && comes_to(Screen::kKeep, 4.0);
}

void FilmedRig::take_picture(const dvec2& pointer_px, bool pressed) {
    Shot shot{.at_s = kiosk_.now_s() - began_s_, .pressed = pressed, .picture = kiosk_.picture()};
    put_cross(shot.picture, pointer_px, pressed);
    film_.push_back(std::move(shot));
}

double FilmedRig::outer_mm(double y_mm) const {
    return wall_at(shape(), std::clamp(y_mm, 0.0, height_mm() - kJustInsideMm)).outer_mm;
}

double FilmedRig::inner_mm(double y_mm) const {
    return wall_at(shape(), std::clamp(y_mm, 0.0, height_mm() - kJustInsideMm)).inner_mm;
}

}  // namespace onggi::visitors
