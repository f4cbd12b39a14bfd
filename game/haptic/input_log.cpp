#include "game/haptic/input_log.h"

#include <array>
#include <bit>
#include <cassert>

namespace onggi::haptic {
namespace {

// Five words a tick; what is kept is how each differs from that word of the ticks before: a mask of the eight
// bytes that are not zero, and those bytes.
constexpr std::size_t kWords = 5;
using Words = std::array<std::uint64_t, kWords>;

Words words_of(const LoggedInput& input) {
    return {std::bit_cast<std::uint64_t>(input.position_mm.x),
            std::bit_cast<std::uint64_t>(input.position_mm.y),
            std::bit_cast<std::uint64_t>(input.position_mm.z),
            std::uint64_t{input.second} << 32U | input.settings, input.force_check};
}

LoggedInput input_of(const Words& words) {
    return {.position_mm = {std::bit_cast<double>(words[0]), std::bit_cast<double>(words[1]),
                            std::bit_cast<double>(words[2])},
            .second = static_cast<std::uint32_t>(words[3] >> 32U),
            .settings = static_cast<std::uint32_t>(words[3]),
            .force_check = static_cast<std::uint32_t>(words[4])};
}

// A straight line goes on by the same difference: the number whose bits, read as one, stand as far from the
// last as the last from the one before.
std::uint64_t expected(std::uint64_t last, std::uint64_t before) {
    return last + (last - before);
}

}  // namespace

void InputLog::push_back(const LoggedInput& input) {
    if (newest_.capacity() < kBlock) newest_.reserve(kBlock);
    newest_.push_back(input);
    if (newest_.size() < kBlock) return;
    packed_.push_back(packed(newest_));
    newest_.clear();
}

void InputLog::shrink(std::size_t count) {
    assert(count <= size());
    if (count < packed_.size() * kBlock) {
        newest_ = unpacked(packed_[count / kBlock]);
        packed_.resize(count / kBlock);
    }
    newest_.resize(count - packed_.size() * kBlock);
}

std::size_t InputLog::bytes() const {
    std::size_t bytes = newest_.size() * sizeof(LoggedInput);
    for (const Packed& block : packed_)
        bytes += block.size();
    return bytes;
}

InputLog::Packed InputLog::packed(const std::vector<LoggedInput>& inputs) {
    Packed bytes;
    bytes.reserve(inputs.size() * kWords * sizeof(std::uint64_t));
    Words last{};
    Words before{};
    for (const LoggedInput& input : inputs) {
        const Words words = words_of(input);
        for (std::size_t word = 0; word < kWords; ++word) {
            const std::uint64_t difference = words[word] ^ expected(last[word], before[word]);
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
    const std::byte* from = bytes.data();
    while (inputs.size() < kBlock) {
        Words words{};
        for (std::size_t word = 0; word < kWords; ++word) {
            const std::byte mask = *from++;
            std::uint64_t difference = 0;
            for (std::size_t at = 0; at < sizeof difference; ++at) {
                if ((mask & static_cast<std::byte>(1U << at)) == std::byte{0}) continue;
                difference |= std::to_integer<std::uint64_t>(*from++) << (8U * at);
            }
            words[word] = difference ^ expected(last[word], before[word]);
        }
        inputs.push_back(input_of(words));
        before = last;
        last = words;
    }
    return inputs;
}

LoggedInput InputLog::Reader::next() {
    assert(next_ < log_.size());
    const std::size_t block = next_ / kBlock;
    const std::size_t at = next_++ % kBlock;
    if (block == log_.packed_.size()) return log_.newest_[at];
    if (block != block_) {
        inputs_ = unpacked(log_.packed_[block]);
        block_ = block;
    }
    return inputs_[at];
}

}  // namespace onggi::haptic
