// Bytes of the same kind one after the other, such as states of one thing, in little memory: how their
// numbers differ from those before, deflated. Not for files: read by the program that wrote them. Any thread
// but the haptic one; allocates. Some 15 ms a megabyte to pack, 4 to unpack.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace onggi::record {

struct PackedBytes {
    std::vector<std::byte> deflated;
    std::size_t size = 0;  // of what was packed
};

// `like` holds what the bytes probably look like, place by place; of any size, none too. Any bytes come back
// as they are; those take little room that are little-endian floats (or words of four bytes) up to the end,
// most of them as in `like` or, in a stretch, all of them more by one and the same number.
[[nodiscard]] PackedBytes pack(std::span<const std::byte> bytes, std::span<const std::byte> like);
// Precondition: packed by pack() with the same `like`. Throws std::runtime_error where it was not.
[[nodiscard]] std::vector<std::byte> unpack(const PackedBytes& packed, std::span<const std::byte> like);

}  // namespace onggi::record
