// Moves rarely read bytes from memory to disk, into an unnamed file that disappears with the program. If the
// disk refuses, they stay in memory. Any one thread at a time but the haptic one; blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/result.h"

namespace onggi::files {

class SpillFile {
  public:
    // Creates no file before the first put(). Empty `folder`: everything stays in memory.
    explicit SpillFile(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}
    SpillFile(SpillFile&& other) noexcept;
    SpillFile& operator=(SpillFile&& other) noexcept;
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;
    ~SpillFile();

    struct Piece {
        std::uint64_t at = 0;  // on the disk
        std::size_t size = 0;
        std::vector<std::byte> in_memory;  // used if the disk refused it
    };
    // After a refusal by the disk, it is tried again only after clear().
    [[nodiscard]] Piece put(std::vector<std::byte> bytes);
    // Errors: failed or system lacks, if the disk cannot be read.
    [[nodiscard]] Result<std::vector<std::byte>> get(const Piece& piece) const;
    // Drops the newest piece: the next put() reuses its space.
    void take_back(const Piece& newest);
    // Drops all pieces.
    void clear();

    [[nodiscard]] std::uint64_t bytes_on_disk() const { return end_; }

  private:
    bool open();
    bool write(std::span<const std::byte> bytes);
    void close() noexcept;

    std::filesystem::path folder_;  // created if missing
    int descriptor_ = -1;
    bool refused_ = false;
    std::uint64_t end_ = 0;
};

}  // namespace onggi::files
