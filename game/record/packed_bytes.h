// Compresses byte strings that resemble their predecessor, such as successive states: stores the deflated
// differences of their numbers. Not a file format: only the same build reads it. Any thread but the haptic
// one; allocates. Packing takes about 15 ms per megabyte, unpacking 4.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace onggi::record {

struct PackedBytes {
    std::vector<std::byte> deflated;
    std::size_t size = 0;  // of the original bytes
};

// `like` is the expected content, of any size, even empty. Lossless for any input. Compresses well if the
// tail is little-endian floats (or 4-byte words) that mostly equal `like`, or differ from it by a constant
// over a stretch.
[[nodiscard]] PackedBytes pack(std::span<const std::byte> bytes, std::span<const std::byte> like);
// Precondition: packed by pack() with the same `like`. Throws std::runtime_error if the bytes cannot be
// unpacked.
[[nodiscard]] std::vector<std::byte> unpack(const PackedBytes& packed, std::span<const std::byte> like);

}  // namespace onggi::record
