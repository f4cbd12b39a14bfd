#include "game/app/haptic_core.h"

#include <fmt/format.h>

#include "game/app/command_line.h"

namespace onggi::app {

jobs::CoreChoice leave_haptic_core() {
    const jobs::CoreChoice core = jobs::choose_haptic_core();
    const jobs::Granted kept = jobs::keep_this_thread_off_haptic_core(core);
    if (kept.grant == jobs::Grant::kRefused) {
        remark(fmt::format("real time: the picture could not be kept off core {}", core.core));
    }
    return core;
}

}  // namespace onggi::app
