// Corrects the checksums of a damaged session file, so that tests and fuzzers reach the checks behind them.
// Written from game/record/README.md, not from the code under test.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace onggi::test {

constexpr std::size_t kSessionHeaderBytes = 72;
constexpr std::size_t kSessionBlockHeadBytes = 40;

// Little-endian, as the machines of this house are.
template <typename T>
void put_at(std::string& bytes, std::size_t offset, T number) {
    std::memcpy(bytes.data() + offset, &number, sizeof number);
}

template <typename T>
[[nodiscard]] T get_at(std::string_view bytes, std::size_t offset) {
    T number{};
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

[[nodiscard]] inline std::uint32_t crc_of(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

// Precondition of both: the header, or the head of a block, is complete.
inline void mend_session_header(std::string& bytes) {
    put_at(bytes, 68, crc_of(std::string_view(bytes).substr(0, 68)));
}

// Returns the offset after the block, or 0 if it extends beyond the file.
inline std::size_t mend_session_block(std::string& bytes, std::size_t at) {
    const std::string_view view = bytes;
    std::size_t end = at + kSessionBlockHeadBytes;
    const bool is_packed = view.substr(at, 4) == "TCKP";
    if (is_packed || view.substr(at, 4) == "TCKS") {
        const std::size_t body_bytes = is_packed ? get_at<std::uint32_t>(view, at + 32)
                                                 : get_at<std::uint32_t>(view, at + 4) +
                                                       std::size_t{4} * get_at<std::uint32_t>(view, at + 16);
        end = body_bytes <= bytes.size() - end ? end + body_bytes : 0;
        if (end != 0) put_at(bytes, at + 20, crc_of(view.substr(end - body_bytes, body_bytes)));
    }
    put_at(bytes, at + 36, crc_of(view.substr(at, 36)));
    return end;
}

// Header, start state and every block, as far as the file goes.
inline void mend_session(std::string& bytes) {
    if (bytes.size() < kSessionHeaderBytes) return;
    const auto start_state_bytes = get_at<std::uint64_t>(bytes, 40);
    if (start_state_bytes > bytes.size() - kSessionHeaderBytes) {
        mend_session_header(bytes);
        return;
    }
    put_at(bytes, 56, crc_of(std::string_view(bytes).substr(kSessionHeaderBytes, start_state_bytes)));
    mend_session_header(bytes);
    std::size_t at = kSessionHeaderBytes + start_state_bytes;
    while (at != 0 && bytes.size() - at >= kSessionBlockHeadBytes)
        at = mend_session_block(bytes, at);
}

}  // namespace onggi::test
