// The time and memory that this process has used, as the kernel reports them. Any thread but the haptic one,
// because it reads files.
#pragma once

#include <optional>

namespace onggi::app {

// Seconds since the kernel started the process, to 10 ms. Empty if /proc does not provide it.
[[nodiscard]] std::optional<double> since_start_s();

// Its resident memory in MB of a million bytes; memory shared with other processes counts in full. Empty if
// /proc does not provide it.
[[nodiscard]] std::optional<double> resident_mb();
// The resident memory that the program has allocated, also that which it shares with the display's
// server, without pages of files such as fonts and drivers.
[[nodiscard]] std::optional<double> own_mb();

}  // namespace onggi::app
