// Pots to be shared: small files of known bytes, words in three languages.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "game/kiosk/strings.h"
#include "game/sharing/outbox.h"
#include "game/sharing/shared_pot.h"

namespace onggi::support {

inline std::vector<std::byte> bytes_of(std::string_view text) {
    const auto* const begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

// Begins as a PNG does; nothing looks further.
inline std::vector<std::byte> like_a_png(std::string_view rest) {
    return bytes_of("\x89PNG\r\n\x1a\n" + std::string(rest));
}

// A round jar, 160 mm high.
inline std::vector<sharing::OutlinePoint> jar_outside() {
    std::vector<sharing::OutlinePoint> outline;
    for (int i = 0; i <= 60; ++i)
        outline.push_back({45.0 + 35.0 * std::sin(0.5 + i * 0.04), i * 160.0 / 60.0});
    return outline;
}

inline std::vector<sharing::OutlinePoint> jar_inside() {
    std::vector<sharing::OutlinePoint> outline = jar_outside();
    std::vector<sharing::OutlinePoint> inside;
    for (auto point = outline.rbegin(); point != outline.rend() && point->height_mm > 8.0; ++point)
        inside.push_back({point->radius_mm - 5.0, point->height_mm});
    return inside;
}

// With every kind of file; each contains `mark`.
inline sharing::SharedPot full_pot(const std::string& mark) {
    sharing::SharedPot pot;
    pot.picture.bytes = like_a_png("picture " + mark);
    pot.poster.bytes = like_a_png("poster " + mark);
    pot.model_glb.bytes = bytes_of("glTF " + mark + std::string(20000, 'v'));
    pot.print_stl.bytes = bytes_of("binary STL " + mark + std::string(30000, 't'));
    pot.print_3mf.bytes = bytes_of("PK\x03\x04 3MF " + mark);
    pot.film.bytes = bytes_of("RIFF....WEBP film " + mark);
    pot.film_mp4.bytes = bytes_of("....ftyp film " + mark);
    pot.drawing_svg.bytes = bytes_of("<svg> drawing " + mark + std::string(400, 'd'));
    pot.drawing_pdf.bytes = bytes_of("%PDF drawing " + mark);
    pot.measures_json.bytes = bytes_of("{} " + mark + std::string(400, ' '));
    pot.film_still.bytes = like_a_png("still " + mark);
    pot.surface.bytes = like_a_png("surface " + mark);
    pot.film_s = 8.0;
    pot.outside = jar_outside();
    pot.inside = jar_inside();
    pot.colour_linear = {0.2, 0.32, 0.2};
    pot.gloss = 0.9;
    pot.height_mm = 160.2;
    pot.width_mm = 159.8;
    pot.mass_g = 810.4;
    pot.capacity_ml = 1900.0;
    pot.words = {{"Celadon", "Moon jar", "Joseon, 18th c., National Museum of Korea"},
                 {"청자", "달항아리", "조선 18세기, 국립중앙박물관"},
                 {"سيلادون", "جرة القمر", "جوسون، القرن ١٨"}};
    pot.nearest_outside = jar_outside();
    return pot;
}

// English, Korean, Arabic.
inline std::shared_ptr<const std::vector<kiosk::Language>> three_languages() {
    const auto& all = kiosk::built_in_languages();
    return std::make_shared<const std::vector<kiosk::Language>>(all.begin(), all.begin() + 3);
}

}  // namespace onggi::support
