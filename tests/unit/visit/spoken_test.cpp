// The spoken line of each screen exists in the tables and belongs to that screen.
#include "game/visit/steps.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "game/kiosk/strings.h"
#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

TEST(Spoken, SaysWhereAVisitorIs) {
    Visitor visitor;
    EXPECT_EQ(spoken_key(visitor.state), "attract.touch");
    visitor.does(event::Input{});
    EXPECT_EQ(spoken_key(visitor.state), "choose.title");
    visitor.presses(Button::kFree);
    EXPECT_EQ(spoken_key(visitor.state), "step.press");
    visitor.does(event::Progress{1});
    EXPECT_EQ(spoken_key(visitor.state), "step.open");
    visitor.does(event::Warned{Warning::kWet});
    EXPECT_EQ(spoken_key(visitor.state), "warn.wet");
    visitor.does(event::Warned{Warning::kNone}).does(event::Progress{3});
    EXPECT_EQ(spoken_key(visitor.state), "step.own");
    visitor.waits(46.0);
    EXPECT_EQ(spoken_key(visitor.state), "idle.title");
    visitor.does(event::Input{}).presses(Button::kDone);
    EXPECT_EQ(spoken_key(visitor.state), "fin.cut");
    visitor.presses(Button::kSkip);
    EXPECT_EQ(spoken_key(visitor.state), "dec.title");
    visitor.presses(Button::kDrawingTool, 2);
    EXPECT_EQ(spoken_key(visitor.state), "dec.cobalt.h");
    visitor.presses(Button::kDone).presses(Button::kSkip);
    EXPECT_EQ(spoken_key(visitor.state), "glz.title");
    visitor.presses(Button::kTakeGlaze);
    EXPECT_EQ(spoken_key(visitor.state), "your.title");
    visitor.presses(Button::kKeep);
    EXPECT_EQ(spoken_key(visitor.state), "keep.saving") << "not before the pot is safe";
    visitor.does(event::Saved{3});
    EXPECT_EQ(spoken_key(visitor.state), "keep.title");
}

TEST(Spoken, HasWordsInEveryLanguageForAllItSays) {
    std::set<std::string> keys;
    State state;
    for (int panel = 0; panel < kPanelCount; ++panel) {
        state.panel = static_cast<Panel>(panel);
        for (int screen = 0; screen < kScreenCount; ++screen) {
            state.screen = static_cast<Screen>(screen);
            for (int part = 0; part < 4; ++part) {
                state.throwing.steps_done = std::min(part, kTeachingSteps);
                state.throwing.warning = static_cast<Warning>(part);
                state.decorating.tool = part;
                state.firing = static_cast<FiringStage>(std::min(part, 2));
                state.keeping.outcome = static_cast<Keeping::Outcome>(std::min(part, 2));
                for (const bool lost : {false, true}) {
                    state.device_lost = lost;
                    if (const auto key = spoken_key(state); !key.empty()) keys.insert(std::string(key));
                }
            }
        }
    }
    EXPECT_GT(keys.size(), 18U);
    for (const Language& language : built_in_languages()) {
        for (const std::string& key : keys) {
            EXPECT_TRUE(language.has(key)) << language.code() << ' ' << key;
            EXPECT_FALSE(language.spoken(key).empty()) << language.code() << ' ' << key;
        }
    }
}

TEST(Spoken, BeginsWithHeadphonesUntilTheVisitorSaysOtherwise) {
    Visitor visitor({.offers_speech = true});
    EXPECT_FALSE(visitor.state.comfort.speech);
    visitor.does(event::Headphones{true});
    EXPECT_TRUE(visitor.state.comfort.speech);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract) << "they begin no visit";
    visitor.does(event::Input{}).presses(Button::kLanguages).presses(Button::kSpeech);
    EXPECT_FALSE(visitor.state.comfort.speech);
    visitor.presses(Button::kComfortDone).waits(70.0);
    EXPECT_EQ(visitor.state.screen, Screen::kAttract);
    EXPECT_TRUE(visitor.state.comfort.speech) << "the next visitor has them on";
    visitor.does(event::Headphones{false});
    EXPECT_FALSE(visitor.state.comfort.speech);
}

TEST(Spoken, IsOfferedAndBegunOnlyWhereThereIsAVoice) {
    Visitor without;
    without.does(event::Headphones{true}).does(event::Input{}).presses(Button::kLanguages);
    EXPECT_FALSE(without.presses(Button::kSpeech).state.comfort.speech);
    Visitor always({.offers_speech = true, .speaks = true});
    EXPECT_TRUE(always.state.comfort.speech);
}

TEST(Spoken, TakesTimeThatDoesNotCountAsIdleWithinBounds) {
    Visitor visitor;
    visitor.starts_to_throw().does(event::Spoken{true}).waits(100.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone) << "somebody listens";
    visitor.does(event::Spoken{false}).waits(40.0);
    EXPECT_EQ(visitor.state.panel, Panel::kNone);
    visitor.waits(10.0);
    EXPECT_EQ(visitor.state.panel, Panel::kIdle);
    Visitor left;
    left.starts_to_throw().does(event::Spoken{true}).waits(180.0 + 44.0);
    EXPECT_EQ(left.state.panel, Panel::kNone);
    left.waits(3.0);
    EXPECT_EQ(left.state.panel, Panel::kIdle) << "a scan goes on for ever";
}

}  // namespace
}  // namespace onggi::visit
