// Says where the targets of every screen are, for scripts that play a visitor: screen_targets [LANGUAGE
// [WIDTH HEIGHT [TEXT [low]]]]. A line each: screen, button, value, place in the ring's order, x and y of its
// middle in pixels.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "game/screens/screens.h"
#include "tests/unit/screens/sample_views.h"

namespace {

const char* word_of(onggi::kiosk::Button button) {
    using onggi::kiosk::Button;
    switch (button) {
        case Button::kBegin:
            return "begin";
        case Button::kShelfNext:
            return "shelf-next";
        case Button::kJoinBowls:
            return "join-bowls";
        case Button::kFree:
            return "free";
        case Button::kTarget:
            return "target";
        case Button::kLanguages:
            return "languages";
        case Button::kLanguage:
            return "language";
        case Button::kTextMore:
            return "text-more";
        case Button::kReach:
            return "reach";
        case Button::kStill:
            return "still";
        case Button::kComfortDone:
            return "comfort-done";
        case Button::kUndo:
            return "undo";
        case Button::kNewClay:
            return "new-clay";
        case Button::kShowMe:
            return "show-me";
        case Button::kMyTurn:
            return "my-turn";
        case Button::kLookIn:
            return "look-in";
        case Button::kHandUp:
            return "hand-up";
        case Button::kHandDown:
            return "hand-down";
        case Button::kHandLeft:
            return "hand-left";
        case Button::kHandRight:
            return "hand-right";
        case Button::kTools:
            return "tools";
        case Button::kTakeTool:
            return "take-tool";
        case Button::kCut:
            return "cut";
        case Button::kWaterMore:
            return "water-more";
        case Button::kSpeedMore:
            return "speed-more";
        case Button::kDone:
            return "done";
        case Button::kDrawingTool:
            return "drawing-tool";
        case Button::kMotif:
            return "motif";
        case Button::kAllRound:
            return "all-round";
        case Button::kTurning:
            return "turning";
        case Button::kPutBrush:
            return "put-brush";
        case Button::kClear:
            return "clear";
        case Button::kSkip:
            return "skip";
        case Button::kGlaze:
            return "glaze";
        case Button::kTakeGlaze:
            return "take-glaze";
        case Button::kKeep:
            return "keep";
        case Button::kAnother:
            return "another";
        case Button::kFinish:
            return "finish";
        case Button::kOnWall:
            return "on-wall";
        case Button::kResumeGo:
            return "resume-go";
        case Button::kResumeFresh:
            return "resume-fresh";
        case Button::kBeforeCollapse:
            return "before-collapse";
        default:
            return "other";
    }
}

}  // namespace

int main(int argc, char** argv) {
    using namespace onggi;
    const auto word = [&](int place, const char* fallback) {
        return std::string(argc > place ? argv[place] : fallback);
    };
    const screens::SampleRequest request{.width_px = std::atoi(word(2, "1280").c_str()),
                                         .height_px = std::atoi(word(3, "720").c_str()),
                                         .language = word(1, "en"),
                                         .text_size = std::atoi(word(4, "1").c_str()),
                                         .reach = word(5, "") == "low"};
    ui::Painter painter;
    screens::PaintingStore store(painter, screens::PaintingStore::Paints::kNothing);
    for (const screens::SampleView& sample : screens::sample_views(request)) {
        const auto screen = screens::compose(*sample.view, painter, store);
        for (std::size_t place = 0; place < screen.targets.size(); ++place) {
            const screens::Target& target = screen.targets[place];
            const vec2 middle = target.rect.centre() * screen.px_per_u;
            const std::string line =
                fmt::format("{} {} {} {} {:.0f} {:.0f}\n", sample.name, word_of(target.button), target.value,
                            place, middle.x, middle.y);
            std::fwrite(line.data(), 1, line.size(), stdout);
        }
    }
    return 0;
}
