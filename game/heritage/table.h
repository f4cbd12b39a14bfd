// A strict reader of comma-separated values: one line a row, fields in double quotes if they hold a comma or
// a quote (doubled). Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::heritage {

constexpr std::size_t kMaxTableBytes = std::size_t{1} << 20U;

struct TableRow {
    std::size_t line = 0;  // counted from 1
    std::vector<std::string> fields;
};

// The rows below a first line that must equal `header`; each has as many fields as the header. kBadInput
// naming the line: another header, too few or too many fields, a quote that does not close or stands inside a
// plain field, a control character or invalid UTF-8, a table without rows, an empty line, more than a
// megabyte. `name` stands for the text in messages.
Result<std::vector<TableRow>> parse_table(std::string_view text, std::string_view header,
                                          std::string_view name);

// An error that begins with "NAME:LINE: ", as every refusal of a table.
Error at_row(std::string_view name, std::size_t line, std::string_view what);

}  // namespace onggi::heritage
