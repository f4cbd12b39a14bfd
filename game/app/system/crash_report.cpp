#include "game/app/system/crash_report.h"

#include <execinfo.h>
#include <fmt/format.h>
#include <limits.h>  // NOLINT: PATH_MAX is POSIX
#include <signal.h>  // NOLINT: sigaction is POSIX
#include <sys/mman.h>
#include <sys/prctl.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <utility>

#include "engine/core/quote.h"
#include "game/app/system/report.h"
#include "game/app/system/version.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

struct Lead {
    std::array<char, PATH_MAX> session{};
    std::array<char, PATH_MAX> keep_in{};
};
// In memory shared with the supervisor, which reads it after the program's death. One of the two leads is
// always complete.
struct SharedLead {
    std::array<Lead, 2> leads;
    std::atomic<std::uint32_t> whole{0};
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

// A signal handler can use only globals.
SharedLead* shared = nullptr;
std::array<char, 256> program{};
std::array<std::byte, std::size_t{64} << 10U> handler_stack{};
std::atomic_flag is_reporting = ATOMIC_FLAG_INIT;

// One line, truncated to its buffer and written with one call, so that lines of several processes do not mix.
class Line {
  public:
    explicit Line(bool for_journal, const char* begins = "onggi: crash: ") {
        *this << (for_journal ? kCritical : "") << begins;
    }
    Line& operator<<(const char* text) {
        while (*text != '\0' && size_ + 1 < bytes_.size())
            bytes_[size_++] = *text++;
        return *this;
    }
    Line& operator<<(unsigned number) { return add(number, 10); }
    Line& hex(std::uintptr_t number) { return (*this << "0x").add(number, 16); }
    void write() {
        bytes_[size_++] = '\n';
        static_cast<void>(!::write(STDERR_FILENO, bytes_.data(), size_));
    }

  private:
    Line& add(std::uintptr_t number, unsigned base) {
        std::array<char, 24> digits{};
        std::size_t at = digits.size() - 1;
        do {
            digits[--at] = "0123456789abcdef"[number % base];
            number /= base;
        } while (number != 0);
        return *this << &digits[at];
    }
    std::array<char, PATH_MAX + 256> bytes_{};
    std::size_t size_ = 0;
};

const char* words_for(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "SIGSEGV";
        case SIGBUS:
            return "SIGBUS";
        case SIGFPE:
            return "SIGFPE";
        case SIGILL:
            return "SIGILL";
        default:
            return "SIGABRT";
    }
}

bool for_journal = false;

// Reports the caller of a null function pointer, for example of a driver: the call has no frame to unwind,
// but the return address is on top of the stack (System V ABI, AMD64, 3.2.2) or in the link register x30
// (Procedure Call Standard for the Arm 64-bit Architecture, 6.1.1).
void tell_who_called_nothing(const void* context) {
#if defined(__x86_64__) || defined(__aarch64__)
    const auto& machine = static_cast<const ucontext_t*>(context)->uc_mcontext;
#ifdef __x86_64__
    if (machine.gregs[REG_RIP] != 0) return;
    void* const caller = *reinterpret_cast<void* const*>(machine.gregs[REG_RSP]);
#else
    if (machine.pc != 0) return;
    void* const caller = reinterpret_cast<void*>(machine.regs[30]);
#endif
    (Line(for_journal) << "a missing function was called from").write();
    ::backtrace_symbols_fd(&caller, 1, STDERR_FILENO);
#else
    static_cast<void>(context);
#endif
}

// Whether this thread was refused memory.
thread_local bool was_refused_memory = false;

void note_refusal() {
    was_refused_memory = true;
    throw std::bad_alloc();
}

// Whether this thread unwinds, most likely because of that refusal: nothing tells which exception it is.
bool unwinds_from_refusal() noexcept {
    return std::uncaught_exceptions() > 0 && was_refused_memory;
}

// A lack of memory is not a crash: reports one line and ends with the exit code for system lacks.
[[noreturn]] void end_without_memory() noexcept {
    std::array<char, 17> thread{};
    ::prctl(PR_GET_NAME, thread.data());
    (Line(for_journal, "onggi: ") << "expected memory for the thread " << thread.data()
                                  << ", found none left")
        .write();
    ::_exit(exit_code(ErrorKind::kSystemLacks));
}

void report_and_die(int signal, siginfo_t* info, void* context) {
    // The first thread that crashes reports it; others that crash meanwhile wait for the end.
    while (is_reporting.test_and_set())
        ::pause();
    // Ends the program if the report hangs, for example on the loader's lock.
    ::alarm(5);
    // Assertions of some libraries fail while their objects are destroyed by an unwind.
    if (signal == SIGABRT && info->si_pid == ::getpid() && unwinds_from_refusal()) end_without_memory();
    std::array<char, 17> thread{};
    ::prctl(PR_GET_NAME, thread.data());
    Line line(for_journal);
    line << words_for(signal);
    // Whether the kernel raised the signal, or another process such as a service manager's watchdog sent it.
    if (info->si_code > 0) {
        (line << " at ").hex(reinterpret_cast<std::uintptr_t>(info->si_addr));
    } else {
        line << " from process " << static_cast<unsigned>(info->si_pid);
    }
    (line << " in thread " << thread.data() << " of " << program.data()).write();
    if (signal == SIGSEGV) tell_who_called_nothing(context);
    constexpr int kMostFrames = 48;
    std::array<void*, kMostFrames> frames{};
    ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), kMostFrames), STDERR_FILENO);
    const char* session = shared == nullptr ? "" : shared->leads[shared->whole % 2].session.data();
    Line led(for_journal);
    if (*session == '\0') {
        led << "no visit was in progress";
    } else {
        led << "the session that led there: " << session;
    }
    led.write();
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

// The terminate handler, for what no thread or start catches. An allocation failure is reported with one line
// and the exit code for system lacks; it is not a crash.
[[noreturn]] void end_without_memory_or_crash() noexcept {
    try {
        if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        end_without_memory();
    } catch (...) {  // NOLINT: abort() reports it
        std::abort();
    }
    // GCC 12's noexcept functions do not tell the exception, once destructors ran (GCC's bug 97720).
    if (unwinds_from_refusal()) end_without_memory();
    std::abort();
}

void copy(std::array<char, PATH_MAX>& into, const std::string& text) {
    into = {};
    if (text.size() < into.size()) std::memcpy(into.data(), text.data(), text.size());
}

// The first unused name, or that of the oldest file. A file dated after now was written before the clock went
// back.
fs::path place_in(const fs::path& folder) {
    fs::path oldest;
    const fs::file_time_type now = fs::file_time_type::clock::now();
    std::pair<bool, fs::file_time_type> written{};
    for (int number = 1; number <= kMostCrashes; ++number) {
        fs::path place = folder / fmt::format("crash-{}.onggi", number);
        std::error_code error;
        const fs::file_time_type at = fs::last_write_time(place, error);
        if (error) return place;
        const std::pair<bool, fs::file_time_type> age{at <= now, at};
        if (!oldest.empty() && age >= written) continue;
        oldest = std::move(place);
        written = age;
    }
    return oldest;
}

}  // namespace

void report_crashes() {
    void* const memory =
        ::mmap(nullptr, sizeof(SharedLead), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory != MAP_FAILED) shared = new (memory) SharedLead;  // NOLINT: it lives as long as the program
    const std::string named = "onggi " + version();
    std::copy_n(named.data(), std::min(named.size(), program.size() - 1), program.data());
    for_journal = stderr_is_journal();
    // The first call loads the unwinder's library, which a signal handler must not do.
    std::array<void*, 1> frame{};
    static_cast<void>(::backtrace(frame.data(), 1));
    // After a stack overflow, the handler needs its own stack.
    const stack_t apart{.ss_sp = handler_stack.data(), .ss_flags = 0, .ss_size = handler_stack.size()};
    ::sigaltstack(&apart, nullptr);
    std::set_terminate(&end_without_memory_or_crash);
    std::set_new_handler(&note_refusal);
    struct sigaction action {};
    action.sa_sigaction = &report_and_die;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        struct sigaction before {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler == SIG_DFL) ::sigaction(signal, &action, nullptr);
    }
}

void crash_leads_to(const fs::path& session, const fs::path& keep_in) noexcept {
    if (shared == nullptr) return;
    const std::uint32_t whole = shared->whole;
    if (session.native() == shared->leads[whole % 2].session.data()) return;
    Lead& next = shared->leads[(whole + 1) % 2];
    copy(next.session, session.native());
    copy(next.keep_in, keep_in.native());
    shared->whole = whole + 1;
}

Result<std::optional<fs::path>> keep_crash_session() {
    if (shared == nullptr) return std::optional<fs::path>();
    const Lead& lead = shared->leads[shared->whole % 2];
    const fs::path session = lead.session.data();
    const fs::path folder = lead.keep_in.data();
    std::error_code error;
    if (session.empty() || !fs::exists(session, error)) return std::optional<fs::path>();
    fs::create_directories(folder, error);
    const fs::path place = place_in(folder);
    fs::remove(place, error);
    fs::create_hard_link(session, place, error);
    // Not every file system supports hard links.
    if (error) fs::copy_file(session, place, error);
    if (error)
        return system_lacks(fmt::format("{}: expected to keep the session of a crash there, found: {}",
                                        shown_path(place.native()), error.message()));
    return std::optional(place);
}

}  // namespace onggi::app
