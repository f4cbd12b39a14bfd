// Watches a piece of code for what the tick must not do: call the kernel, read a clock, allocate, lock,
// throw, or fault a page. For tests, in a program of its own (quiet_watch.cpp replaces functions of the C and
// C++ libraries), on one thread.
#pragma once

#include <functional>
#include <string>

namespace onggi::test {

// The forbidden operations of a piece of code.
struct Disturbances {
    long system_calls = 0;
    long clock_reads = 0;  // through the C library, or the time stamp counter if the kernel can disable it
    long allocations = 0;  // and releases
    long locks = 0;
    long exceptions = 0;
    long page_faults = 0;

    [[nodiscard]] bool none() const {
        return system_calls == 0 && clock_reads == 0 && allocations == 0 && locks == 0 && exceptions == 0 &&
               page_faults == 0;
    }
    [[nodiscard]] std::string words() const;
};

// Runs the code three times: in a child process under a system call filter; watching page faults (the fewest
// of several runs, because the kernel may evict a page at any time); and counting calls. The code must be
// repeatable, and everything it needs must have been touched before. Exits the test program if the kernel has
// no such filter.
[[nodiscard]] Disturbances watch(const std::function<void()>& code);

}  // namespace onggi::test
