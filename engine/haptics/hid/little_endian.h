// Numbers in HID reports: low byte first. Pure; any thread. The caller has checked the length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace onggi::haptics::hid {

[[nodiscard]] inline std::uint16_t uint16_at(std::span<const std::uint8_t> bytes, std::size_t at) noexcept {
    return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8U));
}
[[nodiscard]] inline std::int16_t int16_at(std::span<const std::uint8_t> bytes, std::size_t at) noexcept {
    return static_cast<std::int16_t>(uint16_at(bytes, at));
}
[[nodiscard]] inline std::uint32_t uint32_at(std::span<const std::uint8_t> bytes, std::size_t at) noexcept {
    return uint16_at(bytes, at) | (std::uint32_t{uint16_at(bytes, at + 2)} << 16U);
}

}  // namespace onggi::haptics::hid
