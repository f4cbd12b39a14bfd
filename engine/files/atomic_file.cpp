#include "engine/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/core/result.h"
#include "engine/files/file_errors.h"

namespace onggi::files {
namespace {

// The resolved location of an output file.
struct OutputPlace {
    std::filesystem::path file;      // absolute, a symbolic link at its end followed
    std::filesystem::path folder;    // its folder
    std::optional<mode_t> old_mode;  // permissions of an existing file there
};

Result<std::filesystem::path> follow_link(const std::filesystem::path& destination) {
    struct stat status {};
    if (::lstat(destination.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return destination;
    // Renaming onto a link would replace the link and leave its target unchanged.
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
    // AT_EACCESS: with the effective user's rights, not the real user's.
    if (::faccessat(AT_FDCWD, asked.c_str(), rights, AT_EACCESS) == 0) return {};
    return error_of_errno(destination, errno, "write");
}

// Only reads. Refuses as check_output_place does.
[[nodiscard]] Result<OutputPlace> find_output_place(const std::filesystem::path& destination) {
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

constexpr std::size_t kBufferBytes = std::size_t{64} << 10U;
constexpr int kMostNames = 1000;
constexpr mode_t kNewFileMode = 0666;  // minus the umask

// The n-th candidate name for the temporary file. A hidden name does not contain the destination's name,
// which may already have the maximum length.
std::filesystem::path beside_name(const OutputPlace& place, Beside beside, int n) {
    if (beside == Beside::kNameless) {
        return place.folder / fmt::format(".onggi-{}-{}.part", ::getpid(), n);
    }
    auto name = place.file;
    name += n == 0 ? std::string(".part") : fmt::format(".part{}", n);
    return name;
}

// Without /proc an unnamed file cannot be linked to a name.
bool can_name_the_nameless() {
    return ::access("/proc/self/fd", X_OK) == 0;
}

std::filesystem::path descriptor_path(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

std::atomic<bool> folder_sync_refused{false};

}  // namespace

int sync_folder(const std::filesystem::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return errno == EACCES ? 0 : errno;  // a folder may be writable but not readable
    const int error = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (error != EINVAL && error != ENOTSUP && error != ENOSYS) return error;
    folder_sync_refused = true;
    return 0;
}

bool folder_sync_was_refused() noexcept {
    return folder_sync_refused;
}

Result<void> check_output_place(const std::filesystem::path& destination) {
    if (auto place = find_output_place(destination); !place) return place.error();
    return {};
}

Result<AtomicFile> AtomicFile::create(const std::filesystem::path& destination, Beside beside) {
    auto place = find_output_place(destination);
    if (!place) return place.error();
    AtomicFile file;
    file.shown_ = destination;
    file.destination_ = place->file;
    if (beside == Beside::kNameless && can_name_the_nameless()) {
        file.descriptor_ = ::open(place->folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kNewFileMode);
    }
    // Not every file system supports unnamed files: then use a hidden name, which the destructor removes.
    for (int n = 0; file.descriptor_ < 0; ++n) {
        auto name = beside_name(*place, beside, n);
        file.descriptor_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kNewFileMode);
        if (file.descriptor_ >= 0) {
            file.beside_ = std::move(name);
        } else if (errno != EEXIST || n == kMostNames) {
            return error_of_errno(destination, errno, "write");
        }
    }
    if (place->old_mode && ::fchmod(file.descriptor_, *place->old_mode) != 0) {
        return file.lost(errno, "set the permissions");
    }
    file.buffer_.reserve(kBufferBytes);
    return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept {
    *this = std::move(other);
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
    if (this == &other) return *this;
    discard();
    shown_ = std::move(other.shown_);
    destination_ = std::move(other.destination_);
    beside_ = std::exchange(other.beside_, {});
    descriptor_ = std::exchange(other.descriptor_, -1);
    prepared_ = other.prepared_;
    buffer_ = std::move(other.buffer_);
    return *this;
}

AtomicFile::~AtomicFile() {
    discard();
}

void AtomicFile::discard() noexcept {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
    if (!beside_.empty()) ::unlink(std::exchange(beside_, {}).c_str());
    buffer_.clear();
}

void AtomicFile::leave() noexcept {
    beside_.clear();
    discard();
}

Error AtomicFile::lost(int error_number, std::string_view doing) {
    discard();
    return error_of_errno(shown_, error_number, doing);
}

Result<void> AtomicFile::write_through(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return lost(errno, "write");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

Result<void> AtomicFile::write(std::span<const std::byte> bytes) {
    if (descriptor_ < 0) return failed(fmt::format("{}: cannot write: already ended", shown(shown_)));
    prepared_ = false;
    if (buffer_.size() + bytes.size() > kBufferBytes) {
        if (auto flushed = flush(); !flushed) return flushed;
    }
    if (bytes.size() > kBufferBytes) return write_through(bytes);
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return {};
}

Result<void> AtomicFile::write(std::string_view text) {
    return write(std::as_bytes(std::span(text.data(), text.size())));
}

Result<void> AtomicFile::flush() {
    if (descriptor_ < 0) return failed(fmt::format("{}: cannot write: already ended", shown(shown_)));
    auto written = write_through(buffer_);
    buffer_.clear();
    return written;
}

Result<void> AtomicFile::prepare() {
    if (prepared_ && descriptor_ >= 0) return {};
    if (auto flushed = flush(); !flushed) return flushed;
    // A full disk may be reported only here.
    if (::fsync(descriptor_) != 0) return lost(errno, "write");
    prepared_ = true;
    return {};
}

Result<void> AtomicFile::commit() {
    if (auto ready = prepare(); !ready) return ready;
    const OutputPlace place{.file = destination_, .folder = destination_.parent_path(), .old_mode = {}};
    for (int n = 0; beside_.empty(); ++n) {
        auto name = beside_name(place, Beside::kNameless, n);
        if (::linkat(AT_FDCWD, descriptor_path(descriptor_).c_str(), AT_FDCWD, name.c_str(),
                     AT_SYMLINK_FOLLOW) == 0) {
            beside_ = std::move(name);
        } else if (errno != EEXIST || n == kMostNames) {
            return lost(errno, "write");
        }
    }
    if (::close(std::exchange(descriptor_, -1)) != 0) return lost(errno, "write");
    if (::rename(beside_.c_str(), destination_.c_str()) != 0) return lost(errno, "write");
    beside_.clear();
    if (const int error = sync_folder(place.folder); error != 0) {
        return error_of_errno(shown_, error, "sync the folder");
    }
    return {};
}

Result<void> write_file_atomically(const std::filesystem::path& destination,
                                   std::span<const std::byte> bytes) {
    auto file = AtomicFile::create(destination);
    if (!file) return file.error();
    if (auto written = file->write(bytes); !written) return written;
    return file->commit();
}

Result<void> write_file_atomically(const std::filesystem::path& destination, std::string_view text) {
    return write_file_atomically(destination, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace onggi::files
