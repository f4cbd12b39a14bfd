#include "game/heritage/card.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/core/quote.h"
#include "engine/core/table.h"
#include "engine/files/read_file.h"

namespace onggi::heritage {
namespace {

constexpr std::string_view kEnglish = "en";
constexpr std::array<std::string_view, kCardLines> kLines{"use", "making", "look"};
constexpr std::string_view kKnownBy = "known_by";

std::optional<KnownBy> known_by(std::string_view word) {
    if (word == "record") return KnownBy::kRecord;
    if (word == "kind") return KnownBy::kKind;
    if (word == "general") return KnownBy::kGeneral;
    return std::nullopt;
}

// Index of each column, by name.
using Columns = std::map<std::string, std::size_t, std::less<>>;

Result<Columns> columns_of(const Table& table, std::string_view name) {
    Columns columns;
    for (const std::string& column : table.columns)
        if (!columns.emplace(column, columns.size()).second)
            return at_row(name, 1,
                          fmt::format("expected each column once, found {} twice", in_quotes(column)));
    std::vector<std::string> needed{"id", "source"};
    for (const std::string_view line : kLines) {
        needed.push_back(fmt::format("{}_{}", line, kEnglish));
        needed.push_back(fmt::format("{}_{}", line, kKnownBy));
    }
    for (const std::string& column : needed)
        if (!columns.contains(column))
            return at_row(name, 1, fmt::format("expected a column {}, found none", in_quotes(column)));
    return columns;
}

Result<Card> card_of(const TableRow& row, const Columns& columns, std::string_view name) {
    Card card;
    card.source = row.fields[columns.find("source")->second];
    if (card.source.empty())
        return at_row(name, row.line, "source: expected where it is known from, found nothing");
    for (std::size_t line = 0; line < kCardLines; ++line) {
        const std::string prefix = fmt::format("{}_", kLines[line]);
        for (const auto& [column, place] : columns) {
            if (!column.starts_with(prefix)) continue;
            const std::string code = column.substr(prefix.size());
            const std::string& field = row.fields[place];
            if (code == kKnownBy) {
                const auto known = known_by(field);
                if (!known)
                    return at_row(name, row.line,
                                  fmt::format("{}: expected record, kind or general, found {}", column,
                                              in_quotes(field)));
                card.known_by[line] = *known;
            } else if (!field.empty()) {
                card.words[code][line] = field;
            }
        }
        if (card.words[std::string(kEnglish)][line].empty())
            return at_row(name, row.line,
                          fmt::format("{}{}: expected a sentence, found nothing", prefix, kEnglish));
    }
    return card;
}

}  // namespace

const std::array<std::string, kCardLines>& Card::in(std::string_view language) const {
    const auto found = words.find(language);
    const bool is_whole = found != words.end() && std::none_of(found->second.begin(), found->second.end(),
                                                               [](const auto& line) { return line.empty(); });
    return is_whole ? found->second : words.find(kEnglish)->second;
}

Result<std::map<std::string, Card, std::less<>>> parse_cards(std::string_view table,
                                                             std::string_view table_name,
                                                             std::span<const Target> targets) {
    const auto parsed = parse_table(table, table_name);
    if (!parsed) return parsed.error();
    const auto columns = columns_of(*parsed, table_name);
    if (!columns) return columns.error();
    if (parsed->rows.empty()) return at_row(table_name, 2, "expected at least one row, found none");
    std::map<std::string, Card, std::less<>> cards;
    for (const TableRow& row : parsed->rows) {
        const std::string& id = row.fields[columns->find("id")->second];
        const bool is_known = std::any_of(targets.begin(), targets.end(),
                                          [&](const Target& target) { return target.id == id; });
        if (!is_known)
            return at_row(table_name, row.line,
                          fmt::format("expected a pot of the table of targets, found {}", in_quotes(id)));
        auto card = card_of(row, *columns, table_name);
        if (!card) return card.error();
        if (!cards.emplace(id, std::move(*card)).second)
            return at_row(table_name, row.line,
                          fmt::format("expected each pot once, found {} again", in_quotes(id)));
    }
    return cards;
}

Result<std::map<std::string, Card, std::less<>>> load_cards(const std::filesystem::path& folder,
                                                            std::span<const Target> targets) {
    const std::filesystem::path place = folder / "cards.csv";
    const auto table = files::read_file(place, kMaxTableBytes);
    if (!table) return table.error();
    return parse_cards(*table, place.string(), targets);
}

}  // namespace onggi::heritage
