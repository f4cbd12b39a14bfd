// A fake Inverse service on loopback, for tests: a WebSocket server on a thread. It moves its cursor by the
// received force, and can send invalid messages, fall silent, or disconnect.
#pragma once

#include <memory>
#include <string>

#include "engine/math/math.h"

namespace onggi::testing {

class FakeService {
  public:
    // Listens on any free port, or on the given one.
    explicit FakeService(int port = 0);
    ~FakeService();
    FakeService(const FakeService&) = delete;
    FakeService& operator=(const FakeService&) = delete;

    [[nodiscard]] int port() const;
    // Any thread.
    void put_cursor_m(const dvec3& cursor_m);
    void be_silent(bool silent);           // answers nothing
    void say(const std::string& instead);  // sent from now on instead of the state; empty: the state again
    [[nodiscard]] std::string last_heard() const;
    [[nodiscard]] int times_heard() const;

    struct Impl;  // for the library's callback

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::testing
