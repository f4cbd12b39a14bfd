#include "engine/render/quality.h"

#include <gtest/gtest.h>

#include <set>

namespace onggi::render {
namespace {

constexpr double kFrameS = 1.0 / 60.0;

// So many seconds of frames that take this long; how often the step changed.
int run(QualityLadder& ladder, double seconds, double drawn_ms) {
    int changes = 0;
    for (double t = 0.0; t < seconds; t += kFrameS)
        changes += ladder.frame(drawn_ms, kFrameS) ? 1 : 0;
    return changes;
}

TEST(QualityLadder, BeginsWhereTheDeviceStands) {
    EXPECT_EQ(QualityLadder(quality_range(DeviceClass::kSoftware, 1)).step(), QualityStep::kOneCore);
    EXPECT_EQ(QualityLadder(quality_range(DeviceClass::kSoftware, 2)).step(), QualityStep::kTwoCores);
    EXPECT_EQ(QualityLadder(quality_range(DeviceClass::kIntegratedGpu, 1)).step(),
              QualityStep::kIntegratedGpu);
    EXPECT_EQ(QualityLadder(quality_range(DeviceClass::kDiscreteGpu, 1)).step(), QualityStep::kDiscreteGpu);
}

TEST(QualityLadder, StaysWhileFramesFitTheirBudget) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    EXPECT_EQ(run(ladder, 120.0, 10.0), 0);
    EXPECT_EQ(ladder.step(), QualityStep::kOneCore);
}

TEST(QualityLadder, GoesDownWithinTwoSecondsOfSlowFrames) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 2));
    EXPECT_EQ(run(ladder, 2.0, 20.0), 1);
    EXPECT_EQ(ladder.step(), QualityStep::kOneCore);
}

TEST(QualityLadder, IsNotMovedByASingleSlowFrame) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    for (int second = 0; second < 30; ++second) {
        EXPECT_EQ(run(ladder, 0.9, 10.0), 0);
        EXPECT_FALSE(ladder.frame(400.0, kFrameS));
    }
}

TEST(QualityLadder, GoesUpWhenThereIsTimeToSpareForLong) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    EXPECT_EQ(run(ladder, 4.0, 4.0), 0) << "too soon";
    EXPECT_EQ(run(ladder, 3.0, 4.0), 1);
    EXPECT_EQ(ladder.step(), QualityStep::kTwoCores);
    EXPECT_EQ(run(ladder, 60.0, 4.0), 0) << "a software device has no higher step";
}

TEST(QualityLadder, TriesAgainEverMoreSeldomWhatDidNotLast) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    int changes = 0;
    // The lower step is easy, the higher one too much: without patience it would change every few seconds.
    for (double t = 0.0; t < 1200.0; t += kFrameS)
        changes += ladder.frame(ladder.step() == QualityStep::kTwoCores ? 18.0 : 4.0, kFrameS) ? 1 : 0;
    EXPECT_GE(changes, 6);
    EXPECT_LE(changes, 18) << "in twenty minutes";
}

TEST(QualityLadder, EndsAtTheBottom) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    run(ladder, 60.0, 100.0);
    EXPECT_EQ(ladder.step(), QualityStep::kSpare);
    EXPECT_FALSE(ladder.step_down());
}

TEST(QualityLadder, StepsDownAtOnceForWantOfMemory) {
    QualityLadder ladder(quality_range(DeviceClass::kDiscreteGpu, 1));
    EXPECT_TRUE(ladder.step_down());
    EXPECT_EQ(ladder.step(), QualityStep::kIntegratedGpu);
}

// A GPU never falls to what is made for a processor that reads and writes pixels itself.
TEST(QualityLadder, NeverTakesAGpuToTheProcessorsBackend) {
    for (const DeviceClass device : {DeviceClass::kIntegratedGpu, DeviceClass::kDiscreteGpu}) {
        QualityLadder ladder(quality_range(device, 1));
        int steps = 0;
        do {
            const RendererDesc desc = quality_desc(ladder.step(), VK_FORMAT_R8G8B8A8_UNORM, 720);
            EXPECT_EQ(desc.backend, Backend::kVulkan) << quality_name(ladder.step());
            ++steps;
        } while (ladder.step_down());
        EXPECT_GE(steps, 3) << "it has somewhere to go";
    }
    QualityLadder software(quality_range(DeviceClass::kSoftware, 8));
    run(software, 60.0, 1.0);
    EXPECT_EQ(quality_desc(software.step(), VK_FORMAT_R8G8B8A8_UNORM, 720).backend, Backend::kCpu);
}

TEST(QualityLadder, GivesUpSamplesAndThenSizeOnAGpu) {
    QualityLadder ladder(quality_range(DeviceClass::kIntegratedGpu, 1));
    const auto desc = [&] { return quality_desc(ladder.step(), VK_FORMAT_R8G8B8A8_UNORM, 720); };
    EXPECT_EQ(desc().samples, 4);
    EXPECT_EQ(run(ladder, 2.0, 20.0), 1);
    EXPECT_EQ(desc().samples, 1);
    EXPECT_EQ(desc().scale, 1.0F);
    EXPECT_EQ(run(ladder, 2.0, 20.0), 1);
    EXPECT_LT(desc().scale, 1.0F);
    EXPECT_EQ(run(ladder, 20.0, 100.0), 0);
    EXPECT_EQ(ladder.step(), QualityStep::kSlowestGpu);
    EXPECT_TRUE(has_time_for_moving_camera(ladder.step()));
}

TEST(Quality, NamesEveryStepDifferentlyAndAsksMoreOfEach) {
    std::set<std::string_view> names;
    int sectors = 0;
    for (int step = 0; step <= static_cast<int>(QualityStep::kDiscreteGpu); ++step) {
        const auto quality = static_cast<QualityStep>(step);
        names.insert(quality_name(quality));
        const RendererDesc desc = quality_desc(quality, VK_FORMAT_R8G8B8A8_UNORM, 720);
        if (quality == QualityStep::kSlowestGpu) sectors = 0;  // another ladder
        EXPECT_GT(desc.sectors, sectors) << quality_name(quality);
        EXPECT_LE(desc.max_rings, kMaxRings);
        EXPECT_TRUE(check_desc(desc)) << quality_name(quality);
        sectors = desc.sectors;
    }
    EXPECT_EQ(names.size(), 7U);
}

TEST(Quality, RefusesWhatNoBackendDraws) {
    RendererDesc processor = live_desc(VK_FORMAT_R8G8B8A8_UNORM, true, 720);
    ASSERT_TRUE(check_desc(processor));
    processor.samples = 4;
    EXPECT_FALSE(check_desc(processor));
    RendererDesc device = still_desc(VK_FORMAT_R8G8B8A8_UNORM);
    ASSERT_TRUE(check_desc(device));
    device.scale = 0.0F;
    EXPECT_FALSE(check_desc(device));
    device.scale = 1.0F;
    device.smooths_outlines = true;
    EXPECT_FALSE(check_desc(device));
}

}  // namespace
}  // namespace onggi::render
