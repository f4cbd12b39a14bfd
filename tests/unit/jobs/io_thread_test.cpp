// The thread for blocking work.
#include "engine/jobs/io_thread.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/support/comes_true.h"

namespace onggi::jobs {
namespace {

class Counting final : public IoWork {
  public:
    explicit Counting(std::int64_t rest_ns) : rest_ns_(rest_ns) {}
    std::int64_t round(std::int64_t now_ns) noexcept override {
        is_in_order = is_in_order && now_ns >= last_ns_ && finishes == 0;
        last_ns_ = now_ns;
        ++rounds;
        return rest_ns_;
    }
    void finish() noexcept override { ++finishes; }

    std::atomic<int> rounds = 0;
    int finishes = 0;
    bool is_in_order = true;

  private:
    std::int64_t rest_ns_;
    std::int64_t last_ns_ = 0;
};

TEST(IoThread, GoesRoundUntilItIsStoppedAndFinishesOnce) {
    Counting work(0);
    IoThread thread;
    ASSERT_TRUE(thread.start(work, "test"));
    EXPECT_TRUE(thread.running());
    ASSERT_TRUE(test::comes_true([&] { return work.rounds >= 100; }));
    thread.stop();
    EXPECT_FALSE(thread.running());
    EXPECT_EQ(work.finishes, 1);
    EXPECT_TRUE(work.is_in_order);
    thread.stop();
    EXPECT_EQ(work.finishes, 1);
}

TEST(IoThread, IsStoppedOutOfALongRest) {
    Counting work(3600'000'000'000);
    {
        IoThread thread;
        ASSERT_TRUE(thread.start(work, "test"));
        ASSERT_TRUE(test::comes_true([&] { return work.rounds >= 1; }));
    }  // would take an hour
    EXPECT_EQ(work.rounds, 1);
    EXPECT_EQ(work.finishes, 1);
}

TEST(IoThread, IsWokenOutOfALongRest) {
    Counting work(3600'000'000'000);
    IoThread thread;
    ASSERT_TRUE(thread.start(work, "test"));
    ASSERT_TRUE(test::comes_true([&] { return work.rounds >= 1; }));
    for (int rounds = 2; rounds < 10; ++rounds) {
        thread.wake();
        ASSERT_TRUE(test::comes_true([&] { return work.rounds >= rounds; }));
    }
}

TEST(IoThread, StartsAgain) {
    Counting work(0);
    IoThread thread;
    ASSERT_TRUE(thread.start(work, "test"));
    thread.stop();
    work.finishes = 0;
    const int before = work.rounds;
    ASSERT_TRUE(thread.start(work, "test"));
    ASSERT_TRUE(test::comes_true([&] { return work.rounds >= before + 1; }));
    thread.stop();
    EXPECT_EQ(work.finishes, 1);
}

}  // namespace
}  // namespace onggi::jobs
