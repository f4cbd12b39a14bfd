// Wrong usage: exit code 2, one line, and what would have been right.
#include <fmt/format.h>

#include <regex>

#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

using Words = std::vector<std::string>;

TEST(Usage, EveryCommandHasHelpAndVersion) {
    for (const Words& command : {Words{}, Words{"throw"}, Words{"replay"}}) {
        for (const char* asked : {"--help", "--version"}) {
            Words words = command;
            words.emplace_back(asked);
            const ProgramRun run = run_onggi(words);
            EXPECT_EQ(run.exit_code, 0);
            EXPECT_FALSE(run.out.empty());
            EXPECT_EQ(run.err, "");
        }
    }
    EXPECT_NE(run_onggi({"throw", "--help"}).out.find("--profile"), std::string::npos);
}

TEST(Usage, TheVersionNamesTheCommit) {
    const ProgramRun run = run_onggi({"--version"});
    const std::regex expected("onggi " ONGGI_VERSION
                              R"( \((unknown|[0-9a-f]{12}(\.changed)?), \d{4}-\d{2}-\d{2}\)\n)");
    EXPECT_TRUE(std::regex_match(run.out, expected)) << run.out;
}

TEST(Usage, HelpThatCannotBePrintedIsNoSuccess) {
    const ProgramRun run = run_onggi({"--help"}, {.in_child = [] {
                                         if (std::freopen("/dev/full", "w", stdout) == nullptr) ::abort();
                                     }});
    expect_one_line(run, 3, "standard output cannot be written");
}

TEST(Usage, UnknownWordsAreRefusedAndNamed) {
    expect_one_line(run_onggi({"trow"}), 2, "expected a command");
    expect_one_line(run_onggi({"trow"}), 2, "found 'trow'");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--bogus"}), 2, "--bogus");
    expect_one_line(run_onggi({"throw", kPressAndHold, "and-another"}), 2, "and-another");
    expect_one_line(run_onggi({"replay", "x.onggi", "--validate", "--fast"}), 2, "--fast");
    expect_one_line(run_onggi({"throw", "two\nlines", "--bo\x1b[31mgus"}), 2, "--bo\\x1b[31mgus");
}

TEST(Usage, MissingArgumentsAreNamed) {
    expect_one_line(run_onggi({"throw"}), 2, "file is required");
    expect_one_line(run_onggi({"replay", "x.onggi"}), 2, "expected --validate, --drawing or --measures");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--rate"}), 2, "--rate");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--size", "640x480"}), 2, "--screenshot");
}

TEST(Usage, NumbersOutsideTheirBoundsAreRefused) {
    for (const char* rate :
         {"99", "10001", "0", "-1000", "nan", "inf", "1e9", "abc", "", "0x3e8", "1000Hz"}) {
        expect_one_line(run_onggi({"throw", kPressAndHold, "--rate", rate}), 2,
                        fmt::format("--rate: expected 100 to 10000, found '{}'", rate));
    }
    for (const char* count : {"99", "200001", "-5", "2000.5", "many", "99999999999999999999"}) {
        expect_one_line(run_onggi({"throw", kPressAndHold, "--elements", count}), 2,
                        fmt::format("--elements: expected 100 to 200000, found '{}'", count));
    }
    for (const char* size : {"640", "640x", "x480", "640x480x3", "15x480", "640x8193", "-640x480", "axb"}) {
        expect_one_line(run_onggi({"throw", kPressAndHold, "--screenshot", "p.png", "--size", size}), 2,
                        fmt::format("--size: expected WIDTHxHEIGHT, each 16 to 8192, found '{}'", size));
    }
}

TEST(Usage, UnsupportedValuesAreRefusedNamingTheSupportedOnes) {
    expect_one_line(run_onggi({"throw", kPressAndHold, "--clay", "porridge"}), 2,
                    "expected studio|paper, found 'porridge'");
    const TemporaryFolder folder;
    expect_one_line(run_onggi({"throw", kPressAndHold, "--export", (folder / "pot.obj").string()}), 2,
                    ".glb");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--export", (folder / "pot").string()}), 2, ".stl");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--screenshot", (folder / "pot.bmp").string()}), 2,
                    ".png");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Usage, OptionsOfTheStudioClayAreNotThePapers) {
    expect_one_line(run_onggi({"throw", kPressAndHold, "--clay", "paper", "--clay-mass", "500"}), 2,
                    "--clay-mass: expected the studio clay, found --clay paper");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--clay", "paper", "--wheel", "kick"}), 2,
                    "--wheel: expected the studio clay, found --clay paper");
    expect_one_line(run_onggi({"throw", kPressAndHold, "--wheel", "ferris"}), 2,
                    "expected electric|kick, found 'ferris'");
    for (const char* mass : {"99", "5001", "nan", "heavy"}) {
        expect_one_line(run_onggi({"throw", kPressAndHold, "--clay-mass", mass}), 2,
                        fmt::format("--clay-mass: expected 100 to 5000, found '{}'", mass));
    }
}

TEST(Usage, AnOptionGivenTwiceIsRefused) {
    expect_one_line(run_onggi({"throw", kPressAndHold, "--rate", "1000", "--rate", "2000"}), 2, "--rate");
}

TEST(Usage, ASessionBringsItsOwnRateAndClay) {
    const TemporaryFolder folder;
    const std::string session = (folder / "s.onggi").string();
    expect_silent_success(run_onggi({"throw", kPressAndHold, "--save", session}));
    for (const Words& extra : {Words{"--rate", "1000"}, Words{"--clay", "paper"}, Words{"--elements", "2000"},
                               Words{"--clay-mass", "500"}}) {
        Words words{"throw", session};
        words.insert(words.end(), extra.begin(), extra.end());
        expect_one_line(run_onggi(words), 2, "a session brings its own rate, clay and elements");
    }
}

}  // namespace
}  // namespace onggi::test
