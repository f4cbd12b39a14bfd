#include "game/heritage/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/quote.h"

namespace onggi::heritage {
namespace {

// Takes one field off the front of `rest`. Returns false with a reason if the field is malformed.
bool take_field(std::string_view& rest, std::string& field, std::string& reason) {
    field.clear();
    if (!rest.starts_with('"')) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        field = rest.substr(0, end);
        rest.remove_prefix(end);
        if (field.find('"') == std::string::npos) return true;
        reason = fmt::format("expected quotes around a whole field, found {}", in_quotes(field));
        return false;
    }
    rest.remove_prefix(1);
    while (true) {
        const std::size_t quote = rest.find('"');
        if (quote == std::string_view::npos) {
            reason = "expected a closing quote, found the end of the line";
            return false;
        }
        field += rest.substr(0, quote);
        rest.remove_prefix(quote + 1);
        if (!rest.starts_with('"')) break;
        field += '"';
        rest.remove_prefix(1);
    }
    if (rest.empty() || rest.starts_with(',')) return true;
    reason = fmt::format("expected a comma after the closing quote, found {}", in_quotes(rest));
    return false;
}

bool is_text(std::string_view field) {
    while (!field.empty()) {
        const std::size_t length = shown_character_length(field);
        if (length == 0) return false;
        field.remove_prefix(length);
    }
    return true;
}

Result<std::vector<std::string>> parse_row(std::string_view text, std::string_view name, std::size_t line) {
    std::vector<std::string> fields;
    std::string field;
    std::string reason;
    while (true) {
        if (!take_field(text, field, reason)) return at_row(name, line, reason);
        if (!is_text(field)) {
            return at_row(
                name, line,
                fmt::format("column {}: expected text, found {}", fields.size() + 1, in_quotes(field)));
        }
        fields.push_back(field);
        if (text.empty()) return fields;
        text.remove_prefix(1);
    }
}

}  // namespace

Error at_row(std::string_view name, std::size_t line, std::string_view what) {
    return bad_input(fmt::format("{}:{}: {}", shown_path(name), line, what));
}

Result<std::vector<TableRow>> parse_table(std::string_view text, std::string_view header,
                                          std::string_view name) {
    if (text.size() > kMaxTableBytes)
        return at_row(name, 1, fmt::format("expected a table of at most {} bytes", kMaxTableBytes));
    const auto columns = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1;
    std::vector<TableRow> rows;
    for (std::size_t line = 1; line == 1 || !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view row = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (row.ends_with('\r')) row.remove_suffix(1);
        if (line == 1) {
            if (row != header)
                return at_row(name, 1,
                              fmt::format("expected the header {}, found {}", header, in_quotes(row)));
            continue;
        }
        auto fields = parse_row(row, name, line);
        if (!fields) return fields.error();
        if (fields->size() != columns) {
            return at_row(name, line, fmt::format("expected {} columns, found {}", columns, fields->size()));
        }
        rows.push_back({line, std::move(fields).value()});
    }
    if (rows.empty()) return at_row(name, 2, "expected at least one row, found none");
    return rows;
}

}  // namespace onggi::heritage
