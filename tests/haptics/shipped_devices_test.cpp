// The capabilities of the supported devices on the stability bench: the stiffness they may render at their
// own rates, and that it is stable. The results must equal stability.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "engine/haptics/haply/inverse_device.h"
#include "engine/haptics/hid/pid_driver.h"
#include "engine/haptics/stability.h"
#include "game/haptic/device_force.h"
#include "game/haptic/tick.h"
#include "tests/support/places.h"

namespace onggi::haptic {
namespace {

using haptics::DeviceCapabilities;

const std::string kTable = test::in_checkout("tests/haptics/stability.md");
constexpr double kRates[] = {500.0, 1000.0, 4000.0};

DeviceCapabilities inverse3() {
    return haptics::InverseDevice().capabilities();
}
DeviceCapabilities stick() {
    return haptics::hid::PidDriver().capabilities();
}

HapticParameters at(double rate_hz) {
    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    return parameters;
}

// The stiffness that fit_to_device allows the studio's clay on an axis with sent forces.
double granted_n_per_mm(const DeviceCapabilities& device, double rate_hz) {
    HapticParameters parameters = at(rate_hz);
    const Result<void> fits = fit_to_device(parameters, device, false);
    EXPECT_TRUE(fits) << fits.error().message;
    return device.has_own_walls ? parameters.feel.most_wire_stiffness_n_per_mm
                                : parameters.feel.most_stiffness_n_per_mm;
}

// A row of the table, N/m.
std::string row_of(const DeviceCapabilities& device) {
    std::string row = fmt::format("| {} |", device.name);
    for (const double rate_hz : kRates)
        row += fmt::format(" {:.0f} |", granted_n_per_mm(device, rate_hz) * 1000.0);
    return row;
}

TEST(ShippedDevices, AreGrantedTheFiguresOfTheTable) {
    const std::string rows = row_of(inverse3()) + "\n" + row_of(stick()) + "\n";
    if (const char* file = std::getenv("ONGGI_WRITE_STABILITY")) std::ofstream(file, std::ios::app) << rows;
    std::ifstream in(kTable);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_NE(text.find(rows), std::string::npos) << rows;
}

// The height of a stick: the studio's raw 4 N/mm through the tick's own device_force and over USB.
double shown_n_per_mm(const DeviceFeel& feel) {
    clay::ContactForces forces;
    forces.contacts = 1;
    forces.local_stiffness_n_per_mm = 4.0;
    forces.stiffness_n = {0.0, 4.0, 0.0};  // one mm deep
    return device_force(forces, dvec3(0.0), 0.0, true, feel, true).wanted_n.y;
}

TEST(AForceOverUsb, OscillatesWithTheStudiosClayButNotWithTheLimitedStiffness) {
    const DeviceCapabilities device = stick();
    for (const double rate_hz : {1000.0, 4000.0}) {
        HapticParameters parameters = at(rate_hz);
        ASSERT_TRUE(fit_to_device(parameters, device, false));
        haptics::LoopSetting usb = haptics::loop_of(device, rate_hz);
        ASSERT_EQ(usb.rate_hz, 250.0);
        ASSERT_EQ(usb.delay_ticks, 2);
        DeviceFeel raw = parameters.feel;
        raw.most_wire_stiffness_n_per_mm = 0.0;
        // With and without the clay's viscosity.
        for (const double viscosity : {0.0, parameters.studio.viscosity_c2_n_s_per_mm}) {
            usb.viscosity_n_s_per_mm = viscosity;
            const double shown = shown_n_per_mm(parameters.feel);
            EXPECT_GT(shown, 0.05) << "there is something to feel";
            EXPECT_TRUE(haptics::is_stable(device, usb, shown)) << shown;
            EXPECT_FALSE(haptics::is_stable(device, usb, shown_n_per_mm(raw))) << shown_n_per_mm(raw);
            EXPECT_GT(haptics::run_loop(device, usb, shown_n_per_mm(raw), 5.0).swing_mm, 5.0);
        }
    }
}

TEST(Inverse3, GetsTheStudiosClayAsStiffAsIsStableOverItsService) {
    const DeviceCapabilities device = inverse3();
    for (const double rate_hz : {1000.0, 4000.0}) {
        HapticParameters parameters = at(rate_hz);
        const Result<void> fits = fit_to_device(parameters, device, false);
        ASSERT_TRUE(fits) << fits.error().message;
        EXPECT_GT(parameters.safety.peak_force_n, 3.0);
        const double shown = parameters.feel.most_stiffness_n_per_mm;
        EXPECT_GT(shown, 0.15);
        haptics::LoopSetting service = haptics::loop_of(device, rate_hz);
        EXPECT_EQ(service.rate_hz, 1000.0) << "a message a ms, however fast the loop";
        EXPECT_EQ(service.delay_ticks, 3);
        EXPECT_TRUE(haptics::is_stable(device, service, shown));
        EXPECT_FALSE(haptics::is_stable(device, service, 4.0)) << "the clay as it is";
    }
}

TEST(Inverse3, GetsThePapersClayWhereItIsStableAndElseALineWithTheNumber) {
    HapticParameters paper = at(1000.0);
    const Result<void> standing = fit_to_device(paper, inverse3(), true);
    ASSERT_FALSE(standing);
    const double most = haptics::largest_stable_stiffness_n_per_mm(
        inverse3(), haptics::loop_of(inverse3(), 1000.0), paper.paper.stiffness_standing_n_per_mm);
    EXPECT_EQ(
        standing.error().message,
        fmt::format(
            "Haply Inverse3: expected a stiffness of at most {:.3g} N/mm, the largest that is stable on "
            "it at 1000 Hz, found 0.5",
            most));

    paper.paper.stiffness_standing_n_per_mm = 0.2;
    const Result<void> soft = fit_to_device(paper, inverse3(), true);
    EXPECT_TRUE(soft) << soft.error().message;
    EXPECT_GT(paper.safety.peak_force_n, 3.0);

    paper.paper.viscosity_c2_n_s_per_mm = 0.02;
    const Result<void> sticky = fit_to_device(paper, inverse3(), true);
    ASSERT_FALSE(sticky);
    EXPECT_NE(sticky.error().message.find("the largest that is stable on it at 1000 Hz, found 0.02"),
              std::string::npos)
        << sticky.error().message;
}

}  // namespace
}  // namespace onggi::haptic
