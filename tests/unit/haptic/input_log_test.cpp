// The log of a visit's ticks: each is restored to the bit, and the log needs little memory.
#include "game/haptic/input_log.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace onggi::haptic {
namespace {

constexpr std::size_t kBlock = InputLog::kBlock;

// A hand that moves for a while and then rests, with numbers that do not compress as differences.
LoggedInput input_at(std::size_t tick) {
    const double phase = tick % 5000 < 2500 ? static_cast<double>(tick % 5000) * 1e-3 : 2.5;
    LoggedInput input{.position_mm = {60.0 * std::cos(phase), 40.0 + 3.0 * phase, -0.0},
                      .second_position_mm = {phase, -static_cast<double>(tick / 700), 1e-300},
                      .settings = static_cast<std::uint32_t>(tick / 3000),
                      .force_check = phase < 2.5 ? static_cast<std::uint32_t>(tick * 2654435761U) : 0};
    if (tick % 977 == 0) input.position_mm.x = std::numeric_limits<double>::quiet_NaN();
    if (tick % 1409 == 0) input.position_mm.y = -std::numeric_limits<double>::max();
    return input;
}

bool same_bits(const dvec3& a, const dvec3& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::bit_cast<std::uint64_t>(a[axis]) != std::bit_cast<std::uint64_t>(b[axis])) return false;
    }
    return true;
}

bool same_bits(const LoggedInput& a, const LoggedInput& b) {
    return same_bits(a.position_mm, b.position_mm) && same_bits(a.second_position_mm, b.second_position_mm) &&
           a.settings == b.settings && a.force_check == b.force_check;
}

void expect_all(const InputLog& log, std::size_t first) {
    InputLog::Reader reader(log, first);
    for (std::size_t tick = first; tick < log.size(); ++tick)
        ASSERT_TRUE(same_bits(*reader.next().value(), input_at(tick))) << tick;
}

InputLog log_of(std::size_t count, const std::filesystem::path& folder = {}) {
    InputLog log(folder);
    for (std::size_t tick = 0; tick < count; ++tick)
        log.push_back(input_at(tick));
    return log;
}

TEST(InputLog, ReturnsItsInputsToTheBit) {
    const InputLog log = log_of(5 * kBlock + 17);
    ASSERT_EQ(log.size(), 5 * kBlock + 17);
    for (const std::size_t first : {std::size_t{0}, kBlock - 1, kBlock, 3 * kBlock + 5, 5 * kBlock + 1})
        expect_all(log, first);
}

TEST(InputLog, GoesOnFromWhereItWasCutOff) {
    const test::TemporaryFolder folder;
    for (const std::size_t left : {4 * kBlock + 1, 3 * kBlock, 2 * kBlock - 1, std::size_t{1}}) {
        InputLog log = log_of(5 * kBlock, folder.path());
        ASSERT_TRUE(log.shrink(left));
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

TEST(InputLog, TakesNoMemoryWhereTheDiskTakesIt) {
    const test::TemporaryFolder folder;
    InputLog log = log_of(50 * kBlock + 100, folder.path() / "made");
    EXPECT_LT(log.bytes(), 300 * sizeof(LoggedInput));
    EXPECT_GT(log.bytes_on_disk(), 50 * kBlock);
    expect_all(log, 3 * kBlock + 17);
    InputLog moved = std::move(log);
    expect_all(moved, 49 * kBlock);
    const std::uint64_t all = moved.bytes_on_disk();
    ASSERT_TRUE(moved.shrink(10 * kBlock));
    EXPECT_LT(moved.bytes_on_disk(), all / 4) << "what was taken back gives its room to what comes";
    moved.clear();
    EXPECT_EQ(moved.bytes_on_disk(), 0U);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "made")) << "it has no name";
}

TEST(InputLog, StaysInMemoryIfTheDiskFails) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "no folder";
    InputLog log = log_of(5 * kBlock, folder.path() / "file");
    EXPECT_EQ(log.bytes_on_disk(), 0U);
    EXPECT_GT(log.bytes(), 5 * kBlock);
    expect_all(log, 0);
}

TEST(InputLog, TakesHardlyAnyMemoryWhileTheHandRests) {
    InputLog log;
    const LoggedInput resting = input_at(4000);
    for (std::size_t tick = 0; tick < 100 * kBlock; ++tick)
        log.push_back(resting);
    EXPECT_LT(log.bytes(), 100 * kBlock * 2);
}

}  // namespace
}  // namespace onggi::haptic
