// Says where the targets of every screen are, for scripts that play a visitor: screen_targets [LANGUAGE
// [WIDTH HEIGHT [TEXT [low]]]]. A line each: screen, button, value, place in the ring's order, x and y of its
// middle in pixels.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace {

using onggi::kiosk::Button;

const std::map<Button, std::string_view> kWords{{Button::kBegin, "begin"},
                                                {Button::kShelfNext, "shelf-next"},
                                                {Button::kJoinBowls, "join-bowls"},
                                                {Button::kFree, "free"},
                                                {Button::kTarget, "target"},
                                                {Button::kLanguages, "languages"},
                                                {Button::kLanguage, "language"},
                                                {Button::kTextMore, "text-more"},
                                                {Button::kReach, "reach"},
                                                {Button::kStill, "still"},
                                                {Button::kComfortDone, "comfort-done"},
                                                {Button::kUndo, "undo"},
                                                {Button::kNewClay, "new-clay"},
                                                {Button::kShowMe, "show-me"},
                                                {Button::kMyTurn, "my-turn"},
                                                {Button::kToWheel, "to-wheel"},
                                                {Button::kLookIn, "look-in"},
                                                {Button::kHandUp, "hand-up"},
                                                {Button::kHandDown, "hand-down"},
                                                {Button::kHandLeft, "hand-left"},
                                                {Button::kHandRight, "hand-right"},
                                                {Button::kTools, "tools"},
                                                {Button::kTakeTool, "take-tool"},
                                                {Button::kCut, "cut"},
                                                {Button::kWaterMore, "water-more"},
                                                {Button::kSpeedMore, "speed-more"},
                                                {Button::kDone, "done"},
                                                {Button::kDrawingTool, "drawing-tool"},
                                                {Button::kMotif, "motif"},
                                                {Button::kAllRound, "all-round"},
                                                {Button::kTurning, "turning"},
                                                {Button::kPutBrush, "put-brush"},
                                                {Button::kClear, "clear"},
                                                {Button::kSkip, "skip"},
                                                {Button::kGlaze, "glaze"},
                                                {Button::kTakeGlaze, "take-glaze"},
                                                {Button::kKeep, "keep"},
                                                {Button::kAnother, "another"},
                                                {Button::kFinish, "finish"},
                                                {Button::kOnWall, "on-wall"},
                                                {Button::kResumeGo, "resume-go"},
                                                {Button::kResumeFresh, "resume-fresh"},
                                                {Button::kBeforeCollapse, "before-collapse"}};

std::string_view word_of(Button button) {
    const auto word = kWords.find(button);
    return word == kWords.end() ? "other" : word->second;
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
        const auto screen = visit::compose(*sample.view, painter, store);
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
