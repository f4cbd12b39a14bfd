#include "game/kiosk/strings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "engine/core/cells.h"
#include "engine/core/quote.h"
#include "languages.h"  // written while building, from assets/languages

namespace onggi::kiosk {
namespace {

constexpr std::string_view kHeader = "key\ttext\tspoken\tcheck";

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        std::size_t length = shown_character_length(text);
        // No-break space and its like begin with c2, which shown_character_length leaves out for terminals.
        if (length == 0 && text.size() > 1 && static_cast<unsigned char>(text[0]) == 0xc2 &&
            static_cast<unsigned char>(text[1]) >= 0xa0 && static_cast<unsigned char>(text[1]) <= 0xbf) {
            length = 2;
        }
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

int placeholders(std::string_view text) {
    int count = 0;
    for (std::size_t at = text.find("{n}"); at != std::string_view::npos; at = text.find("{n}", at + 3))
        ++count;
    return count;
}

const std::string& looked_up(const std::map<std::string, Words, std::less<>>& words,
                             const std::map<std::string, Words, std::less<>>& fallback, std::string_view key,
                             std::string Words::*which) {
    if (const auto found = words.find(key); found != words.end()) return found->second.*which;
    if (const auto found = fallback.find(key); found != fallback.end()) return found->second.*which;
    static const std::string nothing;
    return nothing;
}

}  // namespace

Result<Language> Language::read(std::string_view table, std::string code, const std::string& file,
                                const Language* pattern) {
    Language language;
    language.code_ = std::move(code);
    if (pattern != nullptr) language.fallback_ = pattern->words_;
    const auto wrong = [&](int line, std::string_view expected, std::string_view found) {
        return bad_input(
            fmt::format("{}, line {}: expected {}, found {}", file, line, expected, in_quotes(found)));
    };
    int number = 0;
    while (!table.empty()) {
        const std::size_t end = std::min(table.find('\n'), table.size());
        std::string_view line = table.substr(0, end);
        table.remove_prefix(std::min(end + 1, table.size()));
        ++number;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (number == 1) {
            if (line != kHeader) return wrong(1, "the header key, text, spoken, check between tabs", line);
            continue;
        }
        if (line.empty() || line.starts_with('#')) continue;
        const auto cells = cells_of(line, '\t');
        if (cells.size() != 4) return wrong(number, "four cells between tabs", line);
        for (const std::string_view cell : cells) {
            if (!is_utf8(cell)) return wrong(number, "UTF-8", cell);
        }
        const std::string key(cells[0]);
        if (key.empty() || cells[1].empty()) return wrong(number, "a key and its text", line);
        if (!cells[3].empty() && cells[3] != "native")
            return wrong(number, "native or nothing as check", cells[3]);
        if (pattern != nullptr) {
            if (!pattern->has(key)) return wrong(number, "a key that the program knows", key);
            if (placeholders(cells[1]) != placeholders(pattern->shown(key)))
                return wrong(number, "{n} as often as in English", cells[1]);
        }
        const Words words{.shown = std::string(cells[1]),
                          .spoken = std::string(cells[2].empty() ? cells[1] : cells[2]),
                          .needs_native_check = !cells[3].empty()};
        if (!language.words_.emplace(key, words).second) return wrong(number, "each key once", key);
    }
    if (number == 0) return wrong(1, "the header key, text, spoken, check between tabs", "");
    return language;
}

const std::string& Language::shown(std::string_view key) const {
    const std::string& words = looked_up(words_, fallback_, key, &Words::shown);
    if (!words.empty()) return words;
    static thread_local std::string itself;
    return itself = key;
}

const std::string& Language::spoken(std::string_view key) const {
    const std::string& words = looked_up(words_, fallback_, key, &Words::spoken);
    return words.empty() ? shown(key) : words;
}

std::string Language::shown(std::string_view key, std::string_view n) const {
    std::string words = shown(key);
    for (std::size_t at = words.find("{n}"); at != std::string::npos; at = words.find("{n}", at + n.size()))
        words.replace(at, 3, n);
    return words;
}

std::vector<std::string> Language::missing_keys() const {
    std::vector<std::string> missing;
    for (const auto& [key, words] : fallback_) {
        if (!words_.contains(key)) missing.push_back(key);
    }
    return missing;
}

bool Language::right_to_left() const {
    constexpr std::array<std::string_view, 6> kRightToLeft{"ar", "he", "fa", "ur", "yi", "dv"};
    return std::find(kRightToLeft.begin(), kRightToLeft.end(), primary_code()) != kRightToLeft.end();
}

std::string in_arabic_digits(std::string_view number) {
    std::string own;
    for (const char letter : number) {
        if (letter >= '0' && letter <= '9') {
            own += '\xd9';
            own += static_cast<char>('\xa0' + (letter - '0'));
        } else if (letter == '.') {
            own += "\xd9\xab";
        } else {
            own += letter;
        }
    }
    return own;
}

const std::vector<Language>& built_in_languages() {
    static const std::vector<Language> languages = [] {
        std::vector<Language> read;
        read.reserve(built_in::kTables.size());
        for (const auto& [code, table] : built_in::kTables) {
            auto language =
                Language::read(table, std::string(code), fmt::format("assets/languages/{}.tsv", code),
                               read.empty() ? nullptr : &read.front());
            assert(language);  // a test reads each
            if (language) read.push_back(std::move(*language));
        }
        return read;
    }();
    return languages;
}

}  // namespace onggi::kiosk
