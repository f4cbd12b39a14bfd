// Invariants after every event in every reachable state.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include "tests/unit/visit/visitor.h"

namespace onggi::visit {
namespace {

constexpr std::array kValues{-1, 0, 1, 3, 8};  // invalid, valid, and beyond the end of each list

// Every event but buttons, with the value wherever it has one.
std::vector<Event> events_with(int value) {
    const bool yes = value == 1;
    const auto warning = static_cast<Warning>(std::clamp(value, 0, static_cast<int>(Warning::kFast)));
    const auto outcome = static_cast<ShareOutcome>(std::clamp(value, 0, 2));
    const auto jar = value == 3 ? std::optional(InterruptedJar{JarStep::kSeam, 2}) : std::nullopt;
    return {event::Tick{},
            event::Input{yes},
            event::ClayTouched{yes},
            event::Held{yes},
            event::ShowOver{},
            event::Soaked{},
            event::Progress{value},
            event::Warned{warning},
            event::Collapsed{warning},
            event::Bowl{yes},
            event::SetAside{},
            event::Rims{value},
            event::RimsApart{},
            event::Joined{},
            event::JarStays{},
            event::UndoneAll{},
            event::ThickFoot{},
            event::Trimmed{value},
            event::Drawn{value},
            event::Saved{value},
            event::SaveFailed{},
            event::Shared{1, outcome},
            event::Device{yes},
            event::Force{yes},
            event::Headphones{yes},
            event::Spoken{yes},
            event::Fault{},
            event::FaultOver{},
            event::InterruptedSession{jar},
            event::CornerHeld{},
            event::CloseAsked{}};
}

// The fields of a state that determine its behaviour, as bytes, because half a million are compared.
using Key = std::array<std::uint8_t, 12>;

Key key_of(const State& state) {
    return {static_cast<std::uint8_t>(state.screen),
            static_cast<std::uint8_t>(state.panel),
            static_cast<std::uint8_t>(state.keeping.outcome),
            static_cast<std::uint8_t>(state.firing),
            static_cast<std::uint8_t>(state.throwing.jar.step),
            state.trimming.is_offered,
            state.throwing.jar.is_bowl,
            state.interrupted_session,
            state.throwing.target.has_value(),
            state.throwing.warning != Warning::kNone,
            state.throwing.shown.has_value(),
            state.pace.held};
}

Rules staffed() {
    return {.jars = {2}, .locked = true, .pin = 1234, .pin_digits = 4};
}

// All states reachable from attract, one visitor per key.
std::map<Key, Visitor> everywhere() {
    std::map<Key, Visitor> found;
    std::vector<Visitor> open{Visitor(staffed())};
    found.emplace(key_of(open.front().state), open.front());
    const auto meet = [&](Visitor visitor) {
        visitor.last.clear();
        visitor.all.clear();
        if (found.emplace(key_of(visitor.state), visitor).second) open.push_back(std::move(visitor));
    };
    while (!open.empty()) {
        const Visitor from = std::move(open.back());
        open.pop_back();
        for (int value = 0; value < 4; ++value) {
            for (const Event& event : events_with(value)) {
                Visitor next = from;
                meet(next.does(event));
            }
        }
        for (int button = 0; button < kButtonCount; ++button) {
            for (const int value : {1, 2}) {
                Visitor next = from;
                meet(next.presses(static_cast<Button>(button), value));
            }
        }
        Visitor typing = from;
        for (const int digit : {1, 2, 3, 4})
            typing.presses(Button::kDigit, digit);
        meet(typing);
        for (const double seconds : {0.5, 1.3, 2.7, 6.0, 46.0, 181.0}) {
            Visitor waiting = from;
            meet(waiting.waits(seconds));
        }
    }
    return found;
}

// The event and its state, formatted only if a test fails.
struct After {
    const Key& where;
    const Event& event;

    friend std::ostream& operator<<(std::ostream& out, const After& after) {
        out << "screen " << int{after.where[0]} << " panel " << int{after.where[1]} << ", event "
            << after.event.index();
        if (const auto* const pressed = std::get_if<event::Pressed>(&after.event))
            out << " button " << static_cast<int>(pressed->button) << " value " << pressed->value;
        return out;
    }
};

void expect_whole(const State& state, const After& after) {
    EXPECT_GE(static_cast<int>(state.screen), 0) << after;
    EXPECT_LT(static_cast<int>(state.screen), kScreenCount) << after;
    EXPECT_LT(static_cast<int>(state.panel), kPanelCount) << after;
    EXPECT_GE(state.comfort.language, 0) << after;
    EXPECT_LT(state.comfort.language, 3) << after;
    EXPECT_TRUE(state.comfort.text_size >= 1 && state.comfort.text_size <= kMostTextSize) << after;
    EXPECT_TRUE(state.comfort.volume >= 0 && state.comfort.volume <= kMostVolume) << after;
    EXPECT_TRUE(state.throwing.tool >= 1 && state.throwing.tool <= kMostTool) << after;
    EXPECT_TRUE(state.throwing.water >= 1 && state.throwing.water <= kMostWater) << after;
    EXPECT_TRUE(state.throwing.speed >= 1 && state.throwing.speed <= kMostSpeed) << after;
    EXPECT_TRUE(state.throwing.steps_done >= 0 && state.throwing.steps_done <= kTeachingSteps) << after;
    EXPECT_TRUE(!state.throwing.target || (*state.throwing.target >= 0 && *state.throwing.target < 4))
        << after;
    EXPECT_LE(std::abs(state.throwing.jar.shift_mm), kMostShiftMm) << after;
    EXPECT_EQ(state.screen == Screen::kJoin, state.throwing.jar.step == JarStep::kJoin) << after;
    EXPECT_TRUE(state.glaze >= 0 && state.glaze < 6) << after;
    if (state.screen == Screen::kFault) {
        EXPECT_NE(state.panel, Panel::kIdle) << after;
        EXPECT_NE(state.panel, Panel::kLanguage) << after;
    }
}

class EveryEvent : public testing::Test {
  protected:
    static void SetUpTestSuite() { visitors = everywhere(); }
    static void TearDownTestSuite() { visitors.clear(); }

    template <typename Look>
    void for_each_event(Look&& look) {
        for (const auto& each : visitors) {
            const auto meets = [&](const Event& event) {
                look(each.second, event, After{each.first, event});
            };
            for (const int value : kValues) {
                for (const Event& event : events_with(value))
                    meets(event);
                for (int button = 0; button < kButtonCount; ++button)
                    meets(event::Pressed{static_cast<Button>(button), value});
            }
        }
    }

    static inline std::map<Key, Visitor> visitors;
};

TEST_F(EveryEvent, IsTried) {
    std::set<std::size_t> kinds{Event(event::Pressed{}).index()};
    for (const Event& event : events_with(1))
        kinds.insert(event.index());
    EXPECT_EQ(kinds.size(), std::variant_size_v<Event>);
}

TEST_F(EveryEvent, ReachesEveryScreenAndEveryPanel) {
    std::map<int, int> screens;
    std::map<int, int> panels;
    for (const auto& [key, visitor] : visitors) {
        ++screens[key[0]];
        ++panels[key[1]];
    }
    EXPECT_EQ(screens.size(), static_cast<std::size_t>(kScreenCount));
    EXPECT_EQ(panels.size(), static_cast<std::size_t>(kPanelCount));
    EXPECT_GT(visitors.size(), 60U);
}

TEST_F(EveryEvent, LeavesAStateThatIsWhole) {
    for_each_event([](Visitor visitor, const Event& event, const After& after) {
        visitor.does(event);
        expect_whole(visitor.state, after);
    });
}

TEST_F(EveryEvent, EndsInAttractWhenTheVisitorWalksAway) {
    // A state that was left alone once behaves the same again.
    std::set<std::pair<Key, bool>> walked_away;
    for_each_event([&](Visitor visitor, const Event& event, const After& after) {
        visitor.does(event);
        if (visitor.state.screen == Screen::kFault) return;
        if (!walked_away.emplace(key_of(visitor.state), visitor.state.comfort == Comfort{}).second) return;
        // The staff panel locks first, then the visit is left alone.
        for (int look = 0; look < 40; ++look) {
            visitor.now_s += 10.0;
            visitor.does(event::Tick{});
        }
        EXPECT_EQ(visitor.state.screen, Screen::kAttract) << after;
        EXPECT_EQ(visitor.state.panel, Panel::kNone) << after;
        EXPECT_EQ(visitor.state.comfort,
                  (Comfort{.language = visitor.state.house_language, .volume = visitor.state.house_volume}))
            << after;
    });
}

TEST_F(EveryEvent, QuitsFromALockedKioskForTheStaffAlone) {
    for_each_event([](Visitor visitor, const Event& event, const After& after) {
        const bool staff_is_there = visitor.state.panel == Panel::kStaff;
        visitor.does(event);
        const bool leaves = visitor.caused<effect::Quit>() || visitor.caused<effect::Restart>();
        EXPECT_TRUE(staff_is_there || !leaves) << after;
    });
}

// The wheel's hands are never left at work on a screen that does not say so, and never told to stop twice.
TEST_F(EveryEvent, StopsTheWheelsHandsWithTheShow) {
    int stopped = 0;
    for_each_event([&](Visitor visitor, const Event& event, const After& after) {
        const bool showed = visitor.state.throwing.shown.has_value();
        visitor.does(event);
        const State& state = visitor.state;
        const bool shows = state.throwing.shown.has_value();
        if (shows) {
            EXPECT_TRUE(state.screen == Screen::kThrow && state.panel == Panel::kNone) << after;
        }
        EXPECT_EQ(visitor.count<effect::ShowStep>(), shows && !showed ? 1 : 0) << after;
        EXPECT_EQ(visitor.count<effect::StopShow>(), showed && !shows ? 1 : 0) << after;
        if (!visitor.caused<effect::StopShow>()) return;
        EXPECT_TRUE(std::holds_alternative<effect::StopShow>(visitor.all.front()))
            << after << ": before all else";
        ++stopped;
    });
    EXPECT_GT(stopped, 100);
}

TEST_F(EveryEvent, SavesOnceAndOnlyForTheKeepButton) {
    for_each_event([](Visitor visitor, const Event& event, const After& after) {
        visitor.does(event);
        if (!visitor.caused<effect::Save>()) return;
        const auto* const pressed = std::get_if<event::Pressed>(&event);
        EXPECT_TRUE(pressed != nullptr && pressed->button == Button::kKeep) << after;
        EXPECT_EQ(visitor.count<effect::Save>(), 1) << after;
        EXPECT_EQ(visitor.state.screen, Screen::kKeep) << after;
    });
}

}  // namespace
}  // namespace onggi::visit
