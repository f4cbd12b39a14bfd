// The core that belongs to the haptic thread, for every command that draws. Main thread.
#pragma once

#include "engine/jobs/thread_setup.h"

namespace onggi::app {

// Chooses it and keeps the calling thread, with all that it will start, off it. To be called before Vulkan is
// created: its software driver starts threads that inherit the caller's cores. A refusal is said and lived
// with.
[[nodiscard]] jobs::CoreChoice leave_haptic_core();

// Keeps all threads off it that there are, once Vulkan is created and before the haptic thread starts.
void leave_haptic_core_wholly(const jobs::CoreChoice& core);

// How many threads a software Vulkan device draws with, once that is done.
[[nodiscard]] int draw_threads(const jobs::CoreChoice& choice);

}  // namespace onggi::app
