// Impossible output paths are refused before the work, never touched, and no partial file is left.
#include <sys/stat.h>

#include "tests/cli/cli_expectations.h"
#include "tests/support/hostile_system.h"

namespace onggi::test {
namespace {

using Words = std::vector<std::string>;

const char* const kOutputs[] = {"--profile", "--forces", "--export", "--save", "--stats"};

// A file name with the option's extension.
std::string name_for(const std::string& option) {
    return option == "--export" ? "pot.glb" : "out";
}

TEST(AnOutput, InAPlaceThatCannotBeIsRefusedAndLeftAlone) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "pot.glb");
    std::filesystem::create_directory(folder / "out");
    const Words before = folder.names();
    for (const std::string option : kOutputs) {
        const auto run = [&](const std::string& place) {
            return run_onggi({"throw", kPressAndHold, option, place}, {.folder = folder.path()});
        };
        expect_one_line(run("none/" + name_for(option)), 2, "none is not there");
        expect_one_line(run(name_for(option)), 2, "expected the place of a file, found a folder");
        expect_one_line(run(kPressAndHold + "/" + name_for(option)), 2, "expected a folder at");
        if (option == "--export") continue;  // a device's name has no ending
        expect_one_line(run("/dev/full"), 2, "/dev/full: expected the place of a file, found a device");
        expect_one_line(run("/dev/null"), 2, "found a device");
    }
    EXPECT_EQ(folder.names(), before);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AnOutput, IsCheckedBeforeTheWork) {
    // An hour's gesture would take long: the missing folder is noticed first.
    const TemporaryFolder folder;
    put_file(folder / "hour.csv", kGestureHeaderLine + "0,90,100,0,1,10\n3600,90,100,0,1,10\n");
    const ProgramRun run = run_onggi({"throw", "hour.csv", "--clay", "paper", "--rate", "10000", "--forces",
                                      "f.csv", "--profile", "none/p.csv"},
                                     {.folder = folder.path()});
    expect_one_line(run, 2, "none is not there");
    EXPECT_EQ(folder.names(), Words{"hour.csv"});
}

TEST(AnOutput, WithoutPermissionIsASystemThatLacksIt) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "closed");
    put_file(folder / "closed" / "old", "old");
    std::filesystem::permissions(folder / "closed", std::filesystem::perms(0555));
    for (const std::string option : kOutputs) {
        expect_one_line(run_onggi({"throw", kPressAndHold, option, "closed/" + name_for(option)},
                                  {.folder = folder.path(), .in_child = &bind_permissions_across_exec}),
                        3, "Permission denied");
    }
    expect_one_line(run_onggi({"throw", kPressAndHold, "--profile", "closed/old"},
                              {.folder = folder.path(), .in_child = &bind_permissions_across_exec}),
                    3, "Permission denied");
    EXPECT_EQ(content_of(folder / "closed" / "old"), "old");
    std::filesystem::permissions(folder / "closed", std::filesystem::perms(0755));
}

TEST(AnOutput, OnAFullDiskIsASystemThatLacksSpace) {
    // Files are limited to 4 KiB, too small for each of these outputs.
    const TemporaryFolder folder;
    for (const std::string option : kOutputs) {
        if (option == "--stats") continue;  // a few hundred bytes fit anywhere
        put_file(folder / name_for(option), "old");
        expect_one_line(run_onggi({"throw", kPressAndHold, option, name_for(option)},
                                  {.folder = folder.path(), .in_child = [] { limit_file_size(4096); }}),
                        3, "cannot write");
        EXPECT_EQ(content_of(folder / name_for(option)), "old");
        std::filesystem::remove(folder / name_for(option));
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST(AnOutput, ThatFailsTakesTheOthersWithIt) {
    const TemporaryFolder folder;
    put_file(folder / "p.csv", "old profile");
    // The profile (35 KB) and the stats fit; the forces (120 KB) do not.
    const ProgramRun run = run_onggi({"throw", kPressAndHold, "--profile", "p.csv", "--stats", "s.json",
                                      "--forces", "f.csv", "--save", "s.onggi"},
                                     {.folder = folder.path(), .in_child = [] { limit_file_size(65536); }});
    expect_one_line(run, 3, "f.csv: cannot write: File too large");
    EXPECT_EQ(folder.names(), Words{"p.csv"});
    EXPECT_EQ(content_of(folder / "p.csv"), "old profile");
}

TEST(AnOutput, OnARealFullDiskLeavesNoFile) {
    // On a disk of 64 KiB that only the program sees; its files are listed before that disk disappears.
    const TemporaryFolder folder;
    const std::string answer = in_child([&] {
        fill_disk_after(folder.path(), std::size_t{64} << 10U);
        const ProgramRun run = run_onggi({"throw", kPressAndHold, "--forces", "f.csv", "--profile", "p.csv"},
                                         {.folder = folder.path()});
        std::string seen = std::to_string(run.exit_code) +
                           (run.err.find("cannot write") != std::string::npos ? " says so" : run.err);
        for (const std::string& name : folder.names())
            seen += " " + name;
        return seen;
    });
    EXPECT_EQ(answer, "3 says so");
}

TEST(AnOutput, HasItsOwnPlace) {
    const TemporaryFolder folder;
    expect_one_line(run_onggi({"throw", kPressAndHold, "--profile", "same.csv", "--forces", "./same.csv"},
                              {.folder = folder.path()}),
                    2, "expected a separate file for each output");
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace onggi::test
