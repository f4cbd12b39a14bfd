// Resources of this process: growth is a leak. Any thread.
#pragma once

#include "engine/core/list_folder.h"
#include "game/app/system/process_use.h"

namespace onggi::test {

// kB of a thousand bytes; 0 where the kernel does not say.
inline double resident_kb() {
    constexpr double kKbAMb = 1e3;
    return app::resident_mb().value_or(0.0) * kKbAMb;
}

inline long open_handles() {
    return static_cast<long>(list_folder("/proc/self/fd").entries.size());
}

}  // namespace onggi::test
