// The film of a visit, made by the built program as a separate process, as in the kiosk.
#include "game/app/kiosk/keeping/kiosk_phone.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/cli/cli_expectations.h"
#include "tests/support/comes_true.h"
#include "tests/support/mp4_frames.h"
#include "tests/support/places.h"
#include "tests/support/sharing_kiosk.h"
#include "tests/support/webp_frames.h"

namespace onggi::app {
namespace {

// Raises the film process from idle priority, since a busy test machine would leave it no processor time. If
// that is refused, it takes longer.
void let_makers_compete() {
    const std::string makers = fmt::format("$(pgrep --parent {})", ::getpid());
    static_cast<void>(std::system(
        ("for maker in " + makers + "; do chrt --all-tasks --other --pid 0 $maker; done 2>/dev/null")
            .c_str()));
}

// The child processes of this test, those included that have ended and are not yet waited for.
std::vector<int> makers() {
    std::ifstream children(fmt::format("/proc/self/task/{}/children", ::getpid()));
    return {std::istream_iterator<int>(children), {}};
}

constexpr std::chrono::seconds kPatience(100);

class KioskFilmTest : public testing::Test {
  protected:
    [[nodiscard]] fs::path session() const {
        const fs::path copy = folder_.path() / "making.onggi";
        fs::copy_file(test::in_checkout("tests/replay/sessions/one-finger-250hz.onggi"), copy);
        return copy;
    }
    static bool ends(KioskFilm& film) {
        let_makers_compete();
        return test::comes_true([&] { return !film.is_in_the_making(); }, kPatience);
    }

    test::TemporaryFolder folder_;
    fs::path place_ = folder_.path() / "film";
    KioskFilm film_{test::in_build("onggi"), place_};
};

TEST_F(KioskFilmTest, IsWholeOnceItsGlazeIsKnown) {
    ASSERT_TRUE(film_.begin(session()));
    EXPECT_TRUE(film_.is_in_the_making());
    EXPECT_FALSE(film_.files());
    film_.finish_in("iron", nullptr);
    ASSERT_TRUE(ends(film_));
    const auto files = film_.files();
    ASSERT_TRUE(files);
    const std::string film = test::content_of(files->film.string());
    const test::WebpFrames frames = test::webp_frames(std::as_bytes(std::span(film.data(), film.size())));
    EXPECT_EQ(frames.ends_ms.back(), static_cast<int>(KioskFilm::kSeconds * 1000.0));
    const std::string mp4 = test::content_of(files->mp4.string());
    const test::Mp4Frames played = test::mp4_frames(std::as_bytes(std::span(mp4.data(), mp4.size())));
    EXPECT_EQ(played.images.size(), frames.images.size());
    EXPECT_EQ(played.lasts_ms, frames.ends_ms.back());
    EXPECT_LE(mp4.size(), 400'000U);
    EXPECT_GT(fs::file_size(files->still), 0U);
    EXPECT_FALSE(fs::exists(folder_.path() / "making.onggi")) << "nothing of a visit stays behind";
    film_.drop();
    EXPECT_FALSE(film_.files());
    EXPECT_FALSE(fs::exists(place_));
}

TEST_F(KioskFilmTest, FailsWithoutASessionAGlazeOrAProgram) {
    EXPECT_FALSE(film_.begin(folder_.path() / "none.onggi"));
    std::ofstream(folder_.path() / "bad.onggi") << "no session";
    ASSERT_TRUE(film_.begin(folder_.path() / "bad.onggi"));
    film_.finish_in("iron", nullptr);  // even if there is no receiver any more
    ASSERT_TRUE(ends(film_));
    EXPECT_FALSE(film_.files());

    ASSERT_TRUE(film_.begin(session()));
    film_.finish_in("gold", nullptr);
    ASSERT_TRUE(ends(film_));
    EXPECT_FALSE(film_.files());

    KioskFilm nobody("/nowhere/onggi", place_);
    const auto begun = nobody.begin(session());
    ASSERT_FALSE(begun);
    EXPECT_NE(begun.error().message.find("/nowhere/onggi"), std::string::npos);
    EXPECT_FALSE(nobody.is_in_the_making());
}

TEST_F(KioskFilmTest, IsDroppedWithItsProcessByTheNext) {
    ASSERT_TRUE(film_.begin(session()));
    const std::vector<int> first = makers();
    ASSERT_EQ(first.size(), 1U);
    // A stopped process never ends by itself: a begin() that waited for it would not return.
    ASSERT_EQ(::kill(first.front(), SIGSTOP), 0);
    ASSERT_TRUE(film_.begin(session()));
    const std::vector<int> second = makers();
    ASSERT_EQ(second.size(), 1U);
    EXPECT_NE(second, first);
    film_.drop();
    EXPECT_FALSE(film_.is_in_the_making());
    EXPECT_FALSE(fs::exists(place_));
}

// A drawing needs no film: none was made of this pot.
TEST_F(SharingKiosk, DrawsThePotThatItsSessionLeft) {
    settings_.config.sharing.publisher = {{"", "House of Clay"}};
    fs::copy_file(test::in_checkout("tests/replay/sessions/one-finger-250hz.onggi"),
                  folder_.path() / "gallery" / kName / "pot.onggi");
    for (const bool is_late : {false, true}) {
        KioskPhone phone(settings_, test::in_build("onggi"),
                         is_late ? 0 : std::chrono::nanoseconds(kPatience).count());
        ASSERT_TRUE(phone.start());
        phone.share(kept());
        // The process is idle otherwise, and begins in the next round of the phone's thread.
        test::comes_true([] { return !makers().empty(); });
        let_makers_compete();
        std::shared_ptr<const PhoneAnswer> answer;
        ASSERT_TRUE(test::comes_true([&] { return (answer = phone.next_answer()) != nullptr; }, kPatience));
        ASSERT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).outcome, kiosk::ShareOutcome::kReady);
        const fs::path place = folder_.path() / "outbox" / shared().at(0).code.text();
        const auto page = [&] { return test::content_of(place / "index.html"); };
        EXPECT_TRUE(test::comes_true([&] { return page().find("href=\"pot.svg\"") != std::string::npos; },
                                     kPatience));
        for (const char* link : {"href=\"pot.pdf\"", "href=\"pot.json\""})
            EXPECT_NE(page().find(link), std::string::npos) << link;
        EXPECT_EQ(page().find("film"), std::string::npos);
        EXPECT_EQ(test::content_of(place / "pot.pdf").substr(0, 5), "%PDF-");
        for (const char* file : {"pot.svg", "pot.json"})
            EXPECT_NE(test::content_of(place / file).find("House of Clay"), std::string::npos) << file;
        phone.forget();
        phone.withdraw(kName);
        EXPECT_TRUE(test::comes_true([&] { return shared().empty(); }));
        EXPECT_FALSE(fs::exists(folder_.path() / "gallery/state/drawn")) << "nothing of a visit stays behind";
    }
}

// A page is published without waiting for a late film.
TEST_F(SharingKiosk, AddsAFilmThatIsLateToThePage) {
    settings_.config.sharing.publisher = {{"", "House of Clay"}};
    KioskPhone phone(settings_, test::in_build("onggi"), 0);
    ASSERT_TRUE(phone.start());
    const fs::path session = phone.session_place();
    fs::create_directories(session.parent_path());
    fs::copy_file(test::in_checkout("tests/replay/sessions/one-finger-250hz.onggi"), session);
    phone.film(session);
    phone.share(kept());
    const auto answer = answer_of(phone);
    ASSERT_TRUE(answer);
    ASSERT_EQ(std::get<PhoneAnswer::OfPot>(answer->what).outcome, kiosk::ShareOutcome::kReady);
    const fs::path place = folder_.path() / "outbox" / shared().at(0).code.text();
    EXPECT_FALSE(fs::exists(place / "film.webp"));
    EXPECT_EQ(test::content_of(place / "index.html").find("film.webp"), std::string::npos);
    phone.forget();
    const fs::path making = session.parent_path() / "film";
    let_makers_compete();
    EXPECT_TRUE(test::comes_true([&] { return !fs::exists(making); }, kPatience))
        << "nothing of a visit stays behind";
    for (const char* picture : {"film.webp", "film.mp4", "still.webp", "poster.webp"})
        EXPECT_NE(test::content_of(place / picture).find("House of Clay"), std::string::npos) << picture;
    for (const char* link : {"href=\"film.webp\"", "src=\"film.mp4\""})
        EXPECT_NE(test::content_of(place / "index.html").find(link), std::string::npos) << link;
}

}  // namespace
}  // namespace onggi::app
