// Gives up the rights that this process does not need to serve files. Main thread; irreversible.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::app {

// If root started the program, becomes the user onggi-share, which the package creates, or else nobody, and
// drops all other groups. Returns that user's name, or an empty string if the program was not started by
// root. Bad input: the user cannot be changed, as in a user namespace that maps only root.
[[nodiscard]] Result<std::string> give_up_root();

// Restricts the process to reading files below `readable` and writing the pipe `writable` (empty: no pipe).
// It cannot create, run, resize or remove files, control a device, bind or connect by TCP, reach an
// outside process by signal or abstract socket, nor gain privileges, even if a request exploits it. Uses all
// that the kernel's Landlock offers: files from 5.13 on, resizing 6.2, TCP 6.7, devices 6.10, processes
// 6.12. Returns false if the kernel has no Landlock: then only the service manager's sandbox protects. System
// lacks: Landlock refused.
[[nodiscard]] Result<bool> confine_to(const std::filesystem::path& readable,
                                      const std::filesystem::path& writable);

// Installs a filter that refuses (EPERM) all system calls except those for reading files and serving open
// sockets. Returns false if the kernel does not support such filters.
[[nodiscard]] bool confine_calls();

}  // namespace onggi::app
