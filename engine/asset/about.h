// What a file says about itself, the same in every format: Dublin Core terms (ISO 15836) as an XMP packet
// (ISO 16684-1) in PNG, WebP, MP4 and SVG, as KHR_xmp_json_ld in glTF, as metadata in 3MF. Any thread; pure.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace onggi::asset {

// A text in one language, by its tag (BCP 47). Any bytes, made valid UTF-8.
struct Wording {
    std::string language;
    std::string text;

    friend bool operator==(const Wording&, const Wording&) = default;
};
using Wordings = std::vector<Wording>;  // the first is the default; empty: not stated

struct About {
    Wordings title{};
    Wordings description{};
    Wordings rights{};  // the licence
    Wordings publisher{};
    std::string date{};        // "2026-11-28"; empty terms are left out
    std::string identifier{};  // of the source
    std::string relation{};    // a related object
    std::string tool{};        // program and version

    [[nodiscard]] bool is_empty() const { return title.empty(); }
    [[nodiscard]] bool has_rights() const { return !rights.empty() || !publisher.empty(); }
    // "House of Glass. CC BY 4.0", in the default language.
    [[nodiscard]] std::string copyright() const;

    friend bool operator==(const About&, const About&) = default;
};

// The text in the default language, or nothing.
[[nodiscard]] std::string first_of(const Wordings& wordings);
// Each text once, in order: a bag of names has no languages.
[[nodiscard]] std::vector<std::string> texts_of(const Wordings& wordings);

// A whole, read-only XMP packet.
[[nodiscard]] std::string xmp_packet(const About& about);

// A PNG, WebP, MP4 or SVG file with what it says about itself. kBadInput: another format, or a damaged file.
[[nodiscard]] Result<std::vector<std::byte>> picture_about(std::span<const std::byte> picture,
                                                           const About& about);

}  // namespace onggi::asset
