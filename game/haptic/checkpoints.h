// States of a lump as bytes, a tick each, in a room that does not grow with the visit: every one is kept as
// what differs from the one before, and where the room is full they thin out. What comes out is what was put
// in, to the bit. One thread that is not the haptic one; allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/record/packed_bytes.h"

namespace onggi::haptic {

class Checkpoints {
  public:
    // The newest and the first are kept, whatever the room.
    explicit Checkpoints(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    // Precondition: a later tick than the newest's.
    void keep(std::uint64_t tick, std::vector<std::byte> bytes);
    // Takes away those behind that tick. Precondition: the first is not.
    void forget_after(std::uint64_t tick);
    void clear();

    // The tick of the last one at that tick or before it. Precondition of both: the first is not behind it.
    [[nodiscard]] std::uint64_t tick_before(std::uint64_t tick) const { return kept_[before(tick)].tick; }
    // Its bytes. Unpacks kLongestRow of them at most.
    [[nodiscard]] std::vector<std::byte> bytes_before(std::uint64_t tick) const {
        return bytes_of(before(tick));
    }
    [[nodiscard]] std::uint64_t newest_tick() const { return kept_.back().tick; }

    [[nodiscard]] std::size_t count() const { return kept_.size(); }
    // All the room they take.
    [[nodiscard]] std::size_t bytes() const { return packed_bytes_ + newest_.size(); }

  private:
    // In a row: one that stands by itself, and those that each say how they differ from the one before.
    static constexpr std::size_t kLongestRow = 8;
    struct Kept {
        std::uint64_t tick = 0;
        record::PackedBytes packed;
        std::size_t step = 0;  // its place in its row
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
    std::vector<std::byte> newest_;  // the last of them as it is, for the next to be told from
    std::size_t packed_bytes_ = 0;
};

}  // namespace onggi::haptic
