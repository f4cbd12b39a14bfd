// Splits a line of a table into cells. Any thread.
#pragma once

#include <string_view>
#include <vector>

namespace onggi {

// Returns the cells between separators, which have no escape; an empty line has one empty cell. The cells
// point into `line`.
[[nodiscard]] inline std::vector<std::string_view> cells_of(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t end = line.find(separator);
        cells.push_back(line.substr(0, end));
        if (end == std::string_view::npos) return cells;
        line.remove_prefix(end + 1);
    }
}

}  // namespace onggi
