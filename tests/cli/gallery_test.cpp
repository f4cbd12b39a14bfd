// `onggi gallery` as staff use it: one archive, one clear line, nothing half there.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "game/app/system/start_log.h"
#include "tests/cli/cli_expectations.h"

namespace onggi::test {
namespace {

namespace fs = std::filesystem;

class TheGallery : public testing::Test {
  protected:
    TheGallery() {
        for (const char* session : {"vase-100hz", "touch-still-300hz", "two-hands-250hz"}) {
            const fs::path pot = old_ / ("2026-11-25/pot-00" + std::to_string(++pots_));
            fs::create_directories(pot);
            fs::copy_file(in_checkout(std::string("tests/replay/sessions/") + session + ".onggi"),
                          pot / "pot.onggi");
            put_file(pot / "pot.glb", std::string(2'000'000, 'v'));
        }
        fs::create_directories(old_ / "statistics");
        put_file(old_ / "statistics/starts.csv", "day,hour\n2026-11-25,09\n");
    }
    [[nodiscard]] ProgramRun run(const std::string& way, const fs::path& gallery,
                                 const ProgramOptions& options = {}) const {
        return run_onggi(words(way, gallery), options);
    }
    [[nodiscard]] std::vector<std::string> words(const std::string& way, const fs::path& gallery) const {
        put_file(settings_, "[gallery]\nleast_free_mb = 1\n");
        return {"gallery",          way,         archive_.string(), "--config",
                settings_.string(), "--gallery", gallery.string()};
    }
    // Files by their names, without the program's own.
    static std::map<std::string, std::string> tree_of(const fs::path& gallery) {
        std::map<std::string, std::string> tree;
        for (const auto& entry : fs::recursive_directory_iterator(gallery))
            if (entry.is_regular_file() && entry.path().filename() != "lock")
                tree[fs::relative(entry.path(), gallery).string()] = content_of(entry.path());
        return tree;
    }

    TemporaryFolder folder_;
    fs::path old_ = folder_ / "old";
    fs::path new_ = folder_ / "new";
    fs::path archive_ = folder_ / "house.zip";
    fs::path settings_ = folder_ / "kiosk.toml";
    int pots_ = 0;
};

TEST_F(TheGallery, LeavesAndComesBackToTheByte) {
    const ProgramRun out = run("export", old_);
    EXPECT_EQ(out.exit_code, 0) << out.err;
    EXPECT_EQ(out.out, archive_.string() + ": 3 pots and 0 pages, with the statistics\n");
    const ProgramRun in = run("import", new_);
    EXPECT_EQ(in.exit_code, 0) << in.err;
    EXPECT_EQ(in.out, archive_.string() + ": 3 pots new, 0 there already; 0 pages; statistics of 1 day\n");
    EXPECT_EQ(tree_of(new_), tree_of(old_));
    EXPECT_EQ(run("import", new_).out,
              archive_.string() + ": 0 pots new, 3 there already; 0 pages; statistics of 0 days\n");
    EXPECT_EQ(tree_of(new_), tree_of(old_));
}

TEST_F(TheGallery, StaysAloneWhileAKioskRunsOnIt) {
    ASSERT_EQ(run("export", old_).exit_code, 0);
    app::GalleryLock kiosk;
    ASSERT_TRUE(kiosk.take(old_ / "state"));
    const std::string line =
        "expected no other kiosk at this gallery, found process " + std::to_string(::getpid());
    const auto before = tree_of(old_);
    expect_one_line(run("export", old_), 3, line);
    expect_one_line(run("import", old_), 3, line);
    EXPECT_EQ(tree_of(old_), before);
}

TEST_F(TheGallery, RejectsWhatItCannotReadOrWriteInOneLine) {
    expect_one_line(run("move", old_), 2, "way: expected export|import, found 'move'");
    expect_one_line(run_onggi({"gallery", "export"}), 2, "archive is required");
    expect_one_line(run("export", folder_ / "none"), 2, "none: expected a gallery, found none");
    expect_one_line(run("import", new_), 2, "house.zip: no such file");
    put_file(archive_, "a text");
    expect_one_line(run("import", new_), 2, "expected a whole ZIP file, found another kind of file");
    EXPECT_TRUE(tree_of(new_).empty());
    archive_ = folder_ / "nowhere/house.zip";
    expect_one_line(run("export", old_), 2, "nowhere is not there");
}

TEST_F(TheGallery, IsWholeAfterKillsInTheMiddle) {
    ASSERT_EQ(run("export", old_).exit_code, 0);
    for (int after_ms = 0; after_ms < 120; after_ms += 8) {
        fs::remove_all(new_);
        static_cast<void>(run_onggi_and_kill(words("import", new_), after_ms));
        const ProgramRun again = run("import", new_);
        EXPECT_EQ(again.exit_code, 0) << again.err;
        EXPECT_EQ(tree_of(new_), tree_of(old_)) << "killed after " << after_ms << " ms";
    }
}

TEST_F(TheGallery, BelongsToItsOwnerAlsoWhenRootBringsItIn) {
    if (::getuid() != 0) GTEST_SKIP() << "only root may act for another user";
    constexpr uid_t kKiosk = 65'533;
    ASSERT_EQ(run("export", old_).exit_code, 0);
    ASSERT_EQ(::chmod(folder_.path().c_str(), 0755), 0);
    ASSERT_EQ(::chmod(archive_.c_str(), 0600), 0) << "it is root's alone";
    fs::create_directories(new_);
    ASSERT_EQ(::chown(new_.c_str(), kKiosk, kKiosk), 0);
    const ProgramRun in = run("import", new_);
    ASSERT_EQ(in.exit_code, 0) << in.err;
    for (const auto& entry : fs::recursive_directory_iterator(new_)) {
        struct stat status {};
        ASSERT_EQ(::stat(entry.path().c_str(), &status), 0);
        EXPECT_EQ(status.st_uid, kKiosk) << entry.path();
        EXPECT_EQ(status.st_gid, kKiosk) << entry.path();
    }
}

}  // namespace
}  // namespace onggi::test
