#include "game/app/system/service.h"

#include <systemd/sd-daemon.h>

#include <cstdlib>
#include <string_view>

#include "engine/core/number_in.h"

namespace onggi::app {
namespace {

// Seconds; 0 where nobody watches.
double watchdog_s() {
    constexpr double kUsPerSecond = 1e6;
    const char* text = std::getenv("WATCHDOG_USEC");
    if (text == nullptr) return 0.0;
    return static_cast<double>(number_in<std::uint64_t>(text).value_or(0)) / kUsPerSecond;
}

// A manager that does not listen is no reason to stop the wheel.
void tell(const std::string& words) {
    static_cast<void>(sd_notify(0, words.c_str()));
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

}  // namespace onggi::app
