#include "game/kiosk/strings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::kiosk {
namespace {

const Language& english() {
    return built_in_languages().front();
}

Result<Language> read(const std::string& lines) {
    return Language::read("key\ttext\tspoken\tcheck\n" + lines, "ko", "ko.tsv", &english());
}

TEST(Strings, HaveEveryKeyInEveryLanguage) {
    ASSERT_EQ(built_in_languages().size(), 8U);
    EXPECT_EQ(english().code(), "en");
    EXPECT_GT(english().words().size(), 100U);
    for (const Language& language : built_in_languages()) {
        EXPECT_TRUE(language.missing_keys().empty()) << language.code();
        EXPECT_EQ(language.words().size(), english().words().size()) << language.code();
    }
}

int numbers_in(std::string_view text) {
    int count = 0;
    for (std::size_t at = text.find("{n}"); at != text.npos; at = text.find("{n}", at + 1))
        ++count;
    return count;
}

TEST(Strings, SpeakANumberWhereEnglishDoes) {
    for (const Language& language : built_in_languages()) {
        for (const auto& [key, words] : language.words()) {
            const Words& pattern = english().words().at(key);
            EXPECT_EQ(numbers_in(words.shown), numbers_in(pattern.shown)) << language.code() << ' ' << key;
            if (pattern.spoken == pattern.shown || words.spoken == words.shown) continue;
            EXPECT_EQ(numbers_in(words.spoken), numbers_in(pattern.spoken)) << language.code() << ' ' << key;
        }
    }
}

// A row that nobody translated is equal to English. Names, signs of units and a few words are so on purpose.
TEST(Strings, AreTranslatedButForNamesAndSigns) {
    const std::set<std::string> same_everywhere{
        "unit.mm",   "unit.g", "unit.n",       "unit.hz",     "number.point",  "phone.name", "mus.met",
        "mus.freer", "mus.bm", "mus.brooklyn", "mus.daitoku", "pot.maebyeong", "pot.kylix",  "pot.meiping"};
    const std::map<std::string, std::set<std::string>> same{
        {"de", {"tool.hand", "dec.finger", "phone.film", "pot.lekythos"}},
        {"fr", {"dec.motif"}},
        {"ja", {"unit.l"}},
    };
    for (const Language& language : built_in_languages()) {
        if (language.code() == "en") continue;
        const auto own = same.find(language.code());
        for (const auto& [key, words] : language.words()) {
            if (words.shown != english().shown(key) || same_everywhere.contains(key)) continue;
            EXPECT_TRUE(own != same.end() && own->second.contains(key))
                << language.code() << ' ' << key << ": " << words.shown;
        }
    }
}

// A language whose own signs a reader has not seen would pass for finished.
TEST(Strings, MarkEveryRowOfTheNewerLanguagesForANativeReader) {
    const std::set<std::string> of_the_program{"name", "lang.letter", "number.point"};
    for (const Language& language : built_in_languages()) {
        const std::string& code = language.code();
        if (code == "en" || code == "ko" || code == "ar") continue;
        for (const auto& [key, words] : language.words())
            EXPECT_EQ(words.needs_native_check, !of_the_program.contains(key)) << code << ' ' << key;
    }
}

TEST(Strings, NameTheButtonThatAQuestionAsksFor) {
    for (const Language& language : built_in_languages()) {
        const std::string& done = language.shown("ctl.done");
        EXPECT_NE(language.shown("solid.ask").find(done), std::string::npos) << language.code();
        for (const char* key : {"solid.ask", "thick.ask"})
            EXPECT_NE(language.spoken(key).find(done), std::string::npos) << language.code() << ' ' << key;
    }
}

const Language& built_in(std::string_view code) {
    const auto& all = built_in_languages();
    return *std::find_if(all.begin(), all.end(), [&](const Language& one) { return one.code() == code; });
}

TEST(Strings, WriteNumbersAsTheLanguageDoes) {
    EXPECT_EQ(built_in("en").number("0.75", true), "0.75");
    for (const char* code : {"de", "fr", "es"})
        EXPECT_EQ(built_in(code).number("0.75", true), "0,75") << code;
    for (const char* code : {"ja", "zh-Hans", "ko"})
        EXPECT_EQ(built_in(code).number("0.75", true), "0.75") << code;
    EXPECT_EQ(built_in("ar").number("0.75", true), "٠٫٧٥");
    EXPECT_EQ(built_in("ar").number("0.75", false), "0.75");
    EXPECT_EQ(built_in("de").number("2026-11-25, 18:00", true), "2026-11-25, 18:00");
    EXPECT_EQ(read("ctl.up\t위로\t\t\n")->number("1/2", true), "1/2");
    EXPECT_EQ(read("ctl.up\t위로\t\t\n")->number("0.5", true), "0.5") << "a table of an earlier program";
}

TEST(Strings, JoinTextsByTheLanguagesSigns) {
    EXPECT_EQ(built_in("en").punctuation().after_label, " ");
    EXPECT_EQ(built_in("fr").punctuation().colon, "\u00a0: ");
    EXPECT_EQ(built_in("zh-Hans").punctuation().comma, "，");
    EXPECT_EQ(built_in("ja").punctuation().stop, "。");
    EXPECT_EQ(built_in("ar").punctuation().comma, "، ");
}

// A text that is never shown costs museums a useless translation.
TEST(Strings, AreAllShownOrSpokenButThoseThatTheDesignHasNoPlaceFor) {
    const std::set<std::string> placeless{
        "help.button",  // "Show me" stands on the ledge for as long as anybody throws
        "a11y.scan",  // beside the ring stands the name of what it is on; the foot of the shelf is too short
    };
    std::string sources;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::in_checkout("game")))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
            sources += test::content_of(entry.path());
    const std::string shelf = test::content_of(test::in_checkout("assets/heritage/shelf.csv"));
    const auto names = [&](const std::string& key) {
        return sources.find('"' + key + '"') != std::string::npos ||
               shelf.find(',' + key + ',') != std::string::npos;
    };
    std::set<std::string> unused;
    for (const auto& [key, words] : english().words()) {
        // The second line of a warning: throw_screen.cpp makes its key of the first's.
        const bool is_second_line = key.starts_with("warn.") && key.ends_with('2');
        if (!names(is_second_line ? key.substr(0, key.size() - 1) : key)) unused.insert(key);
    }
    EXPECT_EQ(unused, placeless);
}

TEST(Strings, WriteNumbersWithTheDigitsOfArabic) {
    EXPECT_EQ(in_arabic_digits("18:05"), "١٨:٠٥");
    EXPECT_EQ(in_arabic_digits("0.75 x"), "٠٫٧٥ x");
    EXPECT_EQ(in_arabic_digits(""), "");
}

TEST(Strings, NameEachLanguageByItself) {
    EXPECT_EQ(built_in_languages()[0].shown("name"), "English");
    EXPECT_EQ(built_in_languages()[1].shown("name"), "한국어");
    EXPECT_EQ(built_in_languages()[2].shown("name"), "العربية");
    EXPECT_TRUE(built_in_languages()[2].right_to_left());
    EXPECT_FALSE(built_in_languages()[1].right_to_left());
    EXPECT_TRUE(built_in_languages()[2].is_arabic());
    EXPECT_FALSE(built_in_languages()[1].is_arabic());
    const auto egypt = Language::read("key\ttext\tspoken\tcheck\nname\tالعربية\t\t\n", "ar-EG", "ar-EG.tsv",
                                      &built_in_languages().front());
    ASSERT_TRUE(egypt) << egypt.error().message;
    EXPECT_TRUE(egypt->is_arabic());
    EXPECT_TRUE(egypt->right_to_left());
}

TEST(Strings, KeepTheMarksForTheNativeReader) {
    EXPECT_TRUE(built_in_languages()[2].words().at("attract.touch").needs_native_check);
    EXPECT_FALSE(built_in_languages()[0].words().at("attract.touch").needs_native_check);
}

TEST(Strings, SpeakTheShownTextIfNoSpokenOneIsGiven) {
    EXPECT_EQ(english().spoken("ctl.up"), "Up");
    EXPECT_EQ(english().spoken("ctl.undo"), "Undo the last touch");
}

TEST(Strings, PutTheNumberIn) {
    EXPECT_EQ(english().shown("keep.no", "14"), "Pot 14 today");
}

TEST(Strings, FallBackToEnglishAndThenToTheKey) {
    const auto korean = read("ctl.up\t위로\t\t\n");
    ASSERT_TRUE(korean) << korean.error().message;
    EXPECT_EQ(korean->shown("ctl.up"), "위로");
    EXPECT_EQ(korean->shown("ctl.down"), "Down");
    EXPECT_EQ(korean->shown("no.such"), "no.such");
    EXPECT_EQ(korean->missing_keys().size(), english().words().size() - 1);
}

TEST(Strings, TakeLinesFromWindowsAndNotes) {
    const auto korean = read("# from the education department\r\nctl.up\t위로\t\t\r\n\r\n");
    ASSERT_TRUE(korean) << korean.error().message;
    EXPECT_EQ(korean->shown("ctl.up"), "위로");
}

TEST(Strings, TakeATableAsEditorsLeaveIt) {
    const auto marked = Language::read(
        "\xef\xbb\xbf"
        "key\ttext\tspoken\tcheck\nctl.up\t위로\n",
        "ko", "ko.tsv", &english());
    ASSERT_TRUE(marked) << marked.error().message;
    EXPECT_EQ(marked->shown("ctl.up"), "위로");
    EXPECT_TRUE(Language::read("key\ttext\tspoken\tcheck\n", "ko", "ko.tsv", &english()))
        << "nothing of its own yet";
}

TEST(Strings, RejectsInvalidTables) {
    const auto refused = Language::read("key,text\n", "ko", "ko.tsv");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "ko.tsv:1: expected the header key,text,spoken,check, found 'key,text'");
    EXPECT_FALSE(Language::read("", "ko", "ko.tsv"));
}

TEST(Strings, RejectsBrokenLinesWithTheirNumber) {
    const struct {
        const char* lines;
        const char* message;
    } kCases[] = {
        {"ctl.up\t위로\t\t\tmore\n", "ko.tsv:2: expected 4 columns, found 5"},
        {"ctl.up\t\t\t\n", "ko.tsv:2: expected a key and its text, found 'ctl.up'"},
        {"ctl.up\tx\t\tmaybe\n", "ko.tsv:2: expected native or nothing as check, found 'maybe'"},
        {"ctl.upp\tx\t\t\n", "ko.tsv:2: expected a key that the program knows, found 'ctl.upp'"},
        {"ctl.up\tx\t\t\nctl.up\ty\t\t\n", "ko.tsv:3: expected each key once, found 'ctl.up'"},
        {"keep.no\tno number\t\t\n", "ko.tsv:2: expected {n} as often as in English, found 'no number'"},
        {"ctl.up\t\xff\t\t\n", "ko.tsv:2: column 2: expected text, found '\\xff'"},
    };
    for (const auto& one : kCases) {
        const auto refused = read(one.lines);
        ASSERT_FALSE(refused) << one.lines;
        EXPECT_EQ(refused.error().message, one.message);
        EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
    }
}

}  // namespace
}  // namespace onggi::kiosk
