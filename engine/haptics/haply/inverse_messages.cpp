#include "engine/haptics/haply/inverse_messages.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

namespace onggi::haptics::haply {
namespace {

// The callbacks of nlohmann/json's parser, with its names. Each returns whether to continue.
class Walker {
  public:
    using Json = nlohmann::json;

    Walker(std::string_view text, const std::function<void(std::string_view, const JsonValue&)>& visit)
        : text_(text),
          visit_(visit) {}

    bool null() { return value({}); }
    bool boolean(bool) { return value({}); }
    bool number_integer(Json::number_integer_t number) { return number_float(static_cast<double>(number)); }
    bool number_unsigned(Json::number_unsigned_t number) { return number_float(static_cast<double>(number)); }
    bool number_float(double number, std::string_view = {}) {
        return value({.kind = JsonValue::Kind::kNumber, .number = number});
    }
    bool string(std::string_view text) { return value({.kind = JsonValue::Kind::kText, .text = text}); }
    bool binary(const Json::binary_t&) { return false; }  // JSON text has no binary values

    bool start_object(std::size_t) { return open(false); }
    bool start_array(std::size_t) { return open(true); }
    bool key(std::string_view name) { return go_to(name); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    // `read`: the number of bytes read, including the offending one; one more than the size if the text
    // ended.
    bool parse_error(std::size_t read, const std::string&, const Json::exception& problem) {
        constexpr int kNumberOverflow = 406;
        const std::size_t at = read > 0 ? read - 1 : 0;
        const std::string found = at >= text_.size()
                                      ? "the end"
                                      : fmt::format("byte {:#04x}", static_cast<unsigned char>(text_[at]));
        error_ =
            bad_input(fmt::format("byte {}: expected {}, found {}", at,
                                  problem.id == kNumberOverflow ? "a number within range" : "JSON", found));
        return false;
    }

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    struct Level {
        std::size_t name_length = 0;  // of the object's or array's own name in place_
        std::size_t count = 0;
        bool is_array = false;
    };

    bool go_to(std::string_view name) {
        place_.resize(levels_.back().name_length);
        if (!place_.empty()) place_ += '.';
        place_ += name;
        return true;
    }
    void count_on() {
        if (!levels_.empty() && levels_.back().is_array) go_to(fmt::format("{}", levels_.back().count++));
    }
    bool value(const JsonValue& value) {
        count_on();
        visit_(place_, value);
        return true;
    }
    bool open(bool is_array) {
        if (levels_.size() >= kMaxJsonDepth) {
            error_ =
                bad_input(fmt::format("expected values at most {} deep, found one deeper", kMaxJsonDepth));
            return false;
        }
        count_on();
        levels_.push_back({.name_length = place_.size(), .is_array = is_array});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }

    std::string_view text_;
    const std::function<void(std::string_view, const JsonValue&)>& visit_;
    std::string place_;
    std::vector<Level> levels_;
    std::optional<Error> error_;
};

}  // namespace

Result<void> walk_json(std::string_view text,
                       const std::function<void(std::string_view place, const JsonValue&)>& visit) {
    if (text.size() > kMaxMessageBytes)
        return bad_input(fmt::format("expected at most {} bytes, found {}", kMaxMessageBytes, text.size()));
    Walker walker(text, visit);
    if (!nlohmann::json::sax_parse(text.begin(), text.end(), &walker)) return *walker.error();
    return {};
}

namespace {

constexpr std::string_view kDevice = "inverse3.0.";
constexpr std::size_t kLongestIdentity = 32;
constexpr double kFurthestM = 1.0;

// The identity is copied into messages without escaping.
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
    const dvec3 n = force_n + 0.0;  // avoids -0
    return message_with(device_id,
                        fmt::format(R"("set_cursor_force":{{"{}":{{"x":{:.4f},"y":{:.4f},"z":{:.4f}}}}})",
                                    force_name, n.x, n.y, n.z),
                        is_first);
}

std::string probe_message(std::string_view device_id, bool is_first) {
    return message_with(device_id, R"("probe_position":{})", is_first);
}

}  // namespace onggi::haptics::haply
