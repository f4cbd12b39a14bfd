// Spilled bytes are read back, from disk or memory, and no file is left behind.
#include "engine/files/spill_file.h"

#include <gtest/gtest.h>

#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

using Bytes = std::vector<std::byte>;
using Names = std::vector<std::string>;

Bytes bytes_of(std::size_t count, int seed) {
    Bytes bytes(count);
    for (std::size_t at = 0; at < count; ++at)
        bytes[at] = static_cast<std::byte>(at * 7 + static_cast<std::size_t>(seed));
    return bytes;
}

TEST(SpillFile, ReturnsTheStoredBytes) {
    const test::TemporaryFolder folder;
    SpillFile aside(folder / "deep/er");
    EXPECT_EQ(folder.names(), Names{}) << "nothing is touched before it is needed";
    std::vector<SpillFile::Piece> pieces;
    for (int i = 0; i < 20; ++i)
        pieces.push_back(aside.put(bytes_of(static_cast<std::size_t>(i * 1000), i)));
    EXPECT_EQ(aside.bytes_on_disk(), 190'000U);
    SpillFile moved(std::move(aside));
    for (int i = 19; i >= 0; --i) {
        EXPECT_TRUE(pieces[static_cast<std::size_t>(i)].in_memory.empty());
        auto back = moved.get(pieces[static_cast<std::size_t>(i)]);
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_EQ(*back, bytes_of(static_cast<std::size_t>(i * 1000), i));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "deep/er")) << "it has no name";
}

TEST(SpillFile, ReusesTheSpaceOfADroppedPiece) {
    const test::TemporaryFolder folder;
    SpillFile aside(folder.path());
    const auto first = aside.put(bytes_of(5000, 1));
    aside.take_back(aside.put(bytes_of(6000, 2)));
    const auto third = aside.put(bytes_of(7000, 3));
    EXPECT_EQ(aside.bytes_on_disk(), 12'000U);
    EXPECT_EQ(aside.get(first).value(), bytes_of(5000, 1));
    EXPECT_EQ(aside.get(third).value(), bytes_of(7000, 3));
    aside.clear();
    EXPECT_EQ(aside.bytes_on_disk(), 0U);
    EXPECT_EQ(aside.get(aside.put(bytes_of(10, 4))).value(), bytes_of(10, 4));
}

TEST(SpillFile, StaysInMemoryIfTheDiskFails) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "file", "no folder");
    for (const std::filesystem::path& place : {std::filesystem::path(), folder / "file"}) {
        SpillFile aside(place);
        const auto piece = aside.put(bytes_of(5000, 1));
        EXPECT_EQ(aside.bytes_on_disk(), 0U);
        EXPECT_EQ(piece.in_memory.size(), 5000U);
        EXPECT_EQ(aside.get(piece).value(), bytes_of(5000, 1));
    }
}

TEST(SpillFile, KeepsBytesInMemoryOnAFullDisk) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(test::in_child([&]() -> std::string {
                  test::limit_file_size(8000);
                  SpillFile aside(folder.path());
                  const auto fits = aside.put(bytes_of(5000, 1));
                  const auto does_not = aside.put(bytes_of(5000, 2));
                  if (aside.bytes_on_disk() != 5000) return "expected the first on the disk alone";
                  if (aside.get(fits).value() != bytes_of(5000, 1)) return "the first is another";
                  if (aside.get(does_not).value() != bytes_of(5000, 2)) return "the second is another";
                  return "both are there";
              }),
              "both are there");
}

TEST(SpillFile, ReportsAReadError) {
    const test::TemporaryFolder folder;
    SpillFile aside(folder.path());
    const auto piece = aside.put(bytes_of(5000, 1));
    aside.clear();
    const auto back = aside.get(piece);
    ASSERT_FALSE(back);
    EXPECT_NE(back.error().message.find("expected 5000 bytes, found 0"), std::string::npos)
        << back.error().message;
}

}  // namespace
}  // namespace onggi::files
