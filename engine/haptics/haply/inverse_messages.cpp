#include "engine/haptics/haply/inverse_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "engine/haptics/haply/json_walk.h"

namespace onggi::haptics::haply {
namespace {

constexpr std::string_view kDevice = "inverse3.0.";
constexpr std::size_t kLongestIdentity = 32;
constexpr double kFurthestM = 1.0;

// It goes back into messages as it came.
bool is_identity(std::string_view text) {
    return !text.empty() && text.size() <= kLongestIdentity &&
           std::all_of(text.begin(), text.end(), [](unsigned char letter) {
               return std::isalnum(letter) != 0 || letter == '-' || letter == '_';
           });
}

std::string message_with(std::string_view device_id, std::string_view command, bool is_first) {
    return fmt::format(R"({{{}"inverse3":[{{"device_id":"{}","commands":{{{}}}}}]}})",
                       is_first ? R"("session":{"configure":{"profile":{"name":"onggi"}}},)" : "", device_id,
                       command);
}

}  // namespace

Result<std::optional<InverseState>> inverse_state(std::string_view message) {
    InverseState state;
    bool has_device = false;
    std::array<bool, 3> has{};
    const auto walked = walk_json(message, [&](std::string_view place, const JsonValue& value) {
        if (!place.starts_with(kDevice)) return;
        has_device = true;
        place.remove_prefix(kDevice.size());
        if (place == "device_id" && value.kind == JsonValue::Kind::kText) state.device_id = value.text;
        constexpr std::string_view kCursor = "state.cursor_position.";
        if (!place.starts_with(kCursor) || place.size() != kCursor.size() + 1 ||
            value.kind != JsonValue::Kind::kNumber)
            return;
        const int axis = place.back() - 'x';
        if (axis < 0 || axis > 2) return;
        state.cursor_m[axis] = value.number;
        has[static_cast<std::size_t>(axis)] = true;
    });
    if (!walked) return walked.error();
    if (!has_device) return std::optional<InverseState>();
    if (!is_identity(state.device_id))
        return bad_input("inverse3.0.device_id: expected up to 32 letters and digits, found something else");
    if (!has[0] || !has[1] || !has[2])
        return bad_input("inverse3.0.state.cursor_position: expected the numbers x, y and z, found fewer");
    const double furthest =
        std::max({std::abs(state.cursor_m.x), std::abs(state.cursor_m.y), std::abs(state.cursor_m.z)});
    if (furthest > kFurthestM)
        return bad_input(
            fmt::format("inverse3.0.state.cursor_position: expected a place within {} m, found {} m",
                        kFurthestM, furthest));
    return std::optional<InverseState>(std::move(state));
}

std::string force_message(std::string_view device_id, const dvec3& force_n, std::string_view force_name,
                          bool is_first) {
    const dvec3 n = force_n + 0.0;  // no minus before a zero
    return message_with(device_id,
                        fmt::format(R"("set_cursor_force":{{"{}":{{"x":{:.4f},"y":{:.4f},"z":{:.4f}}}}})",
                                    force_name, n.x, n.y, n.z),
                        is_first);
}

std::string probe_message(std::string_view device_id, bool is_first) {
    return message_with(device_id, R"("probe_position":{})", is_first);
}

}  // namespace onggi::haptics::haply
