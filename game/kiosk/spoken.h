// What is spoken where a visit stands: a key of the languages' tables, whose words are spoken as their third
// column says them. A recording of it is LANGUAGE/KEY.wav. Any thread; pure.
#pragma once

#include <string_view>

#include "game/kiosk/state.h"

namespace onggi::kiosk {

// Empty: nothing. It changes when there is something new to say, and with nothing else.
[[nodiscard]] std::string_view spoken_key(const State& state);

}  // namespace onggi::kiosk
