// A gallery that moves to another machine: to the byte, once, whole or not at all.
#include "game/app/kiosk/gallery/moving_house.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "engine/files/atomic_folder.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/sharing/kept_note.h"
#include "tests/support/hostile_system.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kNoonS = 1'795'608'000;  // of 2026-11-25, UTC
constexpr const char* kCode = "K73FQ9TX";

using Tree = std::map<std::string, std::string>;  // files by their names

Tree tree_of(const fs::path& folder) {
    Tree tree;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            tree[fs::relative(entry.path(), folder).string()] = test::content_of(entry.path());
    return tree;
}

// A kiosk's folders.
struct Place {
    explicit Place(const fs::path& folder) : root(folder) {
        config.gallery.folder = (folder / "gallery").string();
        config.gallery.least_free_mb = 1.0;
        config.sharing.public_url = "http://pots.example";
        config.sharing.outbox = (folder / "outbox").string();
        fs::create_directories(folder / "gallery");
    }
    void put_pot(const std::string& name, const std::string& session) const {
        const fs::path pot = root / "gallery" / name;
        fs::create_directories(pot);
        fs::copy_file(test::in_checkout("tests/replay/sessions/" + session + ".onggi"), pot / "pot.onggi");
        for (const char* file : {"pot.glb", "pot.stl", "pot.3mf", "pot.png"})
            test::put_file(pot / file, name + session + file);
    }
    void put_page(const std::string& code, const std::string& pot, std::int64_t expires_s) const {
        fs::create_directories(root / "outbox" / code);
        test::put_file(root / "outbox" / code / "en.html", "<p>" + pot);
        test::put_file(root / "outbox" / code / ".kept",
                       sharing::written({.made_s = kNoonS, .expires_s = expires_s, .gallery_name = pot}));
    }
    [[nodiscard]] Result<Moved> take_out(const fs::path& archive) const {
        return export_gallery(config, archive, [](auto, auto) {});
    }
    [[nodiscard]] Result<Moved> bring_in(const fs::path& archive) const {
        auto reader = files::ArchiveReader::open(archive);
        if (!reader) return reader.error();
        return import_gallery(std::move(*reader), config, kNoonS + 60, [](auto, auto) {});
    }

    fs::path root;
    kiosk::Config config{};
};

class MovingHouse : public testing::Test {
  protected:
    void SetUp() override {
        old_.put_pot("2026-11-24/pot-001", "vase-100hz");
        old_.put_pot("2026-11-25/pot-001", "touch-still-300hz");
        old_.put_pot("2026-11-25/pot-1000", "two-hands-250hz");
        fs::copy_file(test::in_checkout("tests/replay/sessions/vase-100hz.onggi"),
                      old_.root / "gallery/2026-11-25/pot-001/bowl-1.onggi");
        old_.put_page(kCode, "2026-11-25/pot-001", kNoonS + 3600);
        old_.put_page("K73FQ9TZ", "2026-11-24/pot-001", kNoonS + 10);
        const fs::path statistics = old_.root / "gallery/statistics";
        ASSERT_TRUE(note_visit(statistics, {.dwell_s = 100, .kept = 1}, kNoonS - 86'400));
        ASSERT_TRUE(note_visit(statistics, {.dwell_s = 77}, kNoonS));
        ASSERT_TRUE(note_start(statistics, kNoonS));
        test::put_file(statistics / "staff.toml", "[sound]\nvolume = 2\n");
        fs::create_directories(old_.root / "gallery/state");
        test::put_file(old_.root / "gallery/state/visit-1.onggi.part", "the pot on the wheel");
        ASSERT_TRUE(old_.take_out(archive_));
    }
    // Refused with such a line, and nothing changed.
    void expect_refused(const Place& place, const std::string& line, ErrorKind kind = ErrorKind::kBadInput) {
        const Tree before = tree_of(place.root);
        const auto moved = place.bring_in(archive_);
        ASSERT_FALSE(moved) << "expected: " << line;
        EXPECT_EQ(moved.error().kind, kind) << moved.error().message;
        EXPECT_NE(moved.error().message.find(line), std::string::npos)
            << "expected: " << line << "\nfound: " << moved.error().message;
        EXPECT_EQ(tree_of(place.root), before);
        EXPECT_FALSE(fs::exists(place.root / "gallery/import"));
        EXPECT_FALSE(fs::exists(place.root / "gallery/import.part"));
    }
    // An archive of these files, after a list that fits them.
    void make_archive(const Tree& files, std::size_t pots, const std::string& list = {}) {
        std::size_t bytes = 0;
        for (const auto& [name, content] : files)
            bytes += content.size();
        auto writer = files::ArchiveWriter::create(archive_);
        ASSERT_TRUE(writer);
        ASSERT_TRUE(writer->add("onggi-gallery.json",
                                !list.empty()
                                    ? list
                                    : fmt::format(R"({{"format":1,"pots":{},"files":{},"bytes":{}}})", pots,
                                                  files.size(), bytes)));
        for (const auto& [name, content] : files)
            ASSERT_TRUE(writer->add(name, content));
        ASSERT_TRUE(writer->commit());
    }

    const test::TemporaryFolder folder_;
    fs::path archive_ = folder_ / "house.zip";
    Place old_{folder_ / "old"};
    Place new_{folder_ / "new"};
};

TEST_F(MovingHouse, BringsPotsPagesAndStatisticsToAnEmptyGalleryToTheByte) {
    const auto moved = new_.bring_in(archive_);
    ASSERT_TRUE(moved) << moved.error().message;
    EXPECT_EQ(moved->pots, 3U);
    EXPECT_EQ(moved->pots_there, 0U);
    EXPECT_EQ(moved->pages, 1U) << "the other one has expired";
    EXPECT_EQ(moved->days, 2U);
    Tree expected = tree_of(old_.root);
    expected.erase("gallery/state/visit-1.onggi.part");
    expected.erase("outbox/K73FQ9TZ/.kept");
    expected.erase("outbox/K73FQ9TZ/en.html");
    EXPECT_EQ(tree_of(new_.root), expected);
    ASSERT_TRUE(new_.take_out(folder_ / "again.zip"));
    Place third(folder_ / "third");
    ASSERT_TRUE(third.bring_in(folder_ / "again.zip"));
    EXPECT_EQ(tree_of(third.root), expected);
}

TEST_F(MovingHouse, LeavesAloneWhatIsThereAlready) {
    ASSERT_TRUE(new_.bring_in(archive_));
    const Tree before = tree_of(new_.root);
    const auto again = new_.bring_in(archive_);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->pots, 0U);
    EXPECT_EQ(again->pots_there, 3U);
    EXPECT_EQ(again->pages, 0U);
    EXPECT_EQ(again->days, 0U);
    EXPECT_EQ(tree_of(new_.root), before);
}

TEST_F(MovingHouse, GivesAnotherPotOfTheSameNumberTheNextFreeOneAndTellsItsPage) {
    new_.put_pot("2026-11-25/pot-001", "one-finger-250hz");
    const Tree before = tree_of(new_.root);
    const auto moved = new_.bring_in(archive_);
    ASSERT_TRUE(moved) << moved.error().message;
    EXPECT_EQ(moved->pots, 3U);
    const Tree after = tree_of(new_.root);
    for (const auto& [name, content] : before)
        EXPECT_EQ(after.at(name), content) << name;
    const Tree old = tree_of(old_.root);
    for (const char* file : {"pot.onggi", "bowl-1.onggi", "pot.glb"})
        EXPECT_EQ(after.at(std::string("gallery/2026-11-25/pot-1001/") + file),
                  old.at(std::string("gallery/2026-11-25/pot-001/") + file));
    const auto note = sharing::read_note(after.at(std::string("outbox/") + kCode + "/.kept"));
    ASSERT_TRUE(note);
    EXPECT_EQ(note->gallery_name, "2026-11-25/pot-1001");
    EXPECT_EQ(new_.bring_in(archive_)->pots_there, 3U) << "under its new number too";
}

TEST_F(MovingHouse, CountsADayOnceAndTwoMachinesTwice) {
    const fs::path statistics = new_.root / "gallery/statistics";
    // The kiosk was started once in its new place, by a program that wrote other columns.
    ASSERT_TRUE(note_start(statistics, kNoonS));
    ASSERT_TRUE(note_start(statistics, kNoonS + 86'400));
    test::put_file(
        statistics / "visits.csv",
        "day,hour,dwell_s,ended_on,kept\n2026-11-24,12,100,attract,1\n2026-11-24,12,55,attract,0\n");
    ASSERT_TRUE(new_.bring_in(archive_));
    EXPECT_EQ(use_of(statistics, "2026-11-25").starts, 1) << "an earlier part of the same day";
    EXPECT_EQ(use_of(statistics, "2026-11-26").starts, 1);
    EXPECT_EQ(use_of(statistics, "2026-11-25").total().visits, 1);
    EXPECT_EQ(use_of(statistics, "2026-11-24").total().visits, 3) << "two machines' visits";
    const std::string table = test::content_of(statistics / "visits.csv");
    EXPECT_TRUE(table.starts_with("day,hour,dwell_s,ended_on,kept\n2026-11-24,12,100,")) << table;
    EXPECT_EQ(new_.bring_in(archive_)->days, 0U);
    EXPECT_EQ(test::content_of(statistics / "visits.csv"), table);
}

TEST_F(MovingHouse, KeepsTheStaffsSettingsOfTheNewMachine) {
    fs::create_directories(new_.root / "gallery/statistics");
    test::put_file(new_.root / "gallery/statistics/staff.toml", "[sound]\nvolume = 5\n");
    ASSERT_TRUE(new_.bring_in(archive_));
    EXPECT_EQ(test::content_of(new_.root / "gallery/statistics/staff.toml"), "[sound]\nvolume = 5\n");
}

TEST_F(MovingHouse, BringsNoPagesWhereNothingIsShared) {
    new_.config.sharing.public_url.clear();
    const auto moved = new_.bring_in(archive_);
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->pages, 0U);
    EXPECT_FALSE(fs::exists(new_.root / "outbox"));
}

TEST_F(MovingHouse, IsCompletedByTheNextStartAfterAKill) {
    // As after a kill between the last check and the first pot: staged, and renamed.
    ASSERT_TRUE(new_.bring_in(archive_));
    Place killed(folder_ / "killed");
    const fs::path staged = killed.root / "gallery/import";
    const fs::path from = new_.root / "gallery";
    fs::create_directories(staged / "pots");
    fs::create_directories(killed.root / "gallery/2026-11-24");
    fs::copy(from / "2026-11-24/pot-001", killed.root / "gallery/2026-11-24/pot-001");
    fs::copy(from / "2026-11-25", staged / "pots/2026-11-25", fs::copy_options::recursive);
    fs::copy(from / "statistics", staged / "statistics");
    fs::copy(new_.root / "outbox", staged / "shared", fs::copy_options::recursive);
    ASSERT_TRUE(finish_import(killed.config));
    EXPECT_EQ(tree_of(killed.root), tree_of(new_.root));
    EXPECT_TRUE(finish_import(killed.config)) << "nothing is left to do";
}

TEST_F(MovingHouse, RejectsEveryCutAndDamagedArchive) {
    const std::string whole = test::content_of(archive_);
    for (int part = 0; part < 20; ++part) {
        test::put_file(archive_, whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 20));
        expect_refused(new_, "house.zip");
    }
    // In the middle of a packed session.
    std::string changed = whole;
    changed[whole.find("pot.onggi") + 4000] ^= 1;
    test::put_file(archive_, changed);
    expect_refused(new_, "2026-11-24/pot-001/pot.onggi: expected an undamaged archive, found");
}

TEST_F(MovingHouse, RejectsWhatIsNoArchiveOfAGalleryOrALaterOne) {
    test::put_file(archive_, "a text");
    expect_refused(new_, "house.zip: expected a whole ZIP file, found another kind of file");
    auto other = files::ArchiveWriter::create(archive_);
    ASSERT_TRUE(other && other->add("photo.jpg", "x") && other->commit());
    expect_refused(new_, "which begins with onggi-gallery.json, found 'photo.jpg'");
    make_archive({}, 0, R"({"format":2})");
    expect_refused(new_, "onggi-gallery.json: expected format 1, found 2: upgrade this program first");
    for (const char* list : {"", "{", "[]", R"({"format":"1"})", R"({"format":-1})", R"({"format":1.5})"}) {
        make_archive({}, 0, std::string(list) + " ");
        expect_refused(new_, "expected format 1, found none");
    }
}

TEST_F(MovingHouse, RejectsNamesThatLeaveTheFolderOrDoNotBelongThere) {
    for (const char* name : {"../x",
                             "/etc/x",
                             "pots/../../x",
                             "pots/2026-11-25/../pot-001/x",
                             "pots/2026-11-25/pot-001/..",
                             "pots/2026-11-25/pot-001/.",
                             "pots/2026-11-25/pot-001/a/b",
                             "pots/2026-11-25/pot-001/.hidden",
                             "pots/2026-11-25/pot-001/x.part",
                             "pots/2026-11-25/pot-0/x",
                             "pots/2026-11-25/pot--1/x",
                             "pots/2026-11-25/pot-001.part/x",
                             "pots/day/pot-001/x",
                             "statistics/../x",
                             "statistics/a/x",
                             "shared/../x",
                             "shared/CODE/x",
                             "shared/K73FQ9TX/a/x",
                             "state/lock",
                             "pots\\x",
                             "x",
                             "a\nb",
                             "pots//pot-001/x"}) {
        make_archive({{name, "x"}}, 0);
        expect_refused(new_, "house.zip: expected pots/DAY/pot-N/FILE, statistics/FILE or shared/CODE/FILE");
    }
}

TEST_F(MovingHouse, RejectsFilesThatItsListDoesNotTell) {
    const Tree table{{"statistics/visits.csv", "day,hour\n"}};
    make_archive(table, 0, R"({"format":1,"pots":0,"files":0,"bytes":0})");
    expect_refused(new_, "expected 0 files with 0 bytes, as its onggi-gallery.json says, found more");
    make_archive(table, 0, R"({"format":1,"pots":0,"files":2,"bytes":9})");
    expect_refused(new_, "expected 2 files with 9 bytes, as its onggi-gallery.json says, found 1 with 9");
    make_archive(table, 0, R"({"format":1,"pots":0,"files":1,"bytes":8})");
    expect_refused(new_, "statistics/visits.csv: expected at most 8 bytes, found more");
    make_archive(table, 1);
    expect_refused(new_, "expected 1 pots, as its onggi-gallery.json says, found 0");
    make_archive({{"pots/2026-11-25/pot-001/pot.glb", "x"}}, 1);
    expect_refused(new_, "expected a pot.onggi in every pot, found none in 2026-11-25/pot-001");
}

TEST_F(MovingHouse, RejectsAPotWhoseSessionFailsItsCheck) {
    const std::string name = "pots/2026-11-25/pot-001/pot.onggi";
    const std::string whole = test::content_of(test::in_checkout("tests/replay/sessions/vase-100hz.onggi"));
    make_archive({{name, whole.substr(0, whole.size() / 2)}}, 1);
    expect_refused(new_, name + ": expected a whole session, found it cut");
    std::string later = whole;
    later[10] = 99;
    make_archive({{name, later}}, 1);
    expect_refused(new_, name);
    make_archive({{name, "clay"}}, 1);
    expect_refused(new_, name);
    // The export says so already, and leaves no archive.
    old_.put_pot("2026-11-25/pot-002", "vase-100hz");
    test::put_file(old_.root / "gallery/2026-11-25/pot-002/pot.onggi", "clay");
    fs::remove(archive_);
    const auto moved = old_.take_out(archive_);
    ASSERT_FALSE(moved);
    EXPECT_NE(moved.error().message.find("2026-11-25/pot-002/pot.onggi"), std::string::npos);
    EXPECT_FALSE(fs::exists(archive_));
}

TEST_F(MovingHouse, RejectsMorePotsThanTheGalleryKeepsAndMoreThanTheDiskHolds) {
    new_.put_pot("2026-11-26/pot-001", "one-finger-250hz");
    new_.config.gallery.most_pots = 3;
    expect_refused(new_, "expected room for 3 pots beside 1, found most_pots = 3 in [gallery]");
    new_.config.gallery.most_pots = 4;
    new_.config.gallery.least_free_mb = 1e9;
    expect_refused(new_, "MB free, found", ErrorKind::kSystemLacks);
    new_.config.gallery.least_free_mb = 1.0;
    make_archive({}, 0, R"({"format":1,"pots":0,"files":1,"bytes":9000000000000000000})");
    expect_refused(new_, "MB free, found", ErrorKind::kSystemLacks);
}

TEST_F(MovingHouse, LeavesTheGalleryAsItWasOnADiskThatFills) {
    const std::string answer = test::in_child([&]() -> std::string {
        Place small(folder_ / "small");
        if (!test::mount_small_disk(small.root.string(), 300 << 10)) return "no mounts";
        fs::create_directories(small.root / "gallery");
        small.put_pot("2026-11-26/pot-001", "touch-still-300hz");
        small.config.gallery.least_free_mb = 0.0;
        // They have room by their bytes, and none by the blocks of the disk.
        Tree files{{"pots/2026-11-25/pot-001/pot.onggi",
                    test::content_of(test::in_checkout("tests/replay/sessions/vase-100hz.onggi"))}};
        for (int i = 0; i < 80; ++i)
            files[fmt::format("pots/2026-11-25/pot-001/{}", i)] = "x";
        make_archive(files, 1);
        const Tree before = tree_of(small.root);
        const auto moved = small.bring_in(archive_);
        if (moved) return "there was room";
        if (tree_of(small.root) != before) return "the gallery has changed";
        return moved.error().kind == ErrorKind::kSystemLacks ? "full" : moved.error().message;
    });
    if (answer == "no mounts") GTEST_SKIP() << "no mounts of its own";
    EXPECT_EQ(answer, "full");
}

}  // namespace
}  // namespace onggi::app
