#include "engine/files/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <new>

#include "engine/files/file_errors.h"

namespace onggi::files {
namespace {

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    // The file is only read, so a failing close loses nothing.
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    [[nodiscard]] int number() const { return number_; }

  private:
    int number_;
};

Result<void> check_regular(const std::filesystem::path& path, const struct stat& status) {
    if (S_ISREG(status.st_mode)) return {};
    return bad_input(fmt::format("{}: expected a file, found {}", shown(path), kind_of_file(status.st_mode)));
}

// Reads at most `most_bytes` of an open file.
Result<std::string> read_up_to(const std::filesystem::path& path, int descriptor, std::size_t expected_bytes,
                               std::size_t most_bytes) {
    std::string bytes;
    std::size_t filled = 0;
    // One byte more than expected detects the end of the file in the same pass.
    bytes.resize(std::min(expected_bytes, most_bytes - 1) + 1);
    while (true) {
        if (filled == bytes.size()) {
            if (filled == most_bytes) break;
            bytes.resize(std::min(most_bytes, std::max<std::size_t>(filled * 2, 4096)));
        }
        const ssize_t got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return error_of_errno(path, errno, "read");
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

Result<std::string> read_regular(const std::filesystem::path& path, std::size_t most_bytes, bool whole) {
    struct stat status {};
    // Check before opening: opening a device can have side effects.
    if (::stat(path.c_str(), &status) != 0) {
        if (errno == ENOENT) return bad_input(fmt::format("{}: no such file", shown(path)));
        return error_of_errno(path, errno, "read");
    }
    if (const auto regular = check_regular(path, status); !regular) return regular.error();

    // O_NONBLOCK: if a pipe has replaced the file meanwhile, open() must not wait for its writer.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (file.number() < 0) return error_of_errno(path, errno, "read");
    if (::fstat(file.number(), &status) != 0) return error_of_errno(path, errno, "read");
    if (const auto regular = check_regular(path, status); !regular) return regular.error();

    const auto size = static_cast<std::size_t>(status.st_size);
    const auto too_large = [&](std::size_t found) {
        return bad_input(
            fmt::format("{}: expected at most {} bytes, found {}", shown(path), most_bytes, found));
    };
    if (!whole) return read_up_to(path, file.number(), std::min(size, most_bytes), most_bytes);
    if (size > most_bytes) return too_large(size);
    // One byte more than allowed: a file that grows while it is read is refused, not truncated.
    auto bytes = read_up_to(path, file.number(), size, most_bytes + 1);
    if (bytes && bytes->size() > most_bytes) return too_large(bytes->size());
    return bytes;
}

Result<std::string> read_within_memory(const std::filesystem::path& path, std::size_t most_bytes,
                                       bool whole) {
    try {
        return read_regular(path, most_bytes, whole);
    } catch (const std::bad_alloc&) {
        return error_of_errno(path, ENOMEM, "read");
    }
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t most_bytes) {
    return read_within_memory(path, most_bytes, true);
}

Result<std::string> read_file_start(const std::filesystem::path& path, std::size_t most_bytes) {
    if (most_bytes == 0) return std::string{};
    return read_within_memory(path, most_bytes, false);
}

}  // namespace onggi::files
