// A kept pot handed to the outbox, on its own thread and a real disk.
#include "game/app/kiosk/keeping/kiosk_phone.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "engine/asset/image.h"
#include "engine/files/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

class KioskPhoneTest : public testing::Test {
  protected:
    KioskPhoneTest() {
        settings_ = load_settings("").value();
        settings_.config.gallery.folder = (folder_.path() / "gallery").string();
        settings_.config.sharing.outbox = (folder_.path() / "outbox").string();
        settings_.config.sharing.public_url = "http://pots.example";
        const fs::path pot = folder_.path() / "gallery" / kName;
        fs::create_directories(pot);
        const asset::Image picture{.width = 2, .height = 2, .rgba = std::vector<std::uint8_t>(16, 200)};
        EXPECT_TRUE(files::write_file_atomically(pot / "pot.png", asset::encode_png(picture).value()));
        for (const char* file : {"pot.glb", "pot.stl", "pot.3mf"})
            std::ofstream(pot / file) << file;
    }
    [[nodiscard]] PotToShare kept() const {
        auto pot = std::make_shared<screens::FiredPot>();
        pot->shape = pot::hollowed({{40, 0}, {50, 50}, {45, 100}}, 5.0F, 8.0F);
        pot->height_mm = 100.0;
        return {.gallery_name = kName, .pot = pot};
    }
    static std::shared_ptr<const PhoneAnswer> answer_of(KioskPhone& phone) {
        for (int i = 0; i < 3000; ++i) {
            if (auto answer = phone.next_answer()) return answer;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return nullptr;
    }
    static std::vector<SharedPotNote> surveyed(KioskPhone& phone) {
        phone.survey();
        const auto answer = answer_of(phone);
        return answer ? std::get<PhoneAnswer::Survey>(answer->what).shared
                      : std::vector<SharedPotNote>{{"no answer", ""}};
    }
    [[nodiscard]] std::vector<sharing::OutboxEntry> shared() const {
        return sharing::Outbox::open({.folder = folder_.path() / "outbox", .languages = settings_.languages})
            .value()
            .list()
            .value();
    }

    static constexpr const char* kName = "2026-11-22/pot-003";
    test::TemporaryFolder folder_;
    KioskSettings settings_;
};

TEST_F(KioskPhoneTest, GivesACodeWhenEveryFileIsThere) {
    settings_.config.sharing.wifi_name = "Museum-Guest";
    KioskPhone phone(settings_);
    ASSERT_TRUE(phone.start());
    phone.share(kept());
    const auto answer = answer_of(phone);
    ASSERT_TRUE(answer);
    const auto* const shown = std::get_if<PhoneAnswer::OfPot>(&answer->what);
    ASSERT_NE(shown, nullptr) << answer->words;
    ASSERT_EQ(shown->event, kiosk::Event::Kind::kShared) << answer->words;
    EXPECT_EQ(shown->gallery_name, kName);
    const auto entries = shared();
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_EQ(entries[0].gallery_name, kName);
    EXPECT_EQ(shown->way->code, entries[0].code.shown());
    ASSERT_GE(shown->way->page.side, 21);
    EXPECT_TRUE(shown->way->page.dark[0]) << "a corner of a QR code is dark";
    ASSERT_TRUE(shown->way->wifi);
    EXPECT_EQ(shown->way->wifi_name, "Museum-Guest");
    for (const char* file : {"pot.glb", "pot.stl", "pot.3mf", "index.html"})
        EXPECT_TRUE(fs::exists(folder_.path() / "outbox" / entries[0].code.text() / file)) << file;
}

TEST_F(KioskPhoneTest, CountsTheCodesItShowsAndThePagesThatAreOpened) {
    settings_.config.sharing.counter = (folder_.path() / "opened").string();
    const auto reader_first = sharing::CounterReader::open(settings_.config.sharing.counter);
    ASSERT_TRUE(reader_first) << "so that what is counted before the kiosk is up waits in the pipe";
    sharing::CounterWriter server(settings_.config.sharing.counter);
    server.count(sharing::ShareEvent::kPageOpened);
    server.count(sharing::ShareEvent::kPageOpened);
    KioskPhone phone(settings_);
    ASSERT_TRUE(phone.start());
    phone.share(kept());
    ASSERT_TRUE(answer_of(phone));
    std::string noted;
    for (int i = 0; i < 3000 && noted.find(",0,2,0,0,0\n") == std::string::npos; ++i) {
        std::ifstream file(folder_.path() / "gallery/statistics/phones.csv");
        noted.assign(std::istreambuf_iterator<char>(file), {});
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_NE(noted.find(",1,0,0,0,0\n"), std::string::npos) << noted;
    EXPECT_NE(noted.find(",0,2,0,0,0\n"), std::string::npos) << noted;
}

TEST_F(KioskPhoneTest, GivesNoneWhereAFileIsMissing) {
    fs::remove(folder_.path() / "gallery" / kName / "pot.stl");
    KioskPhone phone(settings_);
    ASSERT_TRUE(phone.start());
    phone.share(kept());
    const auto answer = answer_of(phone);
    ASSERT_TRUE(answer);
    EXPECT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).event, kiosk::Event::Kind::kShareFailed);
    EXPECT_NE(answer->words.find("pot.stl"), std::string::npos) << answer->words;
    EXPECT_TRUE(shared().empty());
}

TEST_F(KioskPhoneTest, SaysThatACodeIsOverWhenTheStaffDeletesThePot) {
    KioskPhone phone(settings_);
    ASSERT_TRUE(phone.start());
    phone.share(kept());
    ASSERT_TRUE(answer_of(phone));
    phone.withdraw("2026-11-22/pot-002");
    phone.withdraw(kName);
    const auto answer = answer_of(phone);
    ASSERT_TRUE(answer);
    EXPECT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).event, kiosk::Event::Kind::kShareOver);
    EXPECT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).gallery_name, kName);
    EXPECT_TRUE(shared().empty());
}

TEST_F(KioskPhoneTest, TellsTheStaffWhatIsSharedUntilItIsWithdrawn) {
    KioskPhone phone(settings_);
    ASSERT_TRUE(phone.start());
    EXPECT_TRUE(surveyed(phone).empty());
    phone.share(kept());
    ASSERT_TRUE(answer_of(phone));
    const std::vector<SharedPotNote> one = surveyed(phone);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].gallery_name, kName);
    EXPECT_FALSE(one[0].until.empty());
    phone.withdraw(kName);
    ASSERT_TRUE(answer_of(phone));
    EXPECT_TRUE(surveyed(phone).empty());
}

}  // namespace
}  // namespace onggi::app
