#include "game/heritage/shelf.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/core/quote.h"
#include "engine/core/table.h"
#include "engine/files/read_file.h"
#include "game/finish/glaze.h"

namespace onggi::heritage {
namespace {

std::optional<int> glaze_of(std::string_view id) {
    for (int place = 0; place <= finish::kIdoGlaze; ++place)
        if (finish::glaze_at(place).id == id) return place;
    return std::nullopt;
}

std::string glaze_ids() {
    std::string ids;
    for (int place = 0; place <= finish::kIdoGlaze; ++place)
        ids += fmt::format("{}{}", place == 0 ? "" : ", ", finish::glaze_at(place).id);
    return ids;
}

}  // namespace

Result<std::vector<ShelfRow>> parse_shelf(std::string_view table, std::string_view table_name,
                                          std::span<const Target> targets) {
    const auto parsed = parse_table(table, table_name, kShelfHeader);
    if (!parsed) return parsed.error();
    std::vector<ShelfRow> shelf;
    for (const TableRow& row : parsed->rows) {
        const auto wrong = [&](const std::string& what) { return at_row(table_name, row.line, what); };
        const std::string& id = row.fields[0];
        const std::string& shown = row.fields[1];
        if (std::none_of(targets.begin(), targets.end(),
                         [&](const Target& target) { return target.id == id; }))
            return wrong(fmt::format("expected a pot of the table of targets, found {}", in_quotes(id)));
        if (find_row(shelf, id) != nullptr)
            return wrong(fmt::format("expected each pot once, found {} again", in_quotes(id)));
        if (shown != "shelf" && shown != "compared")
            return wrong(fmt::format("shown: expected shelf or compared, found {}", in_quotes(shown)));
        if (row.fields[2].empty() || row.fields[4].empty()) return wrong("name and date: expected both");
        const auto glaze = glaze_of(row.fields[5]);
        if (!glaze)
            return wrong(
                fmt::format("glaze: expected one of {}; found {}", glaze_ids(), in_quotes(row.fields[5])));
        shelf.push_back({.id = id,
                         .is_on_shelf = shown == "shelf",
                         .name = row.fields[2],
                         .museum = row.fields[3],
                         .date = row.fields[4],
                         .glaze = *glaze});
    }
    return shelf;
}

Result<std::vector<ShelfRow>> load_shelf(const std::filesystem::path& folder,
                                         std::span<const Target> targets) {
    const std::filesystem::path place = folder / "shelf.csv";
    const auto table = files::read_file(place, kMaxTableBytes);
    if (!table) return table.error();
    return parse_shelf(*table, place.string(), targets);
}

const ShelfRow* find_row(std::span<const ShelfRow> rows, std::string_view id) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const ShelfRow& one) { return one.id == id; });
    return row == rows.end() ? nullptr : &*row;
}

}  // namespace onggi::heritage
