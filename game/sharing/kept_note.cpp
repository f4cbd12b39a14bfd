#include "game/sharing/kept_note.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/number_in.h"

namespace onggi::sharing {
namespace {

// Takes the next line if it begins with `word`. Returns the rest of that line; empty otherwise.
std::optional<std::string_view> take_line(std::string_view& text, std::string_view word) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos || !text.starts_with(word)) return std::nullopt;
    const std::string_view rest = text.substr(word.size(), end - word.size());
    text.remove_prefix(end + 1);
    return rest;
}

// The largest setting and an hour.
constexpr std::int64_t kLongestStayS = (std::int64_t{168} + 1) * 3600;

std::optional<std::int64_t> seconds(std::optional<std::string_view> text) {
    return text ? number_in<std::int64_t>(*text) : std::nullopt;
}

}  // namespace

bool is_over(const KeptNote& note, std::int64_t now_s) {
    if (redated(note, now_s)) return false;
    if (note.expires_s <= now_s) return true;
    return now_s >= kClockIsSetS && note.expires_s - now_s > kLongestStayS;
}

std::optional<KeptNote> redated(const KeptNote& note, std::int64_t now_s) {
    if (note.made_s >= kClockIsSetS || now_s < kClockIsSetS) return std::nullopt;
    // A damaged note may have any number.
    if (note.expires_s < note.made_s || note.expires_s > note.made_s + kLongestStayS) return std::nullopt;
    return KeptNote{now_s, now_s + (note.expires_s - note.made_s), note.gallery_name};
}

std::string written(const KeptNote& note) {
    std::string name = note.gallery_name.substr(0, kMostNoteBytes / 2);
    std::replace(name.begin(), name.end(), '\n', ' ');
    return fmt::format("made {}\nexpires {}\nname {}\n", note.made_s, note.expires_s, name);
}

std::optional<KeptNote> read_note(std::string_view text) {
    if (text.size() > kMostNoteBytes) return std::nullopt;
    const auto made = seconds(take_line(text, "made "));
    const auto expires = seconds(take_line(text, "expires "));
    const auto name = take_line(text, "name ");
    if (!made || !expires || !name || !text.empty()) return std::nullopt;
    return KeptNote{*made, *expires, std::string(*name)};
}

}  // namespace onggi::sharing
