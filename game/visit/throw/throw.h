// Throwing: what its files and the jar share. Any thread, but the drawing.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "game/screens/page/icons.h"
#include "game/tool/tool.h"
#include "game/visit/flow/turn.h"

namespace onggi::visit {

// A tool of the tray, with its keys in the tables of words.
struct TrayTool {
    tool::Tool tool;
    screens::Icon icon;
    const char* name_key;
    const char* line_key;         // written in the tray
    std::string_view held_key{};  // spoken while it is held; empty: the lesson's line
    std::string_view title{};     // its word in the window's title
};
// In the order of the tray.
constexpr std::array kTray{
    TrayTool{tool::Tool::kHand, screens::Icon::kHand, "tool.hand", "tool.hand.line"},
    TrayTool{tool::Tool::kRib, screens::Icon::kRib, "tool.rib", "tool.rib.line", "tool.rib.line", "rib"},
    TrayTool{tool::Tool::kSponge, screens::Icon::kSponge, "tool.sponge", "tool.sponge.line",
             "tool.sponge.line", "sponge"},
    TrayTool{tool::Tool::kWire, screens::Icon::kWire, "tool.wire", "tool.wire.line", "wire.how", "wire"}};

// Precondition: the tray has the tool.
[[nodiscard]] constexpr std::size_t tray_place(tool::Tool held) {
    return static_cast<std::size_t>(
        std::find_if(kTray.begin(), kTray.end(), [&](const TrayTool& row) { return row.tool == held; }) -
        kTray.begin());
}
[[nodiscard]] constexpr const TrayTool& tray_tool(tool::Tool held) {
    return kTray[tray_place(held)];
}

// The key of the question's words. Precondition: it is one.
[[nodiscard]] constexpr std::string_view question_key(DoneQuestion question) {
    return question == DoneQuestion::kSolid ? "solid.ask" : "thick.ask";
}

// The key of the reason for a collapse.
[[nodiscard]] constexpr std::string_view failure_key(Warning collapse) {
    return collapse == Warning::kWet    ? "fail.why.wet"
           : collapse == Warning::kFast ? "fail.why.fast"
                                        : "fail.why";
}

// Returns whether the cue for the next move is visible now.
[[nodiscard]] bool shows_hint(const State& state, double now_s, const Rules& rules);

// Cuts the pot off the wheel as it is, and goes to the firing.
void finish_throwing(Turn& turn);

void draw_throw(Page& page);

}  // namespace onggi::visit
