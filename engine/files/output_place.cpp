#include "engine/files/output_place.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "engine/files/atomic_file.h"
#include "engine/files/file_errors.h"

namespace onggi::files {
namespace {

Result<std::filesystem::path> follow_link(const std::filesystem::path& destination) {
    struct stat status {};
    if (::lstat(destination.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return destination;
    // Renaming onto a link would replace the link and leave the file it stands for as it was.
    std::error_code error;
    auto target = std::filesystem::canonical(destination, error);
    if (!error) return target;
    if (error.value() == ENOENT) {
        return bad_input(fmt::format("{}: is a link to a file that is not there", shown(destination)));
    }
    return error_of_errno(destination, error.value(), "write");
}

Result<void> check_folder(const std::filesystem::path& destination, const std::filesystem::path& folder) {
    struct stat status {};
    if (::stat(folder.c_str(), &status) != 0) {
        if (errno == ENOENT) {
            return bad_input(
                fmt::format("{}: the folder {} is not there", shown(destination), shown(folder)));
        }
        return error_of_errno(destination, errno, "write");
    }
    if (!S_ISDIR(status.st_mode)) {
        return bad_input(fmt::format("{}: expected a folder at {}, found {}", shown(destination),
                                     shown(folder), kind_of_file(status.st_mode)));
    }
    return {};
}

Result<void> check_rights(const std::filesystem::path& destination, const std::filesystem::path& asked,
                          int rights) {
    // AT_EACCESS: with the rights the program has now, not with those of who started it.
    if (::faccessat(AT_FDCWD, asked.c_str(), rights, AT_EACCESS) == 0) return {};
    return error_of_errno(destination, errno, "write");
}

}  // namespace

Result<OutputPlace> find_output_place(const std::filesystem::path& destination) {
    if (destination.empty()) return bad_input("expected the name of an output file, found an empty one");
    auto followed = follow_link(destination);
    if (!followed) return followed.error();
    std::error_code error;
    OutputPlace place;
    place.file = std::filesystem::absolute(*followed, error);
    if (error) return error_of_errno(destination, error.value(), "write");
    place.folder = place.file.parent_path();

    if (auto folder = check_folder(destination, place.folder); !folder) return folder.error();
    struct stat status {};
    if (::stat(place.file.c_str(), &status) == 0) {
        if (!S_ISREG(status.st_mode)) {
            return bad_input(fmt::format("{}: expected the place of a file, found {}", shown(destination),
                                         kind_of_file(status.st_mode)));
        }
        place.old_mode = status.st_mode & 07777U;
    } else if (errno != ENOENT) {
        return error_of_errno(destination, errno, "write");
    }
    if (auto rights = check_rights(destination, place.folder, W_OK | X_OK); !rights) return rights.error();
    if (place.old_mode) {
        if (auto rights = check_rights(destination, place.file, W_OK); !rights) return rights.error();
    }
    return place;
}

Result<void> check_output_place(const std::filesystem::path& destination) {
    if (auto place = find_output_place(destination); !place) return place.error();
    return {};
}

}  // namespace onggi::files
