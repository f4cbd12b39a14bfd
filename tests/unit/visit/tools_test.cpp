// The tools of the throwing hand.
#include <gtest/gtest.h>

#include "game/visit/steps.h"
#include "game/visit/throw/throw.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

int number(tool::Tool held) {
    return static_cast<int>(tray_place(held));
}

TEST(Tools, LieInATrayThatChoosingCloses) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kTools);
    EXPECT_TRUE(visitor.state.throwing.tray);
    EXPECT_EQ(spoken_key(visitor.state), "tool.title");
    visitor.presses(Button::kToolMore);
    EXPECT_TRUE(visitor.state.throwing.tray) << "how large is asked there";
    EXPECT_EQ(visitor.state.throwing.tool, 3);
    visitor.presses(Button::kTakeTool, number(tool::Tool::kRib));
    EXPECT_FALSE(visitor.state.throwing.tray);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kRib);
    EXPECT_EQ(spoken_key(visitor.state), "tool.rib.line");
    visitor.presses(Button::kTools).presses(Button::kTools);
    EXPECT_FALSE(visitor.state.throwing.tray) << "back";
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kRib);
}

TEST(Tools, AreTakenByTheirKeysWithoutATray) {
    Visitor visitor;
    visitor.starts_to_throw();
    for (const tool::Tool held :
         {tool::Tool::kSponge, tool::Tool::kWire, tool::Tool::kRib, tool::Tool::kHand}) {
        visitor.presses(Button::kTakeTool, number(held));
        EXPECT_EQ(visitor.state.throwing.held, held);
    }
    visitor.presses(Button::kTakeTool, static_cast<int>(kTray.size())).presses(Button::kTakeTool, -1);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kHand);
}

TEST(Tools, TheTrayClosesUnderAHandThatTouchesTheClay) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kTools).does(event::ClayTouched{});
    EXPECT_FALSE(visitor.state.throwing.tray);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kHand);
}

TEST(Tools, TheTrayStaysOpenUnderATouchThatHadBegunBefore) {
    Visitor visitor;
    visitor.starts_to_throw()
        .does(event::ClayTouched{})
        .presses(Button::kTools)
        .does(event::ClayTouched{.goes_on = true});
    EXPECT_TRUE(visitor.state.throwing.tray);
    visitor.does(event::ClayTouched{});
    EXPECT_FALSE(visitor.state.throwing.tray) << "another one";
}

TEST(Tools, TheWireCutsOnceAndIsLaidBack) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kCut);
    EXPECT_FALSE(visitor.caused<effect::CutRim>()) << "it is not held";
    visitor.presses(Button::kTakeTool, number(tool::Tool::kWire));
    EXPECT_EQ(spoken_key(visitor.state), "wire.how");
    visitor.presses(Button::kCut);
    EXPECT_EQ(visitor.last, (std::vector<Effect>{effect::CutRim{}}));
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kHand);
    visitor.presses(Button::kCut);
    EXPECT_EQ(visitor.count<effect::CutRim>(), 1);
    visitor.presses(Button::kUndo);
    EXPECT_TRUE(visitor.caused<effect::Undo>());
}

TEST(Tools, TheSpongeDriesTheHandsByADotATurn) {
    Visitor visitor;
    visitor.starts_to_throw();
    const int water = visitor.state.throwing.water;
    visitor.presses(Button::kTakeTool, number(tool::Tool::kSponge)).does(event::Soaked{});
    EXPECT_EQ(visitor.state.throwing.water, water - 1);
    for (int turn = 0; turn < 9; ++turn)
        visitor.does(event::Soaked{});
    EXPECT_EQ(visitor.state.throwing.water, 1);
    visitor.presses(Button::kWaterMore);
    EXPECT_EQ(visitor.state.throwing.water, 2);
}

TEST(Tools, AreLaidDownForNewClayAndForThePotThatIsDone) {
    for (const Button button : {Button::kNewClay, Button::kDone}) {
        Visitor visitor;
        visitor.starts_to_throw()
            .presses(Button::kTakeTool, number(tool::Tool::kSponge))
            .presses(Button::kTools);
        visitor.presses(button);
        EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kHand) << static_cast<int>(button);
        EXPECT_FALSE(visitor.state.throwing.tray);
    }
}

TEST(Tools, DemonstrationsUseTheHeldToolOrWithTheWireTheLesson) {
    Visitor visitor;
    visitor.starts_to_throw().presses(Button::kTakeTool, number(tool::Tool::kRib)).presses(Button::kShowMe);
    EXPECT_EQ(visitor.state.throwing.shown, ShownStep::kDrawTool);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kRib);
    visitor.presses(Button::kMyTurn)
        .presses(Button::kTakeTool, number(tool::Tool::kWire))
        .presses(Button::kShowMe);
    EXPECT_EQ(visitor.state.throwing.shown, ShownStep::kPress);
    EXPECT_EQ(visitor.state.throwing.held, tool::Tool::kHand);
}

TEST(Tools, TheLessonIsHiddenWithAToolInTheHandOrAnOpenTray) {
    for (const auto& press : {event::Pressed{Button::kTakeTool, 1}, event::Pressed{Button::kTools}}) {
        Visitor visitor;
        visitor.starts_to_throw().does(press).waits(30.0);
        EXPECT_FALSE(visitor.caused<effect::ShowStep>());
    }
}

}  // namespace
}  // namespace onggi::visit
