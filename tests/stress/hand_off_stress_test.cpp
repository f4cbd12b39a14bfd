// Two threads on each buffer, as fast as they can, for ThreadSanitizer. Bounded by counts, not by time.
// Without the sanitizer they still check that no value is torn, lost or out of order.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>
#include <vector>

#include "engine/jobs/mailbox.h"
#include "engine/jobs/spsc_ring.h"
#include "engine/jobs/triple_buffer.h"

namespace onggi::jobs {
namespace {

// Every word identifies its value, so a torn value is detected.
struct Payload {
    std::vector<std::uint64_t> words = std::vector<std::uint64_t>(256, 0);

    void fill(std::uint64_t value) {
        for (std::uint64_t& word : words)
            word = value;
    }
    [[nodiscard]] bool whole() const {
        for (const std::uint64_t word : words) {
            if (word != words.front()) return false;
        }
        return true;
    }
};

TEST(TripleBufferUnderStress, GivesWholeValuesInOrderAndTheLastOneInTheEnd) {
    constexpr std::uint64_t kValues = 100'000;
    TripleBuffer<Payload> buffer;
    std::thread writer([&] {
        for (std::uint64_t value = 1; value <= kValues; ++value) {
            buffer.writing().fill(value);
            buffer.publish();
            if (value % 64 == 0) std::this_thread::yield();
        }
    });
    std::uint64_t last = 0;
    std::uint64_t acquired = 0;
    while (last < kValues) {
        if (!buffer.acquire()) {
            std::this_thread::yield();
            continue;
        }
        ++acquired;
        ASSERT_TRUE(buffer.reading().whole());
        ASSERT_GT(buffer.reading().words.front(), last);
        last = buffer.reading().words.front();
    }
    writer.join();
    EXPECT_LE(acquired, kValues);
    EXPECT_FALSE(buffer.acquire());
}

TEST(MailboxUnderStress, NeverGoesBack) {
    constexpr std::uint64_t kValues = 200'000;
    Mailbox<std::array<std::uint64_t, 4>> mailbox{{0, 0, 0, 0}};
    std::thread writer([&] {
        for (std::uint64_t value = 1; value <= kValues; ++value)
            mailbox.put({value, value, value, value});
    });
    std::uint64_t last = 0;
    while (last < kValues) {
        const std::array<std::uint64_t, 4> now = mailbox.latest();
        ASSERT_TRUE(now[0] == now[1] && now[1] == now[2] && now[2] == now[3]);
        ASSERT_GE(now[0], last);
        last = now[0];
    }
    writer.join();
}

TEST(SpscRingUnderStress, LosesNoElementAndKeepsTheOrder) {
    constexpr std::uint64_t kValues = 500'000;
    for (const std::size_t capacity : {std::size_t{2}, std::size_t{64}, std::size_t{16384}}) {
        SpscRing<std::uint64_t> ring(capacity);
        std::thread producer([&] {
            for (std::uint64_t value = 0; value < kValues;) {
                if (ring.try_push(value)) {
                    ++value;
                } else {
                    std::this_thread::yield();
                }
            }
        });
        for (std::uint64_t expected = 0; expected < kValues;) {
            std::uint64_t value = 0;
            if (!ring.try_pop(value)) {
                std::this_thread::yield();
                continue;
            }
            ASSERT_EQ(value, expected);
            ++expected;
        }
        producer.join();
        std::uint64_t value = 0;
        EXPECT_FALSE(ring.try_pop(value));
    }
}

}  // namespace
}  // namespace onggi::jobs
