// Waiting for what another thread or process is about to do.
#pragma once

#include <chrono>
#include <thread>

#include "tests/support/patience.h"

namespace onggi::test {

// Returns as soon as the condition holds. False: it did not hold within that time, which scaled() makes
// longer on a slow machine.
template <typename Condition>
bool comes_true(Condition&& condition, std::chrono::seconds most = std::chrono::seconds(30)) {
    const auto end = std::chrono::steady_clock::now() + scaled(most);
    while (!condition()) {
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace onggi::test
