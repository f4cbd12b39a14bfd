// What the Haply Inverse service says and is told: JSON texts on a WebSocket of the same machine. Pure; an
// I/O thread. m, N, in the service's frame: x right, y away from the person, z up. Source: the service's
// public description, version 3.5. Never tried on hardware by this project; which way the axes point is taken
// from that description.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/math/math.h"

namespace onggi::haptics::haply {

// What one message says of the first Inverse3 in it.
struct InverseState {
    std::string device_id = {};
    dvec3 cursor_m{0.0};
};

// None: a message without an Inverse3, as before one is plugged in. Bad input: no JSON; a device whose
// identity is none, a place that is not all there or is further away than any such device reaches.
[[nodiscard]] Result<std::optional<InverseState>> inverse_state(std::string_view message);

// Newtons on the cursor until the next message; each message is answered by one with the state. `force_name`:
// "vector" since 3.5, "values" before. The first one also says who we are.
[[nodiscard]] std::string force_message(std::string_view device_id, const dvec3& force_n,
                                        std::string_view force_name, bool is_first);
// Asks for the state without any force.
[[nodiscard]] std::string probe_message(std::string_view device_id, bool is_first);

}  // namespace onggi::haptics::haply
