// A place where one thread leaves its latest small value for another: a triple buffer with the manners of a
// variable. One writer thread, one reader thread, both wait-free.
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

    // Reader thread. The latest value put, or the initial one; stays as it is until the next call.
    [[nodiscard]] const T& latest() noexcept {
        buffer_.acquire();
        return buffer_.reading();
    }

  private:
    TripleBuffer<T> buffer_;
};

}  // namespace onggi::jobs
