// Studio pots on the command line: thrown on, joined, fired, and scored against a museum's.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

// Opens a lump of 500 g at its axis, widens it, and cuts the rim level at 34 mm.
const std::string kBowl =
    "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm,shaft_mm,wire,wire_y_mm\n"
    "0,0,90,0,1,10,0,none,0\n"
    "0.3,0,60,0,1,10,0,none,0\n"
    "2.3,0,22,0,1,10,0,none,0\n"
    "2.4,0,22,0,1,10,9,none,0\n"
    "4.4,24,22,0,1,10,9,none,0\n"
    "4.8,10,90,0,1,10,0,none,0\n"
    "4.9,10,90,0,1,10,0,rim,34\n"
    "5.0,10,90,0,1,10,0,none,0\n";

// A hand that collars the clay between 40 and 50 mm of height.
const std::string kCollar =
    "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\n0,90,48,0,1,10\n0.5,60,48,0,1,10\n1.5,54,46,0,1,10\n2,90,60,0,"
    "1,10\n";

class PotOnTheCommandLine : public testing::Test {
  protected:
    void SetUp() override {
        put_file(folder_ / "bowl.csv", kBowl);
        put_file(folder_ / "collar.csv", kCollar);
    }
    ProgramRun onggi(const std::vector<std::string>& words) {
        return run_onggi(words, {.folder = folder_.path()});
    }
    void throw_bowl() {
        expect_silent_success(onggi({"throw", "bowl.csv", "--clay-mass", "500", "--rate", "500", "--save",
                                     "bowl.onggi", "--stats", "bowl.json"}));
    }
    nlohmann::json json_of(const std::string& name) {
        return nlohmann::json::parse(content_of(folder_ / name));
    }

    TemporaryFolder folder_;
};

TEST_F(PotOnTheCommandLine, TellsItsMeasuresWetAndFired) {
    throw_bowl();
    const auto stats = json_of("bowl.json");
    const auto& wet = stats.at("wet");
    const auto& fired = stats.at("fired");
    EXPECT_NEAR(wet.at("height_mm").get<double>(), 34.0, 1e-6);
    EXPECT_NEAR(fired.at("height_mm").get<double>(), 34.0 * 0.88, 1e-6);
    EXPECT_EQ(wet.at("stage"), "wet");
    EXPECT_EQ(fired.at("stage"), "glaze");
    EXPECT_EQ(wet.at("body"), "stoneware");
    EXPECT_EQ(wet.at("ledger_error_mm3"), 0.0);
    EXPECT_EQ(wet.at("wall_y_mm").size(), wet.at("wall_mm").size());
    EXPECT_EQ(wet.at("wall_y_mm").at(0), 15.0);
    EXPECT_NEAR(fired.at("capacity_ml").get<double>(), wet.at("capacity_ml").get<double>() * 0.681472, 1e-6);
}

TEST_F(PotOnTheCommandLine, DrawsItselfAndTellsItsMeasures) {
    throw_bowl();
    const std::vector<std::string> outputs{"--fired", "glaze",    "--drawing",  "p.svg",      "--drawing",
                                           "p.pdf",   "--credit", "House, CC0", "--measures", "p.json"};
    const auto drawn_by = [&](const std::string& command) {
        std::vector<std::string> words{command, "bowl.onggi"};
        words.insert(words.end(), outputs.begin(), outputs.end());
        expect_silent_success(onggi(words));
        return std::array{content_of(folder_ / "p.svg"), content_of(folder_ / "p.pdf"),
                          content_of(folder_ / "p.json")};
    };
    const auto thrown = drawn_by("throw");
    EXPECT_EQ(thrown, drawn_by("replay")) << "to the byte, and without a time";
    EXPECT_TRUE(thrown[0].starts_with("<?xml"));
    EXPECT_TRUE(thrown[1].starts_with("%PDF-1.4"));
    const auto pot = nlohmann::json::parse(thrown[2]);
    EXPECT_EQ(pot.at("format"), "onggi-pot");
    EXPECT_EQ(pot.at("version"), 1);
    EXPECT_EQ(pot.at("credit"), "House, CC0");
    EXPECT_NE(thrown[1].find("/Subject"), std::string::npos) << "a PDF's properties";
    const auto stats = json_of("bowl.json");
    for (const char* stage : {"wet", "fired"})
        EXPECT_EQ(pot.at(stage), stats.at(stage)) << "one name, one meaning";
    expect_silent_success(onggi(
        {"throw", "bowl.onggi", "--drawing", "q.pdf", "--credit", "House\xff", "--measures", "q.json"}));
    EXPECT_EQ(json_of("q.json").at("credit"), "House\ufffd");
    expect_one_line(onggi({"throw", "bowl.onggi", "--drawing", "p.png"}), 2,
                    "p.png: expected a drawing's ending (.svg or .pdf)");
    expect_one_line(onggi({"throw", "bowl.onggi", "--credit", "House"}), 2, "--drawing");
    expect_one_line(onggi({"throw", kPressAndHold, "--clay", "paper", "--drawing", "q.svg"}), 2,
                    "--drawing, --measures: expected the studio clay");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "q.svg"));
}

TEST_F(PotOnTheCommandLine, ExportsAtItsStage) {
    throw_bowl();
    expect_silent_success(
        onggi({"throw", "bowl.onggi", "--fired", "glaze", "--export", "fired.glb", "--stats", "s.json"}));
    expect_silent_success(onggi({"throw", "bowl.onggi", "--export", "wet.glb"}));
    const std::string fired = content_of(folder_ / "fired.glb");
    EXPECT_NE(fired.find("\"stage\":\"glaze\""), std::string::npos);
    EXPECT_NE(fired.find("glazed stoneware"), std::string::npos);
    EXPECT_NE(content_of(folder_ / "wet.glb").find("\"stage\":\"wet\""), std::string::npos);
    expect_one_line(onggi({"throw", "bowl.onggi", "--fired", "hot", "--export", "x.glb"}), 2,
                    "--fired: expected wet|dry|bisque|glaze, found 'hot'");
    expect_one_line(
        onggi({"throw", kPressAndHold, "--clay", "paper", "--fired", "glaze", "--export", "x.glb"}), 2,
        "--fired: expected the studio clay");
    expect_one_line(onggi({"throw", "bowl.onggi", "--export", "x.obj"}), 2,
                    "ends in .glb, .stl, .3mf or .usdz");
}

TEST_F(PotOnTheCommandLine, IsThrownFromAnotherBody) {
    expect_silent_success(onggi({"throw", "bowl.csv", "--clay-mass", "500", "--rate", "500", "--body",
                                 "porcelain", "--stats", "s.json"}));
    EXPECT_NEAR(json_of("s.json").at("fired").at("shrinkage_percent").get<double>(), 14.0, 1e-9);
    expect_one_line(onggi({"throw", "bowl.csv", "--body", "glass"}), 2,
                    "expected stoneware|porcelain|earthenware, found 'glass'");
}

TEST_F(PotOnTheCommandLine, IsScoredBesideAMuseumsPot) {
    throw_bowl();
    const ProgramRun run = onggi({"throw", "bowl.onggi", "--target", "buncheong-bowl", "--stats", "s.json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Buncheong bowl, Joseon, late 15th c., Brooklyn Museum 80.274.2"),
              std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("not published"), std::string::npos);
    const auto score = json_of("s.json").at("target");
    EXPECT_EQ(score.at("id"), "buncheong-bowl");
    EXPECT_EQ(score.at("measures").at("height_mm").at("museum"), 50.0);
    EXPECT_NEAR(score.at("measures").at("height_mm").at("pot").get<double>(), 34.0 * 0.88, 1e-6);
    EXPECT_TRUE(score.at("measures").at("mass_g").at("museum").is_null());
    EXPECT_GT(score.at("profile_rms_mm").get<double>(), 0.0);
    EXPECT_FALSE(score.at("nearest").get<std::string>().empty());
    const ProgramRun nearest = onggi({"throw", "bowl.onggi", "--target", "nearest", "--stats", "n.json"});
    EXPECT_EQ(nearest.exit_code, 0) << nearest.err;
    EXPECT_EQ(json_of("n.json").at("target").at("id"), score.at("nearest"));
}

TEST_F(PotOnTheCommandLine, IsNotScoredBesideOneThatIsNotThere) {
    throw_bowl();
    expect_one_line(onggi({"throw", "bowl.onggi", "--target", "jug", "--stats", "s.json"}), 2,
                    "--target: expected one of moon-jar-nmk, moon-jar-bm");
    EXPECT_EQ(folder_.names(),
              (std::vector<std::string>{"bowl.csv", "bowl.json", "bowl.onggi", "collar.csv"}));
    expect_one_line(onggi({"throw", kPressAndHold, "--clay", "paper", "--target", "moon-jar-nmk"}), 2,
                    "--target: expected the studio clay");
}

TEST_F(PotOnTheCommandLine, IsPutBackAndThrownOn) {
    throw_bowl();
    expect_silent_success(onggi({"throw", "collar.csv", "--rate", "500", "--on", "bowl.onggi", "--save",
                                 "on.onggi", "--stats", "on.json"}));
    EXPECT_EQ(json_of("on.json").at("wet").at("ledger_lump_mm3"),
              json_of("bowl.json").at("wet").at("ledger_lump_mm3"));
    const ProgramRun replay = onggi({"replay", "on.onggi", "--validate"});
    EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

TEST_F(PotOnTheCommandLine, IsJoinedToAnotherAndReplaysToTheBit) {
    throw_bowl();
    expect_silent_success(
        onggi({"throw", "collar.csv", "--rate", "500", "--on", "bowl.onggi", "--join", "bowl.onggi", "--save",
               "jar.onggi", "--stats", "jar.json", "--profile", "a.csv"}));
    const auto jar = json_of("jar.json").at("wet");
    const auto bowl = json_of("bowl.json").at("wet");
    EXPECT_EQ(jar.at("ledger_error_mm3"), 0.0);
    EXPECT_EQ(jar.at("ledger_lump_mm3").get<double>(), 2.0 * bowl.at("ledger_lump_mm3").get<double>());
    // Twice 34 mm, less a floor of 12.
    EXPECT_NEAR(jar.at("height_mm").get<double>(), 56.0, 4.0);
    const ProgramRun replay = onggi({"replay", "jar.onggi", "--validate"});
    EXPECT_EQ(replay.exit_code, 0) << replay.err;
    expect_silent_success(onggi({"throw", "jar.onggi", "--profile", "b.csv"}));
    EXPECT_EQ(content_of(folder_ / "a.csv"), content_of(folder_ / "b.csv"));
}

TEST_F(PotOnTheCommandLine, RefusesInvalidStarts) {
    throw_bowl();
    expect_one_line(onggi({"throw", "collar.csv", "--join", "bowl.onggi"}), 2, "--join requires --on");
    expect_one_line(onggi({"throw", "collar.csv", "--on", "nowhere.onggi"}), 2,
                    "nowhere.onggi: no such file");
    expect_one_line(onggi({"throw", "collar.csv", "--on", "bowl.csv"}), 2, "bowl.csv:");
    expect_one_line(onggi({"throw", "bowl.onggi", "--on", "bowl.onggi"}), 2, "expected no --on");
    expect_one_line(onggi({"throw", "collar.csv", "--on", "bowl.onggi", "--clay-mass", "500"}), 2,
                    "the pot brings its own");
    expect_one_line(onggi({"throw", kPressAndHold, "--clay", "paper", "--on", "bowl.onggi"}), 2,
                    "--on: expected the studio clay, found --clay paper");
    expect_one_line(
        onggi({"throw", "collar.csv", "--on", "bowl.onggi", "--join", "bowl.onggi", "--mouth", "250"}), 2,
        "joining: expected a mouth narrower");
    expect_silent_success(onggi({"throw", kPressAndHold, "--clay", "paper", "--save", "paper.onggi"}));
    expect_one_line(onggi({"throw", "collar.csv", "--on", "paper.onggi"}), 2,
                    "expected a session of the studio clay, found one of the paper's");
}

}  // namespace
}  // namespace onggi::test
