// The session file, `.onggi`: its header, and the limits of its content. README.md describes the bytes.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/math/math.h"

namespace onggi::record {

// Not valid text, and changed by every kind of line-end conversion.
constexpr std::string_view kMagic{"\x89ONGGI\r\n", 8};
// An addition raises the minor version, and older versions stay readable: see README.md.
constexpr std::uint16_t kMajorVersion = 2;
constexpr std::uint16_t kMinorVersion = 2;     // 1: a supplement may precede the end marker; 2: packed blocks
constexpr std::uint32_t kHashInterval = 1000;  // ticks between state hashes, and per block

// The limits of a file; a larger number is damage or an attack.
constexpr std::uint32_t kMaxElements = 200000;
constexpr std::uint32_t kMaxSectors = 4096;
constexpr std::uint64_t kMaxStartStateBytes = std::uint64_t{64} << 20U;
constexpr std::uint32_t kMaxSupplementBytes = std::uint32_t{1} << 20U;
constexpr double kMinSessionRateHz = 100.0;
constexpr double kMaxSessionRateHz = 10000.0;
constexpr double kMaxSessionSeconds = 24.0 * 3600.0;
constexpr std::uint64_t kMaxSessionBytes = std::uint64_t{2} << 30U;

// The detail in which the records describe a tool: a plain tool, or all its fields. The numbers are in files:
// never renumber.
enum class ToolDetail : std::uint32_t { kPlain = 1, kWhole = 2 };

// The parameters of the whole session. The start state itself is opaque here: the game writes and reads it.
struct SessionHeader {
    double rate_hz = 1000.0;
    std::uint32_t element_count = 2000;
    std::uint32_t sector_count = 1;  // 1: the work is round everywhere
    ToolDetail tool_detail = ToolDetail::kPlain;
    std::uint64_t start_state_hash = 0;  // before the first tick

    friend bool operator==(const SessionHeader&, const SessionHeader&) = default;
};

// The check value of a tick's force. It suffices to find the tick from which a replay's forces differ. A
// packed block keeps half of its bits: one differing tick in 65536 is told by the tick after it.
[[nodiscard]] std::uint32_t force_check(const dvec3& force_n) noexcept;

// Whether a file's first bytes are a session's, intact or damaged.
[[nodiscard]] constexpr bool opens_a_session(std::string_view start) {
    return start.substr(0, kMagic.size()) == kMagic;
}

}  // namespace onggi::record
