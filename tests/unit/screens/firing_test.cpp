// The screens between the wheel and the finished pot.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

// True of the drying alone: of a pot that is cut off, burns or is done it would be wrong.
TEST(NoteOnShrinking, StandsWhileThePotDriesAndOnNoOtherScreenAfterDone) {
    ui::Painter painter;
    PaintingStore store(painter);
    int notes = 0;
    for (const kiosk::Language& language : kiosk::built_in_languages()) {
        const std::string note(language.shown("fin.note"));
        for (const SampleView& sample : sample_views({.language = language.code()})) {
            const kiosk::ScreenState& state = sample.view->state;
            const std::string_view step = visit::step_of(state.screen).name;
            constexpr std::array kAfterDone{"firing", "trim", "decorate", "glaze"};
            if (std::find(kAfterDone.begin(), kAfterDone.end(), step) == kAfterDone.end()) continue;
            const bool dries = state.screen == kiosk::Screen::kFiring && state.panel == kiosk::Panel::kNone &&
                               state.firing == kiosk::FiringStage::kDry;
            const Composition screen = visit::compose(*sample.view, painter, store);
            const bool has_note =
                std::any_of(screen.writings.begin(), screen.writings.end(),
                            [&](const Writing& text) { return text.words.find(note) != std::string::npos; });
            EXPECT_EQ(has_note, dries) << language.code() << ' ' << sample.name;
            notes += has_note ? 1 : 0;
        }
    }
    EXPECT_GE(notes, static_cast<int>(kiosk::built_in_languages().size()));
}

}  // namespace
}  // namespace onggi::screens
