#include "engine/jobs/thread_setup.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <system_error>
#include <thread>

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

Granted allow_this_thread(std::span<const int> cores) {
    cpu_set_t mask;
    CPU_ZERO(&mask);
    for (const int core : cores)
        CPU_SET(static_cast<std::size_t>(core), &mask);
    return outcome(pthread_setaffinity_np(pthread_self(), sizeof mask, &mask));
}

Granted ask_for_fifo(int priority) {
    sched_param parameter{};
    parameter.sched_priority = priority;
    return outcome(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter));
}

// Everything mapped now is read in and locked. What is mapped later is locked as it is first touched, but
// only where there is no limit: under one, a later allocation of the renderer would fail instead.
Granted lock_memory() {
    if (mlockall(MCL_CURRENT) != 0) return outcome(errno);
    rlimit limit{};
    const bool unlimited =
        geteuid() == 0 || (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY);
    if (unlimited && mlockall(MCL_FUTURE | MCL_ONFAULT) != 0) return outcome(errno);
    return outcome(0);
}

// Touches the stack the tick will use, so that no tick is the first to do so.
[[gnu::noinline]] void touch_stack() {
    constexpr std::size_t kBytes = 128 * 1024;
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
        setenv("MESA_SHADER_CACHE_DISABLE", "true", kKeepWhatIsSet);
    }
    return allow_this_thread(choice.others);
}

RealTimeReport set_up_this_thread(const RealTimeRequest& request) {
    RealTimeReport report;
    report.core = request.core;
    if (request.core.core >= 0) report.pinning = allow_this_thread(std::span(&request.core.core, 1));
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
