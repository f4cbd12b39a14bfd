#include "engine/files/atomic_folder.h"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "engine/files/atomic_file.h"
#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

TEST(AtomicFolder, IsCompleteOrAbsent) {
    const test::TemporaryFolder folder;
    {
        auto dropped = AtomicFolder::create(folder / "pot");
        ASSERT_TRUE(dropped);
        test::put_file(dropped->inside() / "file", "half");
    }
    EXPECT_TRUE(folder.names().empty());
    auto kept = AtomicFolder::create(folder / "pot");
    ASSERT_TRUE(kept);
    test::put_file(kept->inside() / "file", "whole");
    EXPECT_FALSE(fs::exists(folder / "pot"));
    ASSERT_TRUE(kept->commit());
    EXPECT_EQ(test::content_of(folder / "pot/file"), "whole");
    EXPECT_FALSE(AtomicFolder::create(folder / "pot")) << "it is taken";
}

TEST(AtomicFolder, IsRemovedWithItsContentsAndAKilledProgramsParts) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "pot/inner");
    test::put_file(folder / "pot/inner/file", "pot");
    fs::create_directories(folder / "pot.part");
    test::put_file(folder / "pot.part/old", "half");
    ASSERT_TRUE(take_away_folder(folder / "pot"));
    EXPECT_TRUE(folder.names().empty());
    const auto none = take_away_folder(folder / "pot");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(none.error().message, (folder / "pot").string() + ": expected a folder, found none");
}

// A kiosk whose system is read-only below and written above: what was there before cannot be renamed (EXDEV).
TEST(AtomicFolder, IsTakenAwayFromTheLowerLayerOfAnOverlay) {
    const test::TemporaryFolder folder;
    const std::string answer = test::in_child([&]() -> std::string {
        const std::string at = folder.path().string();
        if (!test::enter_own_mounts() || ::mount("none", at.c_str(), "tmpfs", 0, nullptr) != 0)
            return "no mounts";
        for (const char* place : {"lower/pot/inner", "upper", "work", "seen"})
            fs::create_directories(folder / place);
        test::put_file(folder / "lower/pot/inner/file", "pot");
        const std::string layers =
            "lowerdir=" + at + "/lower,upperdir=" + at + "/upper,workdir=" + at + "/work";
        if (::mount("none", (at + "/seen").c_str(), "overlay", 0, layers.c_str()) != 0) return "no overlay";
        std::error_code error;
        fs::rename(folder / "seen/pot", folder / "seen/other", error);
        if (error != std::errc::cross_device_link) return "no longer refused: " + error.message();
        const auto gone = take_away_folder(folder / "seen/pot");
        if (!gone) return gone.error().message;
        auto again = AtomicFolder::create(folder / "seen/pot");
        if (!again) return again.error().message;
        const auto kept = again->commit();
        if (!kept) return kept.error().message;
        return fs::exists(folder / "lower/pot/inner/file") ? "gone and made again"
                                                           : "the lower layer was written";
    });
    if (answer == "no mounts" || answer == "no overlay")
        GTEST_SKIP() << "this system grants a test " << answer;
    EXPECT_EQ(answer, "gone and made again");
}

TEST(AtomicFolder, IsKeptOnAFileSystemThatSyncsNoFolder) {
    const test::TemporaryFolder folder;
    const auto kept_with = [&](int error) {
        return test::in_child([&]() -> std::string {
            if (!test::refuse_folder_syncs(error)) return "no filter";
            auto pot = AtomicFolder::create(folder / std::to_string(error));
            if (!pot) return pot.error().message;
            const auto written = write_file_atomically(pot->inside() / "file", "pot");
            const auto done = written ? pot->commit() : written;
            if (!done) return done.error().message;
            return folder_sync_was_refused() ? "kept, and it is known" : "kept";
        });
    };
    for (const int error : {EINVAL, ENOTSUP, ENOSYS})
        EXPECT_EQ(kept_with(error), "kept, and it is known") << error;
    EXPECT_NE(kept_with(EIO).find("sync the folder: Input/output error"), std::string::npos)
        << kept_with(EIO);
}

TEST(AtomicFolder, RemovesOnlyParts) {
    const test::TemporaryFolder folder;
    for (const char* place : {"day.part/pot", "day/pot.part/inner", "day/pot/inner.part"})
        fs::create_directories(folder / place);
    test::put_file(folder / "file.part", "a file");
    clear_parts(folder.path());
    EXPECT_FALSE(fs::exists(folder / "day.part"));
    EXPECT_TRUE(fs::exists(folder / "day/pot.part"));
    clear_parts(folder.path(), true);
    EXPECT_FALSE(fs::exists(folder / "day/pot.part"));
    EXPECT_TRUE(fs::exists(folder / "day/pot/inner.part"));
    EXPECT_TRUE(fs::exists(folder / "file.part"));
}

TEST(AtomicFolder, TakesAwayFilesBesideOfProcessesThatAreNoMore) {
    const test::TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    const std::string left = ".onggi-" + std::to_string(child) + "-0.part";
    const std::string mine = ".onggi-" + std::to_string(::getpid()) + "-0.part";
    for (const std::string& name : {left, mine, std::string(".onggi-x.part")})
        test::put_file(folder / name, "half");
    clear_parts(folder.path());
    EXPECT_EQ(folder.names().size(), 2U);
    EXPECT_FALSE(fs::exists(folder / left));
}

TEST(MoveIntoPlace, ReplacesAFileAndMakesTheFolderAround) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "new", "new");
    fs::create_directories(folder / "here");
    test::put_file(folder / "here/file", "old");
    ASSERT_TRUE(move_into_place(folder / "new", folder / "here/file"));
    EXPECT_EQ(test::content_of(folder / "here/file"), "new");
    ASSERT_TRUE(move_into_place(folder / "here/file", folder / "there/below/file"));
    EXPECT_EQ(test::content_of(folder / "there/below/file"), "new");
    EXPECT_FALSE(move_into_place(folder / "none", folder / "here/file"));
}

TEST(MoveIntoPlace, CopiesToAnotherDiskWhole) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "pot/inner");
    test::put_file(folder / "pot/inner/file", "clay");
    fs::create_directories(folder / "disk");
    const std::string answer = test::in_child([&]() -> std::string {
        if (!test::mount_small_disk((folder / "disk").string(), 64 << 10)) return "no mounts";
        const auto moved = move_into_place(folder / "pot", folder / "disk/deep/pot");
        if (!moved) return moved.error().message;
        if (fs::exists(folder / "pot")) return "the old one is still there";
        return test::content_of(folder / "disk/deep/pot/inner/file");
    });
    if (answer == "no mounts") GTEST_SKIP() << "no mounts of its own";
    EXPECT_EQ(answer, "clay");
}

}  // namespace
}  // namespace onggi::files
