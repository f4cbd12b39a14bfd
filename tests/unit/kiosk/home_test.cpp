// The way home by phone, of a pot that is kept.
#include <gtest/gtest.h>

#include "game/kiosk/spoken.h"
#include "tests/unit/kiosk/visitor.h"

namespace onggi::kiosk {
namespace {

Visitor kept(bool has_wifi = false, bool shares = true) {
    Visitor visitor(Rules{.shares = shares, .has_wifi = has_wifi});
    visitor.keeps().does(Event::Kind::kSaved, 7);
    return visitor;
}

TEST(TakingHome, IsNotOfferedWhereTheHouseSharesNothing) {
    const Visitor visitor = kept(false, false);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kNone);
    EXPECT_FALSE(visitor.caused(Effect::Kind::kShare));
    EXPECT_EQ(spoken_key(visitor.state), "keep.title");
}

TEST(TakingHome, PacksOnceThePotIsSafeAndThenShowsItsCode) {
    Visitor visitor = kept();
    EXPECT_EQ(visitor.count(Effect::Kind::kShare), 1);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    EXPECT_EQ(spoken_key(visitor.state), "home.making");
    visitor.does(Event::Kind::kShared, 7);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kReady);
    EXPECT_EQ(spoken_key(visitor.state), "home.title");
}

TEST(TakingHome, JoinsTheWifiFirstWhereThereIsOne) {
    Visitor visitor = kept(true);
    visitor.presses(Button::kOnWifi);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking) << "there is no code yet";
    visitor.does(Event::Kind::kShared, 7);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kWifi);
    visitor.presses(Button::kOnWifi);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kReady);
}

TEST(TakingHome, MayBeTriedAgainWhereItRests) {
    Visitor visitor = kept();
    visitor.does(Event::Kind::kShareFailed, 7);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kResting);
    EXPECT_EQ(visitor.state.keeping.outcome, Keeping::Outcome::kKept) << "the shelf has it";
    visitor.presses(Button::kShareAgain);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    EXPECT_EQ(visitor.count(Effect::Kind::kShare), 2);
}

TEST(TakingHome, AsksForAnotherCodeWhenOneIsOver) {
    Visitor visitor = kept();
    visitor.does(Event::Kind::kShared, 7).does(Event::Kind::kShareOver, 7);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kOver);
    visitor.presses(Button::kShareAgain).does(Event::Kind::kShared, 7);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kReady);
}

TEST(TakingHome, ShowsNoCodeOfAnEarlierPot) {
    Visitor visitor = kept();
    visitor.does(Event::Kind::kShared, 6);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    visitor.presses(Button::kAnother).does(Event::Kind::kShared, 7);
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
}

TEST(TakingHome, SharesNothingThatCouldNotBeKept) {
    Visitor visitor(Rules{.shares = true});
    visitor.keeps().does(Event::Kind::kSaveFailed);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kNone);
    EXPECT_FALSE(visitor.caused(Effect::Kind::kShare));
}

TEST(WallOfTheDay, IsForVisitorsWhoChooseIt) {
    Visitor visitor(Rules{.has_wall = true});
    visitor.keeps().presses(Button::kOnWall);
    EXPECT_FALSE(visitor.caused(Effect::Kind::kWall)) << "not before it is kept";
    visitor.does(Event::Kind::kSaved, 7);
    EXPECT_FALSE(visitor.state.keeping.on_wall);
    visitor.presses(Button::kOnWall);
    EXPECT_TRUE(visitor.state.keeping.on_wall);
    visitor.presses(Button::kOnWall);
    EXPECT_FALSE(visitor.state.keeping.on_wall) << "pressed again it comes down";
    EXPECT_EQ(visitor.count(Effect::Kind::kWall), 2);

    Visitor elsewhere(Rules{});
    elsewhere.keeps().does(Event::Kind::kSaved, 7).presses(Button::kOnWall);
    EXPECT_FALSE(elsewhere.caused(Effect::Kind::kWall));
}

}  // namespace
}  // namespace onggi::kiosk
