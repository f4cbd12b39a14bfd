#include "engine/haptics/haply/json_walk.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace onggi::haptics::haply {
namespace {

// What the library's parser tells, as it reads: the names are its own. Each answer says whether to go on.
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
    bool binary(const Json::binary_t&) { return false; }  // text has none

    bool start_object(std::size_t) { return open(false); }
    bool start_array(std::size_t) { return open(true); }
    bool key(std::string_view name) { return go_to(name); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    // `read`: how many bytes, the offending one included; one more than there are where the text ends.
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
        std::size_t name_length = 0;  // of the object or array itself, as it is written in place_
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

}  // namespace onggi::haptics::haply
