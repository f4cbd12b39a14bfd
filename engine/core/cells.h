// A line of a table as its cells. Any thread.
#pragma once

#include <string_view>
#include <vector>

namespace onggi {

// What stands between separators, which no cell can hold; at least one cell, empty of an empty line. They
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
