#include "engine/files/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include "engine/files/read_file.h"
#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

const std::string kLong(300'000, 'x');

void write_two(const fs::path& place) {
    auto writer = ArchiveWriter::create(place);
    ASSERT_TRUE(writer) << writer.error().message;
    ASSERT_TRUE(writer->add("a/empty", ""));
    ASSERT_TRUE(writer->add("a/long.txt", kLong));
    ASSERT_TRUE(writer->commit());
}

// Everything that can be read, and the line of the first error.
std::string line_of(const fs::path& place, std::size_t most_bytes = 1'000'000) {
    auto reader = ArchiveReader::open(place);
    if (!reader) return reader.error().message;
    for (;;) {
        const auto name = reader->next();
        if (!name) return name.error().message;
        if (!*name) return "";
        if (const auto content = reader->read(most_bytes); !content) return content.error().message;
    }
}

TEST(Archive, GivesBackWhatWasPutInToTheByteAndIsTheSameEveryTime) {
    const test::TemporaryFolder folder;
    write_two(folder / "one.zip");
    write_two(folder / "two.zip");
    EXPECT_EQ(test::content_of(folder / "one.zip"), test::content_of(folder / "two.zip"));
    auto reader = ArchiveReader::open(folder / "one.zip");
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_EQ(**reader->next(), "a/empty");
    EXPECT_EQ(*reader->read(10), "");
    EXPECT_EQ(**reader->next(), "a/long.txt");
    EXPECT_EQ(*reader->read(kLong.size()), kLong);
    EXPECT_FALSE(*reader->next());
}

TEST(Archive, AppearsWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "old.zip", "old");
    {
        auto writer = ArchiveWriter::create(folder / "old.zip");
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->add("a", kLong));
    }
    EXPECT_EQ(test::content_of(folder / "old.zip"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"old.zip"});
}

TEST(Archive, OnAFullDiskIsASystemThatLacksSpace) {
    const test::TemporaryFolder folder;
    const std::string answer = test::in_child([&]() -> std::string {
        if (!test::mount_small_disk(folder.path().string(), 64 << 10)) return "no mounts";
        std::string mixed(2'000'000, 'x');
        std::uint32_t seed = 1;
        for (char& letter : mixed)
            letter = static_cast<char>((seed = seed * 1'664'525U + 1'013'904'223U) >> 24U);
        auto writer = ArchiveWriter::create(folder / "full.zip");
        if (!writer) return writer.error().message;
        auto done = writer->add("a", mixed);
        if (done) done = writer->commit();
        if (done || done.error().kind != ErrorKind::kSystemLacks) return "no full disk";
        return done.error().message;
    });
    if (answer == "no mounts") GTEST_SKIP() << "no mounts of its own";
    EXPECT_EQ(answer, (folder / "full.zip").string() + ": cannot write: No space left on device");
}

TEST(Archive, RejectsWhatIsNoWholeZip) {
    const test::TemporaryFolder folder;
    write_two(folder / "whole.zip");
    const std::string whole = test::content_of(folder / "whole.zip");
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        test::put_file(folder / "cut.zip", whole.substr(0, size));
        EXPECT_NE(line_of(folder / "cut.zip"), "") << size << " of " << whole.size() << " bytes";
    }
    test::put_file(folder / "text.zip", "a text");
    EXPECT_EQ(line_of(folder / "text.zip"),
              (folder / "text.zip").string() +
                  ": expected a whole ZIP file, found another kind of file, or a part");
    EXPECT_EQ(line_of(folder / "none.zip"), (folder / "none.zip").string() + ": no such file");
    EXPECT_EQ(line_of(folder.path()), folder.path().string() + ": expected a file, found a folder");
}

TEST(Archive, RejectsEveryChangedByteOfItsContent) {
    const test::TemporaryFolder folder;
    auto writer = ArchiveWriter::create(folder / "whole.zip");
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->add("a.txt", "Once upon a time there was a pot, and the pot was round and red."));
    ASSERT_TRUE(writer->commit());
    const std::string whole = test::content_of(folder / "whole.zip");
    const std::size_t begins = whole.find("a.txt");
    const std::size_t ends = whole.find("PK\x01\x02");
    int unnoticed = 0;
    for (std::size_t at = begins; at < ends; ++at) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 0x10);
        test::put_file(folder / "changed.zip", changed);
        auto reader = ArchiveReader::open(folder / "changed.zip");
        ASSERT_TRUE(reader);
        const auto name = reader->next();
        const auto content = name && *name ? reader->read(1000) : Result<std::string>(bad_input(""));
        // A byte of the head that means nothing may change; the name and the content may not.
        if (content && *name == std::optional<std::string>("a.txt")) {
            EXPECT_EQ(*content, "Once upon a time there was a pot, and the pot was round and red.") << at;
        }
        unnoticed += content ? 1 : 0;
    }
    EXPECT_LT(unnoticed, 60) << "of " << ends - begins;
}

TEST(Archive, RejectsLinksPipesAndContentBeyondItsBound) {
    const test::TemporaryFolder folder;
    const fs::path place = folder / "link.zip";
    archive* const into = archive_write_new();
    archive_write_set_format_zip(into);
    ASSERT_EQ(archive_write_open_filename(into, place.c_str()), ARCHIVE_OK);
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, "a/door");
    archive_entry_set_filetype(entry, AE_IFLNK);
    archive_entry_set_symlink(entry, "/etc");
    ASSERT_EQ(archive_write_header(into, entry), ARCHIVE_OK);
    archive_entry_free(entry);
    archive_write_free(into);
    EXPECT_EQ(line_of(place), place.string() + ", a/door: expected a plain file, found a link");

    write_two(folder / "long.zip");
    EXPECT_EQ(line_of(folder / "long.zip", 1000),
              (folder / "long.zip").string() + ", a/long.txt: expected at most 1000 bytes, found more");
    EXPECT_EQ(line_of(folder / "long.zip", kLong.size()), "");
}

}  // namespace
}  // namespace onggi::files
