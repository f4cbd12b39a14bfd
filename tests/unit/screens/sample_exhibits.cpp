// Pots of museums as samples: four outlines, with the longest that any shipped card has to say.
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/files/asset_folder.h"
#include "game/finish/glaze.h"
#include "game/heritage/card.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

constexpr std::array kCodes{"ko",      "en", "ar", "ja",
                            "zh-Hans", "de", "fr", "es"};  // as the samples order them

std::size_t bytes_of(std::span<const std::string> lines) {
    std::size_t bytes = 0;
    for (const std::string& line : lines)
        bytes += line.size();
    return bytes;
}

// In each language the most that any card has to say, and the longest source.
std::shared_ptr<const ExhibitCard> longest_card() {
    // Not by the checkout's path, which another user's home may hide from a visitor's tools under cage.
    const std::string folder = files::find_asset("heritage").value().string();
    const auto targets = heritage::load_targets(folder).value();
    const auto cards = heritage::load_cards(folder, targets).value();
    auto shown = std::make_shared<ExhibitCard>();
    for (const char* language : kCodes) {
        auto& longest = shown->lines.emplace_back();
        for (const auto& [id, card] : cards)
            if (bytes_of(card.in(language)) > bytes_of(longest)) longest = card.in(language);
    }
    for (const auto& [id, card] : cards)
        if (card.source.size() > shown->source.size()) shown->source = card.source;
    shown->known_by = {0, 1, 2};
    shown->published_points = 4;
    shown->drawn_points = 9;
    return shown;
}

std::shared_ptr<const std::vector<Exhibit>> make_exhibits() {
    std::vector<Exhibit> all{
        {"pot.ido", "mus.daitoku", "date.joseon16", 91.0, 154.0, "", finish::kIdoGlaze,
         pot::hollowed({{26, 0}, {28, 12}, {30, 16}, {48, 30}, {63, 52}, {72, 74}, {77, 91}}, 5.0F, 20.0F)},
        {"pot.buncheong", "mus.brooklyn", "date.joseon15", 50.0, 196.0, "", 2,
         pot::hollowed({{29, 0}, {30, 7}, {48, 14}, {72, 26}, {90, 40}, {98, 50}}, 5.0F, 12.0F)},
        {"pot.maebyeong", "mus.nmk", "date.goryeo12", 303.0, 0.0, "1/2", 0,
         pot::hollowed({{52, 0},
                        {50, 30},
                        {52, 80},
                        {64, 150},
                        {84, 215},
                        {90, 240},
                        {84, 264},
                        {60, 284},
                        {28, 292},
                        {20, 296},
                        {25, 303}},
                       5.0F, 8.0F)},
        {"pot.moon", "mus.nmk", "date.joseon18", 305.0, 302.0, "1/3", 1,
         pot::hollowed({{60, 0},
                        {62, 10},
                        {103, 44},
                        {136, 90},
                        {150, 135},
                        {151, 158},
                        {147, 188},
                        {130, 228},
                        {103, 262},
                        {81, 283},
                        {72, 290},
                        {69, 296},
                        {71, 305}},
                       6.0F, 10.0F)}};
    const auto card = longest_card();
    for (Exhibit& exhibit : all)
        exhibit.card = card;
    return std::make_shared<const std::vector<Exhibit>>(std::move(all));
}

}  // namespace

std::shared_ptr<const std::vector<Exhibit>> sample_exhibits() {
    static const auto all = make_exhibits();
    return all;
}

}  // namespace onggi::screens
