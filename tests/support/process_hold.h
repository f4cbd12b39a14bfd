// What this process holds of the machine: more after than before is a leak. Any thread.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace onggi::test {

inline double resident_kb() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        double kb = 0.0;
        if (word == "VmRSS:" && status >> kb) return kb;
    }
    return 0.0;
}

inline long open_handles() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
}

}  // namespace onggi::test
