// Visitors that hash, write or read a clay's state number by number, all by one list of its members. Any
// thread; hashing allocates nothing.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/core/hash.h"
#include "engine/core/little_endian.h"

namespace onggi::clay {

// Hashes every number of a state.
class StateHasher {
  public:
    void number(const double& value) { hash_.add(value); }
    void number(const float& value) { hash_.add_word(std::bit_cast<std::uint32_t>(value)); }
    void number(const bool& value) { hash_.add_word(value ? 1 : 0); }
    void number(const int& value) { hash_.add_word(static_cast<std::uint32_t>(value)); }
    void number(const std::uint64_t& value) { hash_.add_word(value); }
    void numbers(std::span<const double> values) { hash_.add_bytes(std::as_bytes(values)); }
    void numbers(std::span<const float> values) { hash_.add(values); }
    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

  private:
    StateHash hash_;
};

// Writes little-endian; a bool is a word of 1 or 0.
class StateWriter {
  public:
    void number(const double& value) { little_endian::put(bytes_, value); }
    void number(const float& value) { little_endian::put(bytes_, value); }
    void number(const bool& value) { little_endian::put(bytes_, std::uint32_t{value ? 1U : 0U}); }
    void number(const int& value) { little_endian::put(bytes_, static_cast<std::uint32_t>(value)); }
    void number(const std::uint32_t& value) { little_endian::put(bytes_, value); }
    void number(const std::uint64_t& value) { little_endian::put(bytes_, value); }
    template <typename T>
    void numbers(std::span<const T> values) {
        for (const T& value : values)
            number(value);
    }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

// Reads zeros past the end, and remembers that (is_short()). Also remembers the first bool that was neither 0
// nor 1.
class StateReader {
  public:
    explicit StateReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    void number(double& value) { value = std::bit_cast<double>(take<std::uint64_t>()); }
    void number(float& value) { value = std::bit_cast<float>(take<std::uint32_t>()); }
    void number(bool& value) {
        const auto word = take<std::uint32_t>();
        if (word > 1 && !strange_) strange_ = word;
        value = word == 1;
    }
    void number(int& value) { value = static_cast<int>(take<std::uint32_t>()); }
    void number(std::uint32_t& value) { value = take<std::uint32_t>(); }
    void number(std::uint64_t& value) { value = take<std::uint64_t>(); }
    template <typename T>
    void numbers(std::span<T> values) {
        for (T& value : values)
            number(value);
    }
    [[nodiscard]] bool is_short() const { return short_; }
    // The first word read for a bool that was neither 0 nor 1.
    [[nodiscard]] std::optional<std::uint32_t> strange() const { return strange_; }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
    // Bytes that all reads together needed, past the end included.
    [[nodiscard]] std::size_t asked() const { return asked_; }

  private:
    template <typename Word>
    Word take() {
        asked_ += sizeof(Word);
        if (left() < sizeof(Word)) {
            short_ = true;
            return 0;
        }
        at_ += sizeof(Word);
        return little_endian::get<Word>(bytes_.data() + at_ - sizeof(Word));
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    std::size_t asked_ = 0;
    bool short_ = false;
    std::optional<std::uint32_t> strange_;
};

// Visits a number, an enumeration as a word, or a vector by its coordinates.
template <typename Visitor, typename T>
void visit_one(Visitor& visitor, T& value) {
    if constexpr (std::is_enum_v<T>) {
        int number = static_cast<int>(value);
        visitor.number(number);
        if constexpr (!std::is_const_v<T>) {
            // A word too large for the enumeration's type must not alias a valid value.
            constexpr int kUnknown = 0xff;
            value = static_cast<T>(number);
            if (static_cast<int>(value) != number) value = static_cast<T>(kUnknown);
        }
    } else if constexpr (requires { value.x; }) {
        visitor.number(value.x);
        visitor.number(value.y);
        if constexpr (requires { value.z; }) visitor.number(value.z);
    } else {
        visitor.number(value);
    }
}

template <typename Visitor, typename... T>
void visit(Visitor& visitor, T&... values) {
    (visit_one(visitor, values), ...);
}

}  // namespace onggi::clay
