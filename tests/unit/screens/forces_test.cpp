#include "game/screens/forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/screens/stage.h"
#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

TEST(ForceTrace, KeepsTheLastSecondsOldestFirst) {
    ForceTrace trace;
    EXPECT_EQ(trace.size(), 0U);
    EXPECT_EQ(trace.rate_hz(), 0.0);
    for (int frame = 0; frame < 640; ++frame)  // ten seconds
        trace.add(frame / 64.0, 0.001 * frame, static_cast<std::uint64_t>(frame) * 50);
    EXPECT_EQ(trace.size(), 257U) << "four seconds, both ends";
    EXPECT_NEAR(trace.at(trace.size() - 1).force_n, 0.639, 1e-12);
    EXPECT_NEAR(trace.at(0).force_n, 0.383, 1e-12);
    for (std::size_t i = 1; i < trace.size(); ++i)
        EXPECT_GT(trace.at(i).time_s, trace.at(i - 1).time_s);
}

TEST(ForceTrace, DropsTheOldestWhenFramesComeFasterThanItHasRoom) {
    ForceTrace trace;
    for (std::uint64_t frame = 0; frame < 3 * ForceTrace::kMost; ++frame)
        trace.add(static_cast<double>(frame) * 1e-4, static_cast<double>(frame), frame);
    EXPECT_EQ(trace.size(), ForceTrace::kMost);
    EXPECT_EQ(trace.at(0).force_n, 2.0 * ForceTrace::kMost);
    EXPECT_EQ(trace.at(ForceTrace::kMost - 1).force_n, 3.0 * ForceTrace::kMost - 1.0);
}

TEST(ForceTrace, MeasuresTheTickRateOverManyTicks) {
    ForceTrace trace;
    // 4 kHz seen at 60 Hz: now 66, now 67 ticks in a frame.
    for (int frame = 0; frame <= 60; ++frame)
        trace.add(frame / 60.0, 0.0, static_cast<std::uint64_t>(std::floor(frame * 4000.0 / 60.0)));
    EXPECT_NEAR(trace.rate_hz(), 4000.0, 5.0);
    // The loop hangs: the display shows it after a quarter of a second.
    for (int frame = 61; frame <= 80; ++frame)
        trace.add(frame / 60.0, 0.0, 4000);
    EXPECT_EQ(trace.rate_hz(), 0.0);
}

TEST(ForceTrace, ScalesItsPlotByTheStrongestOfTheWindow) {
    ForceTrace trace;
    trace.add(0.0, 0.05, 0);
    EXPECT_EQ(trace.full_n(), 0.1);
    trace.add(0.1, 0.7, 0);
    EXPECT_EQ(trace.full_n(), 1.0);
    trace.add(0.2, 30.0, 0);
    EXPECT_EQ(trace.full_n(), 50.0);
    trace.add(4.15, 0.3, 0);
    EXPECT_EQ(trace.full_n(), 50.0);
    trace.add(4.25, 0.3, 0);
    EXPECT_EQ(trace.full_n(), 0.5) << "what was stronger is out of the window";
}

TEST(ForceNames, AreKeptApartAndOnTheScreen) {
    const ui::Rect bounds{0.0F, 0.0F, 600.0F, 300.0F};
    std::array<ui::Rect, 4> boxes{{{100.0F, 100.0F, 120.0F, 36.0F},
                                   {110.0F, 104.0F, 120.0F, 36.0F},
                                   {90.0F, 96.0F, 120.0F, 36.0F},
                                   {590.0F, 290.0F, 120.0F, 36.0F}}};
    const ui::Rect alone = boxes[3];
    keep_apart(boxes, bounds, 4.0F);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_GE(boxes[i].x, 0.0F);
        EXPECT_LE(boxes[i].right(), 600.0F);
        EXPECT_LE(boxes[i].bottom(), 300.0F);
        for (std::size_t k = 0; k < i; ++k) {
            const ui::Rect shared = overlap(boxes[i], boxes[k]);
            EXPECT_FALSE(shared.width > 0.0F && shared.height > 0.0F) << i << ' ' << k;
        }
    }
    EXPECT_LT(boxes[3].x, alone.x);
    EXPECT_NEAR(boxes[0].x, 100.0F, 1e-3F) << "none is moved aside";
}

TEST(ForceArrows, EndAtTheTipAndDifferInFormAndNotOnlyInColour) {
    std::array<std::vector<vec2>, kForceCount> corners;
    for (std::size_t force = 0; force < kForceCount; ++force) {
        ui::DrawList list;
        draw_arrow(list, static_cast<Force>(force), {100.0F, 100.0F}, {220.0F, 100.0F}, 1.0F);
        float farthest = 0.0F;
        for (const ui::Vertex& vertex : list.vertices()) {
            corners[force].push_back(vertex.position_px);
            farthest = std::max(farthest, vertex.position_px.x);
        }
        EXPECT_NEAR(farthest, 220.0F, 9.0F) << force << ": the tip and its casing";
    }
    EXPECT_NE(corners[0], corners[1]);
    EXPECT_NE(corners[0], corners[2]);
    EXPECT_NE(corners[1], corners[2]);
    ui::DrawList none;
    draw_arrow(none, Force::kStiffness, {100.0F, 100.0F}, {100.2F, 100.0F}, 1.0F);
    EXPECT_TRUE(none.vertices().empty());
}

// A touch with a line for each of three rings, and all four arrows.
ForceFrame sample_frame(const ForceTrace& trace) {
    ForceTouch touch;
    touch.arrows = {{{{300.0F, 200.0F}, {380.0F, 200.0F}, 1.0F, false, true},
                     {{300.0F, 200.0F}, {340.0F, 240.0F}, 1.0F, false, true},
                     {{300.0F, 200.0F}, {302.0F, 190.0F}, 0.1F, false, true},
                     {{300.0F, 200.0F}, {390.0F, 220.0F}, 1.0F, false, true}}};
    touch.rings_px = {{{250.0F, 190.0F}, {350.0F, 190.0F}},
                      {{250.0F, 200.0F}, {350.0F, 200.0F}},
                      {{250.0F, 210.0F}, {350.0F, 210.0F}}};
    return {.touches = {touch}, .size_n = {0.25, 0.1, 1.0, 0.5}, .trace = &trace};
}

class ForcesOnStage : public testing::Test {
  protected:
    std::size_t vertices(const std::string& name, const ForceFrame* frame) {
        Stage stage;
        for (const SampleView& sample : sample_views({.width_px = 640, .height_px = 360})) {
            if (sample.name != name) continue;
            stage.take(std::make_shared<const Composed>(
                           Composed{sample.view, visit::compose(*sample.view, painter_, store_)}),
                       0.0);
        }
        static_cast<void>(stage.draw({.now_s = 1.0}));
        return stage.draw({.now_s = 2.0, .forces = frame}).vertices().size();
    }
    ui::Painter painter_;
    PaintingStore store_{painter_};
    ForceTrace trace_;
};

TEST_F(ForcesOnStage, ShowArrowsWhileTeachingAndNumbersAndPlotsOnRequest) {
    for (int frame = 0; frame < 100; ++frame)
        trace_.add(frame / 60.0, 0.4, static_cast<std::uint64_t>(frame) * 66);
    ForceFrame frame = sample_frame(trace_);
    const std::size_t plain = vertices("throw-0", nullptr);
    const std::size_t with_sum = vertices("throw-0", &frame);
    EXPECT_GT(with_sum, plain + 100);
    frame.with_sum = false;
    EXPECT_LT(vertices("throw-0", &frame), with_sum) << "three forces are the lesson";
    const std::size_t panel_alone = vertices("throw-forces", nullptr);
    // Sixteen digits and a point for each of five numbers at least, and two plots of a hundred samples.
    EXPECT_GT(vertices("throw-forces", &frame), panel_alone + 4U * 16U + 2U * 99U * 4U);
}

TEST_F(ForcesOnStage, ShowOnlyWhileThrowing) {
    const ForceFrame frame = sample_frame(trace_);
    EXPECT_EQ(vertices("glaze-0", &frame), vertices("glaze-0", nullptr));
}

TEST_F(ForcesOnStage, AreTheOnlyOverlayOfAPictureThatPlaysByItself) {
    View view;
    view.width_px = 640;
    view.height_px = 360;
    view.state.comfort.forces = true;
    view.languages = std::make_shared<const std::vector<kiosk::Language>>(kiosk::built_in_languages());
    const Composition alone = compose_forces(view, painter_, store_);
    EXPECT_TRUE(alone.targets.empty());
    ASSERT_NE(alone.forces, nullptr);
    EXPECT_TRUE(alone.forces->has_panel);
    EXPECT_TRUE(std::all_of(alone.forces->digits.begin(), alone.forces->digits.end(),
                            [](const Item& digit) { return digit.painting != nullptr; }));
}

}  // namespace
}  // namespace onggi::screens
