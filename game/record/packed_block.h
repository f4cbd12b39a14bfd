// The packed body of a session's block: its records and checks in about a sixth of their bytes. README.md
// describes them. Any thread but the haptic one; allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace onggi::record {

constexpr std::size_t kPackedCheckBytes = 2;
// Of a tick's force_check(): both halves in one, because a number's upper bits reach only the upper half.
constexpr std::uint16_t packed_check(std::uint32_t check) {
    return static_cast<std::uint16_t>(check ^ (check >> 16U));
}

// records: as SessionWriter writes them; checks: force_check() of each tick. Throws if there is no memory.
[[nodiscard]] std::vector<std::byte> pack_block(std::span<const std::byte> records,
                                                std::span<const std::uint32_t> checks);
// Returns record_bytes of records, and after them the checks of tick_count ticks. Nothing if the bytes are
// not those of such a block; the records' content is not checked. Throws if there is no memory.
[[nodiscard]] std::optional<std::vector<std::byte>> unpack_block(std::span<const std::byte> packed,
                                                                 std::size_t record_bytes,
                                                                 std::size_t tick_count);

}  // namespace onggi::record
