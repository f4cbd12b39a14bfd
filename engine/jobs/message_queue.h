// Messages from one thread to another, first in first out: of any size, for the ring holds them by reference.
// One thread posts, one takes; both wait-free but for the memory of a message.
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
    // At most so many wait.
    explicit MessageQueue(std::size_t capacity) : ring_(capacity) {}

    // Posting thread. Dropped where too many wait.
    void post(Message message) {
        static_cast<void>(ring_.try_push(std::make_shared<const Message>(std::move(message))));
    }
    // Taking thread. Null: none waits.
    [[nodiscard]] std::shared_ptr<const Message> next() noexcept {
        std::shared_ptr<const Message> next;
        return ring_.try_pop(next) ? next : nullptr;
    }

  private:
    SpscRing<std::shared_ptr<const Message>> ring_;
};

// What one thread asks another to do, in the other's own rounds.
using TaskQueue = MessageQueue<std::function<void()>>;

}  // namespace onggi::jobs
