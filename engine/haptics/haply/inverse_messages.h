// What the Haply Inverse service says and is told: JSON texts on a WebSocket of the same machine. Pure; an
// I/O thread. m, N, in the service's frame: x right, y away from the person, z up. Source: the service's
// public description, version 3.5. Never tried on hardware by this project; which way the axes point is taken
// from that description.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/math/math.h"

namespace onggi::haptics::haply {

// Walks through a JSON text and tells of each plain value where it stands: for messages of a service on the
// same machine, of which a few numbers are wanted. No tree is built: nlohmann/json reads and tells. Pure; an
// I/O thread.

constexpr std::size_t kMaxMessageBytes = std::size_t{1} << 16U;
constexpr std::size_t kMaxJsonDepth = 32;  // objects and arrays inside each other

struct JsonValue {
    enum class Kind { kNumber, kText, kOther };  // kOther: true, false, null
    Kind kind = Kind::kOther;
    double number = 0.0;         // finite
    std::string_view text = {};  // escapes undone
};

// `visit` gets each number, text, true, false and null with its place: names and counts from the outside in,
// with dots between them, as in "inverse3.0.state.cursor_position.x". Error: bad input, one line with the
// byte, or with what is too much; what was visited before it counts for nothing.
Result<void> walk_json(std::string_view text,
                       const std::function<void(std::string_view place, const JsonValue&)>& visit);

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
