// Which core the haptic thread gets, what the kernel grants it, and what each refusal costs.
// The order matters: choose the core, keep the main thread off it *before* Vulkan is created (software Vulkan
// starts workers that inherit the mask), all threads once it is, and only then start the haptic thread, which
// sets itself up.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace onggi::jobs {

// The core of the haptic thread and the cores of everybody else. core is -1 when nothing could be learned.
struct CoreChoice {
    int core = -1;
    std::vector<int> others;  // empty: there is one core only, and it is shared

    [[nodiscard]] bool shared() const { return others.empty(); }
};

// The last core that the process may use: core 0 serves most interrupts. `allowed` ascending.
[[nodiscard]] CoreChoice choose_haptic_core(std::span<const int> allowed);
// The same from the calling thread's own mask. Main thread, before it is kept off any core.
[[nodiscard]] CoreChoice choose_haptic_core();

enum class Grant : std::uint8_t { kNotAsked, kGranted, kRefused };

// One thing asked of the kernel.
struct Granted {
    Grant grant = Grant::kNotAsked;
    int error = 0;  // errno of a refusal
};

// Main thread, before Vulkan is created and before any other thread starts: restricts it, and all that it
// will start, to the other cores. Where one other core is left, software Vulkan is also told to draw in its
// callers' threads, unless the user has set that variable. Does nothing on a shared core.
Granted keep_this_thread_off_haptic_core(const CoreChoice& choice);

// The same for every thread there is, by whomever it was started: the one that keeps a driver's compiled
// shaders on the disk takes all cores for itself. Before the haptic thread starts; what such a driver starts
// later it makes the least urgent of all, and the haptic thread goes before it. A thread that ends meanwhile
// is no refusal.
Granted keep_all_threads_off_haptic_core(const CoreChoice& choice);

// Asks the kernel not to let idle cores fall into a sleep from which they wake slowly, as cyclictest does.
// Holds for the whole machine, as long as it lives. On a virtual machine no difference was measured: the host
// decides.
class WakefulCores {
  public:
    WakefulCores() = default;
    WakefulCores(const WakefulCores&) = delete;
    WakefulCores& operator=(const WakefulCores&) = delete;
    ~WakefulCores() { release(); }

    // Refused to most users, unless the system's rules open /dev/cpu_dma_latency to them. Any thread.
    Granted request() noexcept;
    void release() noexcept;

  private:
    int file_ = -1;
};

// What a thread that keeps deadlines asks for.
struct RealTimeRequest {
    CoreChoice core;
    int fifo_priority = 80;  // 1 to 99; above the kernel's threaded interrupts at 50
    bool lock_memory = true;
    bool wakeful_cores = true;
};

// What is missing, in words for a person: one line each, without a full stop.
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

    // The names the stats file uses.
    [[nodiscard]] const char* scheduler() const { return fifo.grant == Grant::kGranted ? "fifo" : "other"; }
    // Nothing was refused that deadlines rest on. (A shared core and drowsy ones are lacks, but no reason not
    // to run: the first nobody can grant, the second costs some us.)
    [[nodiscard]] bool nothing_refused() const {
        return pinning.grant != Grant::kRefused && fifo.grant != Grant::kRefused &&
               memory_lock.grant != Grant::kRefused;
    }
    // Refusals first, then what the machine itself lacks.
    [[nodiscard]] std::vector<RealTimeLack> lacks() const;
};

// Keeps what the process takes near what it uses: threads share two heaps instead of having one each, and
// large blocks lie apart, so that each goes back to the system as it is freed. The tick allocates nothing and
// does not notice. Before any other thread starts.
void keep_heaps_small();

// Hands memory that was freed back to the system. To be called after what takes much for a while, such as a
// driver that compiles. Other threads' allocations wait for some ms, and the heap is not locked meanwhile.
// Any thread but a tick's.
void give_back_freed_memory();

// Hands back the code of all libraries but those that a tick runs: a software driver's compiler above all, up
// to 50 MB, and 30 MB that only a start needs; and fonts. The kernel keeps it or reads it again as it likes,
// and no lock holds it any longer; what is run again comes back as it is used, page by page. To be called
// when a driver has compiled and when something else begins. Takes about a ms. Any thread but a tick's.
void give_back_code();

// The calling thread: pins itself to the core, locks the process's memory, touches its stack, and asks for
// SCHED_FIFO last, so that nothing slow happens under it. Goes on after a refusal and records it. Wakeful
// cores are not the thread's but its owner's to hold.
[[nodiscard]] RealTimeReport set_up_this_thread(const RealTimeRequest& request);

// The calling thread, alone: SCHED_FIFO at that priority. For the few others whose lateness matters.
Granted ask_for_fifo(int priority);

// Finds out what would be granted, on a thread of its own that ends at once; the process is left as it was,
// but for memory locked before, which is unlocked. Any thread that is not real-time; takes a few ms.
[[nodiscard]] RealTimeReport probe_real_time(const RealTimeRequest& request);

// Tells the kernel the name of the calling thread, at most 15 letters, as `top -H` shows it.
void name_this_thread(const char* name);

}  // namespace onggi::jobs
