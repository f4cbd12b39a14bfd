// The guarantees of the buffers between threads, in one thread; tests/stress has threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "engine/jobs/mailbox.h"
#include "engine/jobs/message_queue.h"
#include "engine/jobs/spsc_ring.h"
#include "engine/jobs/triple_buffer.h"

namespace onggi::jobs {
namespace {

TEST(TripleBuffer, ShowsTheInitialValueUntilSomethingIsPublished) {
    TripleBuffer<int> buffer(7);
    EXPECT_FALSE(buffer.acquire());
    EXPECT_EQ(buffer.reading(), 7);
    buffer.writing() = 8;
    EXPECT_FALSE(buffer.acquire());
    EXPECT_EQ(buffer.reading(), 7);
    buffer.publish();
    EXPECT_TRUE(buffer.acquire());
    EXPECT_EQ(buffer.reading(), 8);
}

TEST(TripleBuffer, GivesTheNewestAndEachOnlyOnce) {
    TripleBuffer<int> buffer;
    for (int value = 1; value <= 5; ++value) {
        buffer.writing() = value;
        buffer.publish();
    }
    EXPECT_TRUE(buffer.acquire());
    EXPECT_EQ(buffer.reading(), 5);
    EXPECT_FALSE(buffer.acquire());
    EXPECT_EQ(buffer.reading(), 5);
}

TEST(TripleBuffer, LeavesTheReadersValueAloneWhileTheWriterGoesOn) {
    TripleBuffer<int> buffer;
    buffer.writing() = 1;
    buffer.publish();
    ASSERT_TRUE(buffer.acquire());
    const int& held = buffer.reading();
    for (int value = 2; value < 50; ++value) {
        buffer.writing() = value;
        buffer.publish();
        EXPECT_EQ(held, 1);
    }
}

TEST(TripleBuffer, KeepsTheMemoryOfItsPayloads) {
    TripleBuffer<std::vector<float>> buffer(std::vector<float>(2000, 60.0F));
    std::vector<const float*> seen;
    for (int i = 0; i < 9; ++i) {
        EXPECT_EQ(buffer.writing().size(), 2000U);
        seen.push_back(buffer.writing().data());
        buffer.publish();
        if (i % 2 == 0) buffer.acquire();
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_LE(std::unique(seen.begin(), seen.end()) - seen.begin(), 3);
}

TEST(Mailbox, HoldsTheLatestValuePut) {
    Mailbox<int> mailbox(3);
    EXPECT_EQ(mailbox.latest(), 3);
    mailbox.put(4);
    mailbox.put(5);
    EXPECT_EQ(mailbox.latest(), 5);
    EXPECT_EQ(mailbox.latest(), 5);
}

TEST(SpscRing, RoundsItsCapacityUpToAPowerOfTwo) {
    EXPECT_EQ(SpscRing<int>(0).capacity(), 2U);
    EXPECT_EQ(SpscRing<int>(5).capacity(), 8U);
    EXPECT_EQ(SpscRing<int>(64).capacity(), 64U);
}

TEST(SpscRing, RefusesUnchangedWhenFullAndWhenEmpty) {
    SpscRing<int> ring(4);
    int value = -1;
    EXPECT_FALSE(ring.try_pop(value));
    EXPECT_EQ(value, -1);
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(ring.try_push(i));
    EXPECT_FALSE(ring.try_push(99));
    for (int i = 0; i < 4; ++i) {
        ASSERT_TRUE(ring.try_pop(value));
        EXPECT_EQ(value, i);
    }
    EXPECT_FALSE(ring.try_pop(value));
}

TEST(SpscRing, ReleasesTakenElements) {
    SpscRing<std::shared_ptr<int>> ring(64);
    auto shared = std::make_shared<int>(7);
    ASSERT_TRUE(ring.try_push(shared));
    std::shared_ptr<int> taken;
    ASSERT_TRUE(ring.try_pop(taken));
    EXPECT_EQ(taken, shared);
    taken.reset();
    EXPECT_EQ(shared.use_count(), 1);
}

TEST(SpscRing, BehavesLikeAQueueOfBoundedLength) {
    SpscRing<int> ring(8);
    std::deque<int> model;
    std::mt19937 random(11);
    for (int step = 0; step < 100'000; ++step) {
        if (random() % 2 == 0) {
            EXPECT_EQ(ring.try_push(step), model.size() < ring.capacity());
            if (model.size() < ring.capacity()) model.push_back(step);
        } else {
            int value = 0;
            ASSERT_EQ(ring.try_pop(value), !model.empty());
            if (model.empty()) continue;
            ASSERT_EQ(value, model.front());
            model.pop_front();
        }
    }
}

TEST(MessageQueue, DoesTasksInTheOrderInWhichTheyWereAskedAndLetsGoOfThem) {
    TaskQueue tasks(4);
    EXPECT_EQ(tasks.next(), nullptr);
    const auto held = std::make_shared<int>(7);
    std::string done;
    for (const char letter : {'a', 'b', 'c'})
        tasks.post([&done, letter, held] { done += letter; });
    EXPECT_EQ(held.use_count(), 4);
    while (const auto task = tasks.next())
        (*task)();
    EXPECT_EQ(done, "abc");
    EXPECT_EQ(held.use_count(), 1) << "what was done holds nothing";
}

TEST(MessageQueue, DropsMessagesWhileTooManyWait) {
    MessageQueue<int> messages(2);
    for (int message = 1; message <= 3; ++message)
        messages.post(message);
    EXPECT_EQ(*messages.next(), 1);
    messages.post(4);
    EXPECT_EQ(*messages.next(), 2);
    EXPECT_EQ(*messages.next(), 4);
    EXPECT_EQ(messages.next(), nullptr);
}

}  // namespace
}  // namespace onggi::jobs
