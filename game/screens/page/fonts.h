// The font families of each language's words, and which of them a kiosk needs for the languages that it
// offers. Any thread; constant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/kiosk/strings.h"

namespace onggi::screens {

// Lists for Pango, in order of preference.
struct Families {
    const char* ui;
    const char* title;
    bool has_bold_titles = true;
};

// Arabic, Japanese and Chinese words have their own family first, so that their digits and marks match and a
// Han letter has its language's form. Other languages than Korean and English begin with Noto: the Nanum
// families have no accented letters.
[[nodiscard]] const Families& families_of(const kiosk::Language& language);

struct FontFamily {
    std::string_view name;
    std::string_view file_prefix;  // of its files
    std::string_view package;      // of Debian
};

// The families without which the words of these languages (BCP 47) look different. Those of Korean, English
// and Arabic always are among them: the packages depend on them.
[[nodiscard]] std::vector<FontFamily> needed_families(std::span<const std::string> codes);

}  // namespace onggi::screens
