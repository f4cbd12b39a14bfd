// Files outlive the program that wrote them: this program reads a sample of every version, and writes the
// newest version that has a sample.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/archive.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/jar_keeping.h"
#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/gallery/moving_house.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/kiosk/gallery/wall_of_the_day.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/health/kiosk_status.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/stored_session.h"
#include "game/app/system/start_log.h"
#include "game/kiosk/config.h"
#include "game/record/session.h"
#include "game/record/session_format.h"
#include "game/sharing/kept_note.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi {
namespace {

namespace fs = std::filesystem;

fs::path sample(const std::string& name) {
    return test::in_checkout("tests/formats/samples/" + name);
}

Result<record::Session> read_session(const std::string& name) {
    return record::parse_session(test::content_of(sample(name)), name);
}

TEST(Sessions, OfVersion2AreReadAndOnesThatWereNeverShippedRefusedInOneLine) {
    for (const char* kept : {"session/2.0.onggi", "session/2.1.onggi", "session/2.2.onggi"}) {
        const auto session = read_session(kept);
        ASSERT_TRUE(session) << session.error().message;
        EXPECT_EQ(session->tick_count(), 9U);
        EXPECT_TRUE(session->is_complete());
    }
    EXPECT_TRUE(read_session("session/2.0.onggi")->supplement().empty());
    EXPECT_EQ(read_session("session/2.1.onggi")->supplement().size(), 31U);
    for (const char* old : {"session/1.0.onggi", "session/1.1.onggi"}) {
        const auto refused = read_session(old);
        ASSERT_FALSE(refused) << old;
        EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(refused.error().message.find("version 2."), std::string::npos) << refused.error().message;
    }
    EXPECT_EQ(record::kMajorVersion, 2) << "a new version wants a sample";
    EXPECT_EQ(record::kMinorVersion, 2) << "a new version wants a sample";
}

TEST(Settings, OfEveryVersionKeepTheirMeaning) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(sample("settings"))) {
        const std::string text = test::content_of(entry.path());
        const auto config = kiosk::read_config(text, entry.path().filename().string());
        ASSERT_TRUE(config) << config.error().message;
        EXPECT_EQ(config->languages.order, (std::vector<std::string>{"ko", "en", "ar"}));
        EXPECT_EQ(config->gallery.most_pots, 500);
        EXPECT_EQ(config->staff.closes_after_s, 120.0);
        ++count;
    }
    EXPECT_EQ(count, 12);
    EXPECT_EQ(test::content_of(test::in_checkout("assets/kiosk.toml")),
              test::content_of(sample("settings/1.11.toml")))
        << "settings that change want a version and a sample";
}

TEST(StaffSettings, OfVersion1AreTakenAndWritten) {
    const test::TemporaryFolder folder;
    auto settings = app::load_settings("");
    ASSERT_TRUE(settings);
    settings->config.sound.remember_staff = true;
    settings->config.staff.statistics_folder = folder.path().string();
    fs::copy_file(sample("staff/1.toml"), folder / "staff.toml");
    app::take_kept_house(*settings);
    EXPECT_EQ(settings->rules.default_volume, 4);
    EXPECT_EQ((*settings->languages)[static_cast<std::size_t>(settings->rules.default_language)].code(),
              "ko");
    ASSERT_TRUE(app::keep_house(folder.path(), {.volume = 4, .language = "ko"}));
    EXPECT_EQ(test::content_of(folder / "staff.toml"), test::content_of(sample("staff/1.toml")));
}

TEST(Galleries, OfBothVersionsAreOpenedTogether) {
    const test::TemporaryFolder folder;
    const std::vector<std::string> first{"pot.onggi", "pot.glb", "pot.stl", "pot.png"};
    std::vector<std::string> second = first;
    second.emplace_back("pot.3mf");
    const auto put = [&](const char* pot, const std::vector<std::string>& files) {
        fs::create_directories(folder / pot);
        for (const std::string& file : files)
            fs::copy_file(sample("session/2.0.onggi"), folder.path() / pot / file);
    };
    put("2026-11-21/pot-001", first);
    put("2026-11-22/pot-001", second);
    std::vector<std::string> third = second;
    third.insert(third.end(), {"bowl-1.onggi", "bowl-2.onggi"});
    put("2026-11-23/pot-001", third);
    kiosk::Config config;
    config.gallery.folder = folder.path().string();
    app::Gallery gallery(config);
    const auto pots = gallery.pots();
    ASSERT_EQ(pots.size(), 3U);
    EXPECT_EQ(pots[0].name, "2026-11-23/pot-001");
    EXPECT_EQ(pots[1].name, "2026-11-22/pot-001");
    EXPECT_EQ(pots[2].name, "2026-11-21/pot-001");
    ASSERT_TRUE(gallery.remove(pots[0]));
    EXPECT_EQ(gallery.pots().size(), 2U);
}

// By the program of 24 November 2026, in a window, at 4 kHz, without the pot's model and picture.
TEST(Galleries, OfTheFirstVersionAreReplayedCountedAndMoved) {
    const test::TemporaryFolder folder;
    auto archive = files::ArchiveReader::open(sample("gallery/1.zip"));
    ASSERT_TRUE(archive) << archive.error().message;
    constexpr std::size_t kMostBytes = 2'000'000;
    for (auto name = archive->next(); name && *name; name = archive->next()) {
        const auto content = archive->read(kMostBytes);
        ASSERT_TRUE(content) << content.error().message;
        const fs::path file = folder / "old" / **name;
        fs::create_directories(file.parent_path());
        test::put_file(file, *content);
    }
    const auto pots = app::kept_pots(folder / "old");
    ASSERT_EQ(pots.size(), 1U);
    auto loaded = app::load_session((pots[0].folder / "pot.onggi").string());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->session.tick_count(), 343'128U);
    EXPECT_FALSE(app::find_difference(loaded->session, std::move(loaded->start), loaded->decoration));
    EXPECT_EQ(app::use_of(folder / "old/statistics", "2026-11-29").starts, 1);
    kiosk::Config config;
    config.gallery.least_free_mb = 1.0;
    config.gallery.folder = (folder / "old").string();
    config.staff.statistics_folder = (folder / "old/statistics").string();
    const auto nothing = [](auto, auto) {};
    ASSERT_TRUE(app::export_gallery(config, folder / "house.zip", nothing));
    auto house = files::ArchiveReader::open(folder / "house.zip");
    ASSERT_TRUE(house) << house.error().message;
    config.gallery.folder = (folder / "new").string();
    config.staff.statistics_folder = (folder / "new/statistics").string();
    const auto moved = app::import_gallery(std::move(*house), config, 1'795'608'000, nothing);
    ASSERT_TRUE(moved) << moved.error().message;
    EXPECT_EQ(test::content_of(folder / "new" / pots[0].name / "pot.onggi"),
              test::content_of(pots[0].folder / "pot.onggi"));
    EXPECT_EQ(app::use_of(folder / "new/statistics", "2026-11-29").starts, 1);
}

TEST(Jars, OfVersion1AreGoneOnWith) {
    const test::TemporaryFolder folder;
    fs::copy_file(sample("jar/1.json"), folder.path() / "jar.json");
    const haptic::HapticState lump(clay::StudioClay(clay::StudioLump{}));
    app::JarKeeping jar(folder.path(), lump, {});
    std::vector<std::string> remarks;
    ASSERT_TRUE(jar.look(remarks));
    EXPECT_TRUE(remarks.empty());
    EXPECT_EQ(jar.stage(), app::JarStage::kFirstBowl);
    EXPECT_EQ(jar.target(), "moon-jar-nmk");
    const test::TemporaryFolder other;
    app::JarKeeping written(other.path(), lump, {});
    ASSERT_TRUE(written.begin("moon-jar-nmk"));
    EXPECT_EQ(test::content_of(other / "jar.json"), test::content_of(sample("jar/1.json")));
}

TEST(VisitPlaces, OfVersion1AreReadAndWritten) {
    const test::TemporaryFolder folder;
    fs::copy_file(sample("place/1.json"), folder.path() / "place.json");
    const auto place = app::read_place(folder.path());
    ASSERT_TRUE(place) << place.error().message;
    EXPECT_EQ(*place, (app::VisitPlace{.target = "moon-jar-nmk", .glaze = 3, .is_cut_off = true}));
    const test::TemporaryFolder other;
    ASSERT_TRUE(app::write_place(other.path(), *place));
    EXPECT_EQ(test::content_of(other / "place.json"), test::content_of(sample("place/1.json")));
}

TEST(Walls, OfAllVersionsAreReadAndTheNewestIsWritten) {
    const test::TemporaryFolder folder;
    for (const char* name : {"wall/1-unsaid.json", "wall/1.json", "wall/2.json"}) {
        app::WallOfTheDay wall(sample(name));
        const auto opened = wall.open("2026-11-24");
        ASSERT_TRUE(opened) << opened.error().message;
        ASSERT_FALSE(wall.pots().empty());
        EXPECT_EQ(wall.pots()[0].gallery_name, "2026-11-24/pot-001");
        EXPECT_EQ(wall.pots()[0].glaze, 3);
        EXPECT_EQ(wall.pots()[0].shape.outside.size(), 3U);
        EXPECT_FALSE(wall.pots()[0].shape.off_round);
        app::WallOfTheDay written(folder / "wall.json");
        for (const app::WallPot& pot : wall.pots())
            ASSERT_TRUE(written.put(pot, "2026-11-24"));
    }
    EXPECT_EQ(test::content_of(folder / "wall.json"), test::content_of(sample("wall/2.json")));
    app::WallOfTheDay newest(folder / "wall.json");
    ASSERT_TRUE(newest.open("2026-11-24"));
    ASSERT_EQ(newest.pots().size(), 2U);
    ASSERT_TRUE(newest.pots()[1].shape.off_round);
    EXPECT_FLOAT_EQ(newest.pots()[1].shape.off_round->centre_at(1.0F).x, 1.83F);
    auto later = nlohmann::json::parse(test::content_of(sample("wall/1.json")));
    later["format"] = 3;
    test::put_file(folder / "wall.json", later.dump());
    app::WallOfTheDay wall(folder / "wall.json");
    const auto refused = wall.open("2026-11-24");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("of format 1 to 2, found 3"), std::string::npos);
    EXPECT_TRUE(wall.pots().empty());
}

TEST(StartLogs, OfVersion1AreReadAndWritten) {
    const std::string text = test::content_of(sample("starts/1"));
    const auto log = app::read_start_log(text, "starts");
    ASSERT_TRUE(log) << log.error().message;
    EXPECT_TRUE(log->is_running);
    EXPECT_EQ(log->falls_s, (std::vector<std::int64_t>{1'795'607'000, 1'795'607'100}));
    EXPECT_EQ(app::text_of(*log), text);
}

TEST(Heartbeats, OfVersion1AreReadAndWritten) {
    const std::string text = test::content_of(sample("status/1.json"));
    const auto note = app::read_status_note(text, "status.json");
    ASSERT_TRUE(note) << note.error().message;
    EXPECT_EQ(note->at_s, 1'795'608'000);
    EXPECT_EQ(note->pulse.screen, "throw");
    EXPECT_EQ(app::text_of(*note), text);
}

TEST(KeptNotes, OfVersion1AreReadAndWritten) {
    const std::string text = test::content_of(sample("note/1.txt"));
    const auto note = sharing::read_note(text);
    ASSERT_TRUE(note);
    EXPECT_EQ(note->expires_s, 1'795'629'600);
    EXPECT_EQ(note->gallery_name, "2026-11-25/pot-014");
    EXPECT_EQ(sharing::written(*note), text);
}

TEST(Statistics, OfBothVersionsAreCountedAlsoInOneFile) {
    const test::TemporaryFolder folder;
    fs::copy_file(sample("statistics/attract_breaks-1.csv"), folder / "attract_breaks.csv");
    fs::copy_file(sample("statistics/starts-1.csv"), folder / "starts.csv");
    const auto of = [&](const std::string& text) {
        test::put_file(folder / "visits.csv", text);
        return app::use_of(folder.path(), "2026-11-21");
    };
    const std::string first = test::content_of(sample("statistics/visits-1.csv"));
    const std::string second = test::content_of(sample("statistics/visits-2.csv"));
    const app::UseOfDay old = of(first);
    EXPECT_EQ(old.starts, 1);
    EXPECT_EQ(old.hours[10],
              (app::UseOfHour{.breaks = 1, .visits = 1, .thrown = 1, .kept = 1, .dwell_s = 312}));
    EXPECT_EQ(old.hours[11], (app::UseOfHour{.breaks = 1, .visits = 1, .dwell_s = 48}));
    const app::UseOfDay now = of(second);
    EXPECT_EQ(now.hours[10],
              (app::UseOfHour{.breaks = 1, .visits = 1, .thrown = 1, .kept = 2, .dwell_s = 312}));
    // An upgrade in the middle of a day goes on with the file it finds.
    EXPECT_EQ(of(first + second).total().visits, 4);
    EXPECT_EQ(of(first + second).total().kept, 3);
}

TEST(Statistics, AreNoWorseForAFirstLineThatIsHalf) {
    const test::TemporaryFolder folder;
    for (const char* half : {"day", "day,hour", "day,hour,dwell_s,ended_on"}) {
        test::put_file(folder / "visits.csv", std::string(half) +
                                                  "\n2026-11-21\n2026-11-21,10\n2026-11-21,10,5,keep\n" +
                                                  "2026-11-21,10,60,keep,1,1\n");
        EXPECT_EQ(app::use_of(folder.path(), "2026-11-21").total().visits, 1) << half;
    }
}

TEST(Statistics, AreWrittenAsTheNewestVersion) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(app::note_visit(folder.path(), {.dwell_s = 5}));
    ASSERT_TRUE(app::note_start(folder.path()));
    ASSERT_TRUE(app::note_attract_break(folder.path()));
    const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
    for (const auto& [written, newest] :
         {std::pair("visits.csv", "visits-2.csv"), std::pair("starts.csv", "starts-1.csv"),
          std::pair("attract_breaks.csv", "attract_breaks-1.csv")})
        EXPECT_EQ(first_line(test::content_of(folder / written)),
                  first_line(test::content_of(sample(std::string("statistics/") + newest))));
}

// The archive's files by their names.
std::map<std::string, std::string> files_of(const fs::path& archive) {
    std::map<std::string, std::string> files;
    auto reader = files::ArchiveReader::open(archive);
    EXPECT_TRUE(reader) << reader.error().message;
    while (reader) {
        const auto name = reader->next();
        EXPECT_TRUE(name) << name.error().message;
        if (!name || !*name) break;
        const auto content = reader->read(10'000);
        EXPECT_TRUE(content) << content.error().message;
        files[**name] = content ? *content : "";
    }
    return files;
}

// Its pots have sessions of every version.
TEST(Archives, OfVersion1AreImportedAndWritten) {
    const test::TemporaryFolder folder;
    kiosk::Config config;
    config.gallery.folder = (folder / "gallery").string();
    config.gallery.least_free_mb = 1.0;
    config.sharing.public_url = "http://pots.example";
    config.sharing.outbox = (folder / "outbox").string();
    constexpr std::int64_t kNoonS = 1'795'608'000;
    const auto nothing = [](auto, auto) {};
    auto reader = files::ArchiveReader::open(sample("archive/1.zip"));
    ASSERT_TRUE(reader) << reader.error().message;
    const auto moved = app::import_gallery(std::move(*reader), config, kNoonS, nothing);
    ASSERT_TRUE(moved) << moved.error().message;
    EXPECT_EQ(moved->pots, 3U);
    EXPECT_EQ(moved->pages, 1U);
    EXPECT_EQ(moved->days, 1U);
    EXPECT_EQ(app::kept_pots(folder / "gallery").size(), 3U);
    ASSERT_TRUE(app::export_gallery(config, folder / "again.zip", nothing));
    EXPECT_EQ(files_of(folder / "again.zip"), files_of(sample("archive/1.zip")));
}

}  // namespace
}  // namespace onggi
