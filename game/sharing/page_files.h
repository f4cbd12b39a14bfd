// The files of a shared pot's folder: names and media types. Any thread; constant.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace onggi::sharing {

struct PageFile {
    std::string_view name;
    std::string_view media_type;
    bool has_twin = false;  // NAME.gz beside it has the same content compressed
    char counted = '\0';    // the event counted when a phone requests it whole: open_counter.h
};

// The files that a pot's folder may have and a phone may request; no other file is ever opened. Pages of
// languages are named CODE.html, such as ko.html. Empty for an unknown name.
[[nodiscard]] std::optional<PageFile> page_file(std::string_view name);

// The format of a picture from its first bytes: "png", "jpg" or "webp"; empty for others.
[[nodiscard]] std::string_view picture_ending(std::span<const std::byte> bytes);

constexpr std::string_view kTwinEnding = ".gz";
// The expiry note, for the server and the outbox: kept_note.h. Never served.
constexpr std::string_view kNoteName = ".kept";

}  // namespace onggi::sharing
