#include "game/haptic/input_log.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace onggi::haptic {
namespace {

// Each tick has eight words. Each word is stored as its XOR with its prediction from the ticks before: a mask
// of the words that differ and, for each of these, a mask of its non-zero bytes and those bytes.
constexpr std::size_t kWords = 8;
using Words = std::array<std::uint64_t, kWords>;

Words words_of(const LoggedInput& input) {
    return {std::bit_cast<std::uint64_t>(input.position_mm.x),
            std::bit_cast<std::uint64_t>(input.position_mm.y),
            std::bit_cast<std::uint64_t>(input.position_mm.z),
            std::bit_cast<std::uint64_t>(input.second_position_mm.x),
            std::bit_cast<std::uint64_t>(input.second_position_mm.y),
            std::bit_cast<std::uint64_t>(input.second_position_mm.z),
            input.settings,
            input.force_check};
}

LoggedInput input_of(const Words& words) {
    return {.position_mm = {std::bit_cast<double>(words[0]), std::bit_cast<double>(words[1]),
                            std::bit_cast<double>(words[2])},
            .second_position_mm = {std::bit_cast<double>(words[3]), std::bit_cast<double>(words[4]),
                                   std::bit_cast<double>(words[5])},
            .settings = static_cast<std::uint32_t>(words[6]),
            .force_check = static_cast<std::uint32_t>(words[7])};
}

// Linear prediction of the bits: the difference between the last two values repeats.
std::uint64_t expected(std::uint64_t last, std::uint64_t before) {
    return last + (last - before);
}

}  // namespace

void InputLog::push_back(const LoggedInput& input) {
    if (newest_.capacity() < kBlock) newest_.reserve(kBlock);
    newest_.push_back(input);
    last_ = input;
    if (newest_.size() < kBlock) return;
    packed_.push_back(aside_.put(packed(newest_)));
    newest_.clear();
}

void InputLog::clear() {
    packed_.clear();
    newest_.clear();
    aside_.clear();
}

Result<void> InputLog::shrink(std::size_t count) {
    assert(count <= size());
    if (count == size()) return {};
    const std::size_t whole = count / kBlock;
    Result<void> read;
    if (whole < packed_.size()) {
        auto newest = block(whole);
        while (packed_.size() > whole) {
            aside_.take_back(packed_.back());
            packed_.pop_back();
        }
        newest_.clear();
        if (newest) newest_ = std::move(*newest);
        if (!newest) read = newest.error();
    }
    newest_.resize(std::min(newest_.size(), count - whole * kBlock));
    if (!newest_.empty()) {
        last_ = newest_.back();
    } else if (whole > 0) {
        auto before = block(whole - 1);
        if (!before) return before.error();
        last_ = before->back();
    }
    return read;
}

std::size_t InputLog::bytes() const {
    std::size_t bytes = newest_.size() * sizeof(LoggedInput);
    for (const files::SpillFile::Piece& piece : packed_)
        bytes += sizeof piece + piece.in_memory.size();
    return bytes;
}

InputLog::Packed InputLog::packed(const std::vector<LoggedInput>& inputs) {
    Packed bytes;
    bytes.reserve(inputs.size() * kWords * sizeof(std::uint64_t));
    Words last{};
    Words before{};
    for (const LoggedInput& input : inputs) {
        const Words words = words_of(input);
        const std::size_t changed_at = bytes.size();
        bytes.push_back(std::byte{0});
        for (std::size_t word = 0; word < kWords; ++word) {
            const std::uint64_t difference = words[word] ^ expected(last[word], before[word]);
            if (difference == 0) continue;
            bytes[changed_at] |= static_cast<std::byte>(1U << word);
            const std::size_t mask_at = bytes.size();
            bytes.push_back(std::byte{0});
            for (std::size_t at = 0; at < sizeof difference; ++at) {
                const auto byte = static_cast<std::byte>(difference >> (8U * at) & 0xffU);
                if (byte == std::byte{0}) continue;
                bytes[mask_at] |= static_cast<std::byte>(1U << at);
                bytes.push_back(byte);
            }
        }
        before = last;
        last = words;
    }
    bytes.shrink_to_fit();
    return bytes;
}

std::vector<LoggedInput> InputLog::unpacked(const Packed& bytes) {
    std::vector<LoggedInput> inputs;
    inputs.reserve(kBlock);
    Words last{};
    Words before{};
    const auto has = [](std::byte mask, std::size_t at) {
        return (mask & static_cast<std::byte>(1U << at)) != std::byte{0};
    };
    const std::byte* from = bytes.data();
    while (inputs.size() < kBlock) {
        Words words{};
        const std::byte changed = *from++;
        for (std::size_t word = 0; word < kWords; ++word) {
            std::uint64_t difference = 0;
            if (has(changed, word)) {
                const std::byte mask = *from++;
                for (std::size_t at = 0; at < sizeof difference; ++at) {
                    if (has(mask, at)) difference |= std::to_integer<std::uint64_t>(*from++) << (8U * at);
                }
            }
            words[word] = difference ^ expected(last[word], before[word]);
        }
        inputs.push_back(input_of(words));
        before = last;
        last = words;
    }
    return inputs;
}

Result<std::vector<LoggedInput>> InputLog::block(std::size_t which) const {
    auto bytes = aside_.get(packed_[which]);
    if (!bytes) return bytes.error();
    return unpacked(*bytes);
}

Result<const LoggedInput*> InputLog::Reader::next() {
    assert(next_ < log_.size());
    const std::size_t block = next_ / kBlock;
    const std::size_t at = next_++ % kBlock;
    if (block == log_.packed_.size()) return &log_.newest_[at];
    if (block != block_) {
        auto inputs = log_.block(block);
        if (!inputs) return inputs.error();
        inputs_ = std::move(*inputs);
        block_ = block;
    }
    return &inputs_[at];
}

}  // namespace onggi::haptic
