// What a museum's pot was for, how it was made and what to look for, in a house's languages, each with how it
// is known and where from. Any thread but the haptic one.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "game/heritage/target.h"

namespace onggi::heritage {

// How a line of a card is known: by the record of this very pot, by a page on pots of its kind, or generally.
enum class KnownBy { kRecord, kKind, kGeneral };

constexpr std::size_t kCardLines = 3;  // use, making, look
struct Card {
    std::map<std::string, std::array<std::string, kCardLines>, std::less<>> words;  // by a language's code
    std::array<KnownBy, kCardLines> known_by{};
    std::string source;

    // Of that language, else English.
    [[nodiscard]] const std::array<std::string, kCardLines>& in(std::string_view language) const;
};

// The cards of a table by their pots' ids. Its first line names the columns: `id`; `use_CODE`, `making_CODE`
// and `look_CODE` of each language, English at least; `use_known_by`, `making_known_by`, `look_known_by`
// (record, kind or general); `source`; others are passed over. kBadInput naming the line: what parse_table
// refuses, a column that is missing, a pot that is not among the targets or comes twice, an empty English
// line, an empty source, a word that does not say how a line is known.
Result<std::map<std::string, Card, std::less<>>> parse_cards(std::string_view table,
                                                             std::string_view table_name,
                                                             std::span<const Target> targets);

// The same from cards.csv of a folder.
Result<std::map<std::string, Card, std::less<>>> load_cards(const std::filesystem::path& folder,
                                                            std::span<const Target> targets);

}  // namespace onggi::heritage
