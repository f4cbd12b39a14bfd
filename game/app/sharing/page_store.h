// The server's read-only access to the outbox. Any one thread; blocks as a disk does.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>

#include "game/sharing/share_code.h"

namespace onggi::app {

// A file that is open for reading; its content stays available while it is open, even if the pot is
// withdrawn.
class OpenFile {
  public:
    OpenFile() = default;
    OpenFile(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
    OpenFile(OpenFile&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)),
          size_(other.size_) {}
    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        size_ = other.size_;
        return *this;
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile();

    explicit operator bool() const { return descriptor_ >= 0; }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    // The caller closes the descriptor.
    [[nodiscard]] int release() { return std::exchange(descriptor_, -1); }
    [[nodiscard]] int descriptor() const { return descriptor_; }

  private:
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

class PageStore {
  public:
    explicit PageStore(std::filesystem::path outbox) : outbox_(std::move(outbox)) {}

    // Opens a file of that code's folder. Returns no file if the folder or file is missing, if it has expired
    // at `wall_s` (seconds since 1970), or if it is not a regular file; links are not followed.
    [[nodiscard]] OpenFile open(const sharing::ShareCode& code, std::string_view name,
                                std::int64_t wall_s) const;

  private:
    std::filesystem::path outbox_;
};

}  // namespace onggi::app
