// Converts the museum's pots for the screens: the shelf, the comparison with a visitor's pot, and the cards.
// Any thread but the haptic one.
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

// The texts of the exhibits: the shelf's rows, the cards by id, and the languages.
struct ExhibitWords {
    std::vector<heritage::ShelfRow> shelf;
    std::map<std::string, heritage::Card, std::less<>> cards;
    std::vector<kiosk::Language> languages;
};

// Returns the pots of the shelf in the order of its rows, then the targets without a row. `places` receives
// each exhibit's index into `targets`.
[[nodiscard]] std::vector<screens::Exhibit> exhibits_of(const std::vector<heritage::Target>& targets,
                                                        const ExhibitWords& words,
                                                        std::vector<std::size_t>& places);
// Returns all of `targets`, in their order.
[[nodiscard]] std::vector<screens::Exhibit> relatives_of(const std::vector<heritage::Target>& targets,
                                                         const ExhibitWords& words);

}  // namespace onggi::app
