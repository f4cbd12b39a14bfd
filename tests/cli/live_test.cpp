// `onggi live`: real time, without a window. These tests check that every period is accounted for, not how
// punctual a busy machine is.
#include <nlohmann/json.hpp>

#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

// The CPU backend, small enough for a sanitizer; without real-time permission the program reports it and
// continues.
const std::vector<std::string> kSmallPicture{"--headless", "--size", "64x36"};

std::vector<std::string> with_small_picture(std::vector<std::string> words) {
    words.insert(words.end(), kSmallPicture.begin(), kSmallPicture.end());
    return words;
}

nlohmann::json stats_of(const std::vector<std::string>& words, const TemporaryFolder& folder) {
    const ProgramRun run = run_onggi(with_small_picture(words), {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, "");
    return nlohmann::json::parse(content_of(folder / "s.json"));
}

TEST(Live, PlaysAGestureOnceAndWritesStatsOthersCanRead) {
    const TemporaryFolder folder;
    put_file(folder / "g.csv", kShortGesture);
    const auto stats =
        stats_of({"live", "g.csv", "--clay", "paper", "--rate", "500", "--stats", "s.json"}, folder);
    EXPECT_EQ(stats.at("ticks"), 201);
    EXPECT_EQ(stats.at("rate_hz"), 500.0);
    EXPECT_EQ(stats.at("lumps"), 1);
    EXPECT_GE(stats.at("frames").get<int>(), 1);
    EXPECT_TRUE(stats.at("missed_deadlines").is_number_unsigned());
    EXPECT_TRUE(stats.at("ledger_error").is_null());
    EXPECT_TRUE(stats.at("scheduler") == "fifo" || stats.at("scheduler") == "other");
    EXPECT_TRUE(stats.at("haptic_core").is_number_integer());
    const auto& safety = stats.at("safety");
    EXPECT_EQ(safety.at("most_force_n").get<double>(), 3.3);
    EXPECT_LE(safety.at("largest_force_n").get<double>(), 3.3 * (1.0 + 1e-12));
    EXPECT_GE(safety.at("largest_force_n").get<double>(), safety.at("mean_force_n").get<double>());
    for (const char* table : {"tick_ns", "wake_latency_us", "frame_ms"}) {
        const auto& fractions = stats.at(table);
        EXPECT_LE(fractions.at("p50").get<double>(), fractions.at("p99").get<double>()) << table;
        EXPECT_LE(fractions.at("p99").get<double>(), fractions.at("max").get<double>()) << table;
    }
}

TEST(Live, ThrowsTheSamePotAsSimulatedTime) {
    for (const std::string clay : {"paper", "studio"}) {
        const TemporaryFolder folder;
        // Low enough for a studio lump, which is 50 mm high.
        put_file(
            folder / "g.csv",
            kGestureHeaderLine + "0,90,20,0,1,10\n0.1,69,20,0,1,10\n0.3,69,25,0,1,10\n0.4,90,25,0,0,10\n");
        expect_silent_success(
            run_onggi({"throw", "g.csv", "--clay", clay, "--stats", "s.json", "--save", "s.onggi"},
                      {.folder = folder.path()}));
        const std::string number = clay == "paper" ? "clay_volume_mm3" : "height_mm";
        const auto thrown = nlohmann::json::parse(content_of(folder / "s.json")).at(number);
        if (clay == "paper") {
            ASSERT_LT(thrown.get<double>(), 2.26e6) << "some clay was pressed";
        } else {
            ASSERT_NE(thrown.get<double>(), 49.57519511507503) << "the lump was moved";
        }
        EXPECT_EQ(stats_of({"live", "g.csv", "--clay", clay, "--stats", "s.json"}, folder).at(number),
                  thrown);
        EXPECT_EQ(stats_of({"live", "s.onggi", "--stats", "s.json", "--wait", "sleep"}, folder).at(number),
                  thrown);
    }
}

// The full picture. Times and resident memory depend on the machine, its fonts and drivers; allocated memory
// hardly does.
TEST(Live, TellsItsFirstFrameAndKeepsItsMemorySmall) {
    const TemporaryFolder folder;
    put_file(folder / "g.csv", kShortGesture);
    const ProgramRun run = run_onggi({"live", "g.csv", "--headless", "--seconds", "2", "--stats", "s.json"},
                                     {.folder = folder.path()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto stats = nlohmann::json::parse(content_of(folder / "s.json"));
    ASSERT_TRUE(stats.at("first_frame_s").is_number());
    ASSERT_TRUE(stats.at("resident_mb").is_number());
    EXPECT_GT(stats.at("first_frame_s").get<double>(), 0.05);
    ASSERT_TRUE(stats.at("own_mb").is_number());
    EXPECT_GT(stats.at("own_mb").get<double>(), 20.0);
    EXPECT_GT(stats.at("resident_mb").get<double>(), stats.at("own_mb").get<double>());
    if (!is_sanitized()) {
        EXPECT_LT(stats.at("own_mb").get<double>(), 150.0);
    }
}

TEST(Live, StartsAgainOnAFreshLumpUntilItsTimeIsUp) {
    const TemporaryFolder folder;
    put_file(folder / "g.csv", kShortGesture);
    const auto stats = stats_of({"live", "g.csv", "--seconds", "1", "--stats", "s.json"}, folder);
    const auto ticks = stats.at("ticks").get<std::uint64_t>();
    EXPECT_GE(ticks + stats.at("skipped_periods").get<std::uint64_t>(), 1000U);
    EXPECT_EQ(stats.at("lumps").get<std::uint64_t>(), (ticks + 400) / 401);
}

TEST(Live, RefusesUnknownOptions) {
    expect_one_line(run_onggi(with_small_picture({"live", kPressAndHold, "--wait", "spin"})), 2,
                    "--wait: expected hybrid or sleep, found 'spin'");
    for (const char* seconds : {"0", "-1", "nan", "1e99", "soon"}) {
        expect_one_line(run_onggi(with_small_picture({"live", kPressAndHold, "--seconds", seconds})), 2,
                        "--seconds: expected");
    }
    expect_one_line(run_onggi(with_small_picture({"live"})), 2, "file is required");
}

TEST(Live, SaysWhyADeviceGetsNoForceOfThisClay) {
    const TemporaryFolder folder;
    put_file(folder / "g.csv", kShortGesture);
    const auto said = [&](const std::string& clay) {
        const ProgramRun run = run_onggi(
            with_small_picture({"live", "g.csv", "--clay", clay, "--rate", "1000", "--device", "inverse3"}),
            {.folder = folder.path()});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return run.err;
    };
    constexpr std::string_view kWhy = "Haply Inverse3: expected a stiffness of at most ";
    const std::string paper = said("paper");
    const std::size_t at = paper.find(kWhy);
    ASSERT_NE(at, std::string::npos) << paper;
    EXPECT_NE(paper.find("the largest that is stable on it at 1000 Hz, found 0.5\n", at), std::string::npos)
        << paper;
    EXPECT_EQ(paper.find(kWhy, at + 1), std::string::npos) << "once: " << paper;
    EXPECT_EQ(said("studio").find("Haply"), std::string::npos) << "that clay is shown softer";
}

TEST(Live, RefusesAPlaceForItsStatsBeforeItPlays) {
    expect_one_line(
        run_onggi(with_small_picture({"live", kPressAndHold, "--stats", "no/such/folder/s.json"})), 2,
        "no/such/folder");
}

TEST(Live, NamesAMissingVulkanDeviceAndWritesNoFile) {
    const TemporaryFolder folder;
    const ProgramRun run =
        run_onggi(with_small_picture({"live", kPressAndHold, "--stats", "s.json"}),
                  {.folder = folder.path(),
                   .environment = {"VK_ICD_FILENAMES=/none.json", "VK_DRIVER_FILES=/none.json"}});
    expect_one_line(run, 3, "Vulkan");
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace onggi::test
