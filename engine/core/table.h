// Tables that people edit: comma-separated values and their relatives, as editors and spreadsheets write
// them. Any thread but the haptic one; allocates.
//
// Accepted in any table: a byte order mark; commas, semicolons or tabs between cells, whichever the first
// line has most of; lines that end in LF or CRLF; empty lines, lines that begin with #, and empty cells at
// the end of a line, which may be missing; cells in double quotes, a quote within doubled (between tabs only
// where a quote is doubled, because plain text may begin and end with one).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi {

constexpr std::size_t kMaxTableBytes = std::size_t{1} << 20U;

struct TableRow {
    std::size_t line = 0;  // counted from 1
    std::vector<std::string> fields;
};

struct Table {
    std::vector<std::string> columns;  // the first line
    std::vector<TableRow> rows;        // each with as many fields as there are columns
};

// `header`: the columns that the table has to have ("id,name,source"); empty: any. Bad input, naming the
// line: another header, too many cells, a quote that does not close or stands inside a plain cell, a control
// character or invalid UTF-8, more than a megabyte. `name` stands for the text in messages.
Result<Table> parse_table(std::string_view text, std::string_view name, std::string_view header = {});

// An error that begins with "NAME:LINE: ", as every refusal of a table.
Error at_row(std::string_view name, std::size_t line, std::string_view what);

}  // namespace onggi
