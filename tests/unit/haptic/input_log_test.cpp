// What is kept of a visit's ticks: every one of them to the bit, and in how little memory.
#include "game/haptic/input_log.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace onggi::haptic {
namespace {

constexpr std::size_t kBlock = InputLog::kBlock;

// A hand that moves for a while and then rests, with numbers that no difference survives in between.
LoggedInput input_at(std::size_t tick) {
    const double phase = tick % 5000 < 2500 ? static_cast<double>(tick % 5000) * 1e-3 : 2.5;
    LoggedInput input{.position_mm = {60.0 * std::cos(phase), 40.0 + 3.0 * phase, -0.0},
                      .second = static_cast<std::uint32_t>(tick / 700),
                      .settings = static_cast<std::uint32_t>(tick / 3000),
                      .force_check = phase < 2.5 ? static_cast<std::uint32_t>(tick * 2654435761U) : 0};
    if (tick % 977 == 0) input.position_mm.x = std::numeric_limits<double>::quiet_NaN();
    if (tick % 1409 == 0) input.position_mm.y = -std::numeric_limits<double>::max();
    return input;
}

bool same_bits(const LoggedInput& a, const LoggedInput& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::bit_cast<std::uint64_t>(a.position_mm[axis]) !=
            std::bit_cast<std::uint64_t>(b.position_mm[axis]))
            return false;
    }
    return a.second == b.second && a.settings == b.settings && a.force_check == b.force_check;
}

void expect_all(const InputLog& log, std::size_t first) {
    InputLog::Reader reader(log, first);
    for (std::size_t tick = first; tick < log.size(); ++tick)
        ASSERT_TRUE(same_bits(reader.next(), input_at(tick))) << tick;
}

InputLog log_of(std::size_t count) {
    InputLog log;
    for (std::size_t tick = 0; tick < count; ++tick)
        log.push_back(input_at(tick));
    return log;
}

TEST(InputLog, GivesBackWhatWasPutInToTheBit) {
    const InputLog log = log_of(5 * kBlock + 17);
    ASSERT_EQ(log.size(), 5 * kBlock + 17);
    for (const std::size_t first : {std::size_t{0}, kBlock - 1, kBlock, 3 * kBlock + 5, 5 * kBlock + 1})
        expect_all(log, first);
}

TEST(InputLog, GoesOnFromWhereItWasCutOff) {
    for (const std::size_t left : {4 * kBlock + 1, 3 * kBlock, 2 * kBlock - 1, std::size_t{1}}) {
        InputLog log = log_of(5 * kBlock);
        log.shrink(left);
        ASSERT_EQ(log.size(), left);
        EXPECT_TRUE(same_bits(log.back(), input_at(left - 1))) << left;
        for (std::size_t tick = left; tick < 5 * kBlock; ++tick)
            log.push_back(input_at(tick));
        expect_all(log, 0);
    }
    InputLog log = log_of(2 * kBlock);
    log.clear();
    EXPECT_TRUE(log.empty());
}

TEST(InputLog, TakesNextToNothingWhileTheHandRests) {
    InputLog log;
    const LoggedInput resting = input_at(4000);
    for (std::size_t tick = 0; tick < 100 * kBlock; ++tick)
        log.push_back(resting);
    EXPECT_LT(log.bytes(), 100 * kBlock * 6);
}

}  // namespace
}  // namespace onggi::haptic
