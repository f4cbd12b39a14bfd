// The core reserved for the haptic thread, for every command that draws. Main thread.
#pragma once

#include "engine/jobs/thread_setup.h"

namespace onggi::app {

// Chooses the core, and keeps the calling thread and all threads that it will start off it. Call it before
// Vulkan is created: a software Vulkan driver starts threads that inherit the caller's cores. A refusal is
// reported and otherwise ignored.
[[nodiscard]] jobs::CoreChoice leave_haptic_core();

// Keeps all existing threads off the core. Call it once Vulkan is created and before the haptic thread
// starts.
void leave_haptic_core_wholly(const jobs::CoreChoice& core);

// The number of threads that a software Vulkan device draws with after that.
[[nodiscard]] int draw_threads(const jobs::CoreChoice& choice);

}  // namespace onggi::app
