#include "engine/render/quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace onggi::render {
namespace {

constexpr double kFrameS = 1.0 / 60.0;

// Runs frames of drawn_ms for `seconds`. Returns the number of step changes.
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

TEST(QualityLadder, StepsUpAfterALongTimeWithRoomToSpare) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    EXPECT_EQ(run(ladder, 4.0, 4.0), 0) << "too soon";
    EXPECT_EQ(run(ladder, 3.0, 4.0), 1);
    EXPECT_EQ(ladder.step(), QualityStep::kTwoCores);
    EXPECT_EQ(run(ladder, 60.0, 4.0), 0) << "a software device has no higher step";
}

TEST(QualityLadder, RetriesAFailedStepWithGrowingDelays) {
    QualityLadder ladder(quality_range(DeviceClass::kSoftware, 1));
    int changes = 0;
    // The lower step is easy, the higher one too much: without the growing delay it would change every few
    // seconds.
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

// A GPU never falls back to the steps of the CPU backend.
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
    float scale = 1.0F;
    for (const float expected : {1.0F, 0.75F, 0.5F}) {
        EXPECT_TRUE(ladder.step_down());
        EXPECT_EQ(desc().samples, 1);
        EXPECT_EQ(desc().scale, expected);
        scale = desc().scale;
    }
    EXPECT_FALSE(ladder.step_down());
    EXPECT_EQ(scale, 0.5F);
    EXPECT_EQ(ladder.step(), QualityStep::kSlowestGpu);
    EXPECT_TRUE(has_time_for_moving_camera(ladder.step()));
}

// Simulates a GPU that takes highest_ms for the highest step and the measured ratio of that for the others,
// with visitors who come and go.
struct SlowDevice {
    double discrete_ms = 10.0;
    double fixed_ms = 1.0;  // independent of the content
    int hiccup_every = 0;   // frames; each of them takes four times as long
    int frame = 0;

    double took_ms(QualityStep step) {
        const RendererDesc desc = quality_desc(step, VK_FORMAT_R8G8B8A8_UNORM, 720);
        const double pixels = desc.scale * desc.scale * (desc.samples == 4 ? 1.0 : 0.55);
        const double vertices = desc.sectors / 192.0;
        const double ms = fixed_ms + (discrete_ms - fixed_ms) * (0.85 * pixels + 0.15 * vertices);
        return hiccup_every > 0 && ++frame % hiccup_every == 0 ? 4.0 * ms : ms;
    }
};

struct Visits {
    int changes = 0;
    int most_in_view = 0;  // of one visitor
    bool went_up_in_view = false;
};

Visits receive(QualityLadder& ladder, SlowDevice& device, int visitors, double each_s) {
    Visits visits;
    for (int visitor = 0; visitor < visitors; ++visitor) {
        int in_view = 0;
        for (double t = 0.0; t < each_s;) {
            const bool is_there = t < 0.75 * each_s;
            const QualityStep before = ladder.step();
            const double ms = device.took_ms(before);
            const double dt_s = std::max(kFrameS, 1e-3 * ms);
            // A screen that covers the scene between two visits, and an empty wheel after it.
            const bool covered = !is_there && t < 0.8 * each_s;
            const bool changed = covered ? ladder.unseen() : ladder.frame(ms, dt_s, is_there);
            t += dt_s;
            if (!changed) continue;
            ++visits.changes;
            if (!is_there) continue;
            ++in_view;
            visits.went_up_in_view = visits.went_up_in_view || ladder.step() > before;
        }
        visits.most_in_view = std::max(visits.most_in_view, in_view);
    }
    return visits;
}

TEST(QualityLadder, SettlesOnASlowGpuAndChangesNoMoreThanOnceInViewOfAVisitor) {
    for (const DeviceClass kind : {DeviceClass::kIntegratedGpu, DeviceClass::kDiscreteGpu}) {
        for (const double discrete_ms : {4.0, 9.0, 14.0, 16.0, 18.0, 24.0, 33.0, 50.0, 90.0, 400.0}) {
            for (const int hiccup_every : {0, 9, 200}) {
                SlowDevice device{.discrete_ms = discrete_ms, .hiccup_every = hiccup_every};
                QualityLadder ladder(quality_range(kind, 1));
                const Visits first = receive(ladder, device, 20, 90.0);
                EXPECT_LE(first.most_in_view, 1) << discrete_ms;
                EXPECT_FALSE(first.went_up_in_view) << discrete_ms;
                const QualityStep settled = ladder.step();
                const Visits later = receive(ladder, device, 40, 90.0);
                EXPECT_EQ(later.changes, 0) << discrete_ms << ' ' << hiccup_every;
                EXPECT_EQ(ladder.step(), settled);
                if (hiccup_every == 9) continue;  // by the slowest tenth it is four times as slow
                EXPECT_TRUE(device.took_ms(settled) < 1000.0 / 60.0 || settled == QualityStep::kSlowestGpu)
                    << discrete_ms << ": " << quality_name(settled);
            }
        }
    }
}

TEST(QualityLadder, GoesUpOnAGpuOnlyWithoutAVisitor) {
    QualityLadder ladder(quality_range(DeviceClass::kIntegratedGpu, 1));
    EXPECT_EQ(run(ladder, 600.0, 3.0), 0) << "a visitor looks";
    EXPECT_TRUE(ladder.unseen());
    EXPECT_EQ(ladder.step(), QualityStep::kDiscreteGpu);
    EXPECT_FALSE(ladder.unseen()) << "once";
}

TEST(QualityLadder, TriesNoStepOfAGpuAgainThatWasTooSlow) {
    QualityLadder ladder(quality_range(DeviceClass::kIntegratedGpu, 1));
    run(ladder, 6.0, 3.0);
    ASSERT_TRUE(ladder.unseen());
    EXPECT_EQ(run(ladder, 2.0, 18.0), 1);
    EXPECT_EQ(ladder.step(), QualityStep::kSlowGpu) << "the highest that ought to be quick enough";
    for (int visitor = 0; visitor < 20; ++visitor) {
        run(ladder, 600.0, 3.0);
        ladder.unseen();
    }
    EXPECT_EQ(ladder.step(), QualityStep::kIntegratedGpu);
}

TEST(BackendChoice, HasTheNamesOfItsOption) {
    for (const char* name : {"auto", "gpu", "cpu"})
        EXPECT_EQ(backend_choice_name(backend_choice_named(name).value()), name);
    EXPECT_FALSE(backend_choice_named("GPU"));
    EXPECT_FALSE(backend_choice_named(""));
}

TEST(BackendChoice, DeterminesTheClassOfADevice) {
    using enum DeviceClass;
    for (const DeviceClass device : {kSoftware, kIntegratedGpu, kDiscreteGpu}) {
        EXPECT_EQ(class_for(BackendChoice::kAuto, device), device);
        EXPECT_EQ(class_for(BackendChoice::kCpu, device), kSoftware);
        EXPECT_EQ(class_for(BackendChoice::kGpu, device), device == kSoftware ? kIntegratedGpu : device);
    }
}

TEST(Quality, NamesEveryStepDifferentlyAndAsksMoreOfEach) {
    std::set<std::string_view> names;
    int sectors = 0;
    for (int step = 0; step <= static_cast<int>(QualityStep::kDiscreteGpu); ++step) {
        const auto quality = static_cast<QualityStep>(step);
        names.insert(quality_name(quality));
        EXPECT_EQ(quality_named(quality_name(quality)), quality);
        const RendererDesc desc = quality_desc(quality, VK_FORMAT_R8G8B8A8_UNORM, 720);
        if (quality == QualityStep::kSlowestGpu) sectors = 0;  // another ladder
        EXPECT_GT(desc.sectors, sectors) << quality_name(quality);
        EXPECT_LE(desc.max_rings, kMaxRings);
        EXPECT_TRUE(check_desc(desc)) << quality_name(quality);
        sectors = desc.sectors;
    }
    EXPECT_EQ(names.size(), 8U);
}

TEST(Quality, RefusesSettingsThatNoBackendSupports) {
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
