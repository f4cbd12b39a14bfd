// Cards about a museum's pots: use, making and what to look for, in the museum's languages, each with its
// evidence and source. Any thread but the haptic one.
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

// Evidence for a line of a card: the record of this very pot, a page on pots of its kind, or general
// knowledge.
enum class KnownBy { kRecord, kKind, kGeneral };

constexpr std::size_t kCardLines = 3;  // use, making, look
struct Card {
    std::map<std::string, std::array<std::string, kCardLines>, std::less<>> words;  // by language code
    std::array<KnownBy, kCardLines> known_by{};
    std::string source;

    // The words in that language if complete, else in English.
    [[nodiscard]] const std::array<std::string, kCardLines>& in(std::string_view language) const;
};

// The cards of a table by their pots' ids. Its first line names the columns: `id`; `use_CODE`, `making_CODE`
// and `look_CODE` of each language, at least English; `use_known_by`, `making_known_by`, `look_known_by`
// (record, kind or general); `source`; others are ignored. kBadInput naming the line: an error of
// parse_table, a missing column, a pot that is not among the targets or comes twice, an empty English line,
// an empty source, an unknown word for the evidence.
Result<std::map<std::string, Card, std::less<>>> parse_cards(std::string_view table,
                                                             std::string_view table_name,
                                                             std::span<const Target> targets);

// The same from a folder's cards.csv.
Result<std::map<std::string, Card, std::less<>>> load_cards(const std::filesystem::path& folder,
                                                            std::span<const Target> targets);

}  // namespace onggi::heritage
