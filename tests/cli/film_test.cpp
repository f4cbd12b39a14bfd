// `onggi film`: a film or one line, never half a file.
#include "tests/cli/cli_expectations.h"
#include "tests/support/mp4_frames.h"
#include "tests/support/webp_frames.h"

namespace onggi::test {
namespace {

const std::string kSession = in_checkout("tests/replay/sessions/one-finger-250hz.onggi");

TEST(FilmCommand, WritesAFilmOfThatLengthAndSize) {
    const TemporaryFolder folder;
    expect_silent_success(
        run_onggi({"film", kSession, "--out", "f.webp", "--size", "160x120", "--seconds", "2"},
                  {.folder = folder.path()}));
    const std::string file = content_of(folder / "f.webp");
    const WebpFrames frames = webp_frames(std::as_bytes(std::span(file.data(), file.size())));
    EXPECT_EQ(frames.images.size(), 25U);
    EXPECT_EQ(frames.ends_ms.back(), 2000);
    EXPECT_EQ(frames.images.front().width, 160);
    EXPECT_EQ(frames.images.front().height, 120);
    EXPECT_LE(file.size(), 1'500'000U);
}

TEST(FilmCommand, WritesTheSameFilmAsMp4) {
    const TemporaryFolder folder;
    expect_silent_success(run_onggi({"film", kSession, "--out", "f.webp", "--mp4", "f.mp4", "--size",
                                     "161x121", "--seconds", "2", "--quick"},
                                    {.folder = folder.path()}));
    const std::string file = content_of(folder / "f.mp4");
    const Mp4Frames frames = mp4_frames(std::as_bytes(std::span(file.data(), file.size())));
    EXPECT_EQ(frames.images.size(), 25U);
    EXPECT_EQ(frames.lasts_ms, 2000);
    EXPECT_EQ(frames.images.front().width, 160);
    EXPECT_EQ(frames.images.front().height, 120);
}

// A kiosk films while its visitor still chooses the glaze.
TEST(FilmCommand, ShowsThePotUnderTheGlazeThatIsSaidBeforeOrLater) {
    const TemporaryFolder folder;
    const auto last_of = [&](const std::string& glaze, const std::string& said) {
        put_file(folder / "said", said);
        expect_silent_success(run_onggi({"film", kSession, "--out", "f.webp", "--size", "160x120",
                                         "--seconds", "1", "--quick", "--glaze", glaze, "--still", "s.webp"},
                                        {.folder = folder.path(), .in_child = [&folder] {
                                             if (std::freopen((folder / "said").c_str(), "r", stdin) ==
                                                 nullptr)
                                                 std::abort();
                                         }}));
        const std::string file = content_of(folder / "f.webp");
        return webp_frames(std::as_bytes(std::span(file.data(), file.size()))).images.back().rgba;
    };
    const auto celadon = last_of("celadon", "");
    EXPECT_NE(celadon, last_of("iron", ""));
    EXPECT_EQ(celadon, last_of("-", "celadon\n"));
    const std::string still = content_of(folder / "s.webp");
    const WebpFrames picture = webp_frames(std::as_bytes(std::span(still.data(), still.size())));
    ASSERT_EQ(picture.images.size(), 1U);
    EXPECT_EQ(picture.images.front().width, 160);
}

TEST(FilmCommand, RefusesWithOneLineAndWritesNoFile) {
    const TemporaryFolder folder;
    const auto film = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "film");
        const ProgramRun run = run_onggi(words, {.folder = folder.path()});
        EXPECT_FALSE(std::filesystem::exists(folder / "f.webp"));
        return run;
    };
    expect_one_line(film({kSession, "--out", "f.gif"}), 2, "expected a film's ending (.webp)");
    expect_one_line(film({kSession, "--out", "nowhere/f.webp"}), 2, "nowhere");
    expect_one_line(film({kSession}), 2, "--out is required");
    expect_one_line(film({kPressAndHold, "--out", "f.webp"}), 2, "press-and-hold.csv");
    expect_one_line(film({"missing.onggi", "--out", "f.webp"}), 2, "missing.onggi");
    expect_one_line(film({kSession, "--out", "f.webp", "--seconds", "0.9"}), 2, "expected 1 to 60");
    expect_one_line(film({kSession, "--out", "f.webp", "--size", "480"}), 2, "expected WIDTHxHEIGHT");
    expect_one_line(
        film({in_checkout("tests/replay/sessions/vase-100hz.onggi"), "--out", "f.webp", "--fired", "glaze"}),
        2, "expected the studio clay");
    expect_one_line(film({kSession, "--out", "f.webp", "--glaze", "gold"}), 2,
                    "--glaze: expected one of celadon, porcelain, buncheong, iron, ash, bare, found 'gold'");
    expect_one_line(
        film({kSession, "--out", "f.webp", "--size", "160x120", "--seconds", "1", "--quick", "--glaze", "-"}),
        2, "standard input: expected one of celadon");
    expect_one_line(film({kSession, "--out", "f.webp", "--still", "s.png"}), 2,
                    "expected a still's ending (.webp)");
    expect_one_line(film({kSession, "--out", "f.webp", "--mp4", "f.webp"}), 2,
                    "expected a film's ending (.mp4)");
    expect_one_line(film({kSession, "--out", "f.webp", "--mp4", "f.mp4", "--size", "8192x8192"}), 2,
                    "MP4: expected a size for H.264");
    put_file(folder / "bad.onggi", content_of(kSession).replace(200, 1, "x"));
    expect_one_line(film({"bad.onggi", "--out", "f.webp"}), 2, "bad.onggi");
    EXPECT_EQ(run_onggi({"film", "--help"}).exit_code, 0);
}

TEST(FilmCommand, WithoutVulkanReportsTheLack) {
    const TemporaryFolder folder;
    expect_one_line(run_onggi({"film", kSession, "--out", "f.webp"},
                              {.folder = folder.path(),
                               .environment = {"VK_ICD_FILENAMES=/nowhere", "VK_DRIVER_FILES=/nowhere"}}),
                    3, "Vulkan");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace onggi::test
