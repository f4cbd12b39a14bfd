// Converts the start of a recording to bytes and back: parameters and state of the haptic loop, without the
// device's safety. The session file stores them as opaque bytes (game/record). Any thread but the haptic one;
// allocates.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "game/haptic/tick.h"
#include "game/record/session_format.h"

namespace onggi::haptic {

struct Start {
    HapticState state;
    HapticParameters parameters;  // with default safety limits, which do not affect the clay
};

// The same start gives the same bytes everywhere. The tick rate is not included: the session's header has it.
[[nodiscard]] std::vector<std::byte> start_state_bytes(const HapticState& state,
                                                       const HapticParameters& parameters);

// The header of a session with that start.
[[nodiscard]] record::SessionHeader session_header(const Start& start);

// Reads a start from those bytes and that rate. Bad input: a wrong size, parameters that clay::check()
// refuses, a tool outside its limits, a wheel direction that is not a unit vector, a clay that its own reader
// refuses.
[[nodiscard]] Result<Start> start_from_bytes(std::span<const std::byte> bytes, double rate_hz);

}  // namespace onggi::haptic
