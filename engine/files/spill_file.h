// Bytes that are seldom read again, put aside on the disk so that they take no memory: in a file without a
// name, which is gone with the program. Where the disk takes none they stay in memory. Any one thread at a
// time but the haptic one; blocks.
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
    // Nothing is touched before the first put(). An empty folder: all stays in memory.
    explicit SpillFile(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}
    SpillFile(SpillFile&& other) noexcept;
    SpillFile& operator=(SpillFile&& other) noexcept;
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;
    ~SpillFile();

    struct Piece {
        std::uint64_t at = 0;  // on the disk
        std::size_t size = 0;
        std::vector<std::byte> in_memory;  // where the disk did not take it
    };
    // A disk that refused once is asked again after clear().
    [[nodiscard]] Piece put(std::vector<std::byte> bytes);
    // Failed, or system lacks: the disk does not give them back.
    [[nodiscard]] Result<std::vector<std::byte>> get(const Piece& piece) const;
    // The newest piece is no longer wanted: its room is taken by the next.
    void take_back(const Piece& newest);
    // Nor is any.
    void clear();

    [[nodiscard]] std::uint64_t bytes_on_disk() const { return end_; }

  private:
    bool open();
    bool write(std::span<const std::byte> bytes);
    void close() noexcept;

    std::filesystem::path folder_;  // created where it is missing
    int descriptor_ = -1;
    bool refused_ = false;
    std::uint64_t end_ = 0;
};

}  // namespace onggi::files
