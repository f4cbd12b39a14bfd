// The gallery on disk: keeping, expiry, deletion by the staff.
#include "game/app/kiosk/gallery/kiosk_gallery.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "engine/files/read_file.h"
#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/haptic/simulated_device.h"
#include "game/haptic/start_state.h"
#include "game/record/session.h"
#include "tests/support/comes_true.h"
#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

kiosk::Config config_of(const fs::path& folder) {
    kiosk::Config config;
    config.gallery.folder = folder.string();
    config.gallery.least_free_mb = 1.0;
    return config;
}

void put_pot(const fs::path& folder, const std::string& name) {
    fs::create_directories(folder / name);
    for (const char* file : {"pot.onggi", "pot.glb", "pot.stl", "pot.3mf", "pot.png"})
        std::ofstream(folder / name / file) << "clay";
}

std::vector<std::string> names_of(const Gallery& gallery) {
    std::vector<std::string> names;
    for (const KeptPot& pot : gallery.pots())
        names.push_back(pot.name);
    return names;
}

class GalleryTest : public testing::Test {
  protected:
    [[nodiscard]] Gallery gallery_of(int most_pots) const {
        kiosk::Config config = config_of(folder_.path());
        config.gallery.most_pots = most_pots;
        return Gallery(config);
    }

    const test::TemporaryFolder folder_;
};

TEST_F(GalleryTest, ListsThePotsTheNewestFirst) {
    for (const char* name : {"2026-11-21/pot-002", "2026-11-22/pot-999", "2026-11-22/pot-1000",
                             "2026-11-22/pot-007", "2026-11-22/notes", "statistics"})
        put_pot(folder_.path(), name);
    const Gallery gallery(config_of(folder_.path()));
    EXPECT_EQ(names_of(gallery), (std::vector<std::string>{"2026-11-22/pot-1000", "2026-11-22/pot-999",
                                                           "2026-11-22/pot-007", "2026-11-21/pot-002"}));
}

TEST_F(GalleryTest, DeletesOnePotWithAllItsFilesAndNoOther) {
    put_pot(folder_.path(), "2026-11-22/pot-001");
    put_pot(folder_.path(), "2026-11-22/pot-002");
    Gallery gallery(config_of(folder_.path()));
    ASSERT_EQ(gallery.pots().size(), 2U);
    ASSERT_TRUE(gallery.remove(gallery.pots().front()));
    EXPECT_FALSE(fs::exists(folder_.path() / "2026-11-22/pot-002"));
    EXPECT_TRUE(fs::exists(folder_.path() / "2026-11-22/pot-001/pot.onggi"));
    EXPECT_EQ(names_of(gallery), std::vector<std::string>{"2026-11-22/pot-001"});
}

// A lump as cut off, with everything that is kept.
struct Cut {
    Cut() {
        for (std::uint32_t tick = 0; tick < 50; ++tick) {
            const haptic::TickResult result = haptic::tick(state, resting_finger(), parameters);
            history.add({.tick = tick,
                         .flags = tick == 0 ? haptic::TickRecord::kFreshLump : 0U,
                         .tool = state.tool,
                         .force_n = result.forces.total_n()});
        }
    }

    haptic::HapticState start{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters;
    haptic::History history{start, parameters};
    haptic::HapticState state = start;
    ui::Painting portrait{.width = 2, .height = 1, .rgba = {200, 150, 100, 255, 0, 0, 0, 0}};

    [[nodiscard]] PotToKeep pot() const {
        return {
            .history = &history, .clay = state.studio(), .glaze = &finish::glaze_at(0), .portrait = portrait};
    }
};

TEST_F(GalleryTest, KeepsAPotWholeUnderTheNextNumberOfTheDay) {
    put_pot(folder_.path(), "2026-11-22/pot-007");
    Gallery gallery(config_of(folder_.path()));
    const Cut cut;
    const auto number = gallery.keep(cut.pot(), "2026-11-22");
    ASSERT_TRUE(number) << number.error().message;
    EXPECT_EQ(*number, 8);
    for (const char* file : {"pot.onggi", "pot.glb", "pot.stl", "pot.3mf", "pot.png"})
        EXPECT_GT(fs::file_size(folder_.path() / "2026-11-22/pot-008" / file), 50U) << file;
}

TEST_F(GalleryTest, WritesThePotsStoryIntoItsFiles) {
    Gallery gallery(config_of(folder_.path()));
    const Cut cut;
    PotToKeep pot = cut.pot();
    pot.story.about = {.title = {{"en", "Moon jar, celadon"}}, .publisher = {{"en", "House of Clay"}}};
    pot.story.extras = {{"glaze", "celadon"}};
    const std::string hash = fmt::format("{:016x}", cut.history.state().hash());
    ASSERT_TRUE(gallery.keep(std::move(pot), "2026-11-22"));
    const fs::path place = folder_.path() / "2026-11-22/pot-001";
    for (const char* file : {"pot.glb", "pot.png"}) {
        const std::string bytes = test::content_of(place / file);
        for (const std::string& said : {std::string("House of Clay"), std::string("2026-11-22"), hash})
            EXPECT_NE(bytes.find(said), std::string::npos) << file << " lacks " << said;
    }
    EXPECT_NE(test::content_of(place / "pot.stl").substr(0, 80).find("Moon jar, celadon, "),
              std::string::npos);
}

TEST_F(GalleryTest, DeletesTheOldestWhenItIsFull) {
    for (const char* name : {"2026-11-20/pot-001", "2026-11-21/pot-001", "2026-11-21/pot-002"})
        put_pot(folder_.path(), name);
    Gallery gallery = gallery_of(2);
    const Cut cut;
    ASSERT_TRUE(gallery.keep(cut.pot(), "2026-11-22"));
    EXPECT_EQ(names_of(gallery), (std::vector<std::string>{"2026-11-22/pot-001", "2026-11-21/pot-002"}));
}

TEST_F(GalleryTest, DeletesNoneForAPotThatCannotBeKept) {
    put_pot(folder_.path(), "2026-11-21/pot-001");
    Gallery gallery = gallery_of(1);
    Cut cut;
    cut.portrait = {};  // which is no picture
    ASSERT_FALSE(gallery.keep(cut.pot(), "2026-11-22"));
    EXPECT_EQ(names_of(gallery), std::vector<std::string>{"2026-11-21/pot-001"});
}

TEST_F(GalleryTest, KeepsTheNewcomerHoweverWrongTheClockIs) {
    put_pot(folder_.path(), "2026-11-21/pot-001");
    Gallery gallery = gallery_of(1);
    const Cut cut;
    ASSERT_TRUE(gallery.keep(cut.pot(), "1970-01-01"));
    EXPECT_EQ(names_of(gallery), std::vector<std::string>{"1970-01-01/pot-001"});
}

TEST_F(GalleryTest, LetsTheOldestGoUnderAClockThatHasGoneBackToo) {
    for (const char* name : {"2026-11-20/pot-001", "2026-11-21/pot-001", "2026-11-21/pot-002"})
        put_pot(folder_.path(), name);
    Gallery gallery = gallery_of(3);
    const Cut cut;
    for (int pot = 0; pot < 2; ++pot)
        ASSERT_TRUE(gallery.keep(cut.pot(), "1970-01-01"));
    EXPECT_EQ(names_of(gallery),
              (std::vector<std::string>{"2026-11-21/pot-002", "1970-01-01/pot-002", "1970-01-01/pot-001"}));
}

TEST_F(GalleryTest, KeepsOnlyTheFinalClayIfATickWasLost) {
    Cut cut;
    haptic::TickRecord late;
    late.tick = 60;  // ten are missing
    cut.history.add(late);
    ASSERT_FALSE(cut.history.is_whole());
    Gallery gallery(config_of(folder_.path()));
    ASSERT_TRUE(gallery.keep(cut.pot(), "2026-11-22"));
    const auto bytes = files::read_file(folder_.path() / "2026-11-22/pot-001/pot.onggi", 1U << 26U);
    ASSERT_TRUE(bytes) << bytes.error().message;
    const auto session = record::parse_session(*bytes, "pot.onggi");
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(session->tick_count(), 0U);
    const auto start = haptic::start_from_bytes(session->start_state(), cut.parameters.rate_hz());
    ASSERT_TRUE(start) << start.error().message;
    EXPECT_EQ(start->state.hash(), cut.history.state().hash());
}

TEST_F(GalleryTest, WritesNoFileOnAFullDisk) {
    put_pot(folder_.path(), "2026-11-21/pot-001");
    kiosk::Config config = config_of(folder_.path());
    config.gallery.least_free_mb = 1e12;
    Gallery gallery(config);
    const Cut cut;
    const auto kept = gallery.keep(cut.pot(), "2026-11-22");
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(kept.error().message.find("MB free, found"), std::string::npos) << kept.error().message;
    EXPECT_EQ(names_of(gallery), std::vector<std::string>{"2026-11-21/pot-001"})
        << "nor is any let go for it";
    EXPECT_TRUE(fs::is_empty(folder_.path() / "2026-11-22"));
}

TEST_F(GalleryTest, SaysWhereItCannotSave) {
    std::ofstream(folder_.path() / "taken") << "a file where a folder is wanted";
    Gallery gallery(config_of(folder_.path() / "taken"));
    const Cut cut;
    const auto kept = gallery.keep(cut.pot(), "2026-11-22");
    ASSERT_FALSE(kept);
    EXPECT_NE(kept.error().message.find("taken"), std::string::npos) << kept.error().message;
    EXPECT_EQ(kept.error().message.find('\n'), std::string::npos);
}

TEST_F(GalleryTest, LosesNoPotIfTheDiskFailsWhileListingAFolder) {
    for (int number = 1; number <= 30; ++number)
        put_pot(folder_.path(), fmt::format("2026-11-21/pot-{:03}", number));
    Gallery gallery = gallery_of(3);
    const Cut cut;
    const std::string told = test::in_child([&]() -> std::string {
        // Six: the folder of days, and some of the pots of a day, whenever it is listed first.
        if (!test::fail_listings_after(6)) return "no such kernel";
        std::string trouble;
        const std::size_t some = gallery.pots(&trouble).size();
        const auto kept = gallery.keep(cut.pot(), "2026-11-21");
        return fmt::format("{} of 30; {}; {}", some > 0 && some < 30 ? "some" : "all or none", trouble,
                           kept ? fmt::format("kept as {}", *kept) : kept.error().message);
    });
    EXPECT_EQ(told, fmt::format("some of 30; {}/2026-11-21: expected to list all that is in this folder, "
                                "found: Input/output error; kept as 31",
                                folder_.path().string()));
    EXPECT_EQ(gallery.pots().size(), 31U) << "none had to go, none was written over";
}

// A keeper on a gallery, and the loop that it follows.
struct KeeperTest : testing::Test {
    KeeperTest() { EXPECT_TRUE(keeper.start()); }
    // Waits for the next answer of that kind; null after a timeout.
    template <typename What>
    std::shared_ptr<const KeeperAnswer> answer() {
        std::shared_ptr<const KeeperAnswer> next;
        const bool came = test::comes_true([&] {
            next = keeper.next_answer();
            return next && std::holds_alternative<What>(next->what);
        });
        return came ? next : nullptr;
    }
    std::optional<KeeperAnswer::Survey> survey() {
        const auto found = answer<KeeperAnswer::Survey>();
        return found ? std::optional(std::get<KeeperAnswer::Survey>(found->what)) : std::nullopt;
    }

    const test::TemporaryFolder folder;
    haptic::HapticState start{clay::StudioClay(clay::StudioLump{})};
    haptic::HapticParameters parameters;
    haptic::HapticJob job{start, parameters, std::make_unique<haptic::SimulatedDevice>(), {}};
    KioskKeeper keeper{job, start, parameters, Gallery(config_of(folder.path())),
                       folder.path() / "statistics"};
};

TEST_F(KeeperTest, DeletesAPotByItsNameAndReportsTheOthers) {
    for (const char* name : {"2026-11-22/pot-001", "2026-11-22/pot-002", "2026-11-22/pot-003"})
        put_pot(folder.path(), name);
    keeper.survey();
    const auto before = this->survey();
    ASSERT_TRUE(before);
    EXPECT_EQ(before->pots.size(), 3U);
    EXPECT_GT(before->free_mb, 0.0);

    keeper.remove("2026-11-22/pot-002");
    const auto said = answer<KeeperAnswer::Remark>();
    ASSERT_NE(said, nullptr);
    EXPECT_EQ(said->words, "removed 2026-11-22/pot-002");
    const auto after = this->survey();
    ASSERT_TRUE(after);
    EXPECT_EQ(after->pots, (std::vector<std::string>{"2026-11-22/pot-003", "2026-11-22/pot-001"}));
    EXPECT_FALSE(fs::exists(folder.path() / "2026-11-22/pot-002"));
}

TEST_F(KeeperTest, DeletesOnlyPotsOfTheGallery) {
    put_pot(folder.path(), "2026-11-22/pot-001");
    put_pot(folder.path(), "precious");
    for (const char* name : {"", ".", "..", "precious", "../precious", "2026-11-22", "2026-11-22/pot-001/.."})
        keeper.remove(name);
    for (int i = 0; i < 7; ++i) {
        const auto survey = this->survey();
        ASSERT_TRUE(survey);
        EXPECT_EQ(survey->pots.size(), 1U);
    }
    EXPECT_TRUE(fs::exists(folder.path() / "precious/pot.glb"));
}

TEST_F(KeeperTest, SaysThatTheGalleryWasTakenAway) {
    put_pot(folder.path(), "2026-11-22/pot-001");
    keeper.survey();
    ASSERT_TRUE(this->survey());
    fs::remove_all(folder.path());
    keeper.survey();
    const auto said = answer<KeeperAnswer::Remark>();
    ASSERT_NE(said, nullptr);
    EXPECT_EQ(said->words,
              folder.path().string() +
                  ": expected the folder of the pots, found none; the next pot begins a new one");
    EXPECT_TRUE(said->is_trouble);
}

TEST_F(KeeperTest, CountsAndRemembersBesideTheFrame) {
    keeper.note_start();
    keeper.note_attract_break();
    keeper.note({.dwell_s = 30, .last = kiosk::Screen::kThrow, .thrown = true, .kept = false});
    keeper.keep({5, "ko"});
    keeper.survey();
    const auto survey = this->survey();
    ASSERT_TRUE(survey);
    EXPECT_EQ(survey->use.total(),
              (UseOfHour{.breaks = 1, .visits = 1, .thrown = 1, .kept = 0, .dwell_s = 30}));
    EXPECT_EQ(survey->use.starts, 1);
    KioskSettings settings;
    settings.config = config_of(folder.path());
    settings.config.sound.remember_staff = true;
    take_kept_house(settings);
    EXPECT_EQ(settings.config.sound.volume, 5);
}

}  // namespace
}  // namespace onggi::app
