#include "game/record/packed_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "engine/core/little_endian.h"
#include "engine/core/within_memory.h"
#include "game/record/zigzag.h"

namespace onggi::record {
namespace {

using Word = std::uint32_t;

// A stretch of words is coded as one common offset, and each word's difference from it.
constexpr std::size_t kStretch = 64;
// A chunk is deflated at once, with the same bytes of all its words together: the high bytes are nearly all
// zero, so they form long runs.
constexpr std::size_t kChunk = 256 * kStretch;
constexpr std::size_t kTold = kChunk + kChunk / kStretch;
using Told = std::array<Word, kTold>;
using ToldBytes = std::array<std::byte, kTold * sizeof(Word)>;

constexpr Word kSign = Word{1} << 31U;

// Maps a float's bits to an order in which the next integer is the next larger float.
Word in_order(Word bits) {
    return (bits & kSign) != 0 ? bits ^ ~kSign : bits;
}

// Adds the offset to a float. Bits that are not a finite number stay unchanged.
Word moved(Word bits, float by) {
    const auto number = std::bit_cast<float>(bits);
    return by != 0.0F && std::isfinite(number) ? std::bit_cast<Word>(number + by) : bits;
}

Word difference(Word bits, Word from, float by) {
    return folded(in_order(bits) - in_order(moved(from, by)));
}
Word restored(Word difference, Word from, float by) {
    // in_order() is its own inverse.
    return in_order(unfolded(difference) + in_order(moved(from, by)));
}

// Divides the bytes into words that end with the last byte. An incomplete first word is padded.
class Words {
  public:
    explicit Words(std::size_t bytes)
        : first_((sizeof(Word) - bytes % sizeof(Word)) % sizeof(Word)),
          bytes_(bytes) {}
    [[nodiscard]] std::size_t count() const { return (first_ + bytes_) / sizeof(Word); }

    [[nodiscard]] Word get(std::span<const std::byte> from, std::size_t word) const {
        const std::size_t at = word * sizeof(Word);
        if (at >= first_ && at - first_ + sizeof(Word) <= from.size())
            return little_endian::get<Word>(from.data() + (at - first_));
        Word bits = 0;
        for (std::size_t byte = 0; byte < sizeof(Word); ++byte) {
            if (at + byte >= first_ && at + byte - first_ < from.size())
                bits |= std::to_integer<Word>(from[at + byte - first_]) << (8U * byte);
        }
        return bits;
    }
    void set(std::span<std::byte> to, std::size_t word, Word bits) const {
        const std::size_t at = word * sizeof(Word);
        for (std::size_t byte = 0; byte < sizeof(Word); ++byte) {
            if (at + byte >= first_)
                to[at + byte - first_] = static_cast<std::byte>(bits >> (8U * byte) & 0xffU);
        }
    }

  private:
    std::size_t first_;  // bytes missing from the first word
    std::size_t bytes_;
};

// Returns the common offset of a stretch: the median of three of its words' differences, or 0 if coding with
// it is not smaller.
float movement(std::span<const Word> words, std::span<const Word> from) {
    const auto of = [&](std::size_t at) {
        const float by = std::bit_cast<float>(words[at]) - std::bit_cast<float>(from[at]);
        return std::isfinite(by) ? by : 0.0F;
    };
    const float a = of(words.size() / 4);
    const float b = of(words.size() / 2);
    const float c = of(words.size() * 3 / 4);
    const float by = std::max(std::min(a, b), std::min(std::max(a, b), c));
    if (by == 0.0F) return 0.0F;
    int bits_moved = 32;
    int bits_standing = 0;
    for (std::size_t at = 0; at < words.size(); ++at) {
        bits_moved += static_cast<int>(std::bit_width(difference(words[at], from[at], by)));
        bits_standing += static_cast<int>(std::bit_width(difference(words[at], from[at], 0.0F)));
    }
    return bits_moved < bits_standing ? by : 0.0F;
}

constexpr std::size_t stretches_of(std::size_t words) {
    return (words + kStretch - 1) / kStretch;
}

// Calls act(first word, end word, index of the stretch) for each stretch of the chunk that begins at `first`.
template <typename Act>
void for_stretches(std::size_t first, std::size_t words, const Act& act) {
    for (std::size_t at = 0; at < words; at += kStretch)
        act(first + at, first + std::min(words, at + kStretch), at / kStretch);
}

// A lack of memory is told as such; any other failure on our own bytes is a bug. Both throw.
void expect(bool well, int said, const char* what) {
    if (said == Z_MEM_ERROR) refuse_memory();
    if (!well) throw std::runtime_error(what);
}

class Deflater {
  public:
    Deflater() {
        // Z_RLE searches only for runs: half the time of a search for all matches, and the result is as
        // small, because most bytes are zero.
        constexpr int kWindowBits = 15;
        constexpr int kMemoryLevel = 9;
        const int said = deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, kWindowBits, kMemoryLevel, Z_RLE);
        expect(said == Z_OK, said, "pack: another zlib");
    }
    ~Deflater() { deflateEnd(&stream_); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    void take(std::span<std::byte> bytes, bool last, std::vector<std::byte>& deflated) {
        stream_.next_in = reinterpret_cast<Bytef*>(bytes.data());
        stream_.avail_in = static_cast<uInt>(bytes.size());
        do {
            stream_.next_out = reinterpret_cast<Bytef*>(out_.data());
            stream_.avail_out = static_cast<uInt>(out_.size());
            deflate(&stream_, last ? Z_FINISH : Z_NO_FLUSH);
            deflated.insert(deflated.end(), out_.data(), out_.data() + (out_.size() - stream_.avail_out));
        } while (stream_.avail_out == 0);
    }

  private:
    z_stream stream_{};
    std::array<std::byte, std::size_t{16} << 10U> out_;
};

class Inflater {
  public:
    explicit Inflater(const std::vector<std::byte>& deflated) {
        const int said = inflateInit(&stream_);
        expect(said == Z_OK, said, "unpack: another zlib");
        // zlib only reads here, but its API takes a non-const pointer.
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(deflated.data()));
        stream_.avail_in = static_cast<uInt>(deflated.size());
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    void give(std::span<std::byte> bytes) {
        stream_.next_out = reinterpret_cast<Bytef*>(bytes.data());
        stream_.avail_out = static_cast<uInt>(bytes.size());
        const int said = inflate(&stream_, Z_SYNC_FLUSH);
        expect((said == Z_OK || said == Z_STREAM_END) && stream_.avail_out == 0, said,
               "unpack: these bytes were packed otherwise");
    }

  private:
    z_stream stream_{};
};

}  // namespace

PackedBytes pack(std::span<const std::byte> bytes, std::span<const std::byte> like) {
    PackedBytes packed{.deflated = {}, .size = bytes.size()};
    const Words words(bytes.size());
    Deflater deflater;
    Told told;
    ToldBytes lanes;
    std::array<Word, kStretch> now;
    std::array<Word, kStretch> before;
    for (std::size_t first = 0; first < words.count(); first += kChunk) {
        const std::size_t count = std::min(kChunk, words.count() - first);
        const std::size_t all = count + stretches_of(count);
        for_stretches(first, count, [&](std::size_t from, std::size_t end, std::size_t stretch) {
            const std::size_t size = end - from;
            for (std::size_t at = 0; at < size; ++at) {
                now[at] = words.get(bytes, from + at);
                before[at] = words.get(like, from + at);
            }
            const float by = movement(std::span(now).first(size), std::span(before).first(size));
            told[count + stretch] = std::bit_cast<Word>(by);
            for (std::size_t at = 0; at < size; ++at)
                told[from - first + at] = difference(now[at], before[at], by);
        });
        for (std::size_t at = 0; at < all; ++at) {
            for (std::size_t lane = 0; lane < sizeof(Word); ++lane)
                lanes[lane * all + at] = static_cast<std::byte>(told[at] >> (8U * lane) & 0xffU);
        }
        deflater.take(std::span(lanes).first(all * sizeof(Word)), first + count == words.count(),
                      packed.deflated);
    }
    packed.deflated.shrink_to_fit();
    return packed;
}

std::vector<std::byte> unpack(const PackedBytes& packed, std::span<const std::byte> like) {
    std::vector<std::byte> bytes(packed.size);
    const Words words(bytes.size());
    Inflater inflater(packed.deflated);
    ToldBytes lanes;
    for (std::size_t first = 0; first < words.count(); first += kChunk) {
        const std::size_t count = std::min(kChunk, words.count() - first);
        const std::size_t all = count + stretches_of(count);
        inflater.give(std::span(lanes).first(all * sizeof(Word)));
        const auto told = [&](std::size_t at) {
            Word word = 0;
            for (std::size_t lane = 0; lane < sizeof(Word); ++lane)
                word |= std::to_integer<Word>(lanes[lane * all + at]) << (8U * lane);
            return word;
        };
        for_stretches(first, count, [&](std::size_t from, std::size_t end, std::size_t stretch) {
            const auto by = std::bit_cast<float>(told(count + stretch));
            for (std::size_t word = from; word < end; ++word)
                words.set(bytes, word, restored(told(word - first), words.get(like, word), by));
        });
    }
    return bytes;
}

}  // namespace onggi::record
