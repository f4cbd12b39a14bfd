// Makes the system refuse operations: permissions, full disks, limits. Works for root and for other users.
#pragma once

#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <net/if.h>
#include <sched.h>
#include <signal.h>  // NOLINT: sigaction is POSIX
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <functional>
#include <string>

namespace onggi::test {

constexpr unsigned kRightsOverFiles = (1U << CAP_DAC_OVERRIDE) | (1U << CAP_DAC_READ_SEARCH);

// While it lives, permissions bind this thread even if it belongs to root.
class WithoutRootRights {
  public:
    WithoutRootRights() {
        read(before_);
        __user_cap_data_struct lowered[2] = {before_[0], before_[1]};
        lowered[0].effective &= ~kRightsOverFiles;
        write(lowered);
    }
    WithoutRootRights(const WithoutRootRights&) = delete;
    WithoutRootRights& operator=(const WithoutRootRights&) = delete;
    ~WithoutRootRights() { write(before_); }

  private:
    static void read(__user_cap_data_struct* data) {
        __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
        ::syscall(SYS_capget, &header, data);
    }
    static void write(__user_cap_data_struct* data) {
        __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
        ::syscall(SYS_capset, &header, data);
    }
    __user_cap_data_struct before_[2] = {};
};

// In a child before exec: permissions will bind the program even for root.
inline void bind_permissions_across_exec() {
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH, 0, 0, 0);
}

// Runs `work` in a child process, which may change its environment freely. Returns its result.
inline std::string in_child(const std::function<std::string()>& work) {
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        const std::string answer = work();
        const ssize_t written = ::write(ends[1], answer.data(), answer.size());
        // _exit: the test's own objects belong to the parent.
        ::_exit(written == static_cast<ssize_t>(answer.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    std::string answer;
    char bytes[4096];
    for (ssize_t got = 0; (got = ::read(ends[0], bytes, sizeof bytes)) > 0;) {
        answer.append(bytes, static_cast<std::size_t>(got));
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) answer += "killed by signal " + std::to_string(WTERMSIG(status));
    return answer;
}

// In a child: a namespace of that kind of its own, as root or through a user namespace. False: both are
// refused.
inline bool enter_own(int kind) {
    const uid_t user = ::getuid();
    const gid_t group = ::getgid();
    if (::unshare(kind) == 0) return true;
    if (::unshare(CLONE_NEWUSER | kind) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    return true;
}

// In a child: a set of mounts of its own. False where that is refused.
inline bool enter_own_mounts() {
    return enter_own(CLONE_NEWNS) && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

// In a child: a network of its own, with nothing but 127.0.0.1, so that every port there is free. False where
// that is refused.
inline bool enter_own_network() {
    if (!enter_own(CLONE_NEWNET)) return false;
    const int any = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    ifreq loopback{};
    loopback.ifr_name[0] = 'l';
    loopback.ifr_name[1] = 'o';
    loopback.ifr_flags = IFF_UP;
    const bool is_up = ::ioctl(any, SIOCSIFFLAGS, &loopback) == 0;
    ::close(any);
    return is_up;
}

// In a child: a disk of `bytes` at `folder`, seen by this child only.
inline bool mount_small_disk(const std::string& folder, std::size_t bytes) {
    const std::string options = "size=" + std::to_string(bytes);
    return enter_own_mounts() && ::mount("none", folder.c_str(), "tmpfs", 0, options.c_str()) == 0;
}

// In a child: no file may grow beyond `bytes`; a write that would is refused instead of killing the program.
inline void limit_file_size(std::size_t bytes) {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGXFSZ, &ignore, nullptr);
    const struct rlimit limit { bytes, bytes };
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

// In a child: a disk of `bytes` at `folder`, or, if mounting is refused, a file size limit of `bytes`.
inline void fill_disk_after(const std::string& folder, std::size_t bytes) {
    if (!mount_small_disk(folder, bytes)) limit_file_size(bytes);
}

// The registers of a system call that was handed to this program: its argument `at`, 0 or 1, and its result
// (System V ABI, AMD64, A.2.1; on arm64 Linux's own convention, syscall(2)).
inline long call_argument(const void* context, int at) {
    const auto& machine = static_cast<const ucontext_t*>(context)->uc_mcontext;
#ifdef __aarch64__
    return static_cast<long>(machine.regs[at]);
#else
    return machine.gregs[at == 0 ? REG_RDI : REG_RSI];
#endif
}
inline void set_call_result(void* context, long result) {
    auto& machine = static_cast<ucontext_t*>(context)->uc_mcontext;
#ifdef __aarch64__
    machine.regs[0] = static_cast<unsigned long long>(result);
#else
    machine.gregs[REG_RAX] = result;
#endif
}

// In a child: from now on a folder is read a few names at a time, and the disk fails after `pieces` such
// pieces, those of all folders together. The kernel hands each getdents64 to this program, which asks again
// for less (an odd size, which is let through) or answers EIO. False where the kernel does not do that.
inline int pieces_before_the_disk_fails = 0;  // NOLINT: a signal handler knows nothing else

inline bool fail_listings_after(int pieces) {
    pieces_before_the_disk_fails = pieces;
    struct sigaction answer {};
    answer.sa_flags = SA_SIGINFO;
    answer.sa_sigaction = [](int, siginfo_t*, void* context) {
        constexpr long kFewBytes = 255;
        long read = -EIO;
        if (pieces_before_the_disk_fails-- > 0) {
            read = ::syscall(SYS_getdents64, call_argument(context, 0), call_argument(context, 1), kFewBytes);
            if (read < 0) read = -errno;
        }
        set_call_result(context, read);
    };
    ::sigaction(SIGSYS, &answer, nullptr);
    // Fields of struct seccomp_data; the third argument's lower half says how much is read.
    constexpr unsigned kNumberAt = 0;
    constexpr unsigned kSizeAt = 32;
    sock_filter steps[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kNumberAt),
                           BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_getdents64, 0, 3),
                           BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kSizeAt),
                           BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, 1, 1, 0),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    const sock_fprog filter{static_cast<unsigned short>(std::size(steps)), steps};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

// In a child: from now on the sync of a folder fails with `error`, as network and FUSE file systems have it;
// files are synced. False where the kernel does not do that.
inline int error_of_folder_syncs = 0;  // NOLINT: a signal handler knows nothing else

inline bool refuse_folder_syncs(int error) {
    error_of_folder_syncs = error;
    struct sigaction answer {};
    answer.sa_flags = SA_SIGINFO;
    answer.sa_sigaction = [](int, siginfo_t*, void* context) {
        const int descriptor = static_cast<int>(call_argument(context, 0));
        struct stat status {};
        const bool is_folder = ::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
        set_call_result(context, is_folder ? -error_of_folder_syncs : ::fdatasync(descriptor));
    };
    ::sigaction(SIGSYS, &answer, nullptr);
    constexpr unsigned kNumberAt = 0;  // in struct seccomp_data
    sock_filter steps[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kNumberAt), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_fsync, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    const sock_fprog filter{static_cast<unsigned short>(std::size(steps)), steps};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

}  // namespace onggi::test
