// Watches a piece of code for what the tick may not do: ask the kernel, read a clock, allocate, lock, throw,
// touch a page that is not there. For tests, in a program of its own (quiet_watch.cpp replaces functions of
// the C and C++ libraries), on one thread.
#pragma once

#include <functional>
#include <string>

namespace onggi::test {

// What a piece of code did.
struct Disturbances {
    long system_calls = 0;
    long clock_reads = 0;  // through the C library, or the time stamp counter where the kernel can close it
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

// Runs it three times: under a system call filter in a child process; watched for page faults, the fewest of
// some runs, because a kernel may take a page away at any time; and counted. It must be able to run again and
// again, and everything it needs must have been touched before. Ends the test program where the kernel has no
// such filter.
[[nodiscard]] Disturbances watch(const std::function<void()>& code);

}  // namespace onggi::test
