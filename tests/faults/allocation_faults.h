// Injects allocation failures: counts this process's allocations, those of operator new and those of C
// libraries, and lets the chosen one, or all from it on, return nothing. The program's code is unchanged: the
// test program interposes the C library's functions (malloc, calloc, ...). Any thread.
#pragma once

namespace onggi::faults {

enum class Shortage {
    kNone,     // only counts
    kOnce,     // that allocation fails
    kForGood,  // that one and all after it
};
[[nodiscard]] const char* name_of(Shortage shortage);

// `at` counts from 1.
void run_short(Shortage shortage, long at);
void end_shortage();
// Since run_short().
[[nodiscard]] long allocations();

}  // namespace onggi::faults
