// The messages of the Haply Inverse service: JSON texts on a local WebSocket. Pure; an I/O thread. m, N, in
// the service's frame: x right, y away from the person, z up. Source: the service's public description,
// version 3.5. Never tried on hardware by this project; the direction of the axes is taken from that
// description.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/math/math.h"

namespace onggi::haptics::haply {

// Parses a JSON text by events (nlohmann/json's SAX interface) and reports each plain value with its path. No
// tree is built, since only a few numbers are needed. Pure; an I/O thread.

constexpr std::size_t kMaxMessageBytes = std::size_t{1} << 16U;
constexpr std::size_t kMaxJsonDepth = 32;  // objects and arrays inside each other

struct JsonValue {
    enum class Kind { kNumber, kText, kOther };  // kOther: true, false, null
    Kind kind = Kind::kOther;
    double number = 0.0;         // finite
    std::string_view text = {};  // escapes undone
};

// Calls `visit` for each number, text, true, false and null with its path: names and indices from the outside
// in, separated by dots, such as "inverse3.0.state.cursor_position.x". Error: bad input, one line with the
// byte or the exceeded limit; the caller must discard the values visited before it.
Result<void> walk_json(std::string_view text,
                       const std::function<void(std::string_view place, const JsonValue&)>& visit);

// The state of the first Inverse3 in a message.
struct InverseState {
    std::string device_id = {};
    dvec3 cursor_m{0.0};
};

// Empty for a message without an Inverse3, for example before one is plugged in. Error: bad input, if it is
// not JSON, the device's identity is invalid, or the position is incomplete or out of the device's reach.
[[nodiscard]] Result<std::optional<InverseState>> inverse_state(std::string_view message);

// A force in N on the cursor until the next message; the service answers each message with the state.
// `force_name`: "vector" since 3.5, "values" before. The first message also names this program.
[[nodiscard]] std::string force_message(std::string_view device_id, const dvec3& force_n,
                                        std::string_view force_name, bool is_first);
// Requests the state without any force.
[[nodiscard]] std::string probe_message(std::string_view device_id, bool is_first);

}  // namespace onggi::haptics::haply
