#include "game/record/packed_block.h"

#include <zlib.h>

#include <array>

#include "engine/core/little_endian.h"
#include "engine/core/within_memory.h"
#include "game/record/layout.h"
#include "game/record/zigzag.h"

namespace onggi::record {
namespace {

using Bits = std::uint64_t;  // of a coordinate
constexpr std::size_t kWordBytes = sizeof(Bits);
constexpr std::size_t kCoordinates = 6;  // of both hands

// The number of coordinates that a record holds in place of its data; 0 if it keeps its data.
std::size_t words_of(RecordKind kind) {
    const bool moves = kind == RecordKind::kPosition || kind == RecordKind::kBothPositions;
    return moves ? record_bytes(kind) / kWordBytes : 0;
}

// Predicts the bits of a coordinate from its last two values: a hand moves on as it did. The difference is
// folded, so that small ones of either sign are small words.
class Places {
  public:
    // A whole tool: its coordinates are the last two.
    void begin(RecordKind kind, const std::byte* data) {
        const std::size_t count = kind == RecordKind::kWholeTool ? kCoordinates : kCoordinates / 2;
        last_ = {};
        for (std::size_t at = 0; at < count; ++at)
            last_[at] = little_endian::get<Bits>(data + at * kWordBytes);
        before_ = last_;
    }
    [[nodiscard]] Bits difference(std::size_t at, Bits word) {
        const Bits by = word - expected(at);
        move(at, word);
        return folded(by);
    }
    [[nodiscard]] Bits restored(std::size_t at, Bits by) {
        const Bits word = expected(at) + unfolded(by);
        move(at, word);
        return word;
    }

  private:
    [[nodiscard]] Bits expected(std::size_t at) const { return 2 * last_[at] - before_[at]; }
    void move(std::size_t at, Bits word) {
        before_[at] = last_[at];
        last_[at] = word;
    }

    std::array<Bits, kCoordinates> last_{};
    std::array<Bits, kCoordinates> before_{};
};

bool is_tool(RecordKind kind) {
    return kind == RecordKind::kTool || kind == RecordKind::kWholeTool;
}

const Bytef* zlib_bytes(std::span<const std::byte> bytes) {
    return reinterpret_cast<const Bytef*>(bytes.data());
}

}  // namespace

std::vector<std::byte> pack_block(std::span<const std::byte> records, std::span<const std::uint32_t> checks) {
    std::vector<std::byte> lanes;
    lanes.reserve(records.size() + checks.size() * kPackedCheckBytes);
    std::vector<Bits> words;
    Places places;
    for (std::size_t at = 0; at < records.size();) {
        const auto kind = static_cast<RecordKind>(records[at]);
        const auto data = records.subspan(at + 1, record_bytes(kind));
        lanes.push_back(records[at]);
        if (is_tool(kind)) places.begin(kind, data.data());
        const std::size_t count = words_of(kind);
        for (std::size_t word = 0; word < count; ++word)
            words.push_back(
                places.difference(word, little_endian::get<Bits>(data.data() + word * kWordBytes)));
        if (count == 0) lanes.insert(lanes.end(), data.begin(), data.end());
        at += 1 + data.size();
    }
    const auto put_lanes = [&](const auto& numbers, std::size_t bytes) {
        for (std::size_t lane = 0; lane < bytes; ++lane) {
            for (const auto number : numbers)
                lanes.push_back(static_cast<std::byte>(number >> (8U * lane) & 0xffU));
        }
    };
    put_lanes(words, kWordBytes);
    std::vector<std::uint16_t> halves;
    halves.reserve(checks.size());
    for (const std::uint32_t check : checks)
        halves.push_back(packed_check(check));
    put_lanes(halves, kPackedCheckBytes);

    uLongf size = ::compressBound(static_cast<uLong>(lanes.size()));
    std::vector<std::byte> packed(size);
    const int said = ::compress(reinterpret_cast<Bytef*>(packed.data()), &size, zlib_bytes(lanes),
                                static_cast<uLong>(lanes.size()));
    if (said != Z_OK) refuse_memory();  // it has room for any bytes
    packed.resize(size);
    return packed;
}

std::optional<std::vector<std::byte>> unpack_block(std::span<const std::byte> packed,
                                                   std::size_t record_bytes_wanted, std::size_t tick_count) {
    std::vector<std::byte> lanes(record_bytes_wanted + tick_count * kPackedCheckBytes);
    uLongf size = static_cast<uLongf>(lanes.size());
    uLong used = static_cast<uLong>(packed.size());
    const int said = ::uncompress2(reinterpret_cast<Bytef*>(lanes.data()), &size, zlib_bytes(packed), &used);
    if (said == Z_MEM_ERROR) refuse_memory();
    if (said != Z_OK || size != lanes.size() || used != packed.size()) return std::nullopt;

    // Where the words begin: after the kinds and what else the records hold.
    std::size_t words_at = 0;
    std::size_t word_count = 0;
    while (words_at + word_count * kWordBytes < record_bytes_wanted) {
        const auto kind = static_cast<RecordKind>(lanes[words_at]);
        const std::size_t data = record_bytes(kind);
        if (data == 0) return std::nullopt;
        const std::size_t count = words_of(kind);
        word_count += count;
        words_at += count > 0 ? 1 : 1 + data;
    }
    if (words_at + word_count * kWordBytes != record_bytes_wanted) return std::nullopt;

    const auto number_at = [&](std::size_t first, std::size_t bytes, std::size_t count, std::size_t at) {
        Bits number = 0;
        for (std::size_t lane = 0; lane < bytes; ++lane)
            number |= std::to_integer<Bits>(lanes[first + lane * count + at]) << (8U * lane);
        return number;
    };
    std::vector<std::byte> bytes;
    bytes.reserve(lanes.size());
    Places places;
    std::size_t word = 0;
    for (std::size_t at = 0; at < words_at;) {
        const auto kind = static_cast<RecordKind>(lanes[at]);
        bytes.push_back(lanes[at++]);
        const std::size_t count = words_of(kind);
        for (std::size_t coordinate = 0; coordinate < count; ++coordinate, ++word)
            little_endian::put(
                bytes, places.restored(coordinate, number_at(words_at, kWordBytes, word_count, word)));
        if (count > 0) continue;
        const auto data = std::span(lanes).subspan(at, record_bytes(kind));
        if (is_tool(kind)) places.begin(kind, data.data());
        bytes.insert(bytes.end(), data.begin(), data.end());
        at += data.size();
    }
    for (std::size_t tick = 0; tick < tick_count; ++tick)
        little_endian::put(bytes, static_cast<std::uint16_t>(
                                      number_at(record_bytes_wanted, kPackedCheckBytes, tick_count, tick)));
    return bytes;
}

}  // namespace onggi::record
