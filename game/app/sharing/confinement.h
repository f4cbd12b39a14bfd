// Shuts this process off from every file but those it serves. Main thread; there is no way back.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace onggi::app {

// From now on nothing but files below `readable` can be read and nothing but the pipe `writable` (empty:
// nothing) be written, made, run or removed, whatever a request talks this process into; nor can it gain a
// right. Landlock of the kernel (5.13 on). False where the kernel has none: then the service manager's own
// walls stand alone. System lacks: there is one, and it refused.
[[nodiscard]] Result<bool> confine_to(const std::filesystem::path& readable,
                                      const std::filesystem::path& writable);

}  // namespace onggi::app
