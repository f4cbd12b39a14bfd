// Pens, from the bytes that an X server sends.
#include "engine/window/pens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "engine/core/little_endian.h"

namespace onggi::window {
namespace {

using little_endian::put;
using Bytes = std::vector<std::byte>;

constexpr std::uint32_t kPressure = 501;
constexpr std::uint32_t kTiltX = 502;
constexpr std::uint32_t kTiltY = 503;
constexpr std::array kLabels{kPressure, kTiltX, kTiltY};
constexpr std::uint16_t kSlavePointer = 3;

void put_number(Bytes& bytes, double value) {
    const double whole = std::floor(value);
    put(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(whole)));
    put(bytes, static_cast<std::uint32_t>((value - whole) * 4294967296.0));
}

struct Valuator {
    std::uint16_t number;
    std::uint32_t label;
    double least;
    double most;
    bool is_absolute = true;
};

// A device in a reply to XIQueryDevice.
void put_device(Bytes& bytes, std::uint16_t id, std::uint16_t type, const std::vector<Valuator>& valuators,
                bool touches = false, bool enabled = true) {
    constexpr std::string_view kName = "Pen 7";
    for (const unsigned head :
         {unsigned{id}, unsigned{type}, 2U, unsigned(valuators.size() + (touches ? 1 : 0)), 5U})
        put(bytes, static_cast<std::uint16_t>(head));
    bytes.push_back(std::byte{enabled});
    bytes.push_back(std::byte{0});
    for (std::size_t i = 0; i < 8; ++i)
        bytes.push_back(i < 5 ? static_cast<std::byte>(kName[i]) : std::byte{0});
    for (const Valuator& valuator : valuators) {
        for (const unsigned head : {2U, 11U, unsigned{id}, unsigned{valuator.number}})
            put(bytes, static_cast<std::uint16_t>(head));
        put(bytes, valuator.label);
        for (const double number : {valuator.least, valuator.most, 0.0})
            put_number(bytes, number);
        put(bytes, std::uint32_t{57});
        put(bytes, std::uint32_t{valuator.is_absolute ? 1U : 0U});
    }
    if (!touches) return;
    for (const unsigned head : {8U, 2U, unsigned{id}, 10U * 256U + 1U})
        put(bytes, static_cast<std::uint16_t>(head));
}

const std::vector<Valuator> kWacom{{0, 11, 0, 44704},    {1, 12, 0, 27940},    {2, kPressure, 0, 2047},
                                   {3, kTiltX, -64, 63}, {4, kTiltY, -64, 63}, {5, 14, -900, 899}};

// A raw event: a pen's pressure and tilt, or the place alone.
PointerReport report(std::uint16_t device, const std::vector<std::pair<int, double>>& values) {
    Bytes bytes;
    std::uint32_t mask = 0;
    for (const auto& [number, value] : values)
        mask |= 1U << static_cast<unsigned>(number);
    put(bytes, mask);
    for (const auto& [number, value] : values)
        put_number(bytes, value);
    return read_report(device, bytes, 1);
}

class APen : public testing::Test {
  protected:
    APen() { know({{9, kWacom}}); }
    void know(const std::vector<std::pair<std::uint16_t, std::vector<Valuator>>>& devices) {
        Bytes bytes;
        for (const auto& [id, valuators] : devices)
            put_device(bytes, id, kSlavePointer, valuators);
        pens_.know(read_pens(bytes, static_cast<int>(devices.size()), kLabels));
    }
    void presses(double pressure, double tilt_x = 0.0, double tilt_y = 0.0) {
        pens_.take(report(9, {{0, 100.0}, {2, pressure}, {3, tilt_x}, {4, tilt_y}}));
    }

    PenState pens_;
};

TEST_F(APen, HasThePressureAndTheTiltOfItsAxes) {
    presses(0.0);
    presses(500.0);
    presses(1023.5, 32.0, -64.0);
    const auto pen = pens_.pen();
    ASSERT_TRUE(pen);
    EXPECT_DOUBLE_EQ(pen->pressure, 0.5);
    EXPECT_NEAR(pen->tilt_rad.x, 32.0 * kPi / 180.0, 1e-9);
    EXPECT_NEAR(pen->tilt_rad.y, -64.0 * kPi / 180.0, 1e-9);
    pens_.take(report(9, {{0, 101.0}}));
    EXPECT_DOUBLE_EQ(pens_.pen()->pressure, 0.5) << "an axis that is not reported keeps its value";
}

TEST_F(APen, IsNoPenWhileItsPressureNeverChanges) {
    for (int press = 0; press < 20; ++press) {
        presses(0.0);
        presses(2047.0);
    }
    EXPECT_TRUE(pens_.leads());
    EXPECT_FALSE(pens_.pen()) << "a panel that names a pressure and reports all or nothing is a mouse";
    presses(1500.0);
    EXPECT_TRUE(pens_.pen());
}

TEST_F(APen, GivesWayToAMouseAndToAFinger) {
    presses(500.0);
    presses(900.0);
    ASSERT_TRUE(pens_.pen());
    pens_.take(report(4, {{0, 3.0}}));
    EXPECT_FALSE(pens_.pen());
    presses(900.0);
    EXPECT_TRUE(pens_.pen());
    pens_.touched();
    EXPECT_FALSE(pens_.pen());
}

TEST_F(APen, MayBePluggedInLaterAndUnplugged) {
    presses(500.0);
    presses(900.0);
    know({{5, kWacom}, {9, kWacom}});
    EXPECT_TRUE(pens_.pen()) << "another pen, the same leader";
    pens_.take(report(5, {{2, 20.0}}));
    pens_.take(report(5, {{2, 2047.0}}));
    EXPECT_DOUBLE_EQ(pens_.pen()->pressure, 1.0);
    know({{9, kWacom}});
    EXPECT_FALSE(pens_.pen());
    presses(900.0);
    EXPECT_TRUE(pens_.pen());
    know({});
    EXPECT_FALSE(pens_.pen());
}

TEST(Pens, AreFoundAmongTheDevicesByTheirAbsolutePressure) {
    Bytes bytes;
    put_device(bytes, 2, 1, kWacom);  // the master, with the classes of its last device
    put_device(bytes, 4, kSlavePointer, {{0, 21, -1, -1, false}, {1, 22, -1, -1, false}});
    put_device(bytes, 6, kSlavePointer, {{0, kPressure, 0, 255}}, true);  // a touch screen
    put_device(bytes, 7, kSlavePointer, {{0, kPressure, 0, 0}});
    put_device(bytes, 8, kSlavePointer, {{0, kPressure, 0, 255, false}});
    put_device(bytes, 9, kSlavePointer, kWacom);
    put_device(bytes, 10, kSlavePointer, kWacom, false, false);  // switched off
    put_device(bytes, 11, kSlavePointer, {{4, kPressure, 0, 65536}});
    const auto pens = read_pens(bytes, 8, kLabels);
    ASSERT_EQ(pens.size(), 2U);
    EXPECT_EQ(pens[0].id, 9);
    EXPECT_EQ(pens[0].axes[1].number, 3);
    EXPECT_EQ(pens[1].id, 11);
    EXPECT_EQ(pens[1].axes[1].number, -1) << "without tilt";
    // Any reply that is cut short is read as far as it is whole.
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_LE(read_pens(std::span(bytes).first(size), 8, kLabels).size(), 2U);
    EXPECT_TRUE(read_report(9, {}, 60000).values.empty());
}

}  // namespace
}  // namespace onggi::window
