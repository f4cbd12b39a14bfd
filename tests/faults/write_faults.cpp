#include "tests/faults/write_faults.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <map>
#include <utility>

namespace onggi::faults {
namespace {

struct Faults {
    std::string folder;  // empty: not armed
    Kind kind = Kind::kNone;
    long at = 0;
    long calls = 0;
    std::string failed_call{};
    std::map<ino_t, off_t> synced{};  // for each written file, the bytes that survive a power cut
};

Faults& faults() {
    static Faults one;
    return one;
}

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// Describes a call for the failure message, and whether it needs disk space.
struct Call {
    std::string words;
    bool takes_room = true;
};

[[noreturn]] void die() {
    ::kill(::getpid(), SIGKILL);
    for (;;)
        ::pause();
}

// Discards everything that was written and not synced.
[[noreturn]] void cut_power() {
    const std::string folder = std::exchange(faults().folder, {});
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        struct stat status {};
        if (::lstat(entry.path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
        const auto found = faults().synced.find(status.st_ino);
        if (found != faults().synced.end() && status.st_size > found->second)
            static_cast<void>(!::truncate(entry.path().c_str(), found->second));
    }
    die();
}

// Returns 0 if the call may proceed, or the errno that it fails with. `tear` writes half of the data.
template <typename Tear>
int meet(const Call& call, Tear&& tear) {
    Faults& state = faults();
    ++state.calls;
    if (state.kind == Kind::kNone || state.calls < state.at) return 0;
    const bool is_first = state.calls == state.at;
    if (is_first) state.failed_call = call.words;
    switch (state.kind) {
        case Kind::kNone:
            return 0;
        case Kind::kTorn:
            tear();
            die();
        case Kind::kKilled:
            die();
        case Kind::kPowerCut:
            cut_power();
        case Kind::kFullOnce:
            return is_first && call.takes_room ? ENOSPC : 0;
        case Kind::kFull:
            return call.takes_room ? ENOSPC : 0;
        case Kind::kBroken:
            return EIO;
        case Kind::kReadOnly:
            return EROFS;
    }
    return 0;
}

bool is_below(const std::string& path) {
    const std::string& folder = faults().folder;
    return !folder.empty() && path.starts_with(folder);
}

std::string path_of(int descriptor) {
    std::array<char, PATH_MAX> path{};
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t size = ::readlink(link.c_str(), path.data(), path.size());
    return size > 0 ? std::string(path.data(), static_cast<std::size_t>(size)) : std::string();
}

std::string path_at(int folder, const char* path) {
    if (path[0] == '/') return path;
    if (folder == AT_FDCWD) return std::filesystem::absolute(path).string();
    return path_of(folder) + "/" + path;
}

// Before a write: records how much of the file is synced.
void remember(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) == 0) faults().synced.try_emplace(status.st_ino, status.st_size);
}

void note_synced(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) == 0) faults().synced[status.st_ino] = status.st_size;
}

// The result of a call on a descriptor or a path below the folder: an injected error, or the library's
// result.
template <typename Result, typename Do, typename Tear>
Result either(bool is_ours, const Call& call, Do&& go_on, Tear&& tear) {
    if (is_ours) {
        if (const int error = meet(call, tear); error != 0) {
            errno = error;
            return static_cast<Result>(-1);
        }
    }
    return go_on();
}
template <typename Result, typename Do>
Result either(bool is_ours, const Call& call, Do&& go_on) {
    return either<Result>(is_ours, call, go_on, [] {});
}

// A call that does something to the file or folder at one path.
template <typename Do>
int on_path(const char* what, int folder, const char* path, Do&& go_on, bool takes_room = true) {
    if (faults().folder.empty()) return go_on();
    const std::string where = path_at(folder, path);
    return either<int>(is_below(where), {what + where, takes_room}, go_on);
}
bool is_there(const char* path) {
    struct stat status {};
    return ::lstat(path, &status) == 0;
}

bool makes_or_writes(int flags) {
    return (flags & (O_CREAT | O_TRUNC)) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
}

template <typename Open>
int opened(const std::string& path, int flags, Open&& open) {
    const bool is_ours = makes_or_writes(flags) && is_below(path);
    const int descriptor = either<int>(is_ours, {"make " + path}, open);
    if (is_ours && descriptor >= 0) remember(descriptor);
    return descriptor;
}

// The mode of open(), which is there only where a file is made.
mode_t mode_of(int flags, va_list words) {
    return makes_or_writes(flags) ? static_cast<mode_t>(va_arg(words, unsigned)) : 0;
}

template <typename Write>
ssize_t written(int descriptor, std::size_t size, Write&& write) {
    if (faults().folder.empty()) return write(size);
    const std::string path = path_of(descriptor);
    const bool is_ours = is_below(path);
    if (is_ours) remember(descriptor);
    return either<ssize_t>(
        is_ours, {"write " + std::to_string(size) + " bytes to " + path}, [&] { return write(size); },
        [&] { static_cast<void>(write(size / 2)); });
}

}  // namespace

const char* name_of(Kind kind) {
    constexpr std::array<const char*, 8> kNames{"counted",   "killed", "torn",   "power cut",
                                                "full once", "full",   "broken", "read-only"};
    return kNames[static_cast<std::size_t>(kind)];
}

void arm(const std::filesystem::path& folder, Kind kind, long at) {
    faults() = {.folder = folder.string(), .kind = kind, .at = at};
}
void disarm() {
    faults().folder.clear();
}
long calls() {
    return faults().calls;
}
const std::string& failed_call() {
    return faults().failed_call;
}

}  // namespace onggi::faults

// Interposes the C library's functions and forwards to them.
extern "C" {
// NOLINTBEGIN: names and signatures are the library's
using namespace onggi::faults;

int open(const char* path, int flags, ...) {
    va_list words;
    va_start(words, flags);
    const mode_t mode = mode_of(flags, words);
    va_end(words);
    static const auto real = next<int (*)(const char*, int, ...)>("open");
    if (faults().folder.empty()) return real(path, flags, mode);
    return opened(path_at(AT_FDCWD, path), flags, [&] { return real(path, flags, mode); });
}
int openat(int folder, const char* path, int flags, ...) {
    va_list words;
    va_start(words, flags);
    const mode_t mode = mode_of(flags, words);
    va_end(words);
    static const auto real = next<int (*)(int, const char*, int, ...)>("openat");
    if (faults().folder.empty()) return real(folder, path, flags, mode);
    return opened(path_at(folder, path), flags, [&] { return real(folder, path, flags, mode); });
}
FILE* fopen64(const char* path, const char* mode) {
    static const auto real = next<FILE* (*)(const char*, const char*)>("fopen64");
    if (faults().folder.empty() || mode[0] == 'r') return real(path, mode);
    const std::string where = path_at(AT_FDCWD, path);
    if (is_below(where)) {
        if (const int error = meet({"make " + where}, [] {}); error != 0) {
            errno = error;
            return nullptr;
        }
    }
    return real(path, mode);
}
FILE* fopen(const char* path, const char* mode) {
    return fopen64(path, mode);
}
ssize_t write(int descriptor, const void* bytes, size_t size) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    return written(descriptor, size, [&](size_t some) { return real(descriptor, bytes, some); });
}
ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t at) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
    return written(descriptor, size, [&](size_t some) { return real(descriptor, bytes, some, at); });
}
// Where files are as long as 64 bits can say, these are the same calls.
int open64(const char* path, int flags, ...) __attribute__((alias("open")));
int openat64(int folder, const char* path, int flags, ...) __attribute__((alias("openat")));
ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t at) __attribute__((alias("pwrite")));
ssize_t writev(int descriptor, const iovec* parts, int count) {
    static const auto real = next<ssize_t (*)(int, const iovec*, int)>("writev");
    size_t size = 0;
    for (int i = 0; i < count; ++i)
        size += parts[i].iov_len;
    return written(descriptor, size, [&](size_t some) {
        return real(descriptor, parts, some == size ? count : std::max(count / 2, 1));
    });
}
int fsync(int descriptor) {
    static const auto real = next<int (*)(int)>("fsync");
    if (faults().folder.empty()) return real(descriptor);
    const std::string path = path_of(descriptor);
    const int done = either<int>(is_below(path), {"sync " + path}, [&] { return real(descriptor); });
    if (done == 0 && is_below(path)) note_synced(descriptor);
    return done;
}
int fdatasync(int descriptor) {
    return fsync(descriptor);
}
int ftruncate(int descriptor, off_t size) {
    static const auto real = next<int (*)(int, off_t)>("ftruncate");
    if (faults().folder.empty()) return real(descriptor, size);
    const std::string path = path_of(descriptor);
    return either<int>(is_below(path), {"cut " + path, false}, [&] { return real(descriptor, size); });
}
int rename(const char* from, const char* to) {
    static const auto real = next<int (*)(const char*, const char*)>("rename");
    if (faults().folder.empty()) return real(from, to);
    const std::string where = path_at(AT_FDCWD, to);
    return either<int>(is_below(where), {"rename " + std::string(from) + " to " + where},
                       [&] { return real(from, to); });
}
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
    static const auto real = next<int (*)(int, const char*, int, const char*, int)>("linkat");
    return on_path("name ", to_folder, to, [&] { return real(from_folder, from, to_folder, to, flags); });
}
int mkdir(const char* path, mode_t mode) {
    static const auto real = next<int (*)(const char*, mode_t)>("mkdir");
    // An existing one changes nothing.
    if (is_there(path)) return real(path, mode);
    return on_path("make folder ", AT_FDCWD, path, [&] { return real(path, mode); });
}
int unlink(const char* path) {
    static const auto real = next<int (*)(const char*)>("unlink");
    return on_path(
        "unlink ", AT_FDCWD, path, [&] { return real(path); }, false);
}
int unlinkat(int folder, const char* path, int flags) {
    static const auto real = next<int (*)(int, const char*, int)>("unlinkat");
    return on_path(
        "unlink ", folder, path, [&] { return real(folder, path, flags); }, false);
}
int rmdir(const char* path) {
    static const auto real = next<int (*)(const char*)>("rmdir");
    return on_path(
        "unlink ", AT_FDCWD, path, [&] { return real(path); }, false);
}
int remove(const char* path) {
    static const auto real = next<int (*)(const char*)>("remove");
    if (!is_there(path)) return real(path);
    return on_path(
        "unlink ", AT_FDCWD, path, [&] { return real(path); }, false);
}
// NOLINTEND
}
