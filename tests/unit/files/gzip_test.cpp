#include "engine/files/gzip.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/gunzip.h"

namespace onggi::files {
namespace {

TEST(Gzip, IsUnpackedToTheByteAndTheSameEachTime) {
    for (const std::size_t size : {0U, 1U, 1000U, 100'000U}) {
        std::string text;
        for (std::size_t i = 0; i < size; ++i)
            text += static_cast<char>(i * i % 251);
        const std::span bytes(reinterpret_cast<const std::byte*>(text.data()), text.size());
        const auto packed = gzip(bytes);
        ASSERT_TRUE(packed) << packed.error().message;
        EXPECT_EQ(test::gunzipped(*packed, size + 1), text);
        EXPECT_EQ(*gzip(bytes), *packed);
    }
}

}  // namespace
}  // namespace onggi::files
