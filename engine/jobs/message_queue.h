// A FIFO queue of messages of any size from one thread to another; the ring holds shared pointers. One thread
// posts, one takes; both wait-free apart from allocating and freeing a message.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "engine/jobs/spsc_ring.h"

namespace onggi::jobs {

template <typename Message>
class MessageQueue {
  public:
    // capacity: the largest number of waiting messages.
    explicit MessageQueue(std::size_t capacity) : ring_(capacity) {}

    // Posting thread. Drops the message if the queue is full.
    void post(Message message) {
        static_cast<void>(ring_.try_push(std::make_shared<const Message>(std::move(message))));
    }
    // Taking thread. Returns null if the queue is empty.
    [[nodiscard]] std::shared_ptr<const Message> next() noexcept {
        std::shared_ptr<const Message> next;
        return ring_.try_pop(next) ? next : nullptr;
    }

  private:
    SpscRing<std::shared_ptr<const Message>> ring_;
};

// Tasks that one thread asks another to run in its own rounds.
using TaskQueue = MessageQueue<std::function<void()>>;

}  // namespace onggi::jobs
