#include "game/app/sharing/confinement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <linux/landlock.h>
#include <pwd.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "engine/core/quote.h"

namespace onggi::app {
namespace {

// Landlock of version N knows the rights in the first N entries, and refuses rules that name others. The
// header of the oldest supported system names only the rights of version 1.
struct Forbidden {  // the kernel's struct landlock_ruleset_attr, version 6
    std::uint64_t files = 0;
    std::uint64_t tcp = 0;
    std::uint64_t processes = 0;
};
static_assert(sizeof(Forbidden) == 24);
constexpr std::array<Forbidden, 6> kForbidden{{
    {.files = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
              LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
              LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
              LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
              LANDLOCK_ACCESS_FS_MAKE_SYM},
    {.files = 1U << 13U},  // to link or rename into another folder
    {.files = 1U << 14U},  // to truncate
    {.tcp = 0b11U},        // to bind and to connect
    {.files = 1U << 15U},  // to control a device (ioctl)
    {.processes = 0b11U},  // abstract sockets and signals outside
}};

// The system calls of a running server whose sockets are open: none creates a socket or process, or changes
// the program or user.
constexpr auto kCalls = std::to_array<int>({
    // files
    SCMP_SYS(openat),
    SCMP_SYS(close),
    SCMP_SYS(read),
    SCMP_SYS(readv),
    SCMP_SYS(pread64),
    SCMP_SYS(lseek),
    SCMP_SYS(fstat),
    SCMP_SYS(newfstatat),
    SCMP_SYS(statx),
    SCMP_SYS(write),
    SCMP_SYS(writev),
    SCMP_SYS(fcntl),
    // sockets
    SCMP_SYS(accept4),
    SCMP_SYS(recvfrom),
    SCMP_SYS(recvmsg),
    SCMP_SYS(sendto),
    SCMP_SYS(sendmsg),
    SCMP_SYS(sendfile),
    SCMP_SYS(shutdown),
    SCMP_SYS(getsockname),
    SCMP_SYS(getpeername),
    SCMP_SYS(getsockopt),
    SCMP_SYS(setsockopt),
    // waiting
    SCMP_SYS(epoll_create1),
    SCMP_SYS(epoll_ctl),
    SCMP_SYS(epoll_wait),
    SCMP_SYS(epoll_pwait),
    SCMP_SYS(poll),
    SCMP_SYS(ppoll),
    SCMP_SYS(eventfd2),
    SCMP_SYS(futex),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(clock_nanosleep),
    SCMP_SYS(nanosleep),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(sched_yield),
    SCMP_SYS(restart_syscall),
#ifdef __SANITIZE_ADDRESS__
    // The check of a virtual call's object asks through a pipe whether its memory can be read; without one,
    // it takes every object for an invalid one
    // (findings/ubsan-takes-a-good-object-for-a-bad-one-where-a-filter-refuses-pipes.sh).
    SCMP_SYS(pipe2),
    SCMP_SYS(pipe),
#endif
    // memory
    SCMP_SYS(mmap),
    SCMP_SYS(munmap),
    SCMP_SYS(mremap),
    SCMP_SYS(mprotect),
    SCMP_SYS(madvise),
    SCMP_SYS(brk),
    SCMP_SYS(getrandom),
    // signals and the end
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigaltstack),
    SCMP_SYS(getpid),
    SCMP_SYS(gettid),
    SCMP_SYS(tgkill),
    SCMP_SYS(prlimit64),
    SCMP_SYS(getrlimit),
    SCMP_SYS(setrlimit),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
});

Error refused(std::string_view what) {
    return system_lacks(
        fmt::format("sharing: expected {}, found: {}", what, std::generic_category().message(errno)));
}

Result<void> allow(int rules, const std::filesystem::path& place, std::uint64_t access) {
    landlock_path_beneath_attr rule{};
    rule.allowed_access = access;
    rule.parent_fd = ::open(place.c_str(), O_PATH | O_CLOEXEC);
    if (rule.parent_fd < 0) return refused("to find " + shown_path(place.native()));
    const long added = ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    const Error error = refused("to get access to " + shown_path(place.native()));
    ::close(rule.parent_fd);
    if (added != 0) return error;
    return {};
}

}  // namespace

Result<std::string> give_up_root() {
    if (::geteuid() != 0) return std::string();
    constexpr std::string_view kWhy = "to leave root before phones are answered";
    for (const char* const name : {"onggi-share", "nobody"}) {
        const passwd* const user = ::getpwnam(name);
        if (user == nullptr || user->pw_uid == 0) continue;
        const uid_t id = user->pw_uid;
        const gid_t group = user->pw_gid;
        if (::setgroups(0, nullptr) == 0 && ::setresgid(group, group, group) == 0 &&
            ::setresuid(id, id, id) == 0)
            return std::string(name);
        return bad_input(
            fmt::format("sharing: expected {}, found that root cannot become {}: {}; start it "
                        "as another user",
                        kWhy, name, std::generic_category().message(errno)));
    }
    return bad_input(fmt::format(
        "sharing: expected {}, found no user onggi-share or nobody; start it as another user", kWhy));
}

Result<bool> confine_to(const std::filesystem::path& readable, const std::filesystem::path& writable) {
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return refused("to give up new privileges");
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) return false;
    Forbidden handled{};  // an older kernel takes its size if what it does not know is zero
    for (std::size_t i = 0; i < std::min(kForbidden.size(), static_cast<std::size_t>(version)); ++i) {
        handled.files |= kForbidden[i].files;
        handled.tcp |= kForbidden[i].tcp;
        handled.processes |= kForbidden[i].processes;
    }
    const int rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (rules < 0) return false;
    Result<void> allowed = allow(rules, readable, LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR);
    if (allowed && !writable.empty()) allowed = allow(rules, writable, LANDLOCK_ACCESS_FS_WRITE_FILE);
    if (allowed && ::syscall(SYS_landlock_restrict_self, rules, 0) != 0)
        allowed = refused("to confine the process");
    ::close(rules);
    if (!allowed) return allowed.error();
    return true;
}

bool confine_calls() {
    const scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ERRNO(EPERM));
    if (filter == nullptr) return false;
    bool is_loaded = true;
    for (const int call : kCalls)
        is_loaded = is_loaded && ::seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0;
    is_loaded = is_loaded && ::seccomp_load(filter) == 0;
    ::seccomp_release(filter);
    return is_loaded;
}

}  // namespace onggi::app
