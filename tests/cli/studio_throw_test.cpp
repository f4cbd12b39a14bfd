// `onggi throw` with the studio's clay, and with the gesture columns that only the studio's clay uses.
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

// Opens a lump of 500 g at its axis, widens it, and cuts the rim level.
const std::string kOpening =
    "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm,shaft_mm,water,wheel_rev_min,wire,wire_y_mm,mood\n"
    "0,0,90,0,1,10,0,1,150,none,0,calm\n"
    "0.3,0,60,0,1,10,0,1,150,none,0,\n"
    "2.3,0,22,0,1,10,0,1,150,none,0,\n"
    "2.4,0,22,0,1,10,9,1,150,none,0,\n"
    "4.4,24,22,0,1,10,9,1,150,none,0,\n"
    "4.8,10,90,0,1,10,0,1,150,none,0,\n"
    "4.9,10,90,0,1,10,0,1,150,rim,34,\n"
    "5.0,10,90,0,1,10,0,1,150,none,0,\n";

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');)
        numbers.push_back(std::stod(field));
    return numbers;
}

class StudioThrow : public testing::Test {
  protected:
    void SetUp() override { put_file(folder_ / "g.csv", kOpening); }
    ProgramRun onggi(const std::vector<std::string>& words) {
        return run_onggi(words, {.folder = folder_.path()});
    }

    TemporaryFolder folder_;
};

TEST_F(StudioThrow, IsTheDefault) {
    expect_silent_success(onggi({"throw", "g.csv", "--profile", "a.csv"}));
    expect_silent_success(onggi({"throw", "g.csv", "--clay", "studio", "--clay-mass", "1000", "--elements",
                                 "2000", "--profile", "b.csv"}));
    EXPECT_EQ(content_of(folder_ / "a.csv"), content_of(folder_ / "b.csv"));
}

TEST_F(StudioThrow, WritesBothFacesOfTheWall) {
    expect_silent_success(onggi({"throw", "g.csv", "--clay-mass", "500", "--profile", "p.csv"}));
    const auto lines = lines_of(content_of(folder_ / "p.csv"));
    ASSERT_GT(lines.size(), 100U);
    EXPECT_EQ(lines[0], "y_mm,outer_mm,inner_mm");
    double y_mm = 0.0;
    double hollow_from_mm = 0.0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto numbers = numbers_of(lines[i]);
        ASSERT_EQ(numbers.size(), 3U) << lines[i];
        ASSERT_GT(numbers[0], y_mm) << lines[i];
        ASSERT_GT(numbers[1], numbers[2]) << lines[i];
        y_mm = numbers[0];
        if (hollow_from_mm == 0.0 && numbers[2] > 0.0) hollow_from_mm = y_mm;
    }
    EXPECT_NEAR(hollow_from_mm, 12.0, 0.6) << "the floor is kept";
    EXPECT_NEAR(y_mm, 34.0, 0.2) << "the wire has cut the rim level";
    // A ball of 10 mm at 24 mm from the axis, minus the yield depth of 0.25 mm.
    EXPECT_NEAR(numbers_of(lines[lines.size() * 2 / 3])[2], 33.0, 1.0);
}

TEST_F(StudioThrow, AccountsForEveryCubicMillimetre) {
    expect_silent_success(onggi({"throw", "g.csv", "--clay-mass", "500", "--stats", "s.json"}));
    const auto stats = nlohmann::json::parse(content_of(folder_ / "s.json"));
    EXPECT_EQ(stats.at("ledger_error"), 0.0);
    const double on_wheel_mm3 = stats.at("clay_volume_mm3");
    const double trimmings_mm3 = stats.at("trimmings_mm3");
    EXPECT_GT(trimmings_mm3, 1000.0);
    EXPECT_NEAR(on_wheel_mm3 + trimmings_mm3, 500.0 / 1.9e-3, 1e-3);
    EXPECT_NEAR(stats.at("mass_g").get<double>(), on_wheel_mm3 * 1.9e-3, 1e-6);
    EXPECT_GT(stats.at("capacity_ml"), 20.0);
    EXPECT_GT(stats.at("load_index"), 0.0);
    EXPECT_LT(stats.at("load_index"), 1.0);
    EXPECT_TRUE(stats.at("failure").is_null());
}

TEST_F(StudioThrow, AddsWheelAndHandsToTheTableOfForces) {
    expect_silent_success(onggi({"throw", "g.csv", "--clay-mass", "500", "--forces", "f.csv"}));
    const auto lines = lines_of(content_of(folder_ / "f.csv"));
    ASSERT_EQ(lines.size(), 5002U);
    EXPECT_EQ(
        lines[0],
        "tick,t_s,contacts,fs_x_N,fs_y_N,fs_z_N,fv_x_N,fv_y_N,fv_z_N,ff_x_N,ff_y_N,ff_z_N,side,contacts_2,"
        "wheel_rev_min,wheel_load_N_mm,load_index");
    EXPECT_NE(lines[1].find(",free,0,"), std::string::npos) << lines[1];
    EXPECT_NE(lines[4001].find(",inner,0,"), std::string::npos) << lines[4001];
    EXPECT_NEAR(numbers_of(lines[4001].substr(lines[4001].find(",inner,0,") + 9))[0], 150.0, 4.0)
        << "the pedal's speed, less what drag and hands take";
}

TEST_F(StudioThrow, IsReplayedToTheBitAndThrownAgainFromItsSession) {
    expect_silent_success(onggi({"throw", "g.csv", "--clay-mass", "500", "--save", "a.onggi", "--forces",
                                 "a.csv", "--export", "a.glb"}));
    const ProgramRun replayed = onggi({"replay", "a.onggi", "--validate"});
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
    EXPECT_NE(replayed.out.find("5001 ticks replayed"), std::string::npos) << replayed.out;
    expect_silent_success(
        onggi({"throw", "a.onggi", "--save", "b.onggi", "--forces", "b.csv", "--export", "b.glb"}));
    for (const char* ending : {".onggi", ".csv", ".glb"}) {
        EXPECT_TRUE(content_of(folder_ / (std::string("a") + ending)) ==
                    content_of(folder_ / (std::string("b") + ending)))
            << ending;
    }
}

// Down onto the lump twice the same way, once without pressing.
TEST_F(StudioThrow, LeavesTheClayAloneWhereTheHandDoesNotPress) {
    put_file(folder_ / "g.csv", kGestureHeaderLine.substr(0, kGestureHeaderLine.size() - 1) +
                                    ",pressing\n0,0,90,0,1,10,0\n1,0,40,0,1,10,0\n2,0,90,0,1,10,1\n"
                                    "3,0,40,0,1,10,\n4,0,40,0,1,10,0\n5,0,40,0,1,10,0\n");
    expect_silent_success(onggi({"throw", "g.csv", "--forces", "f.csv", "--save", "s.onggi"}));
    const auto lines = lines_of(content_of(folder_ / "f.csv"));
    ASSERT_EQ(lines.size(), 5002U);
    std::size_t touching = 0;
    for (std::size_t tick = 0; tick <= 5000; ++tick) {
        const std::string& line = lines[1 + tick];
        const std::string contacts = line.substr(line.find(',', line.find(',') + 1) + 1);
        if (contacts.starts_with("0,")) continue;
        ++touching;
        ASSERT_TRUE(tick >= 2000 && tick < 4000) << line;
    }
    EXPECT_GT(touching, 1000U);
    const ProgramRun replayed = onggi({"replay", "s.onggi", "--validate"});
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
}

TEST_F(StudioThrow, RefusesAColumnItCannotUseWithItsLine) {
    put_file(folder_ / "bad.csv", kGestureHeaderLine.substr(0, kGestureHeaderLine.size() - 1) +
                                      ",tool\n0,1,2,3,0,10,hand\n1,1,2,3,0,10,fork\n");
    expect_one_line(onggi({"throw", "bad.csv"}), 2,
                    "bad.csv:3: tool: expected hand, rib, sponge, trimmer, found 'fork'");
    put_file(folder_ / "bad.csv", kGestureHeaderLine.substr(0, kGestureHeaderLine.size() - 1) +
                                      ",guided,pressing\n0,1,2,3,0,10,1,1\n1,1,2,3,0,10,1,maybe\n");
    expect_one_line(onggi({"throw", "bad.csv"}), 2, "bad.csv:3: pressing: expected 0 or 1, found 'maybe'");
}

}  // namespace
}  // namespace onggi::test
