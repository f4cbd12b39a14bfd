// The meaning of tool and command numbers on this wheel, and their words in a gesture's table. The engine
// passes them on without knowing them. The numbers are in files: never renumber.
#pragma once

#include <array>
#include <string_view>

#include "engine/haptics/gesture_columns.h"
#include "engine/haptics/tool_state.h"

namespace onggi::haptic {

constexpr haptics::ToolKind kRib{1};
constexpr haptics::ToolKind kSponge{2};
constexpr haptics::ToolKind kTrimmer{3};
constexpr std::array<std::string_view, haptics::kToolKinds> kToolWords{"hand", "rib", "sponge", "trimmer"};

// Cuts of the wire; one pull cuts once.
constexpr haptics::WorkCommand kCutRim{1};
constexpr haptics::WorkCommand kCutOff{2};
constexpr std::array<std::string_view, haptics::kWorkCommands> kWireWords{"none", "rim", "off"};

constexpr haptics::GestureWords kGestureWords{
    .tools = kToolWords, .commands = kWireWords, .command = "wire", .command_height = "wire_y_mm"};

}  // namespace onggi::haptic
