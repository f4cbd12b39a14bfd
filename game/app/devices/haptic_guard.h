// What stands by while the haptic loop runs, for the moments when this program cannot help itself: a process
// that outlives a crash, and a stop key that needs no window. Main thread.
#pragma once

#include <optional>

#include "engine/haptics/stop_key.h"
#include "engine/jobs/io_thread.h"
#include "game/haptic/job.h"

namespace onggi::app {

// To be called first of all by a command that lets devices push. From here on this is the child of a
// supervisor, which tells every device to let go should the child die on the spot; see jobs::supervise for
// what is returned. ONGGI_UNSUPERVISED=1 leaves it out, for debuggers.
[[nodiscard]] std::optional<int> supervise_devices();
// Whether it is not left out.
[[nodiscard]] bool is_supervised();

// Pause or Stop on any keyboard the user may read, and no force from the next tick on. While it lives.
class StopGuard {
  public:
    explicit StopGuard(haptic::HapticJob& job);

  private:
    haptics::StopKey key_;
    jobs::IoThread thread_;
};

}  // namespace onggi::app
