// A device's session: found, read, sent forces, lost, found again. Scripted device, virtual time.
#include "engine/haptics/hid/hid_session.h"

#include <gtest/gtest.h>

#include "engine/haptics/hid/simple_drivers.h"
#include "tests/support/scripted_hid.h"

namespace onggi::haptics::hid {
namespace {

using testing::ScriptedBus;
using testing::ScriptedHid;

// Uses each report's second byte as a position in mm, and stores the sent forces.
class NotingDriver final : public HidDriver {
  public:
    explicit NotingDriver(std::vector<std::string>& notes) : notes_(notes) {}
    [[nodiscard]] DeviceCapabilities capabilities() const override { return {}; }
    Result<void> start(const HidDeviceInfo& device, HidPort&) override {
        notes_.push_back("start");
        if (refuses_ || device.path == refused_path_) return failed("it does not want to");
        return {};
    }
    void take_report(std::span<const std::uint8_t> report, std::int64_t) noexcept override {
        input_.is_live = report[0] != 0;
        input_.is_fresh = report[0] == 1;
        input_.motion = DeviceInput::Motion::kPlace;
        input_.place_mm.x = report[1];
    }
    [[nodiscard]] DeviceInput input(std::int64_t) const noexcept override { return input_; }
    Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t) override {
        force_n = order.force_n;
        const std::array<std::uint8_t, 1> nothing{};
        return port.write(nothing);
    }
    void stop(HidPort&) noexcept override { notes_.push_back("stop"); }

    dvec2 force_n{-1.0};
    bool refuses_ = false;
    std::string refused_path_ = {};

  private:
    std::vector<std::string>& notes_;
    DeviceInput input_;
};

class HidSessionTest : public ::testing::Test {
  protected:
    HidSessionTest() {
        script->info = {.path = "/dev/hidraw9", .name = "Testing stick", .may_open = true};
        script->info.kind = HidKind::kForceJoystick;
        auto driver = std::make_unique<NotingDriver>(notes);
        told = driver.get();
        session =
            std::make_unique<HidSession>(link, std::make_unique<ScriptedBus>(script), std::move(driver),
                                         HidSessionOptions{.kind = HidKind::kForceJoystick, .force = {}});
    }

    // One round, then time goes on as the thread would let it.
    void step() {
        last_round_ns = now_ns;
        const std::int64_t rest_ns = session->round(now_ns);
        now_ns += rest_ns > 0 ? rest_ns : kReadWaitMs * kMs;
    }
    void step_until(std::int64_t end_ns) {
        while (now_ns < end_ns)
            step();
    }
    // The tick's order, a new one each time.
    void order(const dvec2& force_n) {
        link.force.put({.force_n = force_n, .tool_mm = {50.0, 50.0}, .ticks = ++ticks});
    }
    // Long enough for the ramp.
    void reach_full_force() {
        for (int round = 0; round < 2; ++round) {
            order({0.0, 0.0});
            script->report("01 10");
            step();
        }
        for (int round = 0; round < 300; ++round) {
            order({1.0, 0.0});
            script->report("01 10");
            step();
        }
    }

    std::shared_ptr<ScriptedHid> script = std::make_shared<ScriptedHid>();
    std::vector<std::string> notes;
    HidLink link;
    NotingDriver* told = nullptr;
    std::unique_ptr<HidSession> session;
    std::int64_t now_ns = 1'000'000'000;
    std::int64_t last_round_ns = 0;
    std::uint64_t ticks = 0;
};

TEST_F(HidSessionTest, PublishesTheNewestOfSixtyFourStaleReports) {
    step();
    const std::uint64_t before = link.input.latest().heartbeat;
    for (int count = 1; count <= 64; ++count)
        script->queue.push_back({1, static_cast<std::uint8_t>(count)});
    step();
    EXPECT_EQ(link.input.latest().place_mm.x, 64.0);
    EXPECT_EQ(link.input.latest().heartbeat, before + 1) << "published once, not sixty-four times";
    EXPECT_TRUE(script->queue.empty());
}

TEST_F(HidSessionTest, EndsARoundAlthoughADeviceKeepsReporting) {
    step();
    for (int count = 0; count < 1000; ++count)
        script->report("01 05");
    step();
    EXPECT_EQ(script->queue.size(), 1000U - kMostReportsARound);
}

TEST_F(HidSessionTest, NoticesARemovalWithinTwoHundredMilliseconds) {
    script->report("01 10");
    step();
    ASSERT_TRUE(link.input.latest().is_live);
    step_until(now_ns + 500 * kMs);
    // A device that neither fails nor reports: only its node is gone.
    script->is_plugged_in = false;
    const std::int64_t removed_ns = now_ns;
    while (link.input.latest().is_live && now_ns < removed_ns + 1000 * kMs)
        step();
    EXPECT_FALSE(link.input.latest().is_live);
    EXPECT_LE(last_round_ns - removed_ns, 200 * kMs);
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kAbsent);
    EXPECT_EQ(script->open_ports, 0);
}

TEST_F(HidSessionTest, NoticesAFailedReadOrWriteAtOnce) {
    for (bool ScriptedHid::*fault : {&ScriptedHid::read_fails, &ScriptedHid::write_fails}) {
        step_until(now_ns + 1500 * kMs);
        ASSERT_EQ(link.status.latest().state, HidStatus::State::kReady);
        (*script).*fault = true;
        step();
        EXPECT_EQ(link.status.latest().state, HidStatus::State::kAbsent);
        EXPECT_FALSE(link.input.latest().is_live);
        EXPECT_EQ(script->open_ports, 0);
    }
}

TEST_F(HidSessionTest, FindsADevicePluggedInAgainWithinTwoSeconds) {
    step();
    script->read_fails = true;
    script->is_plugged_in = false;
    step();
    step_until(now_ns + 5000 * kMs);
    ASSERT_EQ(link.status.latest().state, HidStatus::State::kAbsent);
    script->is_plugged_in = true;
    const std::int64_t plugged_in_ns = now_ns;
    while (link.status.latest().state != HidStatus::State::kReady && now_ns < plugged_in_ns + 5000 * kMs)
        step();
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kReady);
    EXPECT_LE(last_round_ns - plugged_in_ns, 2000 * kMs);
    EXPECT_EQ(script->times_opened, 2);
    EXPECT_EQ(link.status.latest().times_found, 2U);
}

TEST_F(HidSessionTest, RampsTheForceUpAgainAfterAReplug) {
    reach_full_force();
    EXPECT_NEAR(told->force_n.x, 1.0, 1e-9);
    script->read_fails = true;
    step();
    step_until(now_ns + 1100 * kMs);
    ASSERT_EQ(link.status.latest().state, HidStatus::State::kReady);
    for (int round = 0; round < 50; ++round) {
        order({1.0, 0.0});
        script->report("01 10");
        step();
    }
    EXPECT_EQ(told->force_n, dvec2(0.0)) << "the tool stands in the clay: it stays loose until it came out";
    order({0.0, 0.0});
    step();
    order({1.0, 0.0});
    step();
    EXPECT_GT(told->force_n.x, 0.0);
    EXPECT_LT(told->force_n.x, 0.01);
}

TEST_F(HidSessionTest, SaysHowMuchOfTheForceItsOwnRampLetThrough) {
    for (int round = 0; round < 400; ++round) {
        order({round < 2 ? 0.0 : 2.0, 0.0});
        script->report("01 10");
        step();
        if (round >= 2) {
            ASSERT_NEAR(link.input.latest().force_fraction * 2.0, told->force_n.x, 1e-12) << round;
        }
    }
    EXPECT_EQ(link.input.latest().force_fraction, 1.0);
    link.silences.fetch_add(1);
    step();
    EXPECT_EQ(link.input.latest().force_fraction, 0.0) << "no force is sent while silenced";
    script->read_fails = true;
    step();
    EXPECT_EQ(link.input.latest().force_fraction, 0.0);
}

TEST_F(HidSessionTest, RemovesTheForceWhenTheTickStops) {
    reach_full_force();
    ASSERT_GT(told->force_n.x, 0.9);
    const std::int64_t stopped_ns = now_ns;
    while (told->force_n.x > 0.0 && now_ns < stopped_ns + 1000 * kMs) {
        script->report("01 10");
        step();
    }
    EXPECT_LE(last_round_ns - stopped_ns, 30 * kMs);
}

TEST_F(HidSessionTest, RemovesTheForceWhenItsInputIsStale) {
    reach_full_force();
    ASSERT_GT(told->force_n.x, 0.9);
    script->report("00 10");
    order({1.0, 0.0});
    step();
    EXPECT_EQ(told->force_n, dvec2(0.0));
    EXPECT_FALSE(link.input.latest().is_live);
    EXPECT_FALSE(link.status.latest().is_heard);
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kReady) << "it is still plugged in";
}

TEST_F(HidSessionTest, StopsTheForceWhenItEnds) {
    step();
    session->finish();
    EXPECT_EQ(notes, (std::vector<std::string>{"start", "stop"}));
    EXPECT_EQ(script->open_ports, 0);
    EXPECT_FALSE(link.input.latest().is_live);
    session->finish();
    EXPECT_EQ(notes.size(), 2U);
    step();  // opened again, as open() after close() does
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kReady);
}

TEST_F(HidSessionTest, SaysWhyADeviceIsRefused) {
    script->info.refusal = "may not be opened by this user";
    step();
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kRefused);
    EXPECT_EQ(link.status.latest().message, "may not be opened by this user");
    EXPECT_EQ(script->times_opened, 0);
    // The udev rule is installed while the program runs.
    script->info.refusal.clear();
    step_until(now_ns + 2000 * kMs);
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kReady);
}

TEST_F(HidSessionTest, ReportsAFailingDeviceAndTriesAgain) {
    told->refuses_ = true;
    step();
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kFailed);
    EXPECT_EQ(link.status.latest().message, "it does not want to");
    EXPECT_EQ(script->open_ports, 0);
    told->refuses_ = false;
    step_until(now_ns + 2000 * kMs);
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kReady);
}

TEST_F(HidSessionTest, TakesTheNextDeviceIfTheFirstFails) {
    HidDeviceInfo broken = script->info;
    broken.path = "/dev/hidraw8";
    HidDeviceInfo forbidden = script->info;
    forbidden.path = "/dev/hidraw7";
    forbidden.refusal = "may not be opened by this user";
    script->others = {forbidden, broken};
    told->refused_path_ = broken.path;
    step();
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kReady);
    EXPECT_EQ(link.status.latest().path, "/dev/hidraw9");
    EXPECT_EQ(link.status.latest().message, "");
    EXPECT_EQ(link.status.latest().times_found, 1U);
    EXPECT_EQ(script->open_ports, 1) << "the broken one is closed again";
    // Without a working device, the error of the failing one is reported, not of the forbidden one.
    script->read_fails = true;
    step();
    told->refuses_ = true;
    step_until(now_ns + 2000 * kMs);
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kFailed);
    EXPECT_EQ(link.status.latest().path, broken.path);
    EXPECT_EQ(script->open_ports, 0);
}

class TwoNodes final : public HidBus {
  public:
    explicit TwoNodes(std::vector<std::shared_ptr<ScriptedHid>> nodes) : nodes_(std::move(nodes)) {}
    Result<std::vector<HidDeviceInfo>> list() override {
        return std::vector<HidDeviceInfo>{nodes_[0]->info, nodes_[1]->info};
    }
    Result<std::unique_ptr<HidPort>> open(const HidDeviceInfo& info) override {
        const auto& node = info.path == nodes_[0]->info.path ? nodes_[0] : nodes_[1];
        return std::unique_ptr<HidPort>(std::make_unique<testing::ScriptedPort>(node));
    }

  private:
    std::vector<std::shared_ptr<ScriptedHid>> nodes_;
};

// Two SpaceMice, or two nodes of one receiver.
class HidSessionOfSeveralNodes : public ::testing::Test {
  protected:
    void SetUp() override {
        nodes[0]->info = {.path = "/dev/hidraw1", .may_open = true, .kind = HidKind::kSpaceMouse};
        nodes[1]->info = {.path = "/dev/hidraw2", .may_open = true, .kind = HidKind::kSpaceMouse};
        session = std::make_unique<HidSession>(link, std::make_unique<TwoNodes>(nodes),
                                               std::make_unique<SpaceMouseDriver>(),
                                               HidSessionOptions{.kind = HidKind::kSpaceMouse, .force = {}});
        listen();
    }
    void listen() {
        for (int round = 0; round < 60; ++round, now_ns += 4 * kMs)
            static_cast<void>(session->round(now_ns));
    }
    [[nodiscard]] std::string used() { return link.status.latest().path; }

    static constexpr const char* kPushed = "01 5e 01 00 00 00 00";
    static constexpr const char* kPushedLess = "01 00 01 00 00 00 00";
    static constexpr const char* kLeans = "01 38 00 00 00 00 00";
    static constexpr const char* kLeansTrembling = "01 3b 00 00 00 00 00";

    std::vector<std::shared_ptr<ScriptedHid>> nodes{std::make_shared<ScriptedHid>(),
                                                    std::make_shared<ScriptedHid>()};
    HidLink link;
    std::unique_ptr<HidSession> session;
    std::int64_t now_ns = 0;
};

// A receiver for several pucks shows a node for each: the one that a hand moves is wanted.
TEST_F(HidSessionOfSeveralNodes, GoesOverToTheFirstThatSaysSomething) {
    EXPECT_EQ(used(), "/dev/hidraw1");
    EXPECT_EQ(nodes[1]->open_ports, 1);
    nodes[1]->report(kPushed);
    listen();
    EXPECT_EQ(used(), "/dev/hidraw2");
    nodes[1]->report(kPushedLess);
    static_cast<void>(session->round(now_ns));
    EXPECT_GT(link.input.latest().rate_mm_s.x, 0.0);
    EXPECT_EQ(nodes[0]->open_ports, 0);
    nodes[0]->report(kPushed);
    nodes[0]->report(kPushedLess);
    listen();
    EXPECT_EQ(used(), "/dev/hidraw2") << "who has it keeps it";
}

TEST_F(HidSessionOfSeveralNodes, LetsTheOneThatMovesWinAndNotTheOneThatLeans) {
    for (const char* report : {kLeans, kLeansTrembling, kLeans, kLeans})
        nodes[0]->report(report);
    listen();
    nodes[1]->report(kPushedLess);
    listen();
    EXPECT_EQ(used(), "/dev/hidraw1") << "two that only lean: the first";
    nodes[0]->report(kLeans);
    nodes[1]->report(kPushed);
    listen();
    EXPECT_EQ(used(), "/dev/hidraw2");
    EXPECT_EQ(nodes[0]->open_ports, 0);
}

TEST_F(HidSessionOfSeveralNodes, GivesTheToolBackFromOneThatLeansToOneThatWasStill) {
    for (const char* report : {kLeans, kLeansTrembling, kLeans})
        nodes[1]->report(report);
    listen();
    EXPECT_EQ(used(), "/dev/hidraw2") << "the other has said nothing";
    for (const char* report : {kPushedLess, kPushed})
        nodes[0]->report(report);
    listen();
    EXPECT_EQ(used(), "/dev/hidraw1");
    EXPECT_EQ(nodes[1]->open_ports, 0);
}

TEST_F(HidSessionOfSeveralNodes, CountsAPressedButtonAndATwistAsMotionButNoBattery) {
    for (const char* report : {kLeans, "17 50", "17 4f", "02 00 00 00 00 00 00", "03 00"})
        nodes[0]->report(report);
    listen();
    nodes[1]->report("17 50");
    nodes[1]->report("17 4f");
    listen();
    EXPECT_EQ(used(), "/dev/hidraw1");
    nodes[1]->report("03 01");
    listen();
    EXPECT_EQ(used(), "/dev/hidraw2");

    SpaceMouseDriver driver;
    EXPECT_TRUE(driver.has_moved(testing::hex("02 00 00 00 00 00 00"), testing::hex("02 00 00 00 00 00 01")));
    EXPECT_FALSE(
        driver.has_moved(testing::hex("02 00 00 00 00 00 00"), testing::hex("02 00 00 00 00 05 00")));
}

TEST_F(HidSessionTest, CountsARoundAsRefreshedOnlyWhenTheDriverSaysSo) {
    step();
    script->report("01 10");
    step();
    const std::uint64_t refreshed = link.input.latest().refreshed;
    EXPECT_GT(refreshed, 0U);
    script->report("02 11");  // live, but old
    for (int round = 0; round < 10; ++round)
        step();
    EXPECT_TRUE(link.input.latest().is_live);
    EXPECT_EQ(link.input.latest().refreshed, refreshed) << "rounds went by, the place did not come";
    script->report("01 12");
    step();
    EXPECT_EQ(link.input.latest().refreshed, refreshed + 1);
}

TEST_F(HidSessionTest, LeavesDevicesOfAnotherKindAlone) {
    script->info.kind = HidKind::kVecPedal;
    step();
    EXPECT_EQ(link.status.latest().state, HidStatus::State::kAbsent);
    EXPECT_EQ(script->times_opened, 0);
}

TEST(SpaceMouseDriver, ReleasesAStuckAxisAndTheWheelAfterSilence) {
    auto script = std::make_shared<ScriptedHid>();
    testing::ScriptedPort port(script);
    SpaceMouseDriver driver;
    ASSERT_TRUE(driver.start({}, port));
    EXPECT_EQ(script->take_sent(), (std::vector<std::string>{"w 04 01"}));
    driver.take_report(testing::hex("03 01 00"), 0);
    driver.take_report(testing::hex("03 00 00"), 0);
    driver.take_report(testing::hex("01 5e 01 00 00 00 00"), 0);
    EXPECT_TRUE(driver.input(100 * kMs).is_live);
    EXPECT_GT(driver.input(100 * kMs).rate_mm_s.x, 0.0);
    EXPECT_TRUE(driver.input(100 * kMs).button) << "pressed and let go: it turns";
    EXPECT_FALSE(driver.input(101 * kMs).is_live);
    // At rest it is silent.
    driver.take_report(testing::hex("01 00 00 00 00 00 00"), 200 * kMs);
    EXPECT_TRUE(driver.input(3600'000 * kMs).is_live);
    driver.take_report(testing::hex("03 01 00"), 300 * kMs);
    EXPECT_FALSE(driver.input(300 * kMs).button) << "pressed again: it stands";
    driver.stop(port);
    EXPECT_EQ(script->take_sent(), (std::vector<std::string>{"w 04 00"}));
}

TEST(VecPedalDriver, TurnsTheWheelWhileAPedalIsDown) {
    auto script = std::make_shared<ScriptedHid>();
    testing::ScriptedPort port(script);
    VecPedalDriver driver;
    ASSERT_TRUE(driver.start({}, port));
    EXPECT_FALSE(driver.input(0).button);
    driver.take_report(testing::hex("02 00"), 0);
    EXPECT_TRUE(driver.input(3600'000 * kMs).button) << "held for an hour, it says nothing";
    driver.take_report(testing::hex("ff ff"), 0);
    EXPECT_TRUE(driver.input(0).button) << "no report of this device";
    driver.take_report(testing::hex("00 00"), 0);
    EXPECT_FALSE(driver.input(0).button);
    EXPECT_EQ(driver.input(0).motion, DeviceInput::Motion::kNone);
}

TEST(VecPedalDriver, MakesTheWheelFasterByTheRightPedalAndSlowerByTheLeft) {
    VecPedalDriver driver;
    driver.take_report(testing::hex("04 00"), 0);
    EXPECT_TRUE(driver.input(0).button);
    EXPECT_EQ(driver.input(0).change_rev_min_s, 40.0);
    driver.take_report(testing::hex("01 00"), 0);
    EXPECT_EQ(driver.input(0).change_rev_min_s, -40.0);
    driver.take_report(testing::hex("02 00"), 0);
    EXPECT_EQ(driver.input(0).change_rev_min_s, 0.0);
}

TEST(SpaceMouseDriver, ChangesTheWheelsSpeedByATwist) {
    SpaceMouseDriver driver;
    driver.take_report(testing::hex("02 00 00 00 00 5e 01"), 0);  // Rz 350
    EXPECT_EQ(driver.input(0).change_rev_min_s, 80.0);
    driver.take_report(testing::hex("02 00 00 00 00 a2 fe"), 0);  // -350
    EXPECT_EQ(driver.input(0).change_rev_min_s, -80.0);
}

}  // namespace
}  // namespace onggi::haptics::hid
