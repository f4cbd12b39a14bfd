// Needs the fonts of all built-in languages: fonts-nanum, fonts-noto-core and fonts-noto-cjk.
#include "game/screens/page/fonts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/ui/painter.h"
#include "game/screens/composer.h"

namespace onggi::screens {
namespace {

const kiosk::Language& built_in(std::string_view code) {
    const auto& all = kiosk::built_in_languages();
    return *std::find_if(all.begin(), all.end(),
                         [&](const kiosk::Language& one) { return one.code() == code; });
}

ui::Text text_in(std::string_view code, std::string words, bool is_title, float width = 0.0F) {
    const Families& families = families_of(built_in(code));
    return {.words = std::move(words),
            .style = {.family = is_title ? families.title : families.ui,
                      .bold = is_title,
                      .size = 40.0F,
                      .line_height = 50.0F,
                      .language = std::string(code)},
            .width = width};
}

std::vector<std::uint8_t> written(ui::Painter& painter, std::string_view code, const char* words,
                                  bool is_title) {
    ui::Sketch sketch{.size = {60.0F, 60.0F}};
    sketch.add(ui::Writing{.at = {6.0F, 4.0F}, .text = text_in(code, words, is_title), .box_width = 54.0F});
    return painter.paint(sketch).rgba;
}

TEST(Fonts, KnowEveryLetterOfEveryLanguage) {
    ui::Painter painter;
    for (const kiosk::Language& language : kiosk::built_in_languages()) {
        for (const auto& [key, words] : language.words()) {
            for (const bool is_title : {false, true}) {
                const ui::TextSize size = painter.measure(text_in(language.code(), words.shown, is_title));
                EXPECT_EQ(size.unknown_glyphs, 0) << language.code() << ' ' << key << ": " << words.shown;
            }
        }
    }
}

// U+76F4: its lowest stroke has a corner in Japan.
TEST(Fonts, WriteAHanLetterInTheFormOfItsLanguage) {
    ui::Painter painter;
    for (const bool is_title : {false, true})
        EXPECT_NE(written(painter, "ja", "\u76f4", is_title),
                  written(painter, "zh-Hans", "\u76f4", is_title));
}

// Of a word in two fonts the letters differ in weight and height.
TEST(Fonts, WriteAccentedWordsInOneFont) {
    ui::Painter painter;
    for (const bool is_title : {false, true}) {
        const std::string plain = is_title ? "Noto Serif" : "Noto Sans Display";
        for (const auto& [code, words] :
             {std::pair("de", "Töpferscheibe"), std::pair("fr", "Étagère"), std::pair("es", "Tamaño")}) {
            ui::Text alone = text_in(code, words, is_title);
            alone.style.family = plain;
            EXPECT_EQ(painter.measure(text_in(code, words, is_title)).width, painter.measure(alone).width)
                << words;
        }
    }
}

// The rules of line breaking in Japanese and Chinese: a line may end after any letter, and begins with no
// full stop, comma or closing bracket.
TEST(Fonts, BreakJapaneseAndChineseBetweenLettersButNotBeforeAStop) {
    ui::Painter painter;
    for (const auto& [code, words] : {std::pair("ja", "土土土土。"), std::pair("zh-Hans", "泥泥泥泥，")}) {
        const ui::TextSize size = painter.measure(text_in(code, words, false, 4.4F * 40.0F));
        EXPECT_EQ(size.lines, 2) << words;
        EXPECT_LT(size.width, 3.5F * 40.0F) << "a letter goes with the sign: " << words;
    }
}

TEST(Fonts, AreNeededOnlyForALanguageThatIsOffered) {
    const auto names = [](std::vector<std::string> codes) {
        std::vector<std::string> all;
        for (const FontFamily& family : needed_families(codes))
            all.emplace_back(family.name);
        return all;
    };
    const std::vector<std::string> always{"NanumSquareRound", "NanumMyeongjo", "Noto Sans Arabic",
                                          "Noto Naskh Arabic"};
    EXPECT_EQ(names({"ko", "en", "ar", "de", "fr", "es"}), always);
    EXPECT_EQ(names({"ja"}).size(), always.size() + 2);
    EXPECT_EQ(names({"zh-Hans"}).back(), "Noto Serif CJK SC");
    EXPECT_EQ(names({"zh-Hant"}).back(), "Noto Serif CJK TC");
    EXPECT_EQ(names({"zh-TW", "zh-CN", "ja"}).size(), always.size() + 6);
}

TEST(Fonts, AreHere) {
    std::vector<std::string> codes;
    for (const kiosk::Language& language : kiosk::built_in_languages())
        codes.push_back(language.code());
    EXPECT_EQ(missing_fonts(codes), "");
}

}  // namespace
}  // namespace onggi::screens
