#include "game/wheel/json_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace onggi::wheel {
namespace {

const nlohmann::json& nothing() {
    static const nlohmann::json value;
    return value;
}

// What a message shows of a value: its kind, and itself where that is short.
std::string shown(const nlohmann::json& value) {
    if (value.is_null()) return "nothing";
    if (value.is_number() || value.is_boolean()) return value.dump();
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    return std::string(value.is_object() ? "an object" : "a text");
}

std::string below(const std::string& place, const char* name) {
    return place.empty() ? name : place + "." + name;
}

const nlohmann::json& member(const nlohmann::json& in, const char* name) {
    if (!in.is_object()) return nothing();
    const auto found = in.find(name);
    return found == in.end() ? nothing() : *found;
}

}  // namespace

nlohmann::json JsonFields::parse(std::string_view text) {
    constexpr bool kThrow = false;
    nlohmann::json value = nlohmann::json::parse(text, nullptr, kThrow);
    if (value.is_discarded() || !value.is_object()) {
        complain("", "a JSON object", value.is_discarded() ? "no JSON" : shown(value));
        return {};
    }
    return value;
}

const nlohmann::json& JsonFields::object(const nlohmann::json& in, const std::string& place,
                                         const char* name) {
    const nlohmann::json& value = member(in, name);
    if (!value.is_object()) complain(below(place, name), "an object", shown(value));
    return value.is_object() ? value : nothing();
}

const nlohmann::json& JsonFields::array(const nlohmann::json& in, const std::string& place, const char* name,
                                        std::size_t size) {
    const nlohmann::json& value = member(in, name);
    const bool fits = value.is_array() && value.size() == size;
    if (!fits) complain(below(place, name), fmt::format("an array of {}", size), shown(value));
    return fits ? value : nothing();
}

double JsonFields::number_itself(const nlohmann::json& value, const std::string& place, Bounds bounds) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (number >= bounds.least && number <= bounds.most) return number;
    complain(place, fmt::format("a number from {} to {}", bounds.least, bounds.most), shown(value));
    return 0.0;
}

double JsonFields::number(const nlohmann::json& in, const std::string& place, const char* name,
                          Bounds bounds) {
    return number_itself(member(in, name), below(place, name), bounds);
}

int JsonFields::whole_number(const nlohmann::json& value, const std::string& place, Bounds bounds) {
    const double number = number_itself(value, place, bounds);
    if (number != std::floor(number)) complain(place, "a whole number", shown(value));
    return static_cast<int>(number);
}

vec3 JsonFields::triple(const nlohmann::json& value, const std::string& place, Bounds bounds) {
    if (!value.is_array() || value.size() != 3) {
        complain(place, "three numbers", shown(value));
        return vec3(0.0F);
    }
    vec3 numbers(0.0F);
    for (int axis = 0; axis < 3; ++axis)
        numbers[axis] =
            static_cast<float>(number_itself(value[static_cast<std::size_t>(axis)], place, bounds));
    return numbers;
}

vec3 JsonFields::triple(const nlohmann::json& in, const std::string& place, const char* name, Bounds bounds) {
    return triple(member(in, name), below(place, name), bounds);
}

void JsonFields::complain(const std::string& place, const std::string& expected, const std::string& found) {
    if (error_) return;
    error_ = bad_input(fmt::format("{}: {}{}expected {}, found {}", file_, place, place.empty() ? "" : ": ",
                                   expected, found));
}

}  // namespace onggi::wheel
