// A loop whose pieces two threads share.
#include "engine/jobs/shared_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "tests/support/comes_true.h"

namespace onggi::jobs {
namespace {

std::vector<int> any_core() {
    const CoreChoice choice = choose_haptic_core();
    std::vector<int> cores = choice.others;
    cores.push_back(choice.core);
    return cores;
}

TEST(SharedLoop, RunsInOrderWithoutASecondThread) {
    SharedLoop loop;
    ASSERT_TRUE(loop.start({}, "test"));
    EXPECT_FALSE(loop.is_shared());
    std::vector<int> seen;
    loop.run(5, [&](int piece) { seen.push_back(piece); });
    EXPECT_EQ(seen, (std::vector{0, 1, 2, 3, 4}));
}

TEST(SharedLoop, RunsEachPieceOnceAndReturnsWhenAllAreDone) {
    SharedLoop loop;
    ASSERT_TRUE(loop.start(any_core(), "test"));
    EXPECT_TRUE(loop.is_shared());
    for (int round = 0; round < 2000; ++round) {
        std::array<int, 9> calls{};
        loop.run(static_cast<int>(calls.size()),
                 [&](int piece) { ++calls[static_cast<std::size_t>(piece)]; });
        ASSERT_EQ(std::accumulate(calls.begin(), calls.end(), 0), 9) << round;
        ASSERT_EQ(*std::max_element(calls.begin(), calls.end()), 1) << round;
    }
    loop.stop();
    EXPECT_FALSE(loop.is_shared());
    int calls = 0;
    loop.run(3, [&](int) { ++calls; });
    EXPECT_EQ(calls, 3);
}

// The first piece waits for the second, so each thread has one.
TEST(SharedLoop, IsSharedByTwoThreads) {
    SharedLoop loop;
    ASSERT_TRUE(loop.start(any_core(), "test"));
    std::array<std::thread::id, 2> by{};
    std::atomic<int> begun = 0;
    loop.run(2, [&](int piece) {
        by[static_cast<std::size_t>(piece)] = std::this_thread::get_id();
        ++begun;
        EXPECT_TRUE(test::comes_true([&] { return begun == 2; }));
    });
    EXPECT_NE(by[0], by[1]);
    EXPECT_EQ(std::set(by.begin(), by.end()).count(std::this_thread::get_id()), 1U);
}

TEST(SharedLoop, TakesTheHapticCoreOnlyWhereDrawingCannotDelayTheTick) {
    const CoreChoice two{.core = 1, .others = {0}};
    EXPECT_EQ(cores_of_second_thread(two, true), std::vector{1});
    EXPECT_TRUE(cores_of_second_thread(two, false).empty());
    const CoreChoice four{.core = 3, .others = {0, 1, 2}};
    EXPECT_EQ(cores_of_second_thread(four, true), four.others);
    EXPECT_EQ(cores_of_second_thread(four, false), four.others);
    EXPECT_TRUE(cores_of_second_thread({.core = 0, .others = {}}, true).empty());
}

}  // namespace
}  // namespace onggi::jobs
