// The session file, `.onggi`: what stands at its start, and the bounds of what it may hold. README.md gives
// the bytes.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/math/math.h"

namespace onggi::record {

// Not text, and spoilt by every kind of line-end conversion.
constexpr std::string_view kMagic{"\x89ONGGI\r\n", 8};
// What is added raises the minor version, and the older ones stay readable: README.md says how.
constexpr std::uint16_t kMajorVersion = 2;
constexpr std::uint16_t kMinorVersion = 1;     // 1: a supplement may stand before the end
constexpr std::uint32_t kHashInterval = 1000;  // ticks; a state hash, and a block, every so many

// What a file may hold at most; more is damage or malice, not a session.
constexpr std::uint32_t kMaxElements = 200000;
constexpr std::uint32_t kMaxSectors = 4096;
constexpr std::uint64_t kMaxStartStateBytes = std::uint64_t{64} << 20U;
constexpr std::uint32_t kMaxSupplementBytes = std::uint32_t{1} << 20U;
constexpr double kMinSessionRateHz = 100.0;
constexpr double kMaxSessionRateHz = 10000.0;
constexpr double kMaxSessionSeconds = 24.0 * 3600.0;
constexpr std::uint64_t kMaxSessionBytes = std::uint64_t{2} << 30U;

// What a tool says to the work that the start state speaks of: a plain tool, or all there is to one. The
// numbers are in files: never renumber.
enum class ToolDetail : std::uint32_t { kPlain = 1, kWhole = 2 };

// What the whole session rests on. The start state itself is opaque here: the game writes and reads it.
struct SessionHeader {
    double rate_hz = 1000.0;
    std::uint32_t element_count = 2000;
    std::uint32_t sector_count = 1;  // 1: work that is round everywhere
    ToolDetail tool_detail = ToolDetail::kPlain;
    std::uint64_t start_state_hash = 0;  // before the first tick

    friend bool operator==(const SessionHeader&, const SessionHeader&) = default;
};

// What is kept of a tick's force: enough to name the tick at which a replay begins to feel different.
[[nodiscard]] std::uint32_t force_check(const dvec3& force_n) noexcept;

// Whether a file's first bytes are those of a session, whole or damaged.
[[nodiscard]] constexpr bool opens_a_session(std::string_view start) {
    return start.substr(0, kMagic.size()) == kMagic;
}

}  // namespace onggi::record
