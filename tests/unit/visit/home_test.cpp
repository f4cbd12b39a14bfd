// The way home by phone, of a pot that is kept.
#include <gtest/gtest.h>

#include "game/visit/steps.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

Visitor kept(bool has_wifi = false, bool shares = true) {
    Visitor visitor(Rules{.shares = shares, .has_wifi = has_wifi});
    visitor.keeps().does(event::Saved{7});
    return visitor;
}

TEST(TakingHome, IsNotOfferedWithoutSharing) {
    const Visitor visitor = kept(false, false);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kNone);
    EXPECT_FALSE(visitor.caused<effect::Share>());
    EXPECT_EQ(spoken_key(visitor.state), "keep.title");
}

TEST(TakingHome, PacksOnceThePotIsSafeAndThenShowsItsCode) {
    Visitor visitor = kept();
    EXPECT_EQ(visitor.count<effect::Share>(), 1);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    EXPECT_EQ(spoken_key(visitor.state), "home.making");
    visitor.does(event::Shared{7});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kReady);
    EXPECT_EQ(spoken_key(visitor.state), "home.title");
}

TEST(TakingHome, JoinsTheConfiguredWifiFirst) {
    Visitor visitor = kept(true);
    visitor.presses(Button::kOnWifi);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking) << "there is no code yet";
    visitor.does(event::Shared{7});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kWifi);
    visitor.presses(Button::kOnWifi);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kReady);
}

TEST(TakingHome, MayBeTriedAgainWhereItRests) {
    Visitor visitor = kept();
    visitor.does(event::Shared{7, ShareOutcome::kFailed});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kResting);
    EXPECT_EQ(visitor.state.keeping.outcome, Keeping::Outcome::kKept) << "the shelf has it";
    visitor.presses(Button::kShareAgain);
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    EXPECT_EQ(visitor.count<effect::Share>(), 2);
}

TEST(TakingHome, AsksForAnotherCodeWhenOneIsOver) {
    Visitor visitor = kept();
    visitor.does(event::Shared{7}).does(event::Shared{7, ShareOutcome::kOver});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kOver);
    visitor.presses(Button::kShareAgain).does(event::Shared{7});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kReady);
}

TEST(TakingHome, ShowsNoCodeOfAnEarlierPot) {
    Visitor visitor = kept();
    visitor.does(event::Shared{6});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kPacking);
    visitor.presses(Button::kAnother).does(event::Shared{7});
    EXPECT_EQ(visitor.state.screen, Screen::kChoose);
}

TEST(TakingHome, SharesOnlyKeptPots) {
    Visitor visitor(Rules{.shares = true});
    visitor.keeps().does(event::SaveFailed{});
    EXPECT_EQ(visitor.state.keeping.phone, Phone::kNone);
    EXPECT_FALSE(visitor.caused<effect::Share>());
}

TEST(WallOfTheDay, IsForVisitorsWhoChooseIt) {
    Visitor visitor(Rules{.has_wall = true});
    visitor.keeps().presses(Button::kOnWall);
    EXPECT_FALSE(visitor.caused<effect::Wall>()) << "not before it is kept";
    visitor.does(event::Saved{7});
    EXPECT_FALSE(visitor.state.keeping.on_wall);
    visitor.presses(Button::kOnWall);
    EXPECT_TRUE(visitor.state.keeping.on_wall);
    visitor.presses(Button::kOnWall);
    EXPECT_FALSE(visitor.state.keeping.on_wall) << "pressed again it comes down";
    EXPECT_EQ(visitor.count<effect::Wall>(), 2);

    Visitor elsewhere(Rules{});
    elsewhere.keeps().does(event::Saved{7}).presses(Button::kOnWall);
    EXPECT_FALSE(elsewhere.caused<effect::Wall>());
}

}  // namespace
}  // namespace onggi::visit
