#include "tests/golden/live_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::golden {
namespace {

constexpr int kAtlasSidePx = 64;
constexpr int kPictureSidePx = 48;

}  // namespace

SampleOverlay::SampleOverlay() {
    ui::Painting ring{.width = kPictureSidePx, .height = kPictureSidePx, .rgba = {}};
    for (int y = 0; y < kPictureSidePx; ++y) {
        for (int x = 0; x < kPictureSidePx; ++x) {
            const int from_middle = (2 * x - kPictureSidePx) * (2 * x - kPictureSidePx) +
                                    (2 * y - kPictureSidePx) * (2 * y - kPictureSidePx);
            const bool is_on = from_middle < 45 * 45 && from_middle > 30 * 30;
            for (const int value : {240, 200, 120, 255})
                ring.rgba.push_back(static_cast<std::uint8_t>(is_on ? value : 0));
        }
    }
    uploads_.push_back({.x = 8, .y = 4, .painting = std::make_shared<const ui::Painting>(std::move(ring))});
    constexpr ui::Rect kInAtlas{
        .x = 8.0F, .y = 4.0F, .width = float{kPictureSidePx}, .height = float{kPictureSidePx}};
    list_.add_box({.x = 30.0F, .y = 360.0F, .width = 260.0F, .height = 90.0F}, ui::hex(0x231A14, 0.6F));
    list_.add_picture({50.0F, 380.0F}, kInAtlas, 1.0F);
    list_.add_picture({110.0F, 380.0F}, kInAtlas, 0.5F);
    constexpr std::array kZigzag{vec2{180.0F, 380.0F}, vec2{215.0F, 428.0F}, vec2{250.0F, 385.0F}};
    list_.add_line(kZigzag, 5.0F, ui::hex(0xF4ECE0, 1.0F));
    constexpr std::array kDiamond{vec2{540.0F, 50.0F}, vec2{590.0F, 90.0F}, vec2{540.0F, 130.0F},
                                  vec2{490.0F, 90.0F}};
    list_.add_polygon(kDiamond, ui::hex(0x2A6F97, 0.8F));
}

render::Overlay SampleOverlay::next() {
    render::Overlay overlay{.list = &list_, .atlas_side_px = kAtlasSidePx};
    if (!has_brought_) overlay.uploads = uploads_;
    has_brought_ = true;
    return overlay;
}

asset::Image draw_live(vk::Device& device, const LiveScene& live, const render::RendererDesc& desc) {
    const GoldenScene shown = scene_named(live.pot);
    EXPECT_FALSE(shown.name.empty()) << live.pot;
    auto opened = wheel::open_scene({}, shown.width, shown.height);
    EXPECT_EQ(opened.lack, "");
    opened.scene->look_at(shown.view == wheel::StillView::kLookingIn ? wheel::View::kLookingIn
                                                                     : wheel::View::kThrowing);
    opened.scene->jump();
    wheel::Clay& clay = opened.scene->registry().get<wheel::Clay>(opened.scene->clay());
    clay.is_cut_open = clay.shows_load = shown.view == wheel::StillView::kCutaway;
    auto renderer = render::Renderer::create(device, desc);
    auto target = vk::Offscreen::create(
        device, {static_cast<std::uint32_t>(shown.width), static_cast<std::uint32_t>(shown.height)});
    SampleOverlay overlay;
    constexpr int kFrames = 3;
    constexpr int kMostFrames = 40;
    float faded = live.fades ? 0.0F : 1.0F;
    for (int frame = 0; frame < kFrames || (faded < 0.5F && frame < kMostFrames); ++frame) {
        GoldenScene moved = shown;
        moved.tool_position_mm.y += 2.0 * std::max(kFrames - 1 - frame, 0);
        if (frame == 1 && live.fades) opened.scene->look_at(wheel::View::kLookingIn);
        const double dt_s = live.fades && frame > 0 ? 1.0 / 60.0 : 0.0;
        render::Scene scene =
            opened.scene->apply(moved.shown(*opened.scene), shown.width, shown.height, dt_s);
        faded = scene.fade_in.value_or(faded);
        scene.levels = wheel::light_levels(live.evening);
        const render::Overlay laid = overlay.next();
        const auto drawn = (*renderer)->draw(scene, **target, live.has_overlay ? &laid : nullptr);
        EXPECT_TRUE(drawn && *drawn);
        if ((*renderer)->stats().next_view_ready) opened.scene->next_view_is_ready();
    }
    EXPECT_GE(faded, 0.5F);
    return {.width = shown.width, .height = shown.height, .rgba = (*target)->read_back().value()};
}

}  // namespace onggi::golden
