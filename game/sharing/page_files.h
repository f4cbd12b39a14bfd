// The files of a shared pot's folder: what each is called, what the web calls its kind. Any thread; constant.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace onggi::sharing {

struct PageFile {
    std::string_view name;
    std::string_view media_type;
    bool has_twin = false;  // NAME.gz beside it, the same packed
    char counted = '\0';    // what the counter says when a phone asks for it: open_counter.h
};

// What may lie in a pot's folder and be asked for; nothing else is ever opened. Pages of languages are called
// CODE.html, such as ko.html. None: no such file.
[[nodiscard]] std::optional<PageFile> page_file(std::string_view name);

// What the bytes of a picture begin as: "png", "jpg" or "webp"; empty: none of them.
[[nodiscard]] std::string_view picture_ending(std::span<const std::byte> bytes);

constexpr std::string_view kTwinEnding = ".gz";
// Says when the pot goes, for the server and the outbox: kept_note.h. Never served.
constexpr std::string_view kNoteName = ".kept";

}  // namespace onggi::sharing
