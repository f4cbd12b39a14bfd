// The live picture redraws only the dirty parts of a target: earlier content must be gone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/jobs/shared_loop.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/alike.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

class HeldPicture : public support::ValidatedDevice {
  protected:
    void SetUp() override {
        support::ValidatedDevice::SetUp();
        opened_ = wheel::open_scene({}, kWidth, kHeight);
        ASSERT_EQ(opened_.lack, "");
        pulling_ = scene_named("pulling");
        ASSERT_FALSE(pulling_.name.empty());
    }
    [[nodiscard]] std::unique_ptr<render::Renderer> renderer() const {
        return render::Renderer::create(*device_, render::live_desc(vk::Offscreen::kFormat, true, kHeight))
            .value();
    }
    [[nodiscard]] std::unique_ptr<vk::Offscreen> target() const {
        return vk::Offscreen::create(*device_, {kWidth, kHeight}).value();
    }
    [[nodiscard]] render::Scene scene_of(const GoldenScene& shown) {
        render::Scene scene = opened_.scene->apply(shown.shown(*opened_.scene), kWidth, kHeight);
        if (!shows_hands_) scene.props.clear();
        return scene;
    }
    // The hand somewhere up the pot, and a box of the overlay somewhere across the picture.
    void draw(render::Renderer& renderer, vk::Offscreen& target, double lift_mm, float box_px) {
        ui::DrawList list;
        list.add_box({.x = box_px, .y = 20.5F, .width = 90.0F, .height = 33.0F}, {.r = 1.0F, .a = 0.7F});
        draw(renderer, target, lift_mm, {.list = &list, .atlas_side_px = 64});
    }
    void draw(render::Renderer& renderer, vk::Offscreen& target, double lift_mm,
              const render::Overlay& overlay) {
        GoldenScene shown = pulling_;
        shown.tool_position_mm.y += lift_mm;
        const auto drawn = renderer.draw(scene_of(shown), target, &overlay);
        ASSERT_TRUE(drawn && *drawn);
        ASSERT_TRUE(target.wait());  // a renderer has one frame in flight
    }
    static int furthest(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
        return apart(a, b, 0).worst;
    }

    wheel::OpenedScene opened_;
    GoldenScene pulling_;
    bool shows_hands_ = true;
};

// Far enough for the layers to have been read back.
constexpr int kFrames = 12;

TEST_F(HeldPicture, IsCompleteWithoutTheHiddenFacesOfHands) {
    auto chooses = renderer();
    render::RendererDesc desc = chooses->desc();
    desc.draws_hidden_faces = true;
    auto draws_all = render::Renderer::create(*device_, desc).value();
    auto one = target();
    auto other = target();
    for (const wheel::View view : {wheel::View::kThrowing, wheel::View::kLookingIn}) {
        opened_.scene->look_at(view);
        opened_.scene->jump();
        // The inner hand from above the rim, where it is fully visible, to deep inside.
        for (int frame = 0; frame < kFrames; ++frame) {
            pulling_.second_hand_mm->y = 120.0 - 8.0 * frame;
            draw(*chooses, *one, 0.0, 500.0F);
            draw(*draws_all, *other, 0.0, 500.0F);
            EXPECT_EQ(furthest(one->read_back().value(), other->read_back().value()), 0) << frame;
        }
    }
}

TEST_F(HeldPicture, ShowsNoTraceOfEarlierFrames) {
    auto long_used = renderer();
    auto held = target();
    for (int frame = 0; frame < kFrames; ++frame)
        draw(*long_used, *held, 30.0 - 4.0 * frame, 500.0F - 40.0F * static_cast<float>(frame));
    draw(*long_used, *held, 0.0, 300.0F);
    auto fresh = renderer();
    auto other = target();
    for (int frame = 0; frame < 3; ++frame)
        draw(*fresh, *other, 0.0, 300.0F);
    EXPECT_LE(furthest(held->read_back().value(), other->read_back().value()), kMaskStep);
}

// Large enough for a second thread to share it; the pot is cut at the right border, where a block of pixels
// would reach into the next band. The other view fades in, and the light changes.
TEST_F(HeldPicture, IsTheSameByTwoThreads) {
    constexpr int kLargeWidth = 2560;
    constexpr int kLargeHeight = 1440;
    jobs::SharedLoop loop;
    const int any_core = jobs::choose_haptic_core().core;
    ASSERT_TRUE(loop.start(std::span(&any_core, 1), "picture"));
    const auto make = [&](jobs::SharedLoop* own) {
        render::RendererDesc desc = render::live_desc(vk::Offscreen::kFormat, true, kLargeHeight);
        desc.loop = own;
        return render::Renderer::create(*device_, desc).value();
    };
    const auto alone = make(nullptr);
    const auto shared = make(&loop);
    const VkExtent2D size{kLargeWidth, kLargeHeight};
    const auto one = vk::Offscreen::create(*device_, size).value();
    const auto other = vk::Offscreen::create(*device_, size).value();
    opened_ = wheel::open_scene({}, kLargeWidth, kLargeHeight);
    opened_.scene->jump();
    for (int frame = 0; frame < 30; ++frame) {
        GoldenScene shown = pulling_;
        shown.tool_position_mm.y += frame;
        if (frame == 4) opened_.scene->look_at(wheel::View::kLookingIn);
        render::Scene scene =
            opened_.scene->apply(shown.shown(*opened_.scene), kLargeWidth, kLargeHeight, 1.0 / 60.0);
        if (frame > 26) scene.camera.lens_shift.x = 0.95F;
        const auto by_one = alone->draw(scene, *one, nullptr);
        const auto by_two = shared->draw(scene, *other, nullptr);
        ASSERT_TRUE(by_one && *by_one && by_two && *by_two);
        ASSERT_TRUE(one->wait() && other->wait());
        if (shared->stats().next_view_ready) opened_.scene->next_view_is_ready();
        if (frame % 3 != 2) continue;
        ASSERT_EQ(one->read_back().value(), other->read_back().value()) << frame;
    }
}

TEST_F(HeldPicture, IsRedrawnWhereAnotherRendererHasDrawn) {
    auto one = renderer();
    auto another = renderer();
    auto shared = target();
    auto own = target();
    for (int frame = 0; frame < kFrames; ++frame) {
        draw(*one, *shared, 20.0, 30.0F);
        draw(*another, *shared, -20.0, 330.0F);
    }
    for (int frame = 0; frame < 3; ++frame)
        draw(*another, *own, -20.0, 330.0F);
    EXPECT_LE(furthest(shared->read_back().value(), own->read_back().value()), kMaskStep);
}

TEST_F(HeldPicture, ShowsEachOfTwoTargetsWhole) {
    auto drawn = renderer();
    auto left = target();
    auto right = target();
    for (int frame = 0; frame < kFrames; ++frame) {
        draw(*drawn, *left, 20.0 - frame, 30.0F);
        draw(*drawn, *right, 20.0 - frame, 30.0F);
    }
    EXPECT_EQ(furthest(left->read_back().value(), right->read_back().value()), 0);
}

// A box, a polygon, a line and a picture, over moving parts and beside them. The device shades a box as two
// triangles, the CPU from edge to edge: the same if the corner colours are coplanar.
ui::DrawList sample_list(float alpha) {
    ui::DrawList list;
    const ui::Colour ink{.r = 0.1F, .g = 0.2F, .b = 0.9F, .a = alpha};
    list.add_box({.x = 10.25F, .y = 250.0F, .width = 600.0F, .height = 90.5F},
                 {ink, ink, ink.with_alpha(0.0F), ink.with_alpha(0.0F)});
    list.add_polygon(std::array{vec2(300.0F, 20.0F), vec2(420.5F, 160.0F), vec2(250.0F, 200.25F)}, ink);
    list.add_line(std::array{vec2(20.0F, 30.0F), vec2(330.0F, 300.0F)}, 5.0F, ink);
    list.add_picture({280.0F, 120.0F}, {.x = 8.0F, .y = 16.0F, .width = 40.0F, .height = 30.0F}, alpha);
    return list;
}

std::vector<ui::Atlas::Upload> sample_picture() {
    ui::Painting painting{.width = 40, .height = 30, .rgba = {}};
    for (int i = 0; i < 40 * 30; ++i) {
        const auto alpha = static_cast<std::uint8_t>(i % 256);
        painting.rgba.insert(painting.rgba.end(), {alpha, static_cast<std::uint8_t>(alpha / 3), 0, alpha});
    }
    return {{8, 16, std::make_shared<const ui::Painting>(std::move(painting))}};
}

constexpr int kAtlasSidePx = 64;

TEST_F(HeldPicture, ShowsTheOverlayAsTheDeviceDrawsIt) {
    const auto uploads = sample_picture();
    shows_hands_ = false;  // which the CPU lights per vertex
    auto painting =
        render::Renderer::create(*device_, strictly_alike(render::Backend::kCpu, kHeight)).value();
    auto plain =
        render::Renderer::create(*device_, strictly_alike(render::Backend::kVulkan, kHeight)).value();
    auto wanted = target();
    auto shown = target();
    for (int frame = 0; frame < kFrames; ++frame) {
        const ui::DrawList list = sample_list(0.2F + 0.05F * static_cast<float>(frame));
        const bool is_first = frame == 0;
        const render::Overlay overlay{
            .list = &list,
            .uploads = is_first ? std::span(uploads) : std::span<const ui::Atlas::Upload>(),
            .atlas_side_px = kAtlasSidePx};
        draw(*plain, *wanted, frame, overlay);
        draw(*painting, *shown, frame, overlay);
        // The CPU's shade is off by at most one step, and so is each blended colour.
        const Apart found = apart(wanted->read_back().value(), shown->read_back().value(), 6);
        EXPECT_LE(found.beyond, kOnEdges) << frame << ": " << found.worst;
    }
}

TEST_F(HeldPicture, RestsWhileAScreenComesAndMovesOnWhenItIsGone) {
    const auto uploads = sample_picture();
    const ui::DrawList list = sample_list(0.6F);
    const ui::DrawList more = sample_list(0.9F);
    auto drawn = renderer();
    auto shown = target();
    const auto draw_list = [&](const ui::DrawList& of, double lift_mm, bool rests) {
        draw(*drawn, *shown, lift_mm, {.list = &of, .atlas_side_px = kAtlasSidePx, .scene_rests = rests});
    };
    draw(*drawn, *shown, 0.0, {.list = &list, .uploads = uploads, .atlas_side_px = kAtlasSidePx});
    for (int frame = 0; frame < 4; ++frame)
        draw_list(more, 10.0, false);
    const auto wanted = shown->read_back().value();
    draw_list(list, 10.0, true);
    for (int frame = 0; frame < 3; ++frame)
        draw_list(frame == 2 ? more : list, 10.0 + 5.0 * frame, true);
    EXPECT_LE(furthest(shown->read_back().value(), wanted), kMaskStep) << "the scene stands still";
    draw_list(more, 10.0, false);
    EXPECT_LE(furthest(shown->read_back().value(), wanted), kMaskStep);
    draw_list(more, 25.0, false);
    EXPECT_GT(furthest(shown->read_back().value(), wanted), 20) << "it moves again";
}

TEST_F(HeldPicture, ReportsTheTimeOfHostAndDevice) {
    auto desc = render::live_desc(vk::Offscreen::kFormat, true, kHeight);
    desc.measures_parts = true;
    desc.host_clock = [] {
        static std::int64_t now_ns = 0;
        return now_ns += 3'000'000;
    };
    auto drawn = render::Renderer::create(*device_, desc).value();
    auto shown = target();
    for (int frame = 0; frame < 3; ++frame)
        draw(*drawn, *shown, 5.0 * frame, 500.0F);
    const auto& parts = drawn->stats().parts;
    const auto ms_of = [&](std::string_view name, bool on_host) {
        double sum = 0.0;
        for (const render::PassTime& part : parts)
            sum += part.name == name && part.is_on_host == on_host ? part.ms : 0.0;
        return sum;
    };
    for (const char* name : {"shapes", "room", "hands and lathe"})
        EXPECT_EQ(ms_of(name, true), 3.0) << name;
    EXPECT_GT(ms_of("copies", false), 0.0);
    EXPECT_EQ(parts.size(), 4U);
}

// The quality ladder believes the device's clock.
TEST_F(HeldPicture, MeasuresTheDeviceUntilItHasDrawn) {
    for (const auto step : {render::QualityStep::kSlowestGpu, render::QualityStep::kIntegratedGpu}) {
        auto drawn =
            render::Renderer::create(*device_, render::quality_desc(step, vk::Offscreen::kFormat, kHeight))
                .value();
        auto shown = target();
        double wall_ms = 0.0;  // of the frame that the next one reports
        double best = 0.0;
        for (int frame = 0; frame < 4; ++frame) {
            GoldenScene lifted = pulling_;
            lifted.tool_position_mm.y += 5.0 * frame;
            ASSERT_TRUE(drawn->draw(scene_of(lifted), *shown));
            const auto submitted = std::chrono::steady_clock::now();
            if (frame > 0) best = std::max(best, drawn->stats().device_ms / wall_ms);
            ASSERT_TRUE(shown->wait());
            wall_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - submitted)
                          .count();
        }
        EXPECT_GT(best, 0.8) << render::quality_name(step);
    }
}

// The first frame of a screen's fade-out still shows only the screen.
TEST_F(HeldPicture, ComesFromUnderAScreenThatCoveredIt) {
    ui::DrawList wall;
    wall.add_box({.x = 0.0F, .y = 0.0F, .width = kWidth, .height = kHeight}, {.g = 0.5F});
    ui::DrawList nothing;
    auto drawn = renderer();
    auto shown = target();
    for (int frame = 0; frame < 4; ++frame)
        draw(*drawn, *shown, 0.0, {.list = &nothing, .atlas_side_px = kAtlasSidePx});
    const auto scene = shown->read_back().value();
    draw(*drawn, *shown, 0.0, {.list = &wall, .atlas_side_px = kAtlasSidePx, .covers = true});
    const auto covered = shown->read_back().value();
    EXPECT_GT(furthest(covered, scene), 20);
    draw(*drawn, *shown, 0.0,
         {.list = &wall, .atlas_side_px = kAtlasSidePx, .scene_rests = true, .covers = true});
    EXPECT_EQ(furthest(shown->read_back().value(), covered), 0);
    draw(*drawn, *shown, 40.0, {.list = &nothing, .atlas_side_px = kAtlasSidePx, .scene_rests = true});
    EXPECT_LE(furthest(shown->read_back().value(), scene), kMaskStep) << "as it was under the screen";
}

TEST_F(HeldPicture, RestsInARenderersFirstFrames) {
    const ui::DrawList list = sample_list(0.6F);
    const ui::DrawList nothing;
    auto drawn = renderer();
    auto shown = target();
    const auto show = [&](const ui::DrawList& of, double lift_mm, bool rests) {
        draw(*drawn, *shown, lift_mm, {.list = &of, .atlas_side_px = kAtlasSidePx, .scene_rests = rests});
    };
    show(nothing, 0.0, true);
    const auto wanted = shown->read_back().value();
    show(list, 20.0, true);
    EXPECT_GT(furthest(shown->read_back().value(), wanted), 20) << "the overlay is seen";
    show(nothing, 40.0, true);
    EXPECT_EQ(furthest(shown->read_back().value(), wanted), 0);
    show(nothing, 40.0, false);
    EXPECT_GT(furthest(shown->read_back().value(), wanted), 20) << "it moves on";
}

// Changes under the opaque screen are drawn by then.
TEST_F(HeldPicture, IsReadyUnderAScreenThatCoversIt) {
    ui::DrawList wall;
    wall.add_box({.x = 0.0F, .y = 0.0F, .width = kWidth, .height = kHeight}, {.g = 0.5F});
    const render::Overlay over{.list = &wall, .atlas_side_px = kAtlasSidePx, .covers = true};
    auto drawn = renderer();
    auto shown = target();
    draw(*drawn, *shown, 0.0, over);
    draw(*drawn, *shown, 0.0, over);
    const auto covered = shown->read_back().value();
    render::Scene lit = scene_of(pulling_);
    lit.key.towards_light = glm::normalize(lit.key.towards_light + vec3(0.3F, 0.0F, 0.0F));
    const auto show = [&](const render::Overlay* overlay) {
        const auto made = drawn->draw(lit, *shown, overlay);
        ASSERT_TRUE(made && *made);
        ASSERT_TRUE(shown->wait());
    };
    for (int frame = 0; frame < 4; ++frame) {
        show(&over);
        EXPECT_EQ(drawn->stats().still_life_drawn, frame == 0);
        EXPECT_EQ(furthest(shown->read_back().value(), covered), 0) << frame;
    }
    EXPECT_FALSE(drawn->stats().device_drew_scene) << "a screen alone says nothing of the machine";
    show(nullptr);
    EXPECT_FALSE(drawn->stats().still_life_drawn);
    show(nullptr);
    EXPECT_TRUE(drawn->stats().device_drew_scene);
    auto fresh = renderer();
    auto other = target();
    for (int frame = 0; frame < 4; ++frame)
        ASSERT_TRUE(fresh->draw(lit, *other, nullptr).value() && other->wait());
    EXPECT_LE(furthest(shown->read_back().value(), other->read_back().value()), kMaskStep);
}

TEST_F(HeldPicture, ShowsThatTheWheelHeadTurns) {
    constexpr int kVisibleLevels = 8;
    constexpr double kHeadMm = 148.0;
    constexpr double kInFrontMm = 75.0;  // here the pot hides nothing
    GoldenScene shown = scene_named("stoneware-wet");
    shown.tool_shown = false;
    auto renders = renderer();
    auto one = target();
    std::vector<std::vector<std::uint8_t>> pictures;
    render::Camera camera;
    for (const double turn_rad : {0.0, kTurn / 20.0}) {
        shown.wheel_direction = {std::cos(turn_rad), std::sin(turn_rad)};
        const render::Scene scene = scene_of(shown);
        camera = scene.camera;
        ASSERT_TRUE(renders->draw(scene, *one).value());
        pictures.push_back(one->read_back().value());
    }
    std::size_t head = 0;
    std::size_t moved = 0;
    for (int at = 0; at < kWidth * kHeight; ++at) {
        const dvec2 pixel(at % kWidth + 0.5, at / kWidth + 0.5);
        const render::Ray ray = render::ray_through(camera, kWidth, kHeight, pixel);
        const dvec3 place_mm = ray.origin_mm - ray.direction * (ray.origin_mm.y / ray.direction.y);
        if (place_mm.z < kInFrontMm || std::hypot(place_mm.x, place_mm.z) > kHeadMm) continue;
        ++head;
        int apart = 0;
        for (int channel = 0; channel < 3; ++channel) {
            const auto byte = static_cast<std::size_t>(4 * at + channel);
            apart = std::max(apart, std::abs(int{pictures[0][byte]} - int{pictures[1][byte]}));
        }
        moved += apart >= kVisibleLevels ? 1U : 0U;
    }
    ASSERT_GT(head, 5'000U);
    EXPECT_GE(moved * 100, head) << moved << " of " << head << " pixels differ";
}

}  // namespace
}  // namespace onggi::golden
