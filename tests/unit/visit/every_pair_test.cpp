// The transition for every pair of place and event. A place is a screen with its panel. A pair that no line
// below names must not change the place; a screen, event or button that no line names at all fails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

// Sets of places that rules may name. "attract-left": an interrupted pot waits; "saving": not kept yet.
const std::map<std::string, std::string> kSets{
    {"told", "choose your-pot"},  // of a museum's pot, on its card
    {"visit", "choose jar-start throw join failure firing trim decorate glaze your-pot saving keep resume"},
    {"left-alone",
     "choose jar-start throw failure trim decorate glaze your-pot saving keep resume"},  // firing goes on by
                                                                                         // itself
    {"any",
     "attract attract-left choose jar-start throw join failure firing trim decorate glaze your-pot saving "
     "keep "
     "resume fault"}};
// The screens over which each panel may lie.
const std::map<std::string, std::string> kPanels{{"", "any"},
                                                 {"+language", "attract attract-left visit"},
                                                 {"+idle", "left-alone join"},
                                                 {"+pin", "any"},
                                                 {"+staff", "any"},
                                                 {"+card", "told"}};

struct Happening {
    std::string name;
    Event event;
    double after_s;
    // FROM -> TO, separated by commas; `same` is the screen of FROM; without a panel: no panel is open.
    std::string rules;
};

const std::string kClosesStaff =
    "visit+pin -> same, visit+staff -> same, fault+pin -> fault, fault+staff -> fault, attract+pin -> "
    "attract, "
    "attract+staff -> attract, attract-left+pin -> attract-left, attract-left+staff -> attract-left";

Happening at_once(const char* name, const Event& event, const char* rules) {
    return {name, event, 0.0, rules};
}

std::vector<Happening> events() {
    const auto tick = [](const char* name, double after_s, const std::string& rules) {
        return Happening{name, event::Tick{}, after_s, rules};
    };
    const std::string leaves =
        "left-alone -> same+idle, firing -> decorate+idle, left-alone+language -> same+idle, "
        "firing+language -> decorate+idle, attract+language -> attract, attract-left+language -> "
        "attract-left, "
        "left-alone+idle -> attract, join+idle -> attract, resume+idle -> attract-left, told+card -> "
        "same+idle";
    return {
        tick("a frame", 0.0, ""),
        tick("21 s", 21.0,
             "firing -> decorate, firing+language -> decorate+language, left-alone+idle -> attract, "
             "join+idle -> attract, resume+idle -> attract-left"),
        tick("46 s", 46.0, leaves),
        tick("130 s", 130.0, leaves + ", " + kClosesStaff),
        tick("181 s", 181.0, leaves + ", join -> same+idle, join+language -> same+idle, " + kClosesStaff),
        at_once("input", event::Input{.by_key = false},
                "attract -> choose, attract-left -> resume, left-alone+idle -> same, join+idle -> same"),
        at_once("clay touched", event::ClayTouched{.goes_on = false},
                "attract -> throw, attract-left -> resume, choose -> throw, choose+idle -> throw, "
                "throw+idle -> same, failure+idle -> same, trim+idle -> same, decorate+idle -> same, "
                "glaze+idle -> same, "
                "your-pot+idle -> same, jar-start+idle -> same, join+idle -> same, "
                "saving+idle -> same, keep+idle -> same, resume+idle -> same"),
        at_once("held", event::Held{.holds = true}, ""),
        at_once("show over", event::ShowOver{}, ""),
        at_once("soaked", event::Soaked{}, ""),
        at_once("progress", event::Progress{2}, ""),
        at_once("warned", event::Warned{Warning::kThin}, ""),
        at_once("collapsed", event::Collapsed{Warning::kThin},
                "throw -> failure, throw+language -> failure, throw+idle -> failure+idle, "
                "throw+pin -> failure+pin, throw+staff -> failure+staff"),
        at_once("bowl", event::Bowl{.is_bowl = true}, ""),
        at_once("set aside", event::SetAside{}, ""),
        at_once("rims", event::Rims{3}, ""),
        at_once("rims apart", event::RimsApart{}, ""),
        at_once("joined", event::Joined{},
                "join -> throw, join+language -> throw+language, join+idle -> throw+idle, "
                "join+pin -> throw+pin, join+staff -> throw+staff"),
        at_once("jar stays", event::JarStays{}, ""),
        at_once("undone all", event::UndoneAll{}, ""),
        at_once("thick foot", event::ThickFoot{}, ""),
        at_once("trimmed", event::Trimmed{12}, ""),
        at_once("drawn", event::Drawn{3}, ""),
        at_once("saved", event::Saved{5},
                "saving -> keep, saving+language -> keep+language, saving+idle -> keep+idle, "
                "saving+pin -> keep+pin, saving+staff -> keep+staff"),
        at_once("save failed", event::SaveFailed{},
                "saving -> keep, saving+language -> keep+language, saving+idle -> keep+idle, "
                "saving+pin -> keep+pin, saving+staff -> keep+staff"),
        at_once("shared", event::Shared{1}, ""),
        at_once("share failed", event::Shared{1, ShareOutcome::kFailed}, ""),
        at_once("share over", event::Shared{1, ShareOutcome::kOver}, ""),
        at_once("device lost", event::Device{.is_there = false}, ""),
        at_once("device back", event::Device{.is_there = true}, ""),
        at_once("force rests", event::Force{.rests = true}, ""),
        at_once("force back", event::Force{.rests = false}, ""),
        at_once("headphones in", event::Headphones{.are_in = true}, ""),
        at_once("headphones out", event::Headphones{.are_in = false}, ""),
        at_once("spoken", event::Spoken{.speaks = true}, ""),
        at_once(
            "fault", event::Fault{},
            "any -> fault, attract+language -> fault, attract-left+language -> fault, "
            "visit+language -> fault, left-alone+idle -> fault, join+idle -> fault, any+pin -> fault+pin, "
            "any+staff -> fault+staff, told+card -> fault"),
        at_once("fault over", event::FaultOver{},
                "fault -> attract, fault+pin -> attract, fault+staff -> attract"),
        at_once("left over", event::InterruptedSession{},
                "attract -> attract-left, attract+language -> attract-left+language, "
                "attract+pin -> attract-left+pin, attract+staff -> attract-left+staff"),
        at_once("corner held", event::CornerHeld{},
                "any -> same+pin, attract+language -> same+pin, attract-left+language -> same+pin, "
                "visit+language -> same+pin, left-alone+idle -> same+pin, join+idle -> same+pin, told+card "
                "-> same+pin"),
        at_once("close asked", event::CloseAsked{}, ""),
    };
}

// The effect of each button besides the one common to all buttons; most have only that.
std::vector<Happening> buttons() {
    const std::string any =
        "attract -> choose, attract-left -> resume, left-alone+idle -> same, join+idle -> same";
    const std::string opens =
        "attract -> same+language, attract-left -> same+language, visit -> same+language, "
        "left-alone+idle -> same, join+idle -> same, ";
    const std::string done =
        "attract+language -> choose, attract-left+language -> resume, visit+language -> same";
    const std::map<Button, std::string> rules{
        {Button::kBegin, any + ", jar-start -> throw"},
        {Button::kLanguages, opens + done},
        {Button::kBack, any + ", choose -> attract, jar-start -> choose, throw -> choose, join -> throw"},
        {Button::kFree, any + ", choose -> throw"},
        {Button::kTarget, any + ", choose -> throw"},
        {Button::kCard, any + ", told -> same+card"},
        {Button::kCardClose, any + ", told+card -> same"},
        {Button::kCardThrow, any + ", choose+card -> throw"},
        {Button::kNewClay, any + ", failure -> throw"},
        {Button::kUndo, any + ", join -> throw"},
        {Button::kDone, any + ", throw -> firing, trim -> decorate, decorate -> firing"},
        {Button::kBeforeCollapse, any + ", failure -> throw"},
        {Button::kKeepSlump, any + ", failure -> firing"},
        {Button::kSkip, any + ", firing -> decorate, trim -> decorate"},
        {Button::kTakeGlaze, any + ", glaze -> your-pot"},
        {Button::kDecorateAgain, any + ", glaze -> decorate"},
        {Button::kOtherGlaze, any + ", your-pot -> glaze"},
        {Button::kKeep, any + ", your-pot -> saving"},
        {Button::kAnother, any + ", keep -> choose"},
        {Button::kFinish, any + ", keep -> attract"},
        {Button::kFresh,
         "attract -> choose, attract-left -> resume, left-alone+idle -> throw, join+idle -> throw"},
        {Button::kComfortDone, any + ", " + done},
        {Button::kResumeGo, any + ", resume -> throw"},
        {Button::kResumeFresh, any + ", resume -> throw"},
        {Button::kPinClose, any + ", " + kClosesStaff},
        {Button::kStaffClose, any + ", " + kClosesStaff},
    };
    std::vector<Happening> all;
    for (int place = 0; place < kButtonCount; ++place) {
        const auto button = static_cast<Button>(place);
        const auto rule = rules.find(button);
        all.push_back({fmt::format("button {}", place), event::Pressed{button, 1}, 0.0,
                       rule == rules.end() ? any : rule->second});
    }
    return all;
}

std::vector<std::string> expanded(const std::string& set) {
    std::istringstream words(set);
    std::vector<std::string> all;
    for (std::string word; words >> word;) {
        const auto found = kSets.find(word);
        if (found == kSets.end()) {
            all.push_back(word);
            continue;
        }
        const auto inner = expanded(found->second);
        all.insert(all.end(), inner.begin(), inner.end());
    }
    return all;
}

std::pair<std::string, std::string> parted(const std::string& place) {
    const std::size_t plus = std::min(place.find('+'), place.size());
    return {place.substr(0, plus), place.substr(plus)};
}

std::string name_of_place(const State& state) {
    std::string name(step_of(state.screen).name);
    if (state.screen == Screen::kAttract && state.interrupted_session) name = "attract-left";
    if (state.screen == Screen::kKeep && state.keeping.outcome == Keeping::Outcome::kSaving) name = "saving";
    return state.panel == Panel::kNone ? name : name + "+" + std::string(overlay_of(state.panel).name);
}

Visitor at_screen(const std::string& name) {
    // Here the kiosk's own work stops no countdown: flow_test tells of that.
    Visitor visitor(Rules{.works_most_s = 0.0, .jars = {2}, .locked = true, .pin = 1234, .pin_digits = 4});
    if (name == "attract") return visitor;
    if (name == "attract-left") return visitor.does(event::InterruptedSession{});
    if (name == "choose") return visitor.does(event::Input{});
    if (name == "jar-start") return visitor.chooses_a_jar(2);
    if (name == "join") return visitor.chooses_a_jar(2).holds_two_bowls();
    if (name == "throw") return visitor.starts_to_throw();
    if (name == "failure") return visitor.starts_to_throw().does(event::Collapsed{});
    if (name == "firing") return visitor.fires();
    if (name == "trim") return visitor.fires().does(event::ThickFoot{}).presses(Button::kSkip);
    if (name == "decorate") return visitor.decorates();
    if (name == "glaze") return visitor.chooses_a_glaze();
    if (name == "your-pot") return visitor.sees_the_pot();
    if (name == "saving") return visitor.keeps();
    if (name == "keep") return visitor.keeps().does(event::Saved{1});
    if (name == "resume") return visitor.does(event::InterruptedSession{}).does(event::Input{});
    if (name == "fault") return visitor.does(event::Fault{});
    ADD_FAILURE() << "no way is known to " << name;
    return visitor;
}

Visitor at_place(const std::string& name) {
    const auto [screen, panel] = parted(name);
    Visitor visitor = at_screen(screen);
    if (panel == "+language") visitor.presses(Button::kLanguages);
    if (panel == "+idle") {
        visitor.now_s += screen == "join" ? 181.0 : 46.0;
        visitor.does(event::Tick{});
    }
    if (panel == "+card") visitor.presses(Button::kCard, 1);
    if (panel == "+pin" || panel == "+staff") visitor.does(event::CornerHeld{});
    if (panel == "+staff") {
        for (const int digit : {1, 2, 3, 4})
            visitor.presses(Button::kDigit, digit);
    }
    visitor.all.clear();
    return visitor;
}

std::vector<std::string> all_places() {
    std::vector<std::string> places;
    for (const auto& [panel, screens] : kPanels) {
        for (const std::string& screen : expanded(screens))
            places.push_back(screen + panel);
    }
    return places;
}

// The target of each place named in the rules.
std::map<std::string, std::string> leads(const Happening& happening) {
    std::map<std::string, std::string> next;
    std::istringstream rules(happening.rules);
    for (std::string rule; std::getline(rules, rule, ',');) {
        std::istringstream words(rule);
        std::string from;
        std::string arrow;
        std::string to;
        words >> from >> arrow >> to;
        EXPECT_EQ(arrow, "->") << happening.name << ": " << rule;
        const auto [set, panel] = parted(from);
        for (const std::string& screen : expanded(set)) {
            const auto [to_screen, to_panel] = parted(to);
            next[screen + panel] = (to_screen == "same" ? screen : to_screen) + to_panel;
        }
    }
    return next;
}

TEST(EveryPair, KnowsAWayToEveryPlace) {
    std::set<int> screens;
    std::set<int> panels;
    for (const std::string& place : all_places()) {
        const Visitor visitor = at_place(place);
        EXPECT_EQ(name_of_place(visitor.state), place);
        screens.insert(static_cast<int>(visitor.state.screen));
        panels.insert(static_cast<int>(visitor.state.panel));
    }
    EXPECT_EQ(screens.size(), static_cast<std::size_t>(kScreenCount)) << "a screen without expectation";
    EXPECT_EQ(panels.size(), static_cast<std::size_t>(kPanelCount)) << "a panel without expectation";
}

TEST(EveryPair, ExpectsSomethingOfEveryEventAndEveryButton) {
    std::set<std::size_t> kinds{Event(event::Pressed{}).index()};  // of which the buttons are
    for (const Happening& happening : events())
        kinds.insert(happening.event.index());
    EXPECT_EQ(kinds.size(), std::variant_size_v<Event>) << "an event without expectation";
    const std::vector<Happening> all = buttons();
    ASSERT_EQ(all.size(), static_cast<std::size_t>(kButtonCount)) << "a button without expectation";
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(static_cast<std::size_t>(std::get<event::Pressed>(all[i].event).button), i);
}

TEST(Steps, StandWhereTheirScreenIs) {
    for (int i = 0; i < kScreenCount; ++i) {
        const Step& step = step_of(static_cast<Screen>(i));
        EXPECT_EQ(static_cast<int>(step.screen), i) << step.name;
        EXPECT_TRUE(step.draw != nullptr && step.spoken != nullptr) << step.name;
    }
    for (int i = 0; i < kPanelCount; ++i)
        EXPECT_EQ(static_cast<int>(overlay_of(static_cast<Panel>(i)).panel), i);
}

TEST(EveryPair, LeadsWhereItShould) {
    std::vector<Happening> all = events();
    for (Happening& button : buttons())
        all.push_back(std::move(button));
    const std::vector<std::string> places = all_places();
    const std::set<std::string> known(places.begin(), places.end());
    int pairs = 0;
    for (const Happening& happening : all) {
        const auto next = leads(happening);
        for (const auto& [from, to] : next) {
            EXPECT_TRUE(known.contains(from)) << happening.name << " names " << from;
            EXPECT_TRUE(known.contains(to)) << happening.name << " names " << to;
        }
        for (const std::string& place : places) {
            Visitor visitor = at_place(place);
            visitor.now_s += happening.after_s;
            visitor.does(happening.event);
            const auto found = next.find(place);
            EXPECT_EQ(name_of_place(visitor.state), found == next.end() ? place : found->second)
                << happening.name << " at " << place;
            ++pairs;
        }
    }
    EXPECT_EQ(pairs, static_cast<int>(all.size() * places.size()));
    EXPECT_GT(pairs, 3500);
}

}  // namespace
}  // namespace onggi::visit
