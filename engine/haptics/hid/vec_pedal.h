// VEC Infinity foot pedal (05f3:00ff): three pedals, no force. Pure; any thread.
// Source: reports as captured in public (fenimore/scribouillage). Never tried on hardware by this project.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace onggi::haptics::hid {

struct VecPedalState {
    bool left = false;
    bool middle = false;
    bool right = false;

    [[nodiscard]] bool any() const noexcept { return left || middle || right; }
};

// The report has no id: 2 bytes, byte 0 the pedals in bits 0 to 2, byte 1 zero. None: not such a report.
[[nodiscard]] inline std::optional<VecPedalState> vec_pedal_state(
    std::span<const std::uint8_t> report) noexcept {
    if (report.size() != 2 || (report[0] & 0xf8U) != 0 || report[1] != 0) return std::nullopt;
    return VecPedalState{
        .left = (report[0] & 1U) != 0, .middle = (report[0] & 2U) != 0, .right = (report[0] & 4U) != 0};
}

}  // namespace onggi::haptics::hid
