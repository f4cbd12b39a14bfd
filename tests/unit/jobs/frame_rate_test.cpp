#include "engine/jobs/frame_pacer.h"

#include <gtest/gtest.h>

#include <limits>

namespace onggi::jobs {
namespace {

TEST(FrameRate, IsTheDisplaysRateUpToTheMachinesLimit) {
    for (const double own : {24.0, 30.0, 50.0, 59.94, 60.0, 72.0, 75.0})
        EXPECT_EQ(frame_rate_hz(own, 75.0), own);
    EXPECT_EQ(frame_rate_hz(75.5, 75.0), 75.5) << "a driver that rounds";
}

TEST(FrameRate, IsAWholeFractionOfAQuickDisplays) {
    EXPECT_EQ(frame_rate_hz(120.0, 75.0), 60.0);
    EXPECT_EQ(frame_rate_hz(100.0, 75.0), 50.0);
    EXPECT_EQ(frame_rate_hz(144.0, 75.0), 72.0);
    EXPECT_EQ(frame_rate_hz(240.0, 75.0), 60.0);
    EXPECT_EQ(frame_rate_hz(144.0, 150.0), 144.0);
    EXPECT_EQ(frame_rate_hz(240.0, 150.0), 120.0);
}

TEST(FrameRate, IsTheDefaultIfADisplayReportsAnImplausibleRate) {
    for (const double odd : {0.0, -1.0, 1.0, 5000.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(frame_rate_hz(odd, 75.0), 60.0) << odd;
}

}  // namespace
}  // namespace onggi::jobs
