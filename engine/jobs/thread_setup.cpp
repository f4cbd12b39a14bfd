#include "engine/jobs/thread_setup.h"

#include <fcntl.h>
#include <link.h>
#include <malloc.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/core/list_folder.h"

namespace onggi::jobs {
namespace {

Granted outcome(int error) {
    return {error == 0 ? Grant::kGranted : Grant::kRefused, error};
}

// The mask as a list of cores, ascending; empty when it cannot be read (more cores than a cpu_set_t holds).
std::vector<int> allowed_cores() {
    cpu_set_t mask;
    CPU_ZERO(&mask);
    std::vector<int> cores;
    if (sched_getaffinity(0, sizeof mask, &mask) != 0) return cores;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(static_cast<std::size_t>(core), &mask)) cores.push_back(core);
    }
    return cores;
}

cpu_set_t mask_of(std::span<const int> cores) {
    cpu_set_t mask;
    CPU_ZERO(&mask);
    for (const int core : cores)
        CPU_SET(static_cast<std::size_t>(core), &mask);
    return mask;
}

// The program itself, which the loader calls by no name, the kernel's page of code, and the libraries whose
// code runs in a tick.
bool may_run_in_a_tick(std::string_view library) {
    constexpr std::array<std::string_view, 7> kBeginnings{
        "libc.", "libm.", "libmvec.", "libstdc++.", "libgcc_s.", "linux-vdso.", "ld-"};
    return library.empty() || std::any_of(kBeginnings.begin(), kBeginnings.end(),
                                          [&](std::string_view name) { return library.starts_with(name); });
}

void drop_pages(std::uintptr_t first, std::uintptr_t end) {
    void* const at = reinterpret_cast<void*>(first);  // NOLINT: where the kernel has put it
    if (munlock(at, end - first) == 0) madvise(at, end - first, MADV_DONTNEED);
}

// Drops the unwritten pages of libraries that no tick runs; the kernel can read them again.
int drop_code(dl_phdr_info* library, std::size_t /*size*/, void* /*unused*/) {
    const std::string_view path = library->dlpi_name;
    if (may_run_in_a_tick(path.substr(path.rfind('/') + 1))) return 0;
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    for (int i = 0; i < library->dlpi_phnum; ++i) {
        const ElfW(Phdr)& segment = library->dlpi_phdr[i];
        if (segment.p_type != PT_LOAD || (segment.p_flags & PF_W) != 0) continue;
        const std::uintptr_t first = (library->dlpi_addr + segment.p_vaddr) / page * page;
        const std::uintptr_t end = library->dlpi_addr + segment.p_vaddr + segment.p_filesz;
        drop_pages(first, end);
    }
    return 0;
}

// Fonts that words were painted in: mapped to be read, and never written. The lines of /proc/self/maps are as
// proc(5) describes them.
void drop_fonts() {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        std::istringstream words(line);
        std::uintptr_t first = 0;
        std::uintptr_t end = 0;
        char dash = 0;
        std::string allowed, offset, device, inode, name;
        if (!(words >> std::hex >> first >> dash >> end >> allowed >> offset >> device >> inode >> name))
            continue;
        if (allowed == "r--p" && (name.ends_with(".ttf") || name.ends_with(".otf") || name.ends_with(".ttc")))
            drop_pages(first, end);
    }
}

}  // namespace

Granted keep_this_thread_on(std::span<const int> cores) {
    const cpu_set_t mask = mask_of(cores);
    return outcome(pthread_setaffinity_np(pthread_self(), sizeof mask, &mask));
}

Granted ask_for_fifo(int priority) {
    sched_param parameter{};
    parameter.sched_priority = priority;
    return outcome(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter));
}

namespace {

extern "C" const char __executable_start;  // set by the linker: start of the program's own code
extern "C" const char etext;               // and its end

// Reads every page of the program's own code, so that no tick causes a page fault.
void touch_code() {
    constexpr std::ptrdiff_t kPage = 4096;
    const volatile char* const end = &etext;
    for (const volatile char* at = &__executable_start; at < end; at += kPage)
        static_cast<void>(*at);
}

// Locks pages that are in memory or are touched from now on (MCL_ONFAULT). It does not read in all mapped
// pages, which would include the software driver's whole compiler and unused stacks, 250 MB. Later mappings
// are locked only if there is no limit: with a limit, a later allocation of the renderer would fail.
Granted lock_memory() {
    rlimit limit{};
    const bool unlimited =
        geteuid() == 0 || (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY);
    if (mlockall(MCL_CURRENT | MCL_ONFAULT | (unlimited ? MCL_FUTURE : 0)) != 0) return outcome(errno);
    touch_code();
    return outcome(0);
}

// Touches the stack that the tick will use, so that no tick causes a page fault.
[[gnu::noinline]] void touch_stack() {
    constexpr std::size_t kBytes = std::size_t{128} * 1024;
    constexpr std::size_t kPage = 4096;
    std::array<volatile unsigned char, kBytes> stack;
    for (std::size_t at = 0; at < kBytes; at += kPage)
        stack[at] = 0;
}

std::string reason(int error) {
    return std::system_category().message(error);
}

}  // namespace

CoreChoice choose_haptic_core(std::span<const int> allowed) {
    CoreChoice choice;
    if (allowed.empty()) return choice;
    choice.core = allowed.back();
    choice.others.assign(allowed.begin(), allowed.end() - 1);
    return choice;
}

CoreChoice choose_haptic_core() {
    return choose_haptic_core(allowed_cores());
}

Granted keep_this_thread_off_haptic_core(const CoreChoice& choice) {
    if (choice.shared()) return {};
    if (choice.others.size() == 1) {
        constexpr int kKeepWhatIsSet = 0;
        setenv("LP_NUM_THREADS", "0", kKeepWhatIsSet);
    }
    return keep_this_thread_on(choice.others);
}

Granted keep_all_threads_off_haptic_core(const CoreChoice& choice) {
    if (choice.shared()) return {};
    const cpu_set_t mask = mask_of(choice.others);
    Granted kept = outcome(0);
    const FolderListing tasks = list_folder("/proc/self/task");
    for (const std::filesystem::path& task : tasks.entries) {
        const int thread = std::atoi(task.filename().c_str());
        if (sched_setaffinity(thread, sizeof mask, &mask) != 0 && errno != ESRCH) kept = outcome(errno);
    }
    return tasks.is_whole() ? kept : outcome(tasks.error.value());
}

// Kernel documentation, power/pm_qos_interface.rst: the request is a 32-bit number of us written to the file,
// and holds while the file is open.
Granted WakefulCores::request() noexcept {
    release();
    const int file = open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC);
    if (file < 0) return outcome(errno);
    constexpr std::int32_t kLatencyUs = 0;
    if (write(file, &kLatencyUs, sizeof kLatencyUs) != sizeof kLatencyUs) {
        const int error = errno;
        close(file);
        return outcome(error);
    }
    file_ = file;
    return outcome(0);
}

void WakefulCores::release() noexcept {
    if (file_ >= 0) close(std::exchange(file_, -1));
}

void keep_heaps_small() {
#ifdef __GLIBC__
    constexpr int kLargeBytes = 64 * 1024;  // otherwise the threshold grows with freed blocks, up to 32 MB
    mallopt(M_ARENA_MAX, 2);
    mallopt(M_MMAP_THRESHOLD, kLargeBytes);
#endif
}

// A locked heap returns only its end. Unlocking it meanwhile returned no more during a visit.
void give_back_freed_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

void give_back_code() {
    dl_iterate_phdr(drop_code, nullptr);
    drop_fonts();
}

RealTimeReport set_up_this_thread(const RealTimeRequest& request) {
    RealTimeReport report;
    report.core = request.core;
    if (request.core.core >= 0) report.pinning = keep_this_thread_on(std::span(&request.core.core, 1));
    touch_stack();
    if (request.lock_memory) report.memory_lock = lock_memory();
    report.fifo = ask_for_fifo(request.fifo_priority);
    return report;
}

RealTimeReport probe_real_time(const RealTimeRequest& request) {
    RealTimeReport report;
    std::jthread([&] {
        report = set_up_this_thread(request);
        if (report.memory_lock.grant == Grant::kGranted) munlockall();
    }).join();
    if (request.wakeful_cores) report.wakeful_cores = WakefulCores().request();
    return report;
}

std::vector<RealTimeLack> RealTimeReport::lacks() const {
    std::vector<RealTimeLack> lacks;
    if (fifo.grant == Grant::kRefused) {
        lacks.push_back(
            {"real-time scheduling (SCHED_FIFO) was refused: " + reason(fifo.error),
             "other programs delay the haptic tick by up to some ms",
             "put '@onggi - rtprio 90' into /etc/security/limits.d/onggi.conf, join the group onggi and "
             "log in again"});
    }
    if (memory_lock.grant == Grant::kRefused) {
        lacks.push_back(
            {"locking memory was refused: " + reason(memory_lock.error),
             "a page that was swapped out delays a tick by some ms",
             "put '@onggi - memlock unlimited' into /etc/security/limits.d/onggi.conf, join the group "
             "onggi and log in again"});
    }
    if (pinning.grant == Grant::kRefused) {
        lacks.push_back({"pinning the haptic thread to core " + std::to_string(core.core) +
                             " was refused: " + reason(pinning.error),
                         "the tick moves between cores and waits for others there",
                         "let the cpuset of the service or container hold that core"});
    }
    if (wakeful_cores.grant == Grant::kRefused) {
        lacks.push_back({"keeping idle cores awake was refused: " + reason(wakeful_cores.error),
                         "the haptic tick starts some 10 us later where it sleeps up to its deadline",
                         "let the group onggi write /dev/cpu_dma_latency, by a udev rule"});
    }
    if (core.core < 0) {
        lacks.push_back({"the cores this process may use could not be read",
                         "the haptic thread shares its core with others",
                         "run it where sched_getaffinity works"});
    } else if (core.shared()) {
        lacks.push_back({"there is one core only, core " + std::to_string(core.core),
                         "the haptic tick and the picture wait for each other",
                         "give the machine, container or service a second core"});
    }
    return lacks;
}

void name_this_thread(const char* name) {
    pthread_setname_np(pthread_self(), name);
}

}  // namespace onggi::jobs
