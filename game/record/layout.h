// Offsets in the session file; only for game/record. README.md has the same as tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "game/tool/tool_bytes.h"

namespace onggi::record {

// The file header: 72 bytes; its checksum is last.
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

// The head of each block, also the end marker: 40 bytes; its checksum is last.
namespace block_at {
constexpr std::size_t kTag = 0;
constexpr std::size_t kRecordBytes = 4;
constexpr std::size_t kFirstTick = 8;   // end marker: number of ticks in the file
constexpr std::size_t kTickCount = 16;  // end marker: number of blocks in the file
constexpr std::size_t kBodyChecksum = 20;
constexpr std::size_t kStateHash = 24;
constexpr std::size_t kReserved = 32;
constexpr std::size_t kPackedBytes = 32;  // of a packed block
constexpr std::size_t kChecksum = 36;
constexpr std::size_t kSize = 40;
}  // namespace block_at

constexpr std::uint32_t kTicksTag = 0x534b4354;       // "TCKS"
constexpr std::uint32_t kPackedTag = 0x504b4354;      // "TCKP"
constexpr std::uint32_t kSupplementTag = 0x53444441;  // "ADDS"
constexpr std::uint32_t kEndTag = 0x2e444e45;         // "END."

// A record of a block's body: its kind, then its data.
enum class RecordKind : std::uint8_t {
    kTool = 1,      // x, y, z, radius (doubles, mm), button (byte): one tick
    kPosition = 2,  // x, y, z: one tick; the other fields as in the tick before
    kRepeat = 3,    // n (16 bits, at least 1): n more ticks equal to the last
    // Only in sessions of whole tools:
    kWholeTool = 4,      // all fields of a tool (tool_bytes.h): one tick
    kBothPositions = 5,  // both hands' x, y, z: one tick; the other fields as in the tick before
};
constexpr std::size_t kToolBytes = 4 * 8 + 1;
constexpr std::size_t kPositionBytes = 3 * 8;
constexpr std::size_t kRepeatBytes = 2;
// The number of data bytes of that kind; 0 for an unknown kind.
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

constexpr std::size_t kCheckBytes = 4;  // force_check() of each tick, after the records

// CRC-32 of zlib (polynomial 0xedb88320).
[[nodiscard]] std::uint32_t checksum(std::span<const std::byte> bytes) noexcept;

}  // namespace onggi::record
