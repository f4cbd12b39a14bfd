// A GLB put together by hand, for tests of readers: JSON as text and a binary chunk as numbers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace onggi::test {

// Appends numbers and tells where they begin.
class GlbBinary {
  public:
    template <typename T>
    std::size_t add(std::span<const T> values) {
        while (bytes_.size() % 4 != 0)
            bytes_.push_back(std::byte{0});
        const std::size_t begin = bytes_.size();
        const auto raw = std::as_bytes(values);
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
        return begin;
    }
    template <typename T>
    std::size_t add(const std::vector<T>& values) {
        return add(std::span<const T>(values));
    }
    [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
};

inline void add_word(std::vector<std::byte>& bytes, std::uint32_t word) {
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<std::byte>(word >> (8 * i) & 0xFF));
}

inline std::vector<std::byte> glb_of(std::string json, std::vector<std::byte> binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    std::vector<std::byte> file;
    add_word(file, 0x46546C67);
    add_word(file, 2);
    add_word(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    add_word(file, static_cast<std::uint32_t>(json.size()));
    add_word(file, 0x4E4F534A);
    for (const char c : json)
        file.push_back(static_cast<std::byte>(c));
    add_word(file, static_cast<std::uint32_t>(binary.size()));
    add_word(file, 0x004E4942);
    file.insert(file.end(), binary.begin(), binary.end());
    return file;
}

}  // namespace onggi::test
