// Listing a folder, also on a disk that fails during the listing.
#include "engine/core/list_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi {
namespace {

TEST(ListFolder, FindsAllEntries) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "b", "");
    test::put_file(folder / ".a", "");
    std::filesystem::create_directory(folder / "c");
    FolderListing listing = list_folder(folder.path());
    EXPECT_TRUE(listing.is_whole());
    std::sort(listing.entries.begin(), listing.entries.end());
    EXPECT_EQ(listing.entries,
              (std::vector<std::filesystem::path>{folder / ".a", folder / "b", folder / "c"}));
}

TEST(ListFolder, IsEmptyWithoutAFolder) {
    const test::TemporaryFolder folder;
    const FolderListing listing = list_folder(folder / "nowhere");
    EXPECT_TRUE(listing.is_whole());
    EXPECT_TRUE(listing.entries.empty());
}

TEST(ListFolder, ReportsAFileInOneLine) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "file", "");
    const FolderListing listing = list_folder(folder / "file");
    EXPECT_FALSE(listing.is_whole());
    EXPECT_EQ(
        listing_trouble(folder / "file", listing),
        (folder / "file").string() + ": expected to list all that is in this folder, found: Not a directory");
}

TEST(ListFolder, KeepsItsEntriesIfTheDiskFails) {
    const test::TemporaryFolder folder;
    for (int i = 0; i < 40; ++i)
        test::put_file(folder / ("file-" + std::to_string(i)), "");
    const auto listed_after = [&](int pieces) {
        return test::in_child([&]() -> std::string {
            if (!test::fail_listings_after(pieces)) return "no such kernel";
            const FolderListing listing = list_folder(folder.path());
            const std::size_t count = listing.entries.size();
            const bool is_some = count > 0 && count < 40;
            return (count == 0 ? "none"
                    : is_some  ? "some"
                               : "all") +
                   (listing.is_whole() ? std::string() : "; " + listing.error.message());
        });
    };
#ifdef __aarch64__
    if (listed_after(0) == "no such kernel") GTEST_SKIP() << "qemu-user filters no system calls";
#endif
    EXPECT_EQ(listed_after(0), "none; Input/output error");
    EXPECT_EQ(listed_after(3), "some; Input/output error");
    EXPECT_EQ(listed_after(1000), "all");
}

}  // namespace
}  // namespace onggi
