// Restricts this process to the files that it serves. Main thread; irreversible.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace onggi::app {

// From now on the process can read only files below `readable` and write only the pipe `writable` (empty:
// none); it cannot create, run or remove files, nor gain privileges, even if a request exploits it. Uses the
// kernel's Landlock (5.13 or later). Returns false if the kernel has no Landlock: then only the service
// manager's sandbox protects. System lacks: Landlock refused.
[[nodiscard]] Result<bool> confine_to(const std::filesystem::path& readable,
                                      const std::filesystem::path& writable);

}  // namespace onggi::app
