#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"
#include "tests/support/refusal.h"

namespace onggi::clay {
namespace {

// Where things lie in the bytes: tag, count, height, previous position, e_r (x, z), flag, radii, carries.
constexpr std::size_t kTagAt = 0;
constexpr std::size_t kCountAt = 4;
constexpr std::size_t kHeightAt = 8;
constexpr std::size_t kPositionAt = 16;
constexpr std::size_t kRadialAt = 40;
constexpr std::size_t kFlagAt = 56;
constexpr std::size_t kRadiiAt = 60;

std::vector<std::byte> worked_state(int element_count = 100) {
    PaperClay clay({.element_count = element_count});
    for (const ToolInput& tool : random_gesture(31, 3000))
        clay.tick(tool, {});
    return clay.start_state();
}

template <typename T>
std::vector<std::byte> with(std::vector<std::byte> bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
}

std::string refusal(const std::vector<std::byte>& bytes) {
    return test::refusal(PaperClay::from_start_state(bytes));
}

TEST(StartState, ComesBackAsTheSameClay) {
    const std::vector<std::byte> bytes = worked_state();
    const Result<PaperClay> clay = PaperClay::from_start_state(bytes);
    ASSERT_TRUE(clay) << clay.error().message;
    EXPECT_EQ(clay->start_state(), bytes);
    EXPECT_EQ(clay->element_count(), 100);
}

TEST(StartState, IsLittleEndianAndOfAKnownSize) {
    const std::vector<std::byte> bytes = PaperClay({.element_count = 258}).start_state();
    ASSERT_EQ(bytes.size(), kRadiiAt + 258 * 8);
    EXPECT_EQ(std::memcmp(bytes.data(), "PCL1", 4), 0);
    EXPECT_EQ(bytes[kCountAt], std::byte{2});
    EXPECT_EQ(bytes[kCountAt + 1], std::byte{1});
    EXPECT_EQ(bytes[kRadiiAt + 3], std::byte{0x42});  // 60.0F is 0x42700000
    EXPECT_EQ(bytes[kRadiiAt + 2], std::byte{0x70});
}

TEST(StartState, RejectsAWrongSize) {
    const std::vector<std::byte> bytes = worked_state();
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, kRadiiAt - 1, kRadiiAt, bytes.size() - 1}) {
        EXPECT_NE(refusal({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}), "accepted")
            << size;
    }
    std::vector<std::byte> longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_EQ(refusal(longer), "clay start state, size: expected 860 bytes for 100 elements, found 861");
}

TEST(StartState, RejectsAWrongTag) {
    EXPECT_EQ(refusal(with(worked_state(), kTagAt, std::uint32_t{0x12345678})),
              "clay start state, tag: expected 0x314c4350, found 0x12345678");
}

TEST(StartState, RejectsAnAbsurdElementCount) {
    for (const std::uint32_t count : {0U, 99U, 200001U, 0x80000000U, 0xffffffffU}) {
        EXPECT_NE(refusal(with(worked_state(), kCountAt, count)).find("element count"), std::string::npos);
    }
}

TEST(StartState, RejectsNumbersThatAreNoClay) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::vector<std::byte> good = worked_state();
    ASSERT_EQ(refusal(good), "accepted");
    for (const double bad : {kNaN, kInfinity, -kInfinity, 0.0, -1.0}) {
        EXPECT_NE(refusal(with(good, kHeightAt, bad)).find("height"), std::string::npos);
        EXPECT_NE(
            refusal(with(good, kRadiiAt + 4 * 99, static_cast<float>(bad))).find("radius of element 99"),
            std::string::npos);
        EXPECT_NE(refusal(with(with(good, kRadialAt, bad), kRadialAt + 8, bad)).find("radial direction"),
                  std::string::npos);
    }
    EXPECT_NE(refusal(with(good, kHeightAt, 1e-9)).find("height"), std::string::npos);
    for (const double bad : {kNaN, kInfinity, -1e300}) {
        for (const std::size_t axis : {0U, 1U, 2U}) {
            EXPECT_NE(refusal(with(good, kPositionAt + 8 * axis, bad)).find("previous position"),
                      std::string::npos);
        }
    }
    for (const float bad : {1.0F, -0.01F, std::numeric_limits<float>::quiet_NaN()}) {
        EXPECT_NE(refusal(with(good, kRadiiAt + 4 * 100, bad)).find("carry of element 0"), std::string::npos);
    }
    EXPECT_NE(
        refusal(with(good, kFlagAt, std::uint32_t{2})).find("first tick flag: expected 0 or 1, found 2"),
        std::string::npos);
}

TEST(StateHash, ChangesWithEverythingALaterTickDependsOn) {
    const std::vector<std::byte> good = worked_state();
    const std::uint64_t hash = PaperClay::from_start_state(good)->state_hash();
    const auto hash_with = [&](std::size_t at, auto value) {
        const Result<PaperClay> clay = PaperClay::from_start_state(with(good, at, value));
        EXPECT_TRUE(clay) << clay.error().message;
        return clay->state_hash();
    };
    EXPECT_NE(hash_with(kHeightAt, 201.0), hash);
    EXPECT_NE(hash_with(kPositionAt, 1.25), hash);
    EXPECT_NE(hash_with(kPositionAt + 8, 1.25), hash);
    EXPECT_NE(hash_with(kPositionAt + 16, 1.25), hash);
    EXPECT_NE(hash_with(kFlagAt, std::uint32_t{0}), hash);
    EXPECT_NE(hash_with(kRadiiAt + 4 * 99, 30.0F), hash);
    EXPECT_NE(hash_with(kRadiiAt + 4 * 199, 1e-7F), hash);
    const std::vector<std::byte> turned = with(with(good, kRadialAt, 0.6), kRadialAt + 8, 0.8);
    EXPECT_NE(PaperClay::from_start_state(turned)->state_hash(), hash);
}

TEST(StateHash, DoesNotChangeWithTheKernel) {
    PaperClay clay;
    const std::uint64_t hash = clay.state_hash();
    clay.use_kernel(KernelVariant::kPlain);
    EXPECT_EQ(clay.state_hash(), hash);
}

}  // namespace
}  // namespace onggi::clay
