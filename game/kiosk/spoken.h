// Chooses the spoken line for the state of a visit. The line is a key of the language tables, whose third
// column is the spoken text; its recording is LANGUAGE/KEY.wav. Any thread; pure.
#pragma once

#include <string_view>

#include "game/kiosk/state.h"

namespace onggi::kiosk {

// Returns the key of the line, or an empty one for silence. It changes only when a new line is due.
[[nodiscard]] std::string_view spoken_key(const State& state);

}  // namespace onggi::kiosk
