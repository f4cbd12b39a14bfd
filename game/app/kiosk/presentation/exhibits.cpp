#include "game/app/kiosk/presentation/exhibits.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "game/finish/glaze.h"
#include "game/heritage/jar.h"

namespace onggi::app {
namespace {

// A pot of the tables for which there are words.
struct Known {
    std::string_view id;
    const char* name_key;
    const char* museum_key;
    const char* date_key;
    int glaze;
};
// Those of the shelf, in its order: four that are known to most, and on along it. One lump or two throw each.
constexpr std::array kShown{
    Known{"ido-kizaemon", "pot.ido", "mus.daitoku", "date.joseon16", finish::kIdoGlaze},
    Known{"buncheong-bowl", "pot.buncheong", "mus.brooklyn", "date.joseon15", 2},
    Known{"maebyeong-1869", "pot.maebyeong", "mus.nmk", "date.goryeo12", 0},
    Known{"moon-jar-nmk", "pot.moon", "mus.nmk", "date.joseon18", 1},
    Known{"joseon-bowl", "pot.bowl", "mus.freer", "date.joseon16", 1},
    Known{"brown-jar-brooklyn", "pot.brownjar", "mus.brooklyn", "date.joseon19", 3},
    Known{"onggi-bottle-chang", "pot.onggibottle", "mus.chang", "date.joseon19", 3},
    Known{"onggi-cooler-bm", "pot.onggi", "mus.bm", "date.korea20", 3},
    Known{"moon-jar-met", "pot.moon", "mus.met", "date.joseon18", 1},
    Known{"onggi-soy-yanji", "pot.soyjar", "", "date.korea20", 5},
    Known{"onggi-heobeok-jeju", "pot.heobeok", "mus.jeju", "date.korea20", 5}};
// The others, which a visitor's pot may resemble: their museums are not named there.
constexpr std::array kRelatives{Known{"moon-jar-bm", "pot.moon", "", "date.joseon17to18", 1},
                                Known{"maebyeong-68", "pot.maebyeong", "", "date.goryeo12", 0},
                                Known{"buncheong-small-bowl", "pot.smallbowl", "", "date.joseon15to16", 2},
                                Known{"meiping-ngv", "pot.meiping", "", "date.ming16", 0},
                                Known{"kylix-met", "pot.kylix", "", "date.athens6", 3},
                                Known{"kylix-ringling", "pot.kylix", "", "date.athens", 3},
                                Known{"lekythos-boston", "pot.lekythos", "", "date.athens5", 3},
                                Known{"lekythos-met", "pot.lekythos", "", "date.athens5", 3},
                                Known{"amphora-met", "pot.amphora", "", "date.athens", 3},
                                Known{"olla-cas", "pot.olla", "", "date.acoma19", 5},
                                Known{"olla-sar", "pot.olla", "", "date.acoma19", 5},
                                Known{"onggi-vat-chang", "pot.vat", "", "date.joseon19", 3}};
constexpr int kBareGlaze = 5;

const Known* known_of(const heritage::Target& target) {
    const auto has_id = [&](const Known& one) { return one.id == target.id; };
    const auto shown = std::find_if(kShown.begin(), kShown.end(), has_id);
    if (shown != kShown.end()) return &*shown;
    const auto other = std::find_if(kRelatives.begin(), kRelatives.end(), has_id);
    return other != kRelatives.end() ? &*other : nullptr;
}

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

screens::Exhibit exhibit_of(const heritage::Target& target, const Known* known, const ExhibitWords& words) {
    constexpr float kWallMm = 5.0F;
    constexpr float kFloorMm = 9.0F;
    screens::Exhibit exhibit;
    // Words that are no key stand for themselves, in every language.
    exhibit.name_key = known != nullptr ? known->name_key : target.name;
    exhibit.museum_key = known != nullptr ? known->museum_key : target.place;
    exhibit.date_key = known != nullptr ? known->date_key : target.culture_date;
    exhibit.height_mm = target.height_mm;
    exhibit.diameter_mm = target.max_diameter_mm.value_or(0.0);
    const heritage::ThrownSize size = heritage::size_on_this_wheel(target);
    if (size.fraction < 1.0) exhibit.part = size.part;
    exhibit.glaze = known != nullptr ? known->glaze : kBareGlaze;
    exhibit.shape = pot::hollowed(heritage::outline_of(target, 1.0), kWallMm, kFloorMm);
    exhibit.card = card_of(target, words);
    return exhibit;
}

}  // namespace

std::vector<screens::Exhibit> exhibits_of(const std::vector<heritage::Target>& targets,
                                          const ExhibitWords& words, std::vector<std::size_t>& places) {
    std::vector<screens::Exhibit> exhibits;
    places.clear();
    const auto add = [&](std::size_t place) {
        exhibits.push_back(exhibit_of(targets[place], known_of(targets[place]), words));
        places.push_back(place);
    };
    for (const Known& shown : kShown) {
        for (std::size_t place = 0; place < targets.size(); ++place)
            if (targets[place].id == shown.id) add(place);
    }
    for (std::size_t place = 0; place < targets.size(); ++place)
        if (known_of(targets[place]) == nullptr) add(place);
    return exhibits;
}

std::vector<screens::Exhibit> relatives_of(const std::vector<heritage::Target>& targets,
                                           const ExhibitWords& words) {
    std::vector<screens::Exhibit> relatives;
    for (const heritage::Target& target : targets)
        relatives.push_back(exhibit_of(target, known_of(target), words));
    return relatives;
}

}  // namespace onggi::app
