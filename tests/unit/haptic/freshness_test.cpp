// The age of the clay in a frame: both loops, each on a simulated core with a virtual clock, and the buffer
// between them.
#include <gtest/gtest.h>

#include <vector>

#include "engine/jobs/frame_pacer.h"
#include "game/haptic/job.h"
#include "tests/support/virtual_clock.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::haptic {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kFrameRateHz = 60.0;
constexpr auto kFrameNs = static_cast<std::int64_t>(1e9 / kFrameRateHz);

struct Age {
    std::int64_t snapshot_ns = 0;  // since the tick it tells of ended
    std::int64_t shape_ns = 0;     // since the tick in which the copy of the rings was finished
};

// Advances the haptic core by whole ticks up to the picture's clock.
class TwoCores {
  public:
    explicit TwoCores(double rate_hz)
        : rate_hz_(rate_hz),
          ticks_(haptic_core_, {.rate_hz = rate_hz}),
          frames_(picture_core_, kFrameRateHz),
          work_(test::studio_start(), parameters_at(rate_hz), std::make_unique<test::StudioHand>(rate_hz),
                {}) {}

    // Draws one frame that takes work_ns. Returns the age of its content when it appears on the screen.
    Age frame(std::int64_t work_ns) {
        frames_.wait();
        catch_up();
        const Snapshot& snapshot = work_.newest_snapshot();
        const std::uint64_t tick = snapshot.tick;
        const std::uint64_t shape_tick = snapshot.pot_stamp.tick;
        picture_core_.pass(work_ns);
        frames_.finish();
        const std::int64_t shown_ns = picture_core_.now_ns();
        return {.snapshot_ns = shown_ns - ended_ns_.at(tick),
                .shape_ns = shown_ns - ended_ns_.at(shape_tick)};
    }
    void wake_late_once(std::int64_t by_ns) { picture_core_.oversleep_once(by_ns); }
    [[nodiscard]] std::int64_t tick_ns() const { return static_cast<std::int64_t>(1e9 / rate_hz_); }

  private:
    static HapticParameters parameters_at(double rate_hz) {
        HapticParameters parameters;
        parameters.set_rate_hz(rate_hz);
        return parameters;
    }
    void catch_up() {
        constexpr std::int64_t kTickWorkNs = 20'000;
        while (ticks_.deadline_ns(ended_ns_.size() - 1) + kTickWorkNs <= picture_core_.now_ns()) {
            const jobs::Period period = ticks_.wait_for_next();
            ASSERT_TRUE(work_.tick(period));
            haptic_core_.pass(kTickWorkNs);
            ticks_.finish(period);
            ended_ns_.push_back(haptic_core_.now_ns());
        }
    }

    double rate_hz_;
    test::VirtualClock haptic_core_;
    test::VirtualClock picture_core_;
    jobs::Pacer<test::VirtualClock> ticks_;
    jobs::FramePacer<test::VirtualClock> frames_;
    HapticWork work_;
    std::vector<std::int64_t> ended_ns_{haptic_core_.now_ns()};  // by how many ticks there have been
};

class Freshness : public testing::TestWithParam<double> {};

TEST_P(Freshness, OfTheNewestClayIsOneFrameAtMostWhenItIsShown) {
    TwoCores cores(GetParam());
    // A frame may take all of its time but the tick it may just have missed.
    const std::int64_t longest_ns = kFrameNs - 2 * cores.tick_ns();
    for (int frame = 0; frame < 300; ++frame) {
        const std::int64_t work_ns = frame % 3 == 0 ? longest_ns : 8 * kMs;
        const Age age = cores.frame(work_ns);
        ASSERT_LE(age.snapshot_ns, kFrameNs) << "frame " << frame;
        // The rings are copied twice a frame: half a frame more, and the ticks at both ends of a copy.
        ASSERT_LE(age.shape_ns, work_ns + kFrameNs / 2 + 4 * cores.tick_ns()) << "frame " << frame;
    }
}

TEST_P(Freshness, IsAFramesAgainRightAfterAFrameThatTookLong) {
    TwoCores cores(GetParam());
    for (int frame = 0; frame < 200; ++frame) {
        const bool is_long = frame % 10 == 5;
        if (frame % 10 == 8) cores.wake_late_once(7 * kMs);
        const std::int64_t work_ns = is_long ? 90 * kMs : 9 * kMs;
        // A late frame still shows the newest state at its start.
        ASSERT_LE(cores.frame(work_ns).snapshot_ns, work_ns + 2 * cores.tick_ns()) << "frame " << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(OfBothRates, Freshness, testing::Values(1000.0, 4000.0),
                         [](const auto& tested) { return std::to_string(static_cast<int>(tested.param)); });

}  // namespace
}  // namespace onggi::haptic
