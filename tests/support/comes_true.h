// Waiting for what another thread or process is about to do.
#pragma once

#include <chrono>
#include <thread>

namespace onggi::test {

// As soon as it is so. False: it was not within that time, which is long because machines are busy.
template <typename Condition>
bool comes_true(Condition&& condition, std::chrono::seconds most = std::chrono::seconds(30)) {
    const auto end = std::chrono::steady_clock::now() + most;
    while (!condition()) {
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace onggi::test
