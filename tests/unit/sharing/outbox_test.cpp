#include "game/sharing/outbox.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "game/sharing/kept_note.h"
#include "shaders/curve.h"
#include "tests/support/hostile_system.h"
#include "tests/support/shared_pot_samples.h"
#include "tests/support/temporary_folder.h"

namespace onggi::sharing {
namespace {

namespace fs = std::filesystem;

constexpr ShareTime kNoon{.now_s = 1'000'000, .expires_s = 1'020'000};

Outbox open_in(const fs::path& folder, std::size_t most_pots = 200,
               std::uint64_t most_bytes = 1'000'000'000) {
    auto outbox = Outbox::open({.folder = folder,
                                .most_pots = most_pots,
                                .most_bytes = most_bytes,
                                .languages = support::three_languages()});
    EXPECT_TRUE(outbox) << outbox.error().message;
    return std::move(outbox).value();
}

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class OutboxTest : public testing::Test {
  protected:
    const test::TemporaryFolder folder_;
};

TEST_F(OutboxTest, KeepsAPotWholeAndFindsItAfterARestart) {
    const SharedPot pot = support::full_pot("one");
    std::string code;
    {
        Outbox outbox = open_in(folder_ / "box");
        const auto put = outbox.put(pot, kNoon);
        ASSERT_TRUE(put) << put.error().message;
        code = put->text();
    }
    const fs::path place = folder_ / "box" / code;
    EXPECT_EQ(test::content_of(place / "pot.glb"), text_of(pot.model_glb.bytes));
    EXPECT_EQ(test::content_of(place / "pot.png"), text_of(pot.picture.bytes));
    for (const char* name :
         {"index.html", "en.html",       "ko.html",     "ar.html",     "page.css",   "pot.js",
          "poster.png", "pot.stl",       "pot.3mf",     "film.webp",   "film.mp4",   "pot.svg",
          "pot.pdf",    "pot.json",      "still.png",   "surface.png", ".kept",      "pot.glb.gz",
          "pot.stl.gz", "index.html.gz", "page.css.gz", "pot.js.gz",   "pot.svg.gz", "pot.json.gz"})
        EXPECT_TRUE(fs::is_regular_file(place / name)) << name;
    for (const char* name : {"pot.png.gz", "pot.3mf.gz", "film.webp.gz", "film.mp4.gz", ".kept.gz"})
        EXPECT_FALSE(fs::exists(place / name)) << name;
    EXPECT_EQ(test::content_of(place / "index.html"), test::content_of(place / "en.html"));

    const Outbox again = open_in(folder_ / "box");
    const auto all = again.list();
    ASSERT_TRUE(all);
    ASSERT_EQ(all->size(), 1U);
    EXPECT_EQ(all->front().code.text(), code);
    EXPECT_EQ(all->front().expires_s, kNoon.expires_s);
    std::uintmax_t bytes = 0;
    for (const auto& file : fs::directory_iterator(place))
        bytes += file.file_size();
    EXPECT_EQ(all->front().bytes, bytes);
}

TEST_F(OutboxTest, ShowsThePotInTheTonesOfTheWheelsScreen) {
    const auto code = open_in(folder_ / "box").put(support::full_pot("one"), kNoon);
    ASSERT_TRUE(code);
    const std::string script = test::content_of(folder_ / "box" / code->text() / "pot.js");
    const std::string curve =
        fmt::format("c = c / ({} * c + {});", shaders::kCurveSlope, shaders::kCurveFoot);
    EXPECT_NE(script.find(curve), std::string::npos) << curve;
}

TEST_F(OutboxTest, OpensWithTheVisitorsLanguage) {
    Outbox outbox = open_in(folder_ / "box");
    SharedPot pot = support::full_pot("one");
    pot.first_language = 2;
    const auto code = outbox.put(pot, kNoon);
    ASSERT_TRUE(code);
    const fs::path place = folder_ / "box" / code->text();
    EXPECT_EQ(test::content_of(place / "index.html"), test::content_of(place / "ar.html"));
}

TEST_F(OutboxTest, AddsMissingFilesToAnExistingPot) {
    Outbox outbox = open_in(folder_ / "box");
    const SharedPot whole = support::full_pot("one");
    SharedPot unfilmed = whole;
    unfilmed.film = unfilmed.film_mp4 = unfilmed.film_still = {};
    const auto code = outbox.put(unfilmed, kNoon);
    ASSERT_TRUE(code) << code.error().message;
    const fs::path place = folder_ / "box" / code->text();
    // On a disk that becomes full during the write.
    EXPECT_EQ(test::in_child([&]() -> std::string {
                  test::limit_file_size(4096);
                  return outbox.renew(*code, whole, kNoon) ? "renewed" : "refused";
              }),
              "refused");
    EXPECT_EQ(test::content_of(place / "ko.html").find("film.webp"), std::string::npos);
    EXPECT_EQ(test::content_of(place / "pot.glb"), text_of(whole.model_glb.bytes));
    EXPECT_TRUE(*outbox.renew(*code, whole, kNoon));
    EXPECT_EQ(test::content_of(place / "film.webp"), text_of(whole.film.bytes));
    for (const char* page : {"index.html", "ko.html"})
        EXPECT_NE(test::content_of(place / page).find("href=\"film.webp\""), std::string::npos) << page;
    ASSERT_EQ(outbox.list()->size(), 1U);
    EXPECT_EQ(outbox.list()->front().expires_s, kNoon.expires_s);

    ASSERT_TRUE(*outbox.withdraw(*code));
    EXPECT_FALSE(*outbox.renew(*code, whole, kNoon));
    EXPECT_TRUE(outbox.list()->empty()) << "what was withdrawn stays away";
}

TEST_F(OutboxTest, TakesFilesFromTheDisk) {
    test::put_file(folder_ / "mine.stl", "triangles");
    Outbox outbox = open_in(folder_ / "box");
    SharedPot pot;
    pot.print_stl.path = folder_ / "mine.stl";
    const auto code = outbox.put(pot, kNoon);
    ASSERT_TRUE(code) << code.error().message;
    EXPECT_EQ(test::content_of(folder_ / "box" / code->text() / "pot.stl"), "triangles");
}

TEST_F(OutboxTest, HasPagesAtItsTopThatPreventListing) {
    static_cast<void>(open_in(folder_ / "box"));
    EXPECT_NE(test::content_of(folder_ / "box/index.html").find("name=\"code\""), std::string::npos);
    EXPECT_NE(test::content_of(folder_ / "box/404.html").find("There is no pot here"), std::string::npos);
    const auto written = fs::last_write_time(folder_ / "box/404.html");
    test::put_file(folder_ / "box/index.html", "somebody else's");
    static_cast<void>(open_in(folder_ / "box"));
    EXPECT_EQ(fs::last_write_time(folder_ / "box/404.html"), written)
        << "correct files are not written again";
    EXPECT_NE(test::content_of(folder_ / "box/index.html").find("name=\"code\""), std::string::npos);
}

TEST_F(OutboxTest, WithdrawsByCodeAndByTheGallerysName) {
    Outbox outbox = open_in(folder_ / "box");
    SharedPot pot = support::full_pot("one");
    pot.gallery_name = "2026-11-24/pot-003";
    const auto named = outbox.put(pot, kNoon);
    const auto plain = outbox.put(support::full_pot("two"), kNoon);
    ASSERT_TRUE(named && plain);
    EXPECT_FALSE(*outbox.withdraw_named("2026-11-24/pot-004"));
    EXPECT_FALSE(*outbox.withdraw_named("")) << "an empty code matches no pot";
    EXPECT_TRUE(*outbox.withdraw_named("2026-11-24/pot-003"));
    EXPECT_FALSE(fs::exists(folder_ / "box" / named->text()));
    EXPECT_TRUE(*outbox.withdraw(*plain));
    EXPECT_FALSE(*outbox.withdraw(*plain)) << "it is gone";
    EXPECT_TRUE(outbox.list()->empty());
}

TEST_F(OutboxTest, KeepsNoMoreThanItMay) {
    Outbox outbox = open_in(folder_ / "box", 3);
    std::vector<std::string> codes;
    for (int i = 0; i < 5; ++i) {
        const auto code =
            outbox.put(support::full_pot("pot"), {.now_s = 1'000'000 + i, .expires_s = 1'020'000});
        ASSERT_TRUE(code);
        codes.push_back(code->text());
    }
    std::vector<std::string> left;
    const auto all = outbox.list();
    for (const OutboxEntry& entry : *all)
        left.push_back(entry.code.text());
    EXPECT_EQ(left, std::vector<std::string>(codes.begin() + 2, codes.end())) << "the oldest leave first";

    const std::uint64_t one = outbox.list()->front().bytes;
    Outbox narrow = open_in(folder_ / "narrow", 200, 2 * one + one / 2);
    for (int i = 0; i < 4; ++i)
        ASSERT_TRUE(narrow.put(support::full_pot("pot"), {.now_s = 1'000'000 + i, .expires_s = 1'020'000}));
    EXPECT_EQ(narrow.list()->size(), 2U);
    Outbox tiny = open_in(folder_ / "tiny", 200, one / 2);
    EXPECT_FALSE(tiny.put(support::full_pot("pot"), kNoon));
    EXPECT_TRUE(tiny.list()->empty());
}

TEST_F(OutboxTest, NeverThrowsTheNewcomerOut) {
    Outbox outbox = open_in(folder_ / "box", 1);
    ASSERT_TRUE(outbox.put(support::full_pot("late"), {.now_s = 2'000'000, .expires_s = 2'020'000}));
    // The machine's clock was put back.
    const auto newcomer = outbox.put(support::full_pot("new"), kNoon);
    ASSERT_TRUE(newcomer);
    ASSERT_EQ(outbox.list()->size(), 1U);
    EXPECT_EQ(outbox.list()->front().code, *newcomer);
}

TEST_F(OutboxTest, RejectsUnsharablePots) {
    Outbox outbox = open_in(folder_ / "box");
    SharedPot no_picture = support::full_pot("x");
    no_picture.picture.bytes = support::bytes_of("GIF89a");
    const auto refused = outbox.put(no_picture, kNoon);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "the shared pot's pot: expected a PNG, JPEG or WebP picture, found none");
    SharedPot no_file;
    no_file.model_glb.path = folder_ / "none.glb";
    EXPECT_FALSE(outbox.put(no_file, kNoon));
    EXPECT_FALSE(outbox.put(support::full_pot("x"), {.now_s = 5, .expires_s = 5}));
    EXPECT_TRUE(outbox.list()->empty());
    EXPECT_EQ(fs::exists(folder_ / "box/.kept"), false);
    test::put_file(folder_ / "file", "no folder");
    const auto no_folder =
        Outbox::open({.folder = folder_ / "file", .languages = support::three_languages()});
    ASSERT_FALSE(no_folder);
    EXPECT_NE(no_folder.error().message.find("expected a folder for shared pots, found "), std::string::npos);
    EXPECT_FALSE(Outbox::open({.folder = folder_ / "box"})) << "no language";
}

TEST_F(OutboxTest, LeavesNoFolderIfTheDiskFails) {
    Outbox outbox = open_in(folder_ / "box");
    fs::permissions(folder_ / "box", fs::perms::owner_read | fs::perms::owner_exec);
    {
        const test::WithoutRootRights bound;
        const auto refused = outbox.put(support::full_pot("x"), kNoon);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().kind, ErrorKind::kSystemLacks);
    }
    fs::permissions(folder_ / "box", fs::perms::owner_all);
    EXPECT_TRUE(outbox.list()->empty());
    // A disk that becomes full during a pot.
    EXPECT_EQ(test::in_child([&]() -> std::string {
                  test::limit_file_size(4096);
                  const auto full = outbox.put(support::full_pot("x"), kNoon);
                  return full                                           ? "put"
                         : full.error().kind == ErrorKind::kSystemLacks ? "lacks"
                                                                        : full.error().message;
              }),
              "lacks");
    for (const auto& entry : fs::directory_iterator(folder_ / "box"))
        EXPECT_FALSE(entry.is_directory()) << entry.path();
}

TEST_F(OutboxTest, RemovesAKilledWritersParts) {
    fs::create_directories(folder_ / "box/K73FQ9TX.part");
    test::put_file(folder_ / "box/K73FQ9TX.part/pot.glb", "half");
    fs::create_directories(folder_ / "box/K73FQ9TY");  // without a note, so without an expiry date
    test::put_file(folder_ / "box/K73FQ9TY/pot.glb", "half");
    fs::create_directories(folder_ / "box/precious/her.part");
    test::put_file(folder_ / "box/K73FQ9TY/.onggi-2147483647-0.part",
                   "half a film");  // of a process that no longer exists
    Outbox outbox = open_in(folder_ / "box");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "box/K73FQ9TY"), {}), 1) << "pot.glb alone";
    EXPECT_FALSE(fs::exists(folder_ / "box/K73FQ9TX.part"));
    EXPECT_EQ(*outbox.expire(1), 1);
    EXPECT_FALSE(fs::exists(folder_ / "box/K73FQ9TY"));
    EXPECT_TRUE(fs::exists(folder_ / "box/precious/her.part")) << "anything but a pot is left alone";
}

TEST(KeptNote, IsReadAsItIsWritten) {
    const auto read = read_note(written({5, 9, "2026-11-24/pot-003"}));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->made_s, 5);
    EXPECT_EQ(read->expires_s, 9);
    EXPECT_EQ(read->gallery_name, "2026-11-24/pot-003");
    EXPECT_TRUE(read_note(written({-1, 9, "a\nexpires 99"})));
    for (const char* text :
         {"", "made 5\nexpires 9\n", "made 5\nexpires 9\nname x", "made 5\nexpires 9a\nname x\n",
          "made 5\nexpires 9\nname x\nmore\n", "expires 9\nmade 5\nname x\n"})
        EXPECT_FALSE(read_note(text)) << text;
    EXPECT_LE(written({5, 9, std::string(5000, 'x')}).size(), kMostNoteBytes);
}

TEST(KeptNote, OfDamagedNumbersIsNotGivenAnotherTime) {
    constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    constexpr std::int64_t kNowS = kClockIsSetS + 1000;
    EXPECT_FALSE(redated({kLeast, kMost, ""}, kNowS));
    EXPECT_FALSE(redated({9, 5, ""}, kNowS));
    EXPECT_FALSE(redated({5, 5 + 170 * 3600, ""}, kNowS)) << "no pot stays so long";
    EXPECT_TRUE(redated({5, 5 + 169 * 3600, ""}, kNowS));
    EXPECT_TRUE(is_over({kLeast, kMost, ""}, kNowS));
    EXPECT_TRUE(is_over({kMost, kLeast, ""}, kNowS));
    EXPECT_TRUE(is_over({9, 5, ""}, kNowS));
}

}  // namespace
}  // namespace onggi::sharing
