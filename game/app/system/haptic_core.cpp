#include "game/app/system/haptic_core.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "game/app/system/report.h"

namespace onggi::app {

namespace {

void say_if_refused(const jobs::Granted& kept, const jobs::CoreChoice& core) {
    if (kept.grant == jobs::Grant::kRefused)
        remark(fmt::format("real time: the picture could not be kept off core {}", core.core));
}

}  // namespace

jobs::CoreChoice leave_haptic_core() {
    const jobs::CoreChoice core = jobs::choose_haptic_core();
    say_if_refused(jobs::keep_this_thread_off_haptic_core(core), core);
    return core;
}

void leave_haptic_core_wholly(const jobs::CoreChoice& core) {
    say_if_refused(jobs::keep_all_threads_off_haptic_core(core), core);
}

int draw_threads(const jobs::CoreChoice& choice) {
    // Mesa's environment variable; 0 and 1 both mean one thread.
    const char* requested = std::getenv("LP_NUM_THREADS");
    if (requested != nullptr) return std::max(1, std::atoi(requested));
    return std::max(1, static_cast<int>(choice.others.size()));
}

}  // namespace onggi::app
