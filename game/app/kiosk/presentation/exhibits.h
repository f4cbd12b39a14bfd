// The museum's pots as the screens know them: on the shelf, beside a visitor's pot, and on their cards. Any
// thread but the haptic one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "game/heritage/card.h"
#include "game/heritage/shelf.h"
#include "game/heritage/target.h"
#include "game/kiosk/strings.h"
#include "game/screens/page/view.h"

namespace onggi::app {

// What is told of them: the shelf's rows, and cards by their ids, for these languages.
struct ExhibitWords {
    std::vector<heritage::ShelfRow> shelf;
    std::map<std::string, heritage::Card, std::less<>> cards;
    std::vector<kiosk::Language> languages;
};

// The pots of the shelf, in the order of its rows, and behind them those without a row, which the table of
// targets names. `places` gets where each stands in that table.
[[nodiscard]] std::vector<screens::Exhibit> exhibits_of(const std::vector<heritage::Target>& targets,
                                                        const ExhibitWords& words,
                                                        std::vector<std::size_t>& places);
// All of them, in the order of the table of targets.
[[nodiscard]] std::vector<screens::Exhibit> relatives_of(const std::vector<heritage::Target>& targets,
                                                         const ExhibitWords& words);

}  // namespace onggi::app
