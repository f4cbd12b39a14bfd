// Numbers as little-endian bytes on any machine: for session files, start states and devices' reports. Any
// thread; reading allocates nothing and is fit for the tick.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace onggi::little_endian {

template <std::unsigned_integral T>
void put(std::vector<std::byte>& bytes, T number) {
    for (std::size_t at = 0; at < sizeof(T); ++at) {
        bytes.push_back(static_cast<std::byte>((std::uint64_t{number} >> (8U * at)) & 0xffU));
    }
}

inline void put(std::vector<std::byte>& bytes, double number) {
    put(bytes, std::bit_cast<std::uint64_t>(number));
}

inline void put(std::vector<std::byte>& bytes, float number) {
    put(bytes, std::bit_cast<std::uint32_t>(number));
}

// Precondition of each: `bytes` points to at least sizeof(T) bytes.
template <std::integral T>
[[nodiscard]] T get(const std::byte* bytes) noexcept {
    std::uint64_t number = 0;
    for (std::size_t at = 0; at < sizeof(T); ++at)
        number |= static_cast<std::uint64_t>(bytes[at]) << (8U * at);
    return static_cast<T>(number);
}
template <std::integral T>
[[nodiscard]] T get(std::span<const std::uint8_t> bytes, std::size_t at) noexcept {
    return get<T>(std::as_bytes(bytes).data() + at);
}

[[nodiscard]] inline double get_double(const std::byte* bytes) noexcept {
    return std::bit_cast<double>(get<std::uint64_t>(bytes));
}

}  // namespace onggi::little_endian
