// Reads the table of allowed includes, and finds violations in a file's text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::house {

struct IncludeRules {
    struct Rule {
        std::string subject;              // a room, an include prefix or a word
        std::vector<std::string> places;  // "engine/*" stands for every room below it
    };
    std::vector<Rule> rooms;
    std::vector<Rule> parties;
    std::vector<Rule> words;
};

Result<IncludeRules> parse_include_rules(std::string_view text);

// One line per violation: path, line number, what was found and what is allowed. `path` is relative to the
// repository's root.
std::vector<std::string> violations(const IncludeRules& rules, std::string_view path, std::string_view text);

}  // namespace onggi::house
