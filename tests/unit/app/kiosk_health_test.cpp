// The kiosk's health figures, on a virtual clock and a simulated machine of files.
#include "game/app/kiosk/health/kiosk_health.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

// Frames at a steady rate, over a loop at a steady rate.
void run(HealthMeter& meter, double& now_s, double seconds, double frame_ms, double rate_hz,
         double device_ms = 8.0) {
    for (const double end_s = now_s + seconds; now_s < end_s;) {
        now_s += 1e-3 * frame_ms;
        meter.see(now_s, frame_ms, device_ms, static_cast<std::uint64_t>(now_s * rate_hz));
    }
}

TEST(HealthMeter, CountsTheTicksThatWereNotThoseThatWereWanted) {
    HealthMeter meter;
    double now_s = 1000.0;
    EXPECT_EQ(meter.achieved_hz(), 0.0);
    run(meter, now_s, 3.0, 16.7, 3950.0);
    EXPECT_NEAR(meter.achieved_hz(), 3950.0, 2.0);
    run(meter, now_s, 3.0, 16.7, 3950.0);
    EXPECT_NEAR(meter.achieved_hz(), 3950.0, 2.0);
}

TEST(HealthMeter, RemembersTenSecondsOfFrames) {
    HealthMeter meter;
    double now_s = 50.0;
    run(meter, now_s, 12.0, 16.0, 1000.0);
    EXPECT_NEAR(meter.mean_frame_ms(), 16.0, 1e-6);
    EXPECT_NEAR(meter.worst_frame_ms(), 16.0, 1e-6);
    now_s += 0.08;
    meter.see(now_s, 80.0, 60.0, 0);
    EXPECT_NEAR(meter.worst_frame_ms(), 80.0, 1e-6);
    EXPECT_LT(meter.mean_frame_ms(), 17.0);
    const screens::FramePlot plot = meter.plot();
    ASSERT_EQ(plot.frame_ms.size(), 100U);
    EXPECT_EQ(plot.frame_ms.back(), 80.0F) << "the newest last";
    EXPECT_EQ(plot.device_ms.back(), 60.0F);
    run(meter, now_s, 10.2, 16.0, 1000.0);
    EXPECT_NEAR(meter.worst_frame_ms(), 16.0, 1e-6) << "and then it is forgotten";
}

TEST(HealthMeter, ShowsAStandstillForAsLongAsItLasted) {
    HealthMeter meter;
    double now_s = 7.0;
    run(meter, now_s, 11.0, 16.0, 1000.0);
    now_s += 2.0;
    meter.see(now_s, 2000.0, 8.0, 0);
    const screens::FramePlot plot = meter.plot();
    int long_ones = 0;
    for (const float ms : plot.frame_ms)
        long_ones += ms > 1000.0F ? 1 : 0;
    EXPECT_NEAR(long_ones, 20, 1);
    now_s += 3600.0;
    meter.see(now_s, 3.6e6, 8.0, 0);
    EXPECT_EQ(meter.plot().frame_ms.size(), 100U) << "a whole night fills only the plot";
    EXPECT_NEAR(meter.plot().frame_ms.front(), 3.6e6F, 1.0F);
}

class Zones : public testing::Test {
  protected:
    void zone(const std::string& name, const std::string& text) {
        std::filesystem::create_directories(folder_.path() / name);
        std::ofstream(folder_.path() / name / "temp") << text;
    }
    const test::TemporaryFolder folder_;
};

TEST_F(Zones, GiveTheHottest) {
    zone("thermal_zone0", "41000\n");
    zone("thermal_zone1", "63500\n");
    zone("cooling_device0", "99000\n");
    EXPECT_EQ(hottest_celsius(folder_.path()), 63.5);
}

TEST_F(Zones, AreEmptyWithoutASensor) {
    EXPECT_EQ(hottest_celsius(folder_.path()), std::nullopt);
    EXPECT_EQ(hottest_celsius(folder_.path() / "nowhere"), std::nullopt);
    zone("thermal_zone0", "broken\n");
    zone("thermal_zone1", "-274000\n");
    zone("thermal_zone2", "9000000\n");
    EXPECT_EQ(hottest_celsius(folder_.path()), std::nullopt);
    zone("thermal_zone3", "-5000\n");
    EXPECT_EQ(hottest_celsius(folder_.path()), -5.0) << "a wheel in an unheated shed";
}

}  // namespace
}  // namespace onggi::app
