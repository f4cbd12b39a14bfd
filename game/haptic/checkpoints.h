// Checkpoints of a lump's state as bytes, each with its tick, in bounded memory: each is stored as a
// difference from the one before, and they are thinned out when the limit is reached. Reads return the exact
// bytes. One thread, but not the haptic one; allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "game/record/packed_bytes.h"

namespace onggi::haptic {

class Checkpoints {
  public:
    // The newest and the first checkpoint are kept even beyond that limit.
    explicit Checkpoints(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Precondition: tick is later than the newest one.
    void keep(std::uint64_t tick, std::vector<std::byte> bytes);
    // Removes the checkpoints after that tick. Precondition: the first is not after it.
    void forget_after(std::uint64_t tick);
    void clear();

    // Tick of the last checkpoint at or before that tick. Precondition of both functions: the first is not
    // after it.
    [[nodiscard]] std::uint64_t tick_before(std::uint64_t tick) const { return kept_[before(tick)].tick; }
    // Its bytes. Unpacks up to kLongestRow checkpoints.
    [[nodiscard]] std::vector<std::byte> bytes_before(std::uint64_t tick) const {
        return bytes_of(before(tick));
    }
    [[nodiscard]] std::uint64_t newest_tick() const { return kept_.back().tick; }

    [[nodiscard]] std::size_t count() const { return kept_.size(); }
    // Memory of all checkpoints.
    [[nodiscard]] std::size_t bytes() const { return packed_bytes_ + newest_.size(); }

  private:
    // A row is one checkpoint in full and up to kLongestRow - 1 differences, each from the one before.
    static constexpr std::size_t kLongestRow = 8;
    struct Kept {
        std::uint64_t tick = 0;
        record::PackedBytes packed;
        std::size_t step = 0;  // place in its row; 0: in full
    };

    [[nodiscard]] std::size_t before(std::uint64_t tick) const;
    [[nodiscard]] std::size_t first_of_row(std::size_t which) const { return which - kept_[which].step; }
    [[nodiscard]] std::vector<std::byte> bytes_of(std::size_t which) const;
    [[nodiscard]] std::vector<std::byte> unpacked(std::size_t which) const;
    void put_packed(std::size_t which, record::PackedBytes packed);
    void thin_out();
    void take_away(std::size_t which);
    void join_rows(std::size_t which);

    std::size_t most_bytes_;
    std::vector<Kept> kept_;         // ascending
    std::vector<std::byte> newest_;  // the last checkpoint unpacked, the reference of the next difference
    std::size_t packed_bytes_ = 0;
};

}  // namespace onggi::haptic
