// The Inverse3's session without a socket, on virtual time.
#include "engine/haptics/haply/inverse_session.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace onggi::haptics::haply {
namespace {

using hid::HidStatus;
using hid::kMs;

std::string message_at(double x, double y, double z, std::string_view device = "049D") {
    return fmt::format(
        R"({{"inverse3":[{{"device_id":"{}","state":{{"cursor_position":{{"x":{},"y":{},"z":{}}}}}}}]}})",
        device, x, y, z);
}

class InverseSessionTest : public ::testing::Test {
  protected:
    // The service answers each message at once, once a ms, while the loop orders this force.
    std::string after_ms(int milliseconds, const dvec3& force_n) {
        std::string last;
        for (int ms = 0; ms < milliseconds; ++ms) {
            now_ns_ += kMs;
            link_.order.put({.force_n = force_n, .ticks = ++ticks_});
            if (const std::string said = session_.next_message(now_ns_); !said.empty()) {
                last = said;
                EXPECT_TRUE(session_.take(message_at(0.0, -0.1, 0.1), now_ns_));
            }
        }
        return last;
    }
    void connect() {
        session_.opened();
        EXPECT_TRUE(session_.take(message_at(0.0, -0.1, 0.1), now_ns_));
    }

    InverseLink link_;
    InverseSession session_{link_, {}};
    std::int64_t now_ns_ = 0;
    std::uint64_t ticks_ = 0;
};

TEST_F(InverseSessionTest, WaitsUntilTheServiceHasSpoken) {
    EXPECT_EQ(session_.next_message(0), "");
    session_.opened();
    EXPECT_EQ(session_.next_message(kMs), "");
    connect();
    EXPECT_EQ(session_.next_message(2 * kMs), probe_message("049D", true)) << "and asks without a force";
    EXPECT_EQ(link_.status.latest().state, HidStatus::State::kReady);
    EXPECT_EQ(link_.status.latest().name, "Haply Inverse3 049D");
}

TEST_F(InverseSessionTest, MovesTheToolInTheWheelsAxesFromWhereItWasFirstHeard) {
    connect();
    EXPECT_EQ(link_.input.latest().place_mm, dvec3(0.0));
    ASSERT_TRUE(session_.take(message_at(0.01, -0.08, 0.13), kMs));
    const dvec3 place = link_.input.latest().place_mm;
    EXPECT_NEAR(place.x, 10.0, 1e-9);
    EXPECT_NEAR(place.y, 30.0, 1e-9) << "the service's z is up";
    EXPECT_NEAR(place.z, -20.0, 1e-9) << "and its y goes away from the person";
    EXPECT_EQ(service_from_wheel(wheel_from_service({1.0, 2.0, 3.0})), dvec3(1.0, 2.0, 3.0));
}

TEST_F(InverseSessionTest, SpeaksAtItsRateAndOnlyWhenAnswered) {
    connect();
    int said = 0;
    for (int step = 0; step < 100; ++step) {
        now_ns_ += kMs / 4;
        if (session_.next_message(now_ns_).empty()) continue;
        ++said;
        ASSERT_TRUE(session_.take(message_at(0.0, 0.0, 0.0), now_ns_));
    }
    EXPECT_EQ(said, 25) << "a thousand a second";
    (void)session_.next_message(now_ns_ += kMs);
    EXPECT_EQ(session_.next_message(now_ns_ + 50 * kMs), "") << "no answer yet";
    EXPECT_NE(session_.next_message(now_ns_ + 100 * kMs), "") << "lost: said again";
    EXPECT_FALSE(session_.is_silent(now_ns_ + 1900 * kMs));
    EXPECT_TRUE(session_.is_silent(now_ns_ + 2100 * kMs));
}

TEST_F(InverseSessionTest, RendersAllThreeAxesAfterItsRamp) {
    connect();
    EXPECT_EQ(after_ms(5, {3.0, 0.0, 0.0}), probe_message("049D", false))
        << "a start inside a wall stays loose";
    after_ms(5, dvec3(0.0));
    const std::string half = after_ms(500, {1.0, 2.0, -0.5});
    EXPECT_NE(half, probe_message("049D", false));
    EXPECT_NE(half, force_message("049D", service_from_wheel({1.0, 2.0, -0.5}), "vector", false));
    EXPECT_EQ(after_ms(600, {1.0, 2.0, -0.5}), force_message("049D", {1.0, 0.5, 2.0}, "vector", false));
    EXPECT_EQ(after_ms(1, {30.0, 0.0, 0.0}), force_message("049D", {3.3, 0.0, 0.0}, "vector", false))
        << "never more than the kiosk's peak";
}

TEST_F(InverseSessionTest, TellsTheObserverHowMuchOfTheForceWentOut) {
    connect();
    EXPECT_EQ(link_.input.latest().force_fraction, 0.0);
    after_ms(5, dvec3(0.0));
    after_ms(20, {1.0, 0.0, 0.0});
    const double early = link_.input.latest().force_fraction;
    EXPECT_GT(early, 0.0);
    EXPECT_LT(early, 1.0) << "its ramp";
    after_ms(1000, {1.0, 0.0, 0.0});
    EXPECT_EQ(link_.input.latest().force_fraction, 1.0);
}

TEST_F(InverseSessionTest, LetsGoWhenTheLoopStandsStill) {
    connect();
    after_ms(2, dvec3(0.0));
    after_ms(1200, {1.0, 0.0, 0.0});
    for (int ms = 0; ms < 19; ++ms) {
        now_ns_ += kMs;
        (void)session_.next_message(now_ns_);
        ASSERT_TRUE(session_.take(message_at(0.0, -0.1, 0.1), now_ns_));
    }
    now_ns_ += 2 * kMs;
    EXPECT_EQ(session_.next_message(now_ns_), probe_message("049D", false));
}

TEST_F(InverseSessionTest, LetsGoAtOnceWhenTheWatchdogAsksAndStaysLooseUntilTheForceIsSmall) {
    connect();
    after_ms(2, dvec3(0.0));
    const std::string force = force_message("049D", {1.0, 0.0, 0.0}, "vector", false);
    ASSERT_EQ(after_ms(1200, {1.0, 0.0, 0.0}), force);
    // A force was just sent and not answered yet; the next is due in a ms.
    link_.order.put({.force_n = {1.0, 0.0, 0.0}, .ticks = ++ticks_});
    ASSERT_EQ(session_.next_message(now_ns_ += kMs), force);
    now_ns_ += kMs / 10;
    ASSERT_EQ(session_.next_message(now_ns_), "");
    link_.silences.fetch_add(1);
    EXPECT_EQ(session_.next_message(now_ns_), probe_message("049D", false));
    EXPECT_EQ(session_.next_message(now_ns_), "") << "once for each time it asks";
    ASSERT_TRUE(session_.take(message_at(0.0, -0.1, 0.1), now_ns_));
    // The loop is back with its old force: through the ramp only, and that begins at a small one.
    EXPECT_EQ(after_ms(50, {1.0, 0.0, 0.0}), probe_message("049D", false));
    after_ms(2, dvec3(0.0));
    EXPECT_EQ(after_ms(1200, {1.0, 0.0, 0.0}), force);
}

TEST_F(InverseSessionTest, RestartsWithADeviceThatReturns) {
    connect();
    after_ms(2, dvec3(0.0));
    after_ms(1200, {1.0, 0.0, 0.0});
    ASSERT_TRUE(session_.take(R"({"inverse3":[]})", now_ns_));
    EXPECT_FALSE(link_.input.latest().is_live);
    EXPECT_EQ(link_.status.latest().state, HidStatus::State::kAbsent);
    now_ns_ += 2000 * kMs;
    EXPECT_EQ(session_.next_message(now_ns_), "{}") << "it asks now and then";
    ASSERT_TRUE(session_.take(message_at(0.2, 0.0, 0.0), now_ns_));
    EXPECT_EQ(link_.input.latest().place_mm, dvec3(0.0)) << "from where it is now";
    EXPECT_EQ(link_.status.latest().times_found, 2U);
    EXPECT_EQ(after_ms(1, {1.0, 0.0, 0.0}), probe_message("049D", false)) << "loose until its ramp";
}

TEST_F(InverseSessionTest, RejectsInvalidMessagesWithAReason) {
    session_.opened();
    EXPECT_FALSE(session_.take("hello", 0));
    session_.closed("not a message of the Inverse service");
    EXPECT_EQ(link_.status.latest().state, HidStatus::State::kFailed);
    EXPECT_EQ(link_.status.latest().message, "not a message of the Inverse service");
    session_.closed("");
    EXPECT_EQ(link_.status.latest().state, HidStatus::State::kAbsent);
    EXPECT_EQ(session_.last_message(), "");
}

}  // namespace
}  // namespace onggi::haptics::haply
