// The outputs of a successful `onggi throw`.
#include <nlohmann/json.hpp>

#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

using Words = std::vector<std::string>;

class Throw : public testing::Test {
  protected:
    const TemporaryFolder folder_;
};

TEST_F(Throw, IsSilentInAPipe) {
    expect_silent_success(run_onggi({"throw", kPressAndHold}));
}

TEST_F(Throw, WritesAProfileRowForEachElement) {
    expect_silent_success(
        run_onggi({"throw", kPressAndHold, "--clay", "paper", "--elements", "500", "--profile", "p.csv"},
                  {.folder = folder_.path()}));
    const auto lines = lines_of(content_of(folder_ / "p.csv"));
    ASSERT_EQ(lines.size(), 501U);
    EXPECT_EQ(lines[0], "y_mm,outer_mm");
    EXPECT_EQ(lines[1], "0.2,60");
    EXPECT_EQ(lines[500], "199.8,60");
    // At 100 mm the tool stood for 1.2 s, 1 mm inside a 60 mm wall: 1/100 of the rest goes each ms.
    const double pressed_mm = std::stod(lines[250].substr(lines[250].find(',') + 1));
    EXPECT_NEAR(pressed_mm, 59.0, 0.01);
}

TEST_F(Throw, WritesAForcesRowForEachTick) {
    expect_silent_success(run_onggi({"throw", kPressAndHold, "--clay", "paper", "--forces", "f.csv"},
                                    {.folder = folder_.path()}));
    const auto lines = lines_of(content_of(folder_ / "f.csv"));
    ASSERT_EQ(lines.size(), 1402U);
    EXPECT_EQ(lines[0], "tick,t_s,contacts,fs_x_N,fs_y_N,fs_z_N,fv_x_N,fv_y_N,fv_z_N,ff_x_N,ff_y_N,ff_z_N");
    EXPECT_EQ(lines[1], "0,0,0,0,0,0,0,0,0,0,0,0");
    EXPECT_TRUE(lines[301].starts_with("300,0.3,")) << lines[301];
    EXPECT_TRUE(lines[1401].starts_with("1400,1.4,")) << lines[1401];
    // Eq. (7) at x = 69 mm: 0.0001 x 4 pi x 69 N, along -Z; nine significant digits.
    EXPECT_TRUE(lines[301].ends_with(",0,0,-0.0867079572")) << lines[301];
}

TEST_F(Throw, WritesStatsOthersCanRead) {
    expect_silent_success(
        run_onggi({"throw", kPressAndHold, "--clay", "paper", "--rate", "500", "--stats", "s.json"},
                  {.folder = folder_.path()}));
    const auto stats = nlohmann::json::parse(content_of(folder_ / "s.json"));
    EXPECT_EQ(stats.at("ticks"), 701);
    EXPECT_EQ(stats.at("rate_hz"), 500.0);
    EXPECT_TRUE(stats.at("ledger_error").is_null());
    const auto& tick_ns = stats.at("tick_ns");
    EXPECT_GT(tick_ns.at("p50"), 0.0);
    EXPECT_LE(tick_ns.at("p50"), tick_ns.at("p99"));
    EXPECT_LE(tick_ns.at("p99"), tick_ns.at("p999"));
    EXPECT_LE(tick_ns.at("p999"), tick_ns.at("max"));
    // A lump of 60 mm and 200 mm, less what was pressed.
    EXPECT_NEAR(stats.at("clay_volume_mm3").get<double>(), 2.2619e6, 0.02e6);
}

TEST_F(Throw, WritesAllItsOutputsAndNoOtherFile) {
    expect_silent_success(run_onggi({"throw", kPressAndHold, "--profile", "p.csv", "--forces", "f.csv",
                                     "--export", "pot.glb", "--save", "s.onggi", "--stats", "s.json"},
                                    {.folder = folder_.path()}));
    EXPECT_EQ(folder_.names(), (Words{"f.csv", "p.csv", "pot.glb", "s.json", "s.onggi"}));
    EXPECT_TRUE(content_of(folder_ / "pot.glb").starts_with("glTF"));
    expect_silent_success(
        run_onggi({"throw", kPressAndHold, "--export", "pot.stl"}, {.folder = folder_.path()}));
    EXPECT_GT(content_of(folder_ / "pot.stl").size(), 1000U);
}

TEST_F(Throw, ReplacesAnOlderFile) {
    put_file(folder_ / "p.csv", "old");
    expect_silent_success(
        run_onggi({"throw", kPressAndHold, "--profile", "p.csv"}, {.folder = folder_.path()}));
    EXPECT_TRUE(content_of(folder_ / "p.csv").starts_with("y_mm,outer_mm"));
}

TEST_F(Throw, GivesTheSameBytesEveryTime) {
    for (const char* name : {"a", "b"}) {
        const std::string n = name;
        expect_silent_success(run_onggi({"throw", kPressAndHold, "--profile", n + ".csv", "--forces",
                                         n + "-f.csv", "--save", n + ".onggi", "--export", n + ".glb"},
                                        {.folder = folder_.path()}));
    }
    for (const char* ending : {".csv", "-f.csv", ".onggi", ".glb"}) {
        EXPECT_TRUE(content_of(folder_ / (std::string("a") + ending)) ==
                    content_of(folder_ / (std::string("b") + ending)))
            << ending;
    }
}

TEST_F(Throw, OfASessionEqualsThatOfItsGesture) {
    const ProgramOptions here{.folder = folder_.path()};
    expect_silent_success(run_onggi({"throw", kPressAndHold, "--rate", "400", "--elements", "700", "--save",
                                     "a.onggi", "--forces", "a.csv"},
                                    here));
    // The kind of file is recognised by content, not by name.
    std::filesystem::rename(folder_ / "a.onggi", folder_ / "gesture.csv");
    expect_silent_success(
        run_onggi({"throw", "gesture.csv", "--save", "b.onggi", "--forces", "b.csv"}, here));
    EXPECT_TRUE(content_of(folder_ / "gesture.csv") == content_of(folder_ / "b.onggi"));
    EXPECT_TRUE(content_of(folder_ / "a.csv") == content_of(folder_ / "b.csv"));
}

TEST_F(Throw, ShowsProgressOnATerminalWithoutColours) {
    // An hour in the clay takes about a second in Release: several times what goes by before progress is
    // shown.
    put_file(folder_ / "long.csv", kGestureHeaderLine + "0,65,100,0,1,20\n3600,65,100,0,1,20\n");
    const ProgramRun run = run_onggi_on_terminal({"throw", "long.csv", "--clay", "paper"},
                                                 {.folder = folder_.path(), .environment = {"NO_COLOR=1"}});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out.find("throwing "), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find('\x1b'), std::string::npos);
    EXPECT_TRUE(run.out.ends_with('\r')) << "the line is taken away at the end";
}

TEST_F(Throw, NeedsNoVulkanWithoutAPicture) {
    expect_silent_success(
        run_onggi({"throw", kPressAndHold},
                  {.environment = {"VK_ICD_FILENAMES=/none.json", "VK_DRIVER_FILES=/none.json"}}));
}

TEST_F(Throw, WithoutVulkanRefusesAPictureAndLeavesNoFile) {
    expect_one_line(run_onggi({"throw", kPressAndHold, "--screenshot", "p.png", "--profile", "p.csv"},
                              {.folder = folder_.path(),
                               .environment = {"VK_ICD_FILENAMES=/none.json", "VK_DRIVER_FILES=/none.json"}}),
                    3, "Vulkan");
    EXPECT_TRUE(folder_.names().empty());
}

TEST_F(Throw, DrawsAPictureOfTheSizeAsked) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the software Vulkan driver has races of its own, which ThreadSanitizer reports";
#endif
    const TemporaryFolder folder;
    // The driver leaks, and is unloaded before LeakSanitizer could find its name among the suppressed ones.
    expect_silent_success(
        run_onggi({"throw", kPressAndHold, "--screenshot", "p.png", "--size", "80x48"},
                  {.folder = folder.path(), .environment = {"ASAN_OPTIONS=detect_leaks=0"}}));
    const std::string png = content_of(folder / "p.png");
    ASSERT_TRUE(png.starts_with("\x89PNG")) << png.size();
    EXPECT_EQ(png.substr(12, 12), std::string("IHDR\0\0\0\x50\0\0\0\x30", 12));
}

TEST_F(Throw, LeavesNoFileWhenKilled) {
    put_file(folder_ / "hour.csv", kGestureHeaderLine + "0,90,100,0,1,10\n3600,61,150,0,1,10\n");
    EXPECT_TRUE(run_onggi_and_kill(
        {"throw", "hour.csv", "--clay", "paper", "--rate", "10000", "--save", "s.onggi", "--forces", "f.csv"},
        300, {.folder = folder_.path()}));
    EXPECT_EQ(folder_.names(), Words{"hour.csv"});
}

}  // namespace
}  // namespace onggi::test
