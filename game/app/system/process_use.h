// What this process has taken so far, by the kernel's account. Any thread but a tick's: it reads files.
#pragma once

#include <optional>

namespace onggi::app {

// Since the kernel started it, s, to 10 ms. None where /proc does not say.
[[nodiscard]] std::optional<double> since_start_s();

// Its memory that is there and not on the disk, MB of a million bytes; what it shares with others is counted
// whole. None where /proc does not say.
[[nodiscard]] std::optional<double> resident_mb();
// What of it the program has allocated: no pages of files, so that fonts and drivers do not count.
[[nodiscard]] std::optional<double> own_mb();

}  // namespace onggi::app
