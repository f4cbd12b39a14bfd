#include "engine/core/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/cells.h"
#include "engine/core/quote.h"

namespace onggi {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool is_text(std::string_view field) {
    while (!field.empty()) {
        const std::size_t length = shown_character_length(field);
        if (length == 0) return false;
        field.remove_prefix(length);
    }
    return true;
}

class RowReader {
  public:
    RowReader(char delimiter, std::string_view name, std::size_t line)
        : delimiter_(delimiter),
          name_(name),
          line_(line) {}

    Result<std::vector<std::string>> read(std::string_view text) {
        std::vector<std::string> fields;
        std::string field;
        while (true) {
            if (!take_field(text, field)) return at_row(name_, line_, reason_);
            if (!is_text(field)) {
                return at_row(
                    name_, line_,
                    fmt::format("column {}: expected text, found {}", fields.size() + 1, in_quotes(field)));
            }
            fields.push_back(field);
            if (text.empty()) break;
            text.remove_prefix(1);
        }
        while (!fields.empty() && fields.back().empty())
            fields.pop_back();
        return fields;
    }

  private:
    // Takes one field off the front of `rest`. Returns false with a reason if the field is malformed.
    bool take_field(std::string_view& rest, std::string& field) {
        const std::string_view plain = rest.substr(0, rest.find(delimiter_));
        const bool between_tabs = delimiter_ == '\t';
        const bool is_quoted =
            rest.starts_with('"') && (!between_tabs || plain.find("\"\"") != std::string_view::npos);
        if (is_quoted) return take_quoted_field(rest, field);
        field = plain;
        rest.remove_prefix(plain.size());
        if (between_tabs || field.find('"') == std::string::npos) return true;
        reason_ = fmt::format("expected quotes around a whole field, found {}", in_quotes(field));
        return false;
    }

    bool take_quoted_field(std::string_view& rest, std::string& field) {
        field.clear();
        rest.remove_prefix(1);
        while (true) {
            const std::size_t quote = rest.find('"');
            if (quote == std::string_view::npos) {
                reason_ = "expected a closing quote, found the end of the line";
                return false;
            }
            field += rest.substr(0, quote);
            rest.remove_prefix(quote + 1);
            if (!rest.starts_with('"')) break;
            field += '"';
            rest.remove_prefix(1);
        }
        if (rest.empty() || rest.front() == delimiter_) return true;
        reason_ = fmt::format("expected {} after the closing quote, found {}", in_quotes({&delimiter_, 1}),
                              in_quotes(rest));
        return false;
    }

    char delimiter_;
    std::string_view name_;
    std::size_t line_;
    std::string reason_;
};

char delimiter_of(std::string_view header) {
    const auto count = [&](char sign) { return std::count(header.begin(), header.end(), sign); };
    constexpr std::string_view kDelimiters = ",;\t";
    return *std::max_element(kDelimiters.begin(), kDelimiters.end(),
                             [&](char a, char b) { return count(a) < count(b); });
}

std::string joined(const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells)
        text += (text.empty() ? "" : ",") + cell;
    return text;
}

}  // namespace

Error at_row(std::string_view name, std::size_t line, std::string_view what) {
    return bad_input(fmt::format("{}:{}: {}", shown_path(name), line, what));
}

Result<Table> parse_table(std::string_view text, std::string_view name, std::string_view header) {
    if (text.size() > kMaxTableBytes)
        return at_row(name, 1, fmt::format("expected a table of at most {} bytes", kMaxTableBytes));
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    const char delimiter = delimiter_of(text.substr(0, text.find('\n')));
    Table table;
    for (std::size_t line = 1; line == 1 || !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view row = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (row.ends_with('\r')) row.remove_suffix(1);
        if (line > 1 && row.starts_with('#')) continue;
        auto fields = RowReader(delimiter, name, line).read(row);
        if (!fields) return fields.error();
        if (line == 1) {
            table.columns = std::move(*fields);
            if (const std::string found = joined(table.columns); !header.empty() && found != header)
                return at_row(name, 1,
                              fmt::format("expected the header {}, found {}", header, in_quotes(found)));
            // A cell may hold the commas of the header: all of it, where another sign is more frequent.
            const auto wanted = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1;
            if (!header.empty() && table.columns.size() != wanted) {
                return at_row(name, 1,
                              fmt::format("expected {} columns, found {} between {}", wanted,
                                          table.columns.size(), in_quotes({&delimiter, 1})));
            }
            continue;
        }
        if (fields->empty()) continue;
        if (fields->size() > table.columns.size()) {
            return at_row(name, line,
                          fmt::format("expected {} columns, found {}", table.columns.size(), fields->size()));
        }
        fields->resize(table.columns.size());
        table.rows.push_back({line, std::move(*fields)});
    }
    return table;
}

}  // namespace onggi
