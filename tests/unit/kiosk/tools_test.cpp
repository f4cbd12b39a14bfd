// The tools of the throwing hand.
#include <gtest/gtest.h>

#include "game/kiosk/spoken.h"
#include "tests/unit/kiosk/visitor.h"

namespace onggi::kiosk {
namespace {

using Kind = Event::Kind;

int number(Held held) {
    return static_cast<int>(held);
}

TEST(Tools, LieInATrayThatChoosingCloses) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kTools);
    EXPECT_TRUE(visitor.state.throwing.tray);
    EXPECT_EQ(spoken_key(visitor.state), "tool.title");
    visitor.presses(Button::kToolMore);
    EXPECT_TRUE(visitor.state.throwing.tray) << "how large is asked there";
    EXPECT_EQ(visitor.state.throwing.tool, 3);
    visitor.presses(Button::kTakeTool, number(Held::kRib));
    EXPECT_FALSE(visitor.state.throwing.tray);
    EXPECT_EQ(visitor.state.throwing.held, Held::kRib);
    EXPECT_EQ(spoken_key(visitor.state), "tool.rib.line");
    visitor.presses(Button::kTools).presses(Button::kTools);
    EXPECT_FALSE(visitor.state.throwing.tray) << "back";
    EXPECT_EQ(visitor.state.throwing.held, Held::kRib);
}

TEST(Tools, AreTakenByTheirKeysWithoutATray) {
    Visitor visitor;
    visitor.starts_to_throw();
    for (const Held held : {Held::kSponge, Held::kWire, Held::kRib, Held::kHand}) {
        visitor.presses(Button::kTakeTool, number(held));
        EXPECT_EQ(visitor.state.throwing.held, held);
    }
    visitor.presses(Button::kTakeTool, kHeldCount).presses(Button::kTakeTool, -1);
    EXPECT_EQ(visitor.state.throwing.held, Held::kHand);
}

TEST(Tools, TheTrayClosesUnderAHandThatTouchesTheClay) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kTools).does(Kind::kClayTouched);
    EXPECT_FALSE(visitor.state.throwing.tray);
    EXPECT_EQ(visitor.state.throwing.held, Held::kHand);
}

TEST(Tools, TheTrayStaysOpenUnderATouchThatHadBegunBefore) {
    Visitor visitor;
    visitor.starts_to_throw().does(Kind::kClayTouched).presses(Button::kTools).does(Kind::kClayTouched, 1);
    EXPECT_TRUE(visitor.state.throwing.tray);
    visitor.does(Kind::kClayTouched);
    EXPECT_FALSE(visitor.state.throwing.tray) << "another one";
}

TEST(Tools, TheWireCutsOnceAndIsLaidBack) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kCut);
    EXPECT_FALSE(visitor.caused(Effect::Kind::kCutRim)) << "it is not held";
    visitor.presses(Button::kTakeTool, number(Held::kWire));
    EXPECT_EQ(spoken_key(visitor.state), "wire.how");
    visitor.presses(Button::kCut);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{{Effect::Kind::kCutRim, 0}}));
    EXPECT_EQ(visitor.state.throwing.held, Held::kHand);
    visitor.presses(Button::kCut);
    EXPECT_EQ(visitor.count(Effect::Kind::kCutRim), 1);
    visitor.presses(Button::kUndo);
    EXPECT_TRUE(visitor.caused(Effect::Kind::kUndo));
}

TEST(Tools, TheSpongeDriesTheHandsByADotATurn) {
    Visitor visitor;
    visitor.starts_to_throw();
    const int water = visitor.state.throwing.water;
    visitor.presses(Button::kTakeTool, number(Held::kSponge)).does(Kind::kSoaked);
    EXPECT_EQ(visitor.state.throwing.water, water - 1);
    for (int turn = 0; turn < 9; ++turn)
        visitor.does(Kind::kSoaked);
    EXPECT_EQ(visitor.state.throwing.water, 1);
    visitor.presses(Button::kWaterMore);
    EXPECT_EQ(visitor.state.throwing.water, 2);
}

TEST(Tools, AreLaidDownForNewClayAndForThePotThatIsDone) {
    for (const Button button : {Button::kNewClay, Button::kDone}) {
        Visitor visitor;
        visitor.starts_to_throw().presses(Button::kTakeTool, number(Held::kSponge)).presses(Button::kTools);
        visitor.presses(button);
        EXPECT_EQ(visitor.state.throwing.held, Held::kHand) << static_cast<int>(button);
        EXPECT_FALSE(visitor.state.throwing.tray);
    }
}

TEST(Tools, TheWheelShowsWhatIsHeldOrWithTheWireTheLesson) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kTakeTool, number(Held::kRib)).presses(Button::kShowMe);
    EXPECT_EQ(visitor.state.throwing.shown, kTeachingSteps);
    EXPECT_EQ(visitor.state.throwing.held, Held::kRib);
    visitor.presses(Button::kMyTurn).presses(Button::kTakeTool, number(Held::kWire)).presses(Button::kShowMe);
    EXPECT_EQ(visitor.state.throwing.shown, 0);
    EXPECT_EQ(visitor.state.throwing.held, Held::kHand);
}

TEST(Tools, TheLessonIsHiddenWithAToolInTheHandOrAnOpenTray) {
    for (const Event& event : {Event::pressed(Button::kTakeTool, 1), Event::pressed(Button::kTools)}) {
        Visitor visitor;
        visitor.starts_to_throw().does(event).waits(30.0);
        EXPECT_FALSE(visitor.caused(Effect::Kind::kShowStep));
    }
}

}  // namespace
}  // namespace onggi::kiosk
