// Decompresses gzip data with zlib.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <span>
#include <string>

namespace onggi::test {

// Returns at most `most` bytes; anything but a complete gzip file fails the test.
inline std::string gunzipped(std::span<const std::byte> packed, std::size_t most) {
    std::string plain(most, '\0');
    std::string input(reinterpret_cast<const char*>(packed.data()), packed.size());
    z_stream stream{};
    constexpr int kGzipOnly = 15 + 16;
    inflateInit2(&stream, kGzipOnly);
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = static_cast<uInt>(plain.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    plain.resize(stream.total_out);
    inflateEnd(&stream);
    return plain;
}

}  // namespace onggi::test
