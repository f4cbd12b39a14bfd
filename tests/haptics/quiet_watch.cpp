#include "tests/haptics/quiet_watch.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>  // NOLINT: sigaction
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>  // NOLINT: clock_gettime
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace {

std::atomic<long> allocations{0};
std::atomic<long> locks{0};
std::atomic<long> exceptions{0};
std::atomic<long> clock_reads{0};

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// Interposes the libraries' functions: counts and forwards. Memory functions forward to glibc's internal
// names, which need no symbol look-up, because they are called before main.
extern "C" {
// NOLINTBEGIN: names and signatures are the libraries'
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept {
    ++allocations;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    ++allocations;
    return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
    ++allocations;
    return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    ++allocations;
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    ++allocations;
    *block = __libc_memalign(alignment, size);
    return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
    if (block != nullptr) ++allocations;
    __libc_free(block);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
    ++locks;
    return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
    static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_trylock");
    ++locks;
    return real(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
    static const auto real = next<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
    ++locks;
    return real(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
    static const auto real = next<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
    ++locks;
    return real(lock);
}

int clock_gettime(clockid_t clock, timespec* now) noexcept {
    static const auto real = next<int (*)(clockid_t, timespec*)>("clock_gettime");
    ++clock_reads;
    return real(clock, now);
}
int gettimeofday(timeval* now, void* zone) noexcept {
    static const auto real = next<int (*)(timeval*, void*)>("gettimeofday");
    ++clock_reads;
    return real(now, zone);
}
time_t time(time_t* now) noexcept {
    static const auto real = next<time_t (*)(time_t*)>("time");
    ++clock_reads;
    return real(now);
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
    static const auto real = next<void* (*)(std::size_t)>("__cxa_allocate_exception");
    ++exceptions;
    return real(size);
}
// NOLINTEND
}

namespace onggi::test {
namespace {

// The child's results, in memory shared with its parent.
struct Seen {
    std::atomic<long> system_calls{0};
    std::atomic<long> clock_reads{0};
};
Seen* seen = nullptr;

[[noreturn]] void give_up(const char* what) {
    std::perror(what);
    std::abort();
}

void on_system_call(int, siginfo_t*, void*) {
    seen->system_calls.fetch_add(1, std::memory_order_relaxed);
}

#if defined(__x86_64__)
// The time stamp counter is disabled in the child, to detect clocks that need no system call (vDSO). The
// handler skips the instruction, so the clock does not advance.
void on_fault(int, siginfo_t*, void* context) {
    auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
    const auto* code = reinterpret_cast<const unsigned char*>(registers[REG_RIP]);
    const bool reads = code[0] == 0x0f && code[1] == 0x31;
    const bool reads_and_names = code[0] == 0x0f && code[1] == 0x01 && code[2] == 0xf9;
    if (!reads && !reads_and_names) _exit(99);
    registers[REG_RIP] += reads ? 2 : 3;
    registers[REG_RAX] = registers[REG_RDX] = registers[REG_RCX] = 0;
    seen->clock_reads.fetch_add(1, std::memory_order_relaxed);
}
#endif

// From here on this thread may only return from signals and exit.
void close_the_kernel() {
    struct sigaction action {};
    action.sa_flags = SA_SIGINFO;
    action.sa_sigaction = on_system_call;
    if (sigaction(SIGSYS, &action, nullptr) != 0) give_up("sigaction");
#if defined(__x86_64__)
    action.sa_sigaction = on_fault;
    if (sigaction(SIGSEGV, &action, nullptr) != 0) give_up("sigaction");
    if (prctl(PR_SET_TSC, PR_TSC_SIGSEGV) != 0) give_up("prctl: time stamp counter");
#endif
    std::array<sock_filter, 5> filter{{
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigreturn, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    }};
    const sock_fprog program{.len = static_cast<unsigned short>(filter.size()), .filter = filter.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) give_up("prctl: no new privileges");
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) give_up("prctl: system call filter");
}

void watch_system_calls(const std::function<void()>& code, Disturbances& found) {
    void* shared = mmap(nullptr, sizeof(Seen), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) give_up("mmap");
    seen = new (shared) Seen;
    const pid_t child = fork();
    if (child < 0) give_up("fork");
    if (child == 0) {
        close_the_kernel();
        code();
        _exit(0);
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child) give_up("waitpid");
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::fprintf(stderr, "the watched child ended with status %d\n", status);
        std::abort();
    }
    found.system_calls = seen->system_calls;
    found.clock_reads = seen->clock_reads;
    munmap(shared, sizeof(Seen));
}

long page_faults_so_far() {
    rusage usage{};
    if (getrusage(RUSAGE_THREAD, &usage) != 0) give_up("getrusage");
    return usage.ru_minflt + usage.ru_majflt;
}

}  // namespace

std::string Disturbances::words() const {
    return fmt::format(
        "{} system calls, {} clock reads, {} allocations, {} locks, {} exceptions, {} page faults",
        system_calls, clock_reads, allocations, locks, exceptions, page_faults);
}

Disturbances watch(const std::function<void()>& code) {
    Disturbances found;
    code();  // touches all pages
    constexpr int kRuns = 5;
    for (int run = 0; run < kRuns; ++run) {
        const long before = page_faults_so_far();
        code();
        const long faults = page_faults_so_far() - before;
        found.page_faults = run == 0 ? faults : std::min(found.page_faults, faults);
    }
    const long allocations_before = ::allocations;
    const long locks_before = ::locks;
    const long exceptions_before = ::exceptions;
    const long clock_reads_before = ::clock_reads;
    code();
    found.allocations = ::allocations - allocations_before;
    found.locks = ::locks - locks_before;
    found.exceptions = ::exceptions - exceptions_before;
    const long clock_reads = ::clock_reads - clock_reads_before;
    watch_system_calls(code, found);
    // A virtual machine's kernel may be unable to disable the counter; the functions are counted everywhere.
    found.clock_reads = std::max(found.clock_reads, clock_reads);
    return found;
}

}  // namespace onggi::test
