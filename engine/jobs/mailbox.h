// Passes the latest small value from one thread to another: a triple buffer used like a variable. One writer
// thread, one reader thread, both wait-free.
#pragma once

#include "engine/jobs/triple_buffer.h"

namespace onggi::jobs {

template <typename T>
class Mailbox {
  public:
    explicit Mailbox(const T& initial = T{}) : buffer_(initial) {}

    // Writer thread.
    void put(const T& value) noexcept {
        buffer_.writing() = value;
        buffer_.publish();
    }

    // Reader thread. Returns the latest value put, or the initial one; the reference's value does not change
    // until the next call.
    [[nodiscard]] const T& latest() noexcept {
        buffer_.acquire();
        return buffer_.reading();
    }

  private:
    TripleBuffer<T> buffer_;
};

}  // namespace onggi::jobs
