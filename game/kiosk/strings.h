// The texts of the screens in each language: tables that a museum can edit and extend. Any thread; constant
// once read.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/language_tag.h"
#include "engine/core/result.h"

namespace onggi::kiosk {

struct Words {
    std::string shown;
    std::string spoken;  // for recorded or synthetic speech
    bool needs_native_check = false;
};

// What stands between texts that the program joins, with its spaces.
struct Punctuation {
    std::string_view comma = ", ";
    std::string_view colon = ": ";
    std::string_view stop = ".";
    std::string_view after_label = " ";  // between "Closest to" and a name
};

class Language {
  public:
    // Reads a table of lines `key TAB text TAB spoken TAB check`; the first line holds exactly these names.
    // An empty spoken cell means "as written"; check is empty or `native`. `code` is BCP 47 ("ko"); `file` is
    // the name in messages. Errors name file and line: a missing or extra cell, an unknown or repeated key,
    // an empty text, invalid UTF-8, a placeholder that differs from the first language's.
    static Result<Language> read(std::string_view table, std::string code, const std::string& file,
                                 const Language* pattern = nullptr);

    // Returns the key's text, or the pattern's where this language lacks it. A key that neither has is
    // returned itself, so that no button is empty.
    [[nodiscard]] const std::string& shown(std::string_view key) const;
    [[nodiscard]] const std::string& spoken(std::string_view key) const;
    // Replaces every {n} in the text by `n`.
    [[nodiscard]] std::string shown(std::string_view key, std::string_view n) const;

    [[nodiscard]] bool has(std::string_view key) const { return words_.contains(key); }
    [[nodiscard]] std::vector<std::string> missing_keys() const;  // present in the pattern only
    [[nodiscard]] const std::string& code() const { return code_; }
    [[nodiscard]] bool right_to_left() const;
    // Without script and country.
    [[nodiscard]] std::string_view primary_code() const { return primary_language(code_); }
    [[nodiscard]] bool is_arabic() const { return primary_code() == "ar"; }
    // Writes a number such as "0.75" with the decimal sign of `number.point`, or, in Arabic with
    // `own_digits`, with Arabic-Indic digits.
    [[nodiscard]] std::string number(std::string_view plain, bool own_digits) const;
    [[nodiscard]] const Punctuation& punctuation() const;
    [[nodiscard]] const std::map<std::string, Words, std::less<>>& words() const { return words_; }

  private:
    std::string code_;
    std::map<std::string, Words, std::less<>> words_;
    std::map<std::string, Words, std::less<>> fallback_;
};

// Replaces every {n} in the words by `n`, and every {m} by `m`.
[[nodiscard]] std::string filled_in(std::string words, std::string_view n, std::string_view m = {});

// Writes a number with Arabic-Indic digits (from U+0660) and the Arabic decimal separator (U+066B).
[[nodiscard]] std::string in_arabic_digits(std::string_view number);

// The built-in languages, English first. They come from assets/languages; game/kiosk/CMakeLists.txt lists
// them.
[[nodiscard]] const std::vector<Language>& built_in_languages();

}  // namespace onggi::kiosk
