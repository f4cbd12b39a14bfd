// `onggi status` as a museum's monitoring calls it: exit codes, one object, one line of refusal; and as
// another user, with and without permission.
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "game/app/kiosk/health/house_status.h"
#include "game/app/system/wall_clock.h"
#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

namespace fs = std::filesystem;

class Status : public testing::Test {
  protected:
    Status() {
        config_.gallery.folder = gallery_.string();
        config_.gallery.least_free_mb = 1.0;
        put_file(settings_, "[gallery]\nfolder = \"" + gallery_.string() + "\"\nleast_free_mb = 1\n");
    }
    void beat(std::int64_t ago_s) {
        const auto done = app::KioskHeartbeat(config_).beat(
            {.screen = "attract", .frames_shown = 1, .haptic_ticks = 1}, app::wall_clock_s() - ago_s);
        ASSERT_TRUE(done) << done.error().message;
    }
    [[nodiscard]] ProgramRun run(std::vector<std::string> words, const ProgramOptions& options = {}) const {
        words.insert(words.begin(), {"status", "--config", settings_.string()});
        return run_onggi(words, options);
    }

    TemporaryFolder folder_;
    fs::path gallery_ = folder_ / "gallery";
    fs::path settings_ = folder_ / "kiosk.toml";
    kiosk::Config config_;
};

TEST_F(Status, EndsWithZeroWhereAllIsWellAndWithOneWhereNot) {
    EXPECT_EQ(run({}).exit_code, 1) << "never started";
    beat(0);
    const ProgramRun well = run({"--json"});
    EXPECT_EQ(well.exit_code, 0) << well.out;
    EXPECT_EQ(well.err, "");
    const auto json = nlohmann::json::parse(well.out);
    EXPECT_EQ(json.at("well"), true);
    EXPECT_EQ(json.at("state"), "running");
    EXPECT_LE(json.at("heartbeat").at("age_s"), 60);
    beat(200);
    const ProgramRun silent = run({});
    EXPECT_EQ(silent.exit_code, 1);
    EXPECT_NE(silent.out.find("health     no heartbeat for 20"), std::string::npos) << silent.out;
}

TEST_F(Status, LeavesAllAsItWas) {
    beat(0);
    fs::create_directories(gallery_ / "2026-11-25/pot-001.part");  // of a pot that is just being kept
    const auto before = fs::last_write_time(gallery_ / "state");
    EXPECT_EQ(run({}).exit_code, 0);
    EXPECT_TRUE(fs::exists(gallery_ / "2026-11-25/pot-001.part"));
    EXPECT_EQ(fs::last_write_time(gallery_ / "state"), before);
}

TEST_F(Status, RefusesWrongSettingsAndDamagedFilesInOneLine) {
    put_file(folder_ / "wrong.toml", "[gallery]\nfolde = \"x\"\n");
    expect_one_line(run_onggi({"status", "--config", (folder_ / "wrong.toml").string()}), 2, "line 2");
    expect_one_line(run_onggi({"status", "--config", (folder_ / "none.toml").string()}), 2, "no such file");
    beat(0);
    put_file(app::status_file(gallery_), "{");
    expect_one_line(run({}), 2, "status.json");
}

TEST_F(Status, SaysThatItMayNotLookAndMayAsOneOfTheGroup) {
    if (::getuid() != 0) GTEST_SKIP() << "only root may become another user";
    beat(0);
    constexpr uid_t kStranger = 65'533;
    constexpr gid_t kGroup = 65'532;
    const auto as_one_of = [&](gid_t group) {
        return ProgramOptions{.in_child = [group] {
            if (::setgroups(0, nullptr) != 0 || ::setgid(group) != 0 || ::setuid(kStranger) != 0) ::abort();
        }};
    };
    // As the service leaves them: UMask=0027, StateDirectoryMode=0750, settings 0640.
    ASSERT_EQ(::chmod(folder_.path().c_str(), 0755), 0);
    for (const fs::path& place : {gallery_, gallery_ / "state", app::status_file(gallery_), settings_}) {
        ASSERT_EQ(::chown(place.c_str(), 0, kGroup), 0);
        ASSERT_EQ(::chmod(place.c_str(), fs::is_directory(place) ? 0750 : 0640), 0);
    }
    expect_one_line(run({"--json"}, as_one_of(kStranger)), 3, "kiosk.toml");
    EXPECT_EQ(run({"--json"}, as_one_of(kGroup)).exit_code, 0);
    ASSERT_EQ(::chmod(settings_.c_str(), 0644), 0);
    expect_one_line(run({"--json"}, as_one_of(kStranger)), 3, "expected permission to read it");
}

}  // namespace
}  // namespace onggi::test
