#include "engine/files/gzip.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

namespace onggi::files {
namespace {

std::string unpacked(std::vector<std::byte> packed, std::size_t most) {
    std::string plain(most, '\0');
    z_stream stream{};
    constexpr int kGzipOnly = 15 + 16;
    inflateInit2(&stream, kGzipOnly);
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(plain.data());
    stream.avail_out = static_cast<uInt>(plain.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    plain.resize(stream.total_out);
    inflateEnd(&stream);
    return plain;
}

TEST(Gzip, IsUnpackedToTheByteAndTheSameEachTime) {
    for (const std::size_t size : {0U, 1U, 1000U, 100'000U}) {
        std::string text;
        for (std::size_t i = 0; i < size; ++i)
            text += static_cast<char>(i * i % 251);
        const std::span bytes(reinterpret_cast<const std::byte*>(text.data()), text.size());
        const auto packed = gzip(bytes);
        ASSERT_TRUE(packed) << packed.error().message;
        EXPECT_EQ(unpacked(*packed, size + 1), text);
        EXPECT_EQ(*gzip(bytes), *packed);
    }
}

}  // namespace
}  // namespace onggi::files
