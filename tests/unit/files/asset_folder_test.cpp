#include "engine/files/asset_folder.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

class AssetFolder : public testing::Test {
  protected:
    void make(const fs::path& folder) { fs::create_directories(root_ / folder); }

    const test::TemporaryFolder folder_;
    const fs::path& root_ = folder_.path();
};

TEST_F(AssetFolder, OfAnInstalledProgramIsBesideItsBin) {
    make("bin");
    make("share/onggi/workshop");
    const auto found = find_asset("workshop", {.chosen = "", .program = root_ / "bin/onggi"});
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(*found, root_ / "share/onggi/workshop");
}

TEST_F(AssetFolder, OfABuildIsInItsSourceTree) {
    make("build/release/tests");
    make("assets/workshop");
    for (const char* program : {"build/release/onggi", "build/release/tests/unit_files"}) {
        const auto found = find_asset("workshop", {.chosen = "", .program = root_ / program});
        ASSERT_TRUE(found) << found.error().message;
        EXPECT_EQ(*found, root_ / "assets/workshop");
    }
}

TEST_F(AssetFolder, NearestToTheProgramWins) {
    make("assets/workshop");
    make("build/share/onggi/workshop");
    const auto found = find_asset("workshop", {.chosen = "", .program = root_ / "build/release/onggi"});
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, root_ / "build/share/onggi/workshop");
}

TEST_F(AssetFolder, ThatTheUserChoseIsTheOnlyOneLookedAt) {
    make("share/onggi/workshop");
    make("mine/workshop");
    const fs::path program = root_ / "bin/onggi";
    const auto found = find_asset("workshop", {.chosen = (root_ / "mine").string(), .program = program});
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, root_ / "mine/workshop");
    const auto missing = find_asset("workshop", {.chosen = (root_ / "other").string(), .program = program});
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(missing.error().message.rfind("ONGGI_ASSETS: expected a folder with workshop in it", 0), 0U);
}

TEST_F(AssetFolder, MissingEverywhereIsSaidInOneLine) {
    // Four folders are looked through, all of them inside the test's own: what lies beside it is not seen,
    // and neither are assets one folder too far up.
    make("assets/workshop");
    const auto found = find_asset("workshop", {.chosen = "", .program = root_ / "a/b/c/bin/onggi"});
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ErrorKind::kSystemLacks);
    EXPECT_EQ(found.error().message.find('\n'), std::string::npos);
    EXPECT_FALSE(find_asset("workshop", {}));
}

TEST_F(AssetFolder, OfThisVeryTestIsFound) {
    const auto found = find_asset("workshop", {.chosen = "", .program = asset_places().program});
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_TRUE(fs::exists(*found / "cameras.json"));
}

}  // namespace
}  // namespace onggi::files
