// Chooses the haptic thread's core, asks the kernel for real-time settings and explains each refusal. The
// order matters: choose the core; keep the main thread off it *before* Vulkan is created (software Vulkan
// starts workers that inherit the mask); keep all threads off it afterwards; then start the haptic thread,
// which sets itself up.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace onggi::jobs {

// The core of the haptic thread and the cores of all other threads. core is -1 if the mask cannot be read.
struct CoreChoice {
    int core = -1;
    std::vector<int> others;  // empty: there is only one core, which all threads share

    [[nodiscard]] bool shared() const { return others.empty(); }
};

// The last core that the process may use: core 0 serves most interrupts. `allowed` ascending.
[[nodiscard]] CoreChoice choose_haptic_core(std::span<const int> allowed);
// The same from the calling thread's own mask. Main thread, before it is kept off any core.
[[nodiscard]] CoreChoice choose_haptic_core();

enum class Grant : std::uint8_t { kNotAsked, kGranted, kRefused };

// The result of one request to the kernel.
struct Granted {
    Grant grant = Grant::kNotAsked;
    int error = 0;  // errno of a refusal
};

// Main thread, before Vulkan is created and before any other thread starts: restricts this thread, and all
// that it will start, to the other cores. If only one other core is left, software Vulkan is also set to draw
// in its caller's thread (LP_NUM_THREADS), unless the user has set that variable. Does nothing on a shared
// core.
Granted keep_this_thread_off_haptic_core(const CoreChoice& choice);

// The same for every thread of the process: a driver's cache of shaders takes back all cores
// (findings/mesas-shader-cache-takes-back-all-cores.sh). Before the haptic thread starts; later threads have
// the lowest priority and cannot delay it. A thread that ends meanwhile is not a refusal.
Granted keep_all_threads_off_haptic_core(const CoreChoice& choice);

// Restricts the calling thread to these cores.
Granted keep_this_thread_on(std::span<const int> cores);

// Keeps idle cores out of deep sleep states, from which they wake slowly, as cyclictest does. Affects the
// whole machine while the object lives. On a virtual machine it made no measurable difference: the host
// decides.
class WakefulCores {
  public:
    WakefulCores() = default;
    WakefulCores(const WakefulCores&) = delete;
    WakefulCores& operator=(const WakefulCores&) = delete;
    ~WakefulCores() { release(); }

    // Refused unless a udev rule lets the user write /dev/cpu_dma_latency. Any thread.
    Granted request() noexcept;
    void release() noexcept;

  private:
    int file_ = -1;
};

// The settings to request for a thread with deadlines.
struct RealTimeRequest {
    CoreChoice core;
    int fifo_priority = 80;  // 1 to 99; above the kernel's threaded interrupts at 50
    bool lock_memory = true;
    bool wakeful_cores = true;
};

// A missing setting, its cost and its remedy for users: one line each, without a full stop.
struct RealTimeLack {
    std::string what;
    std::string cost;
    std::string remedy;
};

struct RealTimeReport {
    CoreChoice core;
    Granted pinning;
    Granted fifo;
    Granted memory_lock;
    Granted wakeful_cores;

    // The name in the stats file.
    [[nodiscard]] const char* scheduler() const { return fifo.grant == Grant::kGranted ? "fifo" : "other"; }
    // Whether no essential request was refused. (A shared core and sleepy cores are lacks, but no reason not
    // to run: the kernel cannot grant the first, and the second costs some us.)
    [[nodiscard]] bool nothing_refused() const {
        return pinning.grant != Grant::kRefused && fifo.grant != Grant::kRefused &&
               memory_lock.grant != Grant::kRefused;
    }
    // Refusals first, then lacks of the machine.
    [[nodiscard]] std::vector<RealTimeLack> lacks() const;
};

// Keeps the process's memory close to what it uses: all threads share two heaps instead of one each, and
// large blocks are mapped separately, so that freeing returns them to the system. The tick does not allocate,
// so it is not affected. Before any other thread starts.
void keep_heaps_small();

// Returns freed memory to the system. Call it after work that used much memory, such as a driver's
// compilation. Other threads' allocations wait for some ms. Any thread but a tick's.
void give_back_freed_memory();

// Releases the code of all libraries except those that a tick runs: mainly a software driver's compiler, up
// to 50 MB, and 30 MB used only at the start; also fonts. Unlocks the pages, so that the kernel may drop
// them; it reads them again on use. Call it after a driver has compiled and when the kind of work changes.
// Takes about a ms. Any thread but a tick's.
void give_back_code();

// Sets up the calling thread: pins it to the core, locks the process's memory, touches its stack, and
// requests SCHED_FIFO last, so that nothing slow runs with that priority. Records a refusal and continues.
// The owner, not the thread, holds WakefulCores.
[[nodiscard]] RealTimeReport set_up_this_thread(const RealTimeRequest& request);

// Requests SCHED_FIFO at that priority for the calling thread alone, for the few other threads with
// deadlines.
Granted ask_for_fifo(int priority);

// Finds out what would be granted, on a temporary thread. Leaves the process unchanged, except that memory
// locked before is unlocked. Any thread that is not real-time; takes a few ms.
[[nodiscard]] RealTimeReport probe_real_time(const RealTimeRequest& request);

// Tells the kernel the name of the calling thread, at most 15 letters, as `top -H` shows it.
void name_this_thread(const char* name);

}  // namespace onggi::jobs
