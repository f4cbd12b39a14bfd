// Inside engine/files only: turns errno and file types into the one line that a user reads, and syncs
// folders. Any thread.
#pragma once

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/core/quote.h"
#include "engine/core/result.h"

namespace onggi::files {

inline std::string shown(const std::filesystem::path& path) {
    return shown_path(path.native());
}

inline std::string_view kind_of_file(mode_t mode) {
    if (S_ISREG(mode)) return "a file";
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
    return "something else";
}

// Who can fix the error: a wrong name is bad input, missing space or rights are what the system lacks.
inline ErrorKind kind_of_errno(int error_number) {
    switch (error_number) {
        case ENOENT:
        case ENOTDIR:
        case EISDIR:
        case ELOOP:
        case ENAMETOOLONG:
        case ENXIO:
            return ErrorKind::kBadInput;
        case EACCES:
        case EPERM:
        case EROFS:
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
        case EMFILE:
        case ENFILE:
        case ENOMEM:
            return ErrorKind::kSystemLacks;
        default:
            return ErrorKind::kFailed;
    }
}

inline Error error_of_errno(const std::filesystem::path& path, int error_number, std::string_view doing) {
    return {kind_of_errno(error_number), shown(path) + ": cannot " + std::string(doing) + ": " +
                                             std::generic_category().message(error_number)};
}

// Makes the names in a folder last through a power cut. Returns 0 or an errno. Network and FUSE file systems
// that cannot sync a folder refuse with EINVAL, ENOTSUP or ENOSYS: no program can do more there, so that
// counts as done.
[[nodiscard]] int sync_folder(const std::filesystem::path& folder);

}  // namespace onggi::files
