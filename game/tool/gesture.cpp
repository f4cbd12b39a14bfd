#include "game/tool/gesture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/core/number_in.h"
#include "engine/core/quote.h"

namespace onggi::tool {
namespace {

using haptics::kWorkspaceMm;
using Complaint = std::optional<std::string>;

// The optional columns of a gesture table, right of tool_radius_mm. A column with any other name is ignored.
enum class GestureColumn {
    kTool,        // one of kToolWords
    kSide,        // one of kSideWords: the side of the wall that an approaching hand aims at
    kWater,       // 0 to 1: wetness of the hand or its tool
    kWheelSpeed,  // rev/min set by the pedal while the button is 1
    kAssistGap,   // mm between the hand and an assisting one held opposite; 0: no assist
    kShaft,       // mm, radius of the shaft that carries an inside tool from above
    kWire,        // one of kWireWords
    kWireHeight,  // mm
    kSecondX,     // mm; empty in a row without a second hand
    kSecondY,
    kSecondZ,
    kSecondRadius,  // mm; default: the first hand's radius
    kSecondTool,    // as kTool
    kGuided,        // 0 or 1: the position is a finger's on the screen, which simulated hands follow
    kPressing,      // 0 or 1: 0 means that no hand is in the clay
    kNotOurs,
};

// Whether the column is one of the second hand's coordinates.
constexpr bool is_place_of_second(GestureColumn column) {
    return column == GestureColumn::kSecondX || column == GestureColumn::kSecondY ||
           column == GestureColumn::kSecondZ;
}

Complaint take_number(std::string_view field, double least, double most, double& number) {
    const auto found = number_in<double>(field);
    if (!found || !std::isfinite(*found)) return "a finite number";
    if (*found < least || *found > most) return fmt::format("{} to {}", least, most);
    number = *found;
    return std::nullopt;
}

// `words` is indexed by the enum's values.
template <typename Enum>
Complaint take_word(std::string_view field, std::span<const std::string_view> words, Enum& value) {
    const auto found = std::find(words.begin(), words.end(), field);
    if (found == words.end()) return fmt::format("{}", fmt::join(words, ", "));
    value = static_cast<Enum>(found - words.begin());
    return std::nullopt;
}

Complaint take_bit(std::string_view field, bool& bit) {
    if (field != "0" && field != "1") return "0 or 1";
    bit = field == "1";
    return std::nullopt;
}

// The columns' names in the order of GestureColumn, without kNotOurs.
constexpr std::array<std::string_view, 15> kNames{
    "tool",       "side",      "water",      "wheel_rev_min", "assist_gap_mm", "shaft_mm",
    "wire",       "wire_y_mm", "hand2_x_mm", "hand2_y_mm",    "hand2_z_mm",    "hand2_radius_mm",
    "hand2_tool", "guided",    "pressing"};

Complaint take_coordinate(std::string_view field, double& number, bool& present) {
    auto complaint = take_number(field, -kWorkspaceMm, kWorkspaceMm, number);
    present = !complaint;
    return complaint;
}

GestureColumn gesture_column(std::string_view name) {
    return static_cast<GestureColumn>(std::find(kNames.begin(), kNames.end(), name) - kNames.begin());
}

// Parses one field of a row into `tool`. An empty field keeps the default. If the field is invalid, returns
// what was expected.
Complaint take_field(GestureColumn column, std::string_view field, ToolState& tool) {
    if (field.empty()) return std::nullopt;
    SecondHand& second = tool.second;
    switch (column) {
        case GestureColumn::kTool:
            return take_word(field, kToolWords, tool.tool);
        case GestureColumn::kSide:
            return take_word(field, kSideWords, tool.side);
        case GestureColumn::kWater:
            return take_number(field, 0.0, 1.0, tool.water);
        case GestureColumn::kWheelSpeed:
            return take_number(field, 0.0, kMaxWheelSpeedRevMin, tool.wheel_speed_rev_min);
        case GestureColumn::kAssistGap:
            return take_number(field, 0.0, kMaxAssistGapMm, tool.assist_gap_mm);
        case GestureColumn::kShaft:
            return take_number(field, 0.0, kMaxToolRadiusMm, tool.shaft_mm);
        case GestureColumn::kWire:
            return take_word(field, kWireWords, tool.wire);
        case GestureColumn::kWireHeight:
            return take_number(field, 0.0, kWorkspaceMm, tool.wire_height_mm);
        case GestureColumn::kSecondX:
            return take_coordinate(field, second.position_mm.x, second.present);
        case GestureColumn::kSecondY:
            return take_number(field, -kWorkspaceMm, kWorkspaceMm, second.position_mm.y);
        case GestureColumn::kSecondZ:
            return take_number(field, -kWorkspaceMm, kWorkspaceMm, second.position_mm.z);
        case GestureColumn::kSecondRadius:
            return take_number(field, kMinToolRadiusMm, kMaxToolRadiusMm, second.radius_mm);
        case GestureColumn::kSecondTool:
            return take_word(field, kToolWords, second.tool);
        case GestureColumn::kGuided:
            return take_bit(field, tool.guided);
        case GestureColumn::kPressing:
            return take_bit(field, tool.pressing);
        case GestureColumn::kNotOurs:
            break;
    }
    return std::nullopt;
}

// Returns the name of a required column that is missing: the wire requires its height, a second hand all its
// coordinates.
std::optional<std::string_view> missing_column(const std::vector<GestureColumn>& columns) {
    using enum GestureColumn;
    const auto name_of = [](GestureColumn column) { return kNames[static_cast<std::size_t>(column)]; };
    const auto has = [&](GestureColumn column) {
        return std::find(columns.begin(), columns.end(), column) != columns.end();
    };
    if (has(kWire) && !has(kWireHeight)) return name_of(kWireHeight);
    constexpr std::array kSecond{kSecondX, kSecondY, kSecondZ, kSecondRadius, kSecondTool};
    if (std::none_of(kSecond.begin(), kSecond.end(), has)) return std::nullopt;
    for (const GestureColumn column : std::span(kSecond).first(3)) {
        if (!has(column)) return name_of(column);
    }
    return std::nullopt;
}

constexpr std::array<std::string_view, 6> kColumns{"t_s", "x_mm", "y_mm", "z_mm", "button", "tool_radius_mm"};
enum Column : std::size_t { kTime, kX, kY, kZ, kButton, kRadius };
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

struct Line {
    std::size_t number = 0;  // from 1
    std::string_view text;   // without its end
};

// Reads line by line; searches for a line's end no further than the longest allowed line.
class LineReader {
  public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool at_end() const { return rest_.empty(); }
    // Precondition: !at_end(). Empty if the line is too long.
    std::optional<Line> next() {
        ++number_;
        const std::string_view window = rest_.substr(0, kMaxGestureLineBytes + 1);
        const std::size_t end = window.find('\n');
        if (end == std::string_view::npos && window.size() > kMaxGestureLineBytes) return std::nullopt;
        Line line{number_, window.substr(0, end)};
        rest_.remove_prefix(std::min(line.text.size() + 1, rest_.size()));
        if (line.text.ends_with('\r')) line.text.remove_suffix(1);
        return line;
    }
    [[nodiscard]] std::size_t number() const { return number_; }

  private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

// Reads the fields of a line one by one.
class FieldReader {
  public:
    explicit FieldReader(std::string_view line) : rest_(line) {}

    std::optional<std::string_view> next() {
        if (!rest_) return std::nullopt;
        const std::size_t comma = rest_->find(',');
        const std::string_view field = rest_->substr(0, comma);
        if (comma == std::string_view::npos) {
            rest_.reset();
        } else {
            rest_->remove_prefix(comma + 1);
        }
        return field;
    }

  private:
    std::optional<std::string_view> rest_;
};

Error at_line(std::string_view name, std::size_t line, std::string_view what) {
    return bad_input(fmt::format("{}:{}: {}", shown_path(name), line, what));
}

Error line_too_long(std::string_view name, std::size_t line) {
    return at_line(
        name, line,
        fmt::format("expected a line of at most {} bytes, found a longer one", kMaxGestureLineBytes));
}

// The optional columns, to the right of the required ones.
struct Header {
    std::vector<std::string> extra;
    std::vector<GestureColumn> columns;  // the meaning of each column
};

Result<Header> parse_header(const Line& line, std::string_view name) {
    if (line.text.starts_with(kByteOrderMark)) {
        return at_line(
            name, line.number,
            fmt::format("expected the header {}, found a byte order mark before it", kGestureHeader));
    }
    FieldReader fields(line.text);
    for (const std::string_view column : kColumns) {
        const auto field = fields.next();
        if (field && *field == column) continue;
        return at_line(name, line.number,
                       fmt::format("expected the header {}: column {} is missing, found {}", kGestureHeader,
                                   column, field ? in_quotes(*field) : "the end of the line"));
    }
    Header header;
    std::vector<std::string>& extra = header.extra;
    while (const auto field = fields.next()) {
        const bool known = std::find(kColumns.begin(), kColumns.end(), *field) != kColumns.end() ||
                           std::find(extra.begin(), extra.end(), *field) != extra.end();
        if (field->empty() || known) {
            return at_line(name, line.number,
                           fmt::format("column {}: expected a name of its own, found {}",
                                       kColumns.size() + extra.size() + 1, in_quotes(*field)));
        }
        extra.emplace_back(*field);
        header.columns.push_back(gesture_column(*field));
    }
    if (const auto missing = missing_column(header.columns)) {
        return at_line(name, line.number,
                       fmt::format("expected a column {} beside the others, found none", *missing));
    }
    return header;
}

// Parses the fields of one row; keeps the first error.
class RowParser {
  public:
    RowParser(std::string_view name, const Line& line) : name_(name), line_(line), fields_(line.text) {}

    double number(Column column, double least, double most) {
        const auto field = value(column);
        if (!field) return 0.0;
        double number = 0.0;
        const auto [end, error] = std::from_chars(field->data(), field->data() + field->size(), number);
        if (error == std::errc::invalid_argument || end != field->data() + field->size()) {
            fail(column, "a number", *field);
        } else if (error != std::errc{} || !std::isfinite(number)) {
            fail(column, "a finite number", *field);
        } else if (number < least || number > most) {
            fail(column, fmt::format("{} to {}", least, most), *field);
        }
        return number;
    }

    bool button() {
        const auto field = value(kButton);
        if (field && *field != "0" && *field != "1") fail(kButton, "0 or 1", *field);
        return field && *field == "1";
    }

    void time_after(std::optional<double> previous_s, double t_s) {
        if (!previous_s && t_s != 0.0) fail(kTime, "0 in the first row", fmt::format("{}", t_s));
        if (previous_s && !(t_s > *previous_s)) {
            fail(kTime, fmt::format("a time after {}", *previous_s), fmt::format("{}", t_s));
        }
    }

    void extra(const Header& header, ToolState& tool) {
        tool.second.radius_mm = tool.radius_mm;
        std::size_t places = 0;  // how many of the second hand's three coordinates are filled in
        std::string_view empty_place;
        for (std::size_t i = 0; i < header.columns.size() && !error_; ++i) {
            const auto field = fields_.next();
            if (!field) {
                missing(header.extra[i]);
            } else if (const auto expected = take_field(header.columns[i], *field, tool)) {
                fail(header.extra[i], *expected, *field);
            } else if (is_place_of_second(header.columns[i])) {
                if (field->empty()) empty_place = header.extra[i];
                places += field->empty() ? 0U : 1U;
            }
        }
        if (places != 0 && !empty_place.empty())
            fail(empty_place, "a number beside the other two coordinates", "");
        // Empty coordinates: this row has no second hand.
        if (!tool.second.present) tool.second = {};
        if (!error_ && fields_.next()) {
            error_ = at_line(
                name_, line_.number,
                fmt::format("expected {} columns, found more", kColumns.size() + header.columns.size()));
        }
    }

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    std::optional<std::string_view> value(Column column) {
        if (error_) return std::nullopt;
        const auto field = fields_.next();
        if (!field) missing(kColumns[column]);
        return field;
    }
    void fail(Column column, std::string_view expected, std::string_view found) {
        fail(kColumns[column], expected, found);
    }
    void fail(std::string_view column, std::string_view expected, std::string_view found) {
        if (error_) return;
        error_ = at_line(name_, line_.number,
                         fmt::format("{}: expected {}, found {}", column, expected, in_quotes(found)));
    }
    void missing(std::string_view column) {
        error_ = at_line(name_, line_.number,
                         fmt::format("{}: expected a value, found the end of the line", column));
    }

    std::string_view name_;
    Line line_;
    FieldReader fields_;
    std::optional<Error> error_;
};

Result<Header> read_header(LineReader& lines, std::string_view name) {
    if (lines.at_end()) {
        return at_line(name, 1, fmt::format("expected the header {}, found an empty file", kGestureHeader));
    }
    const auto line = lines.next();
    if (!line) return line_too_long(name, lines.number());
    return parse_header(*line, name);
}

}  // namespace

Result<Gesture> parse_gesture(std::string_view text, std::string_view name) {
    LineReader lines(text);
    auto header = read_header(lines, name);
    if (!header) return header.error();

    Gesture gesture;
    const Header columns = std::move(header).value();
    std::optional<double> previous_s;
    while (!lines.at_end()) {
        const auto line = lines.next();
        if (!line) return line_too_long(name, lines.number());
        RowParser parser(name, *line);
        Gesture::Row row;
        row.t_s = parser.number(kTime, 0.0, kMaxGestureSeconds);
        parser.time_after(previous_s, row.t_s);
        row.tool.position_mm.x = parser.number(kX, -kWorkspaceMm, kWorkspaceMm);
        row.tool.position_mm.y = parser.number(kY, -kWorkspaceMm, kWorkspaceMm);
        row.tool.position_mm.z = parser.number(kZ, -kWorkspaceMm, kWorkspaceMm);
        row.tool.wheel_button = parser.button();
        row.tool.radius_mm = parser.number(kRadius, kMinToolRadiusMm, kMaxToolRadiusMm);
        parser.extra(columns, row.tool);
        if (parser.error()) return *parser.error();
        previous_s = row.t_s;
        gesture.rows_.push_back(row);
    }
    if (gesture.rows_.empty()) {
        return at_line(name, lines.number() + 1, "expected at least one row after the header, found none");
    }
    return gesture;
}

Result<void> check_gesture_start(std::string_view start, std::string_view name) {
    LineReader lines(start);
    if (const auto header = read_header(lines, name); !header) return header.error();
    return {};
}

ToolState Gesture::at(double t_s) const noexcept {
    const auto after = std::upper_bound(rows_.begin(), rows_.end(), t_s,
                                        [](double t, const Row& row) { return t < row.t_s; });
    if (after == rows_.begin()) return rows_.front().tool;
    const Row& before = *(after - 1);
    ToolState tool = before.tool;
    if (after == rows_.end()) return tool;
    const double part = (t_s - before.t_s) / (after->t_s - before.t_s);
    tool.position_mm += (after->tool.position_mm - before.tool.position_mm) * part;
    if (tool.second.present && after->tool.second.present) {
        tool.second.position_mm += (after->tool.second.position_mm - before.tool.second.position_mm) * part;
    }
    return tool;
}

std::uint64_t Gesture::tick_count(double rate_hz) const noexcept {
    // The slack gives a last row at 0.3 s its tick at 1000 Hz, although the double 0.3 is less than three
    // tenths.
    return static_cast<std::uint64_t>(std::floor(duration_s() * rate_hz + 1e-9)) + 1;
}

}  // namespace onggi::tool
