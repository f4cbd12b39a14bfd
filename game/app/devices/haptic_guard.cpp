#include "game/app/devices/haptic_guard.h"

#include <fmt/format.h>

#include <cstdlib>

#include "engine/haptics/hid/hid_device.h"
#include "engine/jobs/supervisor.h"
#include "game/app/system/crash_report.h"
#include "game/app/system/report.h"

namespace onggi::app {

bool is_supervised() {
    return std::getenv("ONGGI_UNSUPERVISED") == nullptr;
}

std::optional<int> supervise_devices() {
    if (!is_supervised()) return std::nullopt;
    return jobs::supervise([](int signal) {
        const int count = haptics::let_go_of_all();
        if (signal == 0) return;  // the program has reported why it ended
        warn(fmt::format("the program died of signal {}; {} silenced", signal,
                         count == 1 ? std::string("1 device was") : fmt::format("{} devices were", count)));
        const auto kept = keep_crash_session();
        if (!kept) {
            warn(kept.error().message);
        } else if (*kept) {
            warn(fmt::format("crash: session kept as {}, for onggi replay", (*kept)->string()));
        }
    });
}

StopGuard::StopGuard(haptic::HapticJob& job)
    : key_([](const std::vector<std::string>& known) { return haptics::open_stop_keys(known); },
           [&job] { job.stop_force(); }) {
    // If the thread cannot start, the window's stop key remains, and the loop runs as before.
    static_cast<void>(thread_.start(key_, "onggi-stop-key"));
}

}  // namespace onggi::app
