#include "game/app/kiosk/presentation/exhibits.h"

#include <algorithm>
#include <memory>

#include "game/finish/glaze.h"
#include "game/heritage/jar.h"

namespace onggi::app {
namespace {

std::shared_ptr<const screens::ExhibitCard> card_of(const heritage::Target& target,
                                                    const ExhibitWords& words) {
    const auto found = words.cards.find(target.id);
    if (found == words.cards.end()) return nullptr;
    const heritage::Card& card = found->second;
    auto shown = std::make_shared<screens::ExhibitCard>();
    for (const kiosk::Language& language : words.languages)
        shown->lines.push_back(card.in(language.code()));
    std::transform(card.known_by.begin(), card.known_by.end(), shown->known_by.begin(),
                   [](heritage::KnownBy known) { return static_cast<int>(known); });
    shown->source = card.source;
    for (const heritage::OutlinePoint& point : target.outline)
        ++(point.published ? shown->published_points : shown->drawn_points);
    return shown;
}

screens::Exhibit exhibit_of(const heritage::Target& target, const ExhibitWords& words) {
    constexpr float kWallMm = 5.0F;
    constexpr float kFloorMm = 9.0F;
    const heritage::ShelfRow* const row = heritage::find_row(words.shelf, target.id);
    screens::Exhibit exhibit;
    // A text that is not a key is shown unchanged in every language.
    exhibit.name_key = row != nullptr ? row->name : target.name;
    exhibit.museum_key = row != nullptr ? row->museum : target.place;
    exhibit.date_key = row != nullptr ? row->date : target.culture_date;
    exhibit.record = target.name;
    for (const std::string& part : {target.culture_date, target.place})
        if (!part.empty()) exhibit.record += ", " + part;
    exhibit.source = target.source;
    exhibit.height_mm = target.height_mm;
    exhibit.diameter_mm = target.max_diameter_mm.value_or(0.0);
    const heritage::ThrownSize size = heritage::size_on_this_wheel(target);
    if (size.fraction < 1.0) exhibit.part = size.part;
    exhibit.glaze = row != nullptr ? row->glaze : static_cast<int>(finish::Glaze::kBare);
    exhibit.shape = pot::hollowed(heritage::outline_of(target, 1.0), kWallMm, kFloorMm);
    exhibit.card = card_of(target, words);
    return exhibit;
}

}  // namespace

std::vector<screens::Exhibit> exhibits_of(const std::vector<heritage::Target>& targets,
                                          const ExhibitWords& words, std::vector<std::size_t>& places) {
    places.clear();
    for (const heritage::ShelfRow& row : words.shelf) {
        for (std::size_t place = 0; row.is_on_shelf && place < targets.size(); ++place)
            if (targets[place].id == row.id) places.push_back(place);
    }
    for (std::size_t place = 0; place < targets.size(); ++place)
        if (heritage::find_row(words.shelf, targets[place].id) == nullptr) places.push_back(place);
    std::vector<screens::Exhibit> exhibits;
    for (const std::size_t place : places)
        exhibits.push_back(exhibit_of(targets[place], words));
    return exhibits;
}

std::vector<screens::Exhibit> relatives_of(const std::vector<heritage::Target>& targets,
                                           const ExhibitWords& words) {
    std::vector<screens::Exhibit> relatives;
    for (const heritage::Target& target : targets)
        relatives.push_back(exhibit_of(target, words));
    return relatives;
}

}  // namespace onggi::app
