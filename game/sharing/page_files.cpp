#include "game/sharing/page_files.h"

#include <algorithm>
#include <array>

#include "game/sharing/open_counter.h"

namespace onggi::sharing {
namespace {

constexpr std::string_view kHtml = "text/html; charset=utf-8";

constexpr char letter_of(ShareEvent event) {
    return static_cast<char>(event);
}

constexpr std::array<PageFile, 23> kFiles{{
    {"index.html", kHtml, true, letter_of(ShareEvent::kPageOpened)},
    {"page.css", "text/css; charset=utf-8", true},
    {"pot.js", "text/javascript; charset=utf-8", true},
    {"poster.png", "image/png"},
    {"poster.jpg", "image/jpeg"},
    {"poster.webp", "image/webp"},
    {"surface.png", "image/png"},
    {"surface.jpg", "image/jpeg"},
    {"surface.webp", "image/webp"},
    {"still.png", "image/png"},
    {"still.jpg", "image/jpeg"},
    {"still.webp", "image/webp"},
    {"pot.png", "image/png"},
    {"pot.jpg", "image/jpeg"},
    {"pot.glb", "model/gltf-binary", true, letter_of(ShareEvent::kModelTaken)},
    {"pot.usdz", "model/vnd.usdz+zip", false, letter_of(ShareEvent::kModelTaken)},
    {"pot.stl", "model/stl", true, letter_of(ShareEvent::kPrintTaken)},
    {"pot.3mf", "model/3mf", false, letter_of(ShareEvent::kPrintTaken)},
    {"pot.svg", "image/svg+xml", true},
    {"pot.pdf", "application/pdf"},
    {"pot.json", "application/json", true},
    {"film.webp", "image/webp", false, letter_of(ShareEvent::kFilmTaken)},
    {"film.mp4", "video/mp4", false, letter_of(ShareEvent::kFilmTaken)},
}};

// "ko.html", "zh-Hant.html".
bool is_language_page(std::string_view name) {
    constexpr std::string_view kEnding = ".html";
    if (!name.ends_with(kEnding)) return false;
    name.remove_suffix(kEnding.size());
    const auto fits = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '-';
    };
    return name.size() >= 2 && name.size() <= 12 && std::all_of(name.begin(), name.end(), fits);
}

}  // namespace

std::optional<PageFile> page_file(std::string_view name) {
    const auto* const found =
        std::find_if(kFiles.begin(), kFiles.end(), [&](const PageFile& file) { return file.name == name; });
    if (found != kFiles.end()) return *found;
    if (is_language_page(name)) return PageFile{name, kHtml, true};
    return std::nullopt;
}

std::string_view picture_ending(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return "png";
    if (text.starts_with("\xff\xd8\xff")) return "jpg";
    if (text.starts_with("RIFF") && text.size() >= 12 && text.substr(8, 4) == "WEBP") return "webp";
    return {};
}

}  // namespace onggi::sharing
