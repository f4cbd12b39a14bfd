// How museums' pots are shown: their order on the shelf, names and glaze. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "game/heritage/target.h"

namespace onggi::heritage {

constexpr std::string_view kShelfHeader = "id,shown,name,museum,date,glaze";

struct ShelfRow {
    std::string id;            // of a target
    bool is_on_shelf = false;  // otherwise it is shown only beside a visitor's pot that resembles it
    // Keys of the tables of words; other words are shown as they are in every language. The museum may be
    // empty.
    std::string name;
    std::string museum;
    std::string date;
    int glaze = 0;  // see finish::glaze_at()
};

// The rows of a table, in its order. kBadInput naming the line: an error of parse_table, a pot that is not
// among the targets or comes twice, `shown` other than `shelf` or `compared`, an empty name or date, an
// unknown glaze.
Result<std::vector<ShelfRow>> parse_shelf(std::string_view table, std::string_view table_name,
                                          std::span<const Target> targets);

// The same from a folder's shelf.csv.
Result<std::vector<ShelfRow>> load_shelf(const std::filesystem::path& folder,
                                         std::span<const Target> targets);

// The row of a target; null if it has none.
[[nodiscard]] const ShelfRow* find_row(std::span<const ShelfRow> rows, std::string_view id);

}  // namespace onggi::heritage
