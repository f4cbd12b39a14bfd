// Takes from this process what it does not need to serve files. Main thread; irreversible.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::app {

// Root becomes the user onggi-share, which the package makes, or nobody where there is none, with no other
// group than that user's. Returns the user's name, empty where another user than root has started the
// program. Bad input: root cannot become either, as in a user namespace that has no other user.
[[nodiscard]] Result<std::string> give_up_root();

// From now on the process can read only files below `readable` and write only the pipe `writable` (empty:
// none); it cannot create, run, resize or remove files, control a device, bind or connect by TCP, reach an
// outside process by signal or abstract socket, nor gain privileges, even if a request exploits it. Uses as
// much of Landlock as the kernel has: files from 5.13 on, resizing 6.2, TCP 6.7, devices 6.10, processes
// 6.12. Returns false if the kernel has no Landlock: then only the service manager's sandbox protects. System
// lacks: Landlock refused.
[[nodiscard]] Result<bool> confine_to(const std::filesystem::path& readable,
                                      const std::filesystem::path& writable);

// From now on the kernel refuses (EPERM) all system calls but those that reading files and serving open
// sockets takes. Returns false where the kernel has no such filter.
[[nodiscard]] bool confine_calls();

}  // namespace onggi::app
