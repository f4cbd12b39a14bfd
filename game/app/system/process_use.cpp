#include "game/app/system/process_use.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

namespace onggi::app {

std::optional<double> since_start_s() {
    // proc(5): the program's name is in parentheses and may contain any character; the start time is the 20th
    // word after it.
    std::ifstream file("/proc/self/stat");
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::size_t name_end = text.rfind(')');
    if (name_end == std::string::npos) return std::nullopt;
    std::istringstream words(text.substr(name_end + 1));
    constexpr int kBeforeStart = 19;
    std::string word;
    for (int i = 0; i < kBeforeStart; ++i)
        words >> word;
    double start_ticks = 0.0;
    if (!(words >> start_ticks)) return std::nullopt;
    double now_s = 0.0;
    if (!(std::ifstream("/proc/uptime") >> now_s)) return std::nullopt;
    return now_s - start_ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

namespace {

// The size in a line of /proc/self/status.
std::optional<double> status_mb(std::string_view name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kib = 0.0;
        if (word == name && status >> kib) return kib * 1024.0 / 1e6;
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> resident_mb() {
    return status_mb("VmRSS:");
}

std::optional<double> own_mb() {
    const auto heap_mb = status_mb("RssAnon:");
    const auto picture_mb = status_mb("RssShmem:");  // shared with the display
    if (!heap_mb || !picture_mb) return std::nullopt;
    return *heap_mb + *picture_mb;
}

}  // namespace onggi::app
