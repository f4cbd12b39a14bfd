#include "game/app/system/service.h"

#include <fmt/format.h>
#include <systemd/sd-daemon.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/number_in.h"

namespace onggi::app {
namespace {

// Seconds; 0 without a watchdog.
double watchdog_s() {
    constexpr double kUsPerSecond = 1e6;
    const char* text = std::getenv("WATCHDOG_USEC");
    if (text == nullptr) return 0.0;
    return static_cast<double>(number_in<std::uint64_t>(text).value_or(0)) / kUsPerSecond;
}

// A failed notification is ignored: it must not stop the wheel.
void tell(const std::string& words) {
    static_cast<void>(sd_notify(0, words.c_str()));
}

// The program's arguments, its name first.
std::vector<std::string> own_words() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::string> words;
    for (std::size_t at = 0; at < all.size(); at += words.back().size() + 1)
        words.emplace_back(all.c_str() + at);
    return words;
}

// The program's path; after an update it names the new file.
std::string own_place() {
    std::error_code error;
    std::string place = std::filesystem::read_symlink("/proc/self/exe", error).string();
    constexpr std::string_view kGone = " (deleted)";
    if (place.ends_with(kGone)) place.resize(place.size() - kGone.size());
    return place;
}

}  // namespace

bool Pulse::is_due(double now_s, const SignsOfLife& signs) {
    if (now_s - last_s_ < every_s_) return false;
    if (signs.frames_shown == last_.frames_shown || signs.haptic_ticks == last_.haptic_ticks) return false;
    last_s_ = now_s;
    last_ = signs;
    return true;
}

Service::Service() : pulse_(watchdog_s()), is_watched_(watchdog_s() > 0.0) {}

void Service::live(double now_s, const SignsOfLife& signs) {
    if (!is_ready_ && (signs.frames_shown == 0 || signs.haptic_ticks == 0)) return;
    if (!is_ready_) tell("READY=1");
    is_ready_ = true;
    if (is_watched_ && pulse_.is_due(now_s, signs)) tell("WATCHDOG=1");
}

void Service::say(const std::string& line) {
    if (line == said_) return;
    said_ = line;
    tell("STATUS=" + line);
}

void Service::ends() {
    tell("STOPPING=1");
}

Error start_anew() {
    const std::string place = own_place();
    std::vector<std::string> words = own_words();
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    if (!words.empty()) ::execv(place.c_str(), arguments.data());
    return system_lacks(
        fmt::format("restart: expected to start {} again, found {}", place, std::strerror(errno)));
}

}  // namespace onggi::app
