#include "engine/files/spill_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "engine/files/file_errors.h"

namespace onggi::files {

SpillFile::SpillFile(SpillFile&& other) noexcept {
    *this = std::move(other);
}

SpillFile& SpillFile::operator=(SpillFile&& other) noexcept {
    if (this == &other) return *this;
    close();
    folder_ = std::move(other.folder_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    refused_ = other.refused_;
    end_ = std::exchange(other.end_, 0);
    return *this;
}

SpillFile::~SpillFile() {
    close();
}

void SpillFile::close() noexcept {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

bool SpillFile::open() {
    if (descriptor_ >= 0) return true;
    if (folder_.empty()) return false;
    constexpr mode_t kMine = 0600;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    descriptor_ = ::open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMine);
    if (descriptor_ >= 0) return true;
    // Not every file system supports unnamed files: then create a named one and unlink it at once.
    const auto name = folder_ / fmt::format(".onggi-{}-aside.part", ::getpid());
    descriptor_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kMine);
    if (descriptor_ >= 0) ::unlink(name.c_str());
    return descriptor_ >= 0;
}

bool SpillFile::write(std::span<const std::byte> bytes) {
    for (std::uint64_t at = end_; !bytes.empty();) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        at += static_cast<std::uint64_t>(written);
    }
    return true;
}

SpillFile::Piece SpillFile::put(std::vector<std::byte> bytes) {
    const std::size_t size = bytes.size();
    refused_ = refused_ || !open() || !write(bytes);
    if (refused_) return {.at = end_, .size = size, .in_memory = std::move(bytes)};
    return {.at = std::exchange(end_, end_ + size), .size = size, .in_memory = {}};
}

Result<std::vector<std::byte>> SpillFile::get(const Piece& piece) const {
    if (piece.in_memory.size() == piece.size) return piece.in_memory;
    std::vector<std::byte> bytes(piece.size);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t read = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                     static_cast<off_t>(piece.at + done));
        if (read < 0 && errno == EINTR) continue;
        if (read < 0) return error_of_errno(folder_, errno, "read the spilled bytes");
        if (read == 0)
            return failed(fmt::format("{}: cannot read the spilled bytes: expected {} bytes, found {}",
                                      shown(folder_), bytes.size(), done));
        done += static_cast<std::size_t>(read);
    }
    return bytes;
}

void SpillFile::take_back(const Piece& newest) {
    end_ = newest.at;
}

void SpillFile::clear() {
    // Truncate instead of closing: the next visit reuses the file.
    if (descriptor_ >= 0 && ::ftruncate(descriptor_, 0) != 0) close();
    end_ = 0;
    refused_ = false;
}

}  // namespace onggi::files
