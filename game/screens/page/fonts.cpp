#include "game/screens/page/fonts.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/core/language_tag.h"

namespace onggi::screens {
namespace {

constexpr Families kNanum{"NanumSquareRound, Noto Sans Arabic, Noto Sans",
                          "NanumMyeongjo, Noto Naskh Arabic, Noto Serif"};
// Display is the narrower cut of Noto Sans. The plain weight of Noto Serif is that of Nanum's bold titles.
constexpr Families kNoto{"Noto Sans Display, Noto Sans, NanumSquareRound, Noto Sans Arabic",
                         "Noto Serif, NanumMyeongjo, Noto Naskh Arabic", false};
constexpr Families kArabic{"Noto Sans Arabic, NanumSquareRound, Noto Sans",
                           "Noto Naskh Arabic, NanumMyeongjo, Noto Serif"};
// Nanum has Han letters in their Korean form and would stand in for a missing family; without it in the list,
// fontconfig prefers any family made for the language.
constexpr Families kJapanese{"Noto Sans CJK JP, Noto Sans, Noto Sans Arabic",
                             "Noto Serif CJK JP, Noto Serif, Noto Naskh Arabic"};
constexpr Families kSimplified{"Noto Sans CJK SC, Noto Sans, Noto Sans Arabic",
                               "Noto Serif CJK SC, Noto Serif, Noto Naskh Arabic"};
constexpr Families kTraditional{"Noto Sans CJK TC, Noto Sans, Noto Sans Arabic",
                                "Noto Serif CJK TC, Noto Serif, Noto Naskh Arabic"};

constexpr std::size_t kAlwaysNeeded = 4;
struct FamilyOfScript {
    FontFamily family;
    const Families* of;  // beyond the first four: the list that begins with it
};
constexpr std::array<FamilyOfScript, 10> kFamilies{{
    {{"NanumSquareRound", "NanumSquareRound", "fonts-nanum"}, nullptr},
    {{"NanumMyeongjo", "NanumMyeongjo", "fonts-nanum"}, nullptr},
    {{"Noto Sans Arabic", "NotoSansArabic", "fonts-noto-core"}, nullptr},
    {{"Noto Naskh Arabic", "NotoNaskhArabic", "fonts-noto-core"}, nullptr},
    {{"Noto Sans CJK JP", "NotoSansCJK", "fonts-noto-cjk"}, &kJapanese},
    {{"Noto Serif CJK JP", "NotoSerifCJK", "fonts-noto-cjk"}, &kJapanese},
    {{"Noto Sans CJK SC", "NotoSansCJK", "fonts-noto-cjk"}, &kSimplified},
    {{"Noto Serif CJK SC", "NotoSerifCJK", "fonts-noto-cjk"}, &kSimplified},
    {{"Noto Sans CJK TC", "NotoSansCJK", "fonts-noto-cjk"}, &kTraditional},
    {{"Noto Serif CJK TC", "NotoSerifCJK", "fonts-noto-cjk"}, &kTraditional},
}};

const Families& families_of_code(std::string_view code) {
    const std::string_view primary = primary_language(code);
    if (primary == "ko" || primary == "en") return kNanum;
    if (primary == "ar") return kArabic;
    if (primary == "ja") return kJapanese;
    if (primary != "zh") return kNoto;
    const bool is_traditional = code.find("Hant") != code.npos || code.ends_with("-TW") ||
                                code.ends_with("-HK") || code.ends_with("-MO");
    return is_traditional ? kTraditional : kSimplified;
}

}  // namespace

const Families& families_of(const kiosk::Language& language) {
    return families_of_code(language.code());
}

std::vector<FontFamily> needed_families(std::span<const std::string> codes) {
    std::vector<FontFamily> needed;
    for (std::size_t i = 0; i < kFamilies.size(); ++i) {
        const FamilyOfScript& wanted = kFamilies[i];
        const bool is_needed =
            i < kAlwaysNeeded || std::any_of(codes.begin(), codes.end(), [&](const std::string& code) {
                return &families_of_code(code) == wanted.of;
            });
        if (is_needed) needed.push_back(wanted.family);
    }
    return needed;
}

}  // namespace onggi::screens
