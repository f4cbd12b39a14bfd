#include "tests/house/include_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace onggi::house {
namespace {

bool is_in(std::string_view path, std::string_view place) {
    if (place.ends_with("/*")) return path.starts_with(place.substr(0, place.size() - 1));
    return path == place ||
           (path.starts_with(place) && path.size() > place.size() && path[place.size()] == '/');
}

bool is_in_any(std::string_view path, const std::vector<std::string>& places) {
    return std::any_of(places.begin(), places.end(),
                       [&](const std::string& place) { return is_in(path, place); });
}

// The name between quotes or angle brackets of an include line; empty for any other line.
std::string_view included_name(std::string_view line) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string_view::npos || line[hash] != '#') return {};
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string_view::npos || !line.substr(word).starts_with("include")) return {};
    const std::size_t open = line.find_first_of("\"<", word);
    const std::size_t close = open == std::string_view::npos ? open : line.find_first_of("\">", open + 1);
    if (close == std::string_view::npos) return {};
    return line.substr(open + 1, close - open - 1);
}

std::string refusal_of_include(const IncludeRules& rules, std::string_view path, std::string_view name) {
    const bool is_test = is_in(path, "tests");
    const bool is_ours = name.starts_with("engine/") || name.starts_with("game/") ||
                         name.starts_with("tests/") || name.starts_with("shaders/");
    if (is_ours) {
        const auto room = std::find_if(rules.rooms.begin(), rules.rooms.end(),
                                       [&](const auto& rule) { return is_in(path, rule.subject); });
        if (room == rules.rooms.end()) return "stands in a room that the table does not know";
        if (is_in(name, room->subject) || is_in_any(name, room->places)) return {};
        return fmt::format("{} may not include {}", room->subject, name);
    }
    if (is_test) return {};
    for (const auto& party : rules.parties) {
        const bool is_prefix = party.subject.ends_with('/');
        if (is_prefix ? !name.starts_with(party.subject) : name != party.subject) continue;
        if (is_in_any(path, party.places)) return {};
        return fmt::format("<{}> belongs in {}", name, fmt::join(party.places, ", "));
    }
    return {};
}

}  // namespace

Result<IncludeRules> parse_include_rules(std::string_view text) {
    IncludeRules rules;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.empty() || line.front() == '#') continue;
        const std::size_t colon = line.rfind(':') == line.size() - 1 ? line.size() - 1 : line.rfind(": ");
        std::istringstream head(line.substr(0, colon));
        std::string kind;
        IncludeRules::Rule rule;
        head >> kind >> rule.subject;
        auto* list = kind == "room"    ? &rules.rooms
                     : kind == "party" ? &rules.parties
                     : kind == "word"  ? &rules.words
                                       : nullptr;
        if (colon == std::string::npos || list == nullptr || rule.subject.empty()) {
            return bad_input(
                fmt::format("line {}: expected 'room|party|word NAME: PLACES', found '{}'", number, line));
        }
        std::istringstream places(line.substr(colon + 1));
        for (std::string place; places >> place;)
            rule.places.push_back(place);
        list->push_back(std::move(rule));
    }
    return rules;
}

std::vector<std::string> violations(const IncludeRules& rules, std::string_view path, std::string_view text) {
    std::vector<std::string> found;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const std::string_view name = included_name(line);
        if (!name.empty()) {
            const std::string refusal = refusal_of_include(rules, path, name);
            if (!refusal.empty()) found.push_back(fmt::format("{}:{}: {}", path, number, refusal));
        }
        for (const auto& word : rules.words) {
            if (line.find(word.subject) == std::string::npos || !is_in_any(path, word.places)) continue;
            found.push_back(fmt::format("{}:{}: '{}' may not stand here", path, number, word.subject));
        }
    }
    return found;
}

}  // namespace onggi::house
