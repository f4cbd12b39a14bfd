// Walks through a JSON text and tells of each plain value where it stands: for messages of a service on the
// same machine, of which a few numbers are wanted. No tree is built: nlohmann/json reads and tells. Pure; an
// I/O thread.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::haptics::haply {

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

}  // namespace onggi::haptics::haply
