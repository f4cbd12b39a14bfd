// Safeguards beside the haptic loop for when this program fails: a supervisor process that outlives a crash,
// and a stop key that needs no window. Main thread.
#pragma once

#include <optional>

#include "engine/haptics/stop_key.h"
#include "engine/jobs/io_thread.h"
#include "game/haptic/job.h"

namespace onggi::app {

// Call it first in a command that drives force devices. From here on this process is the child of a
// supervisor, which silences every device if the child dies. See jobs::supervise for the return value.
// ONGGI_UNSUPERVISED=1 disables it, for debuggers.
[[nodiscard]] std::optional<int> supervise_devices();
// Whether ONGGI_UNSUPERVISED is unset.
[[nodiscard]] bool is_supervised();

// While it lives, Pause or Stop on any readable keyboard turns the force off from the next tick on.
class StopGuard {
  public:
    explicit StopGuard(haptic::HapticJob& job);

  private:
    haptics::StopKey key_;
    jobs::IoThread thread_;
};

}  // namespace onggi::app
