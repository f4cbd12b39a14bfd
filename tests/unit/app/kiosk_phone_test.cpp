// A kept pot handed to the outbox, on its own thread and a real disk.
#include "game/app/kiosk/keeping/kiosk_phone.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/support/comes_true.h"
#include "tests/support/sharing_kiosk.h"

namespace onggi::app {
namespace {

class KioskPhoneTest : public SharingKiosk {
  protected:
    [[nodiscard]] std::shared_ptr<const PhoneAnswer> answer_to_share(KioskPhone& phone) const {
        EXPECT_TRUE(phone.start());
        phone.share(kept());
        return answer_of(phone);
    }
    static std::vector<SharedPotNote> surveyed(KioskPhone& phone) {
        phone.survey();
        const auto answer = answer_of(phone);
        return answer ? std::get<PhoneAnswer::Survey>(answer->what).shared
                      : std::vector<SharedPotNote>{{"no answer", ""}};
    }
};

TEST_F(KioskPhoneTest, GivesACodeWhenEveryFileIsThere) {
    settings_.config.sharing.wifi_name = "Museum-Guest";
    KioskPhone phone(settings_);
    const auto answer = answer_to_share(phone);
    ASSERT_TRUE(answer);
    const auto* const shown = std::get_if<PhoneAnswer::OfPot>(&answer->what);
    ASSERT_NE(shown, nullptr) << answer->words;
    ASSERT_EQ(shown->outcome, kiosk::ShareOutcome::kReady) << answer->words;
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
    ASSERT_TRUE(reader_first) << "so that counts before the kiosk's start wait in the pipe";
    sharing::CounterWriter server(settings_.config.sharing.counter);
    server.count(sharing::ShareEvent::kPageOpened);
    server.count(sharing::ShareEvent::kPageOpened);
    KioskPhone phone(settings_);
    ASSERT_TRUE(answer_to_share(phone));
    std::string noted;
    EXPECT_TRUE(test::comes_true([&] {
        std::ifstream file(folder_.path() / "gallery/statistics/phones.csv");
        noted.assign(std::istreambuf_iterator<char>(file), {});
        return noted.find(",0,2,0,0,0\n") != std::string::npos;
    })) << noted;
    EXPECT_NE(noted.find(",1,0,0,0,0\n"), std::string::npos) << noted;
}

TEST_F(KioskPhoneTest, ReturnsNoCodeIfAFileIsMissing) {
    fs::remove(folder_.path() / "gallery" / kName / "pot.stl");
    KioskPhone phone(settings_);
    const auto answer = answer_to_share(phone);
    ASSERT_TRUE(answer);
    EXPECT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).outcome, kiosk::ShareOutcome::kFailed);
    EXPECT_NE(answer->words.find("pot.stl"), std::string::npos) << answer->words;
    EXPECT_TRUE(shared().empty());
}

TEST_F(KioskPhoneTest, SaysThatACodeIsOverWhenTheStaffDeletesThePot) {
    KioskPhone phone(settings_);
    ASSERT_TRUE(answer_to_share(phone));
    phone.withdraw("2026-11-22/pot-002");
    phone.withdraw(kName);
    const auto answer = answer_of(phone);
    ASSERT_TRUE(answer);
    EXPECT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).outcome, kiosk::ShareOutcome::kOver);
    EXPECT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).gallery_name, kName);
    EXPECT_TRUE(shared().empty());
}

TEST_F(KioskPhoneTest, ListsASharedPotForTheStaffUntilItIsWithdrawn) {
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
