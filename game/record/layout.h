// Inside game/record only: where in the file what stands. README.md gives the same as a table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "game/tool/tool_bytes.h"

namespace onggi::record {

// The file header: 72 bytes, its own checksum last.
namespace header_at {
constexpr std::size_t kMajor = 8;
constexpr std::size_t kMinor = 10;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kRate = 16;
constexpr std::size_t kElements = 24;
constexpr std::size_t kSectors = 28;
constexpr std::size_t kFlags = 32;
constexpr std::size_t kToolDetail = 36;
constexpr std::size_t kStartStateBytes = 40;
constexpr std::size_t kStartStateHash = 48;
constexpr std::size_t kStartStateChecksum = 56;
constexpr std::size_t kHashInterval = 60;
constexpr std::size_t kReserved = 64;
constexpr std::size_t kChecksum = 68;
constexpr std::size_t kSize = 72;
}  // namespace header_at

// What opens every block and stands alone as the end marker: 40 bytes, its own checksum last.
namespace block_at {
constexpr std::size_t kTag = 0;
constexpr std::size_t kRecordBytes = 4;
constexpr std::size_t kFirstTick = 8;   // end marker: ticks in all
constexpr std::size_t kTickCount = 16;  // end marker: blocks in all
constexpr std::size_t kBodyChecksum = 20;
constexpr std::size_t kStateHash = 24;
constexpr std::size_t kReserved = 32;
constexpr std::size_t kChecksum = 36;
constexpr std::size_t kSize = 40;
}  // namespace block_at

constexpr std::uint32_t kTicksTag = 0x534b4354;       // "TCKS"
constexpr std::uint32_t kSupplementTag = 0x53444441;  // "ADDS"
constexpr std::uint32_t kEndTag = 0x2e444e45;         // "END."

// Records of a block's body: a kind, and what follows it.
enum class RecordKind : std::uint8_t {
    kTool = 1,      // x, y, z, radius (doubles, mm), button (byte): one tick
    kPosition = 2,  // x, y, z: one tick, the rest as in the tick before
    kRepeat = 3,    // how many (16 bits, at least 1): so many ticks more like the last
    // Of whole tools alone:
    kWholeTool = 4,      // a tool with all there is to it (tool_bytes.h): one tick
    kBothPositions = 5,  // both hands' x, y, z: one tick, the rest as in the tick before
};
constexpr std::size_t kToolBytes = 4 * 8 + 1;
constexpr std::size_t kPositionBytes = 3 * 8;
constexpr std::size_t kRepeatBytes = 2;
// What follows a kind; nothing for a byte that is no kind.
constexpr std::size_t record_bytes(RecordKind kind) {
    switch (kind) {
        case RecordKind::kTool:
            return kToolBytes;
        case RecordKind::kPosition:
            return kPositionBytes;
        case RecordKind::kRepeat:
            return kRepeatBytes;
        case RecordKind::kWholeTool:
            return tool::kWholeToolBytes;
        case RecordKind::kBothPositions:
            return tool::kBothPositionsBytes;
    }
    return 0;
}

constexpr std::size_t kCheckBytes = 4;  // force_check() of a tick, after the records

// CRC-32 of zlib (polynomial 0xedb88320).
[[nodiscard]] std::uint32_t checksum(std::span<const std::byte> bytes) noexcept;

}  // namespace onggi::record
