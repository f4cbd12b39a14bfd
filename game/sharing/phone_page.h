// The page of a shared pot: static HTML in one language, with links to the other languages, the picture and
// the files. It works without a script and loads nothing from other hosts. Also the two pages without a pot.
// Any thread; pure.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/kiosk/strings.h"
#include "game/sharing/share_code.h"
#include "game/sharing/shared_pot.h"

namespace onggi::sharing {

// Escapes text for HTML, between tags or between double quotes. Any input is safe: the result opens no tag,
// ends no attribute and is UTF-8. Invalid bytes, and control characters except line ends, become U+FFFD.
[[nodiscard]] std::string html(std::string_view text);

// lang="ko" dir="ltr"
[[nodiscard]] std::string language_attributes(std::string_view code, bool right_to_left);

// A pot's outline on the page: as numbers for the script that draws the pot, and as SVG.

// "50,0 54.2,5 ...": radius and height, mm to a tenth; up to 160 points, including the first and the last.
// Stops at the first value that is not finite or exceeds two metres.
[[nodiscard]] std::string outline_numbers(std::span<const OutlinePoint> outline);

// "0,12,-3 840,60,-3 ...": height and centre in whole twentieths of a millimetre; the points that an axis
// within a twentieth of a millimetre needs.
[[nodiscard]] std::string axis_numbers(std::span<const AxisPoint> axis);

// "0,0,5 0,-2,5 ...": rows of dents in whole twentieths of a millimetre.
[[nodiscard]] std::string dent_numbers(std::span<const std::vector<double>> rows_mm);

// Two pots on one board, as SVG without text: ours, then the museum's. At one scale, unless the museum's
// would then be the larger picture.
struct TwoPots {
    std::string svg{};         // empty if an outline has less than two points
    double times_as_tall = 0;  // the museum's pot; 0: both are at one scale
};
[[nodiscard]] TwoPots two_pots(std::span<const OutlinePoint> ours, std::span<const OutlinePoint> nearest);

// Targets of the page's links: files beside it; empty if missing.
struct PageLinks {
    std::string poster{};
    std::string picture{};
    std::string surface{};
    std::string film_still{};
};

struct PageFacts {
    const SharedPot& pot;
    const std::vector<kiosk::Language>& languages;
    std::size_t language;  // of this page
    const ShareCode& code;
    PageLinks links;
    std::string gone_at;     // "18:00" for today, else "2026-11-25, 18:00"
    bool is_gone_today;      //
    bool own_digits = true;  // Arabic-Indic digits in Arabic
    std::string page_url;    // "https://host/K73FQ9TX/"; without https the page has no augmented reality
};

[[nodiscard]] std::string phone_page(const PageFacts& facts);

// The page's content security policy, for the header and for a server that sends none: allows only files
// beside the page.
constexpr std::string_view kPagePolicy =
    "default-src 'none'; img-src 'self' data:; media-src 'self'; connect-src 'self'; style-src 'self'; "
    "script-src 'self'; base-uri 'none'; form-action 'self'";

// The two pages without a pot: for an unknown code, and to type a code. Each has all languages, the preferred
// one first, and embeds its style.

// For a code that never existed, has expired or was withdrawn: the server cannot tell these apart.
[[nodiscard]] std::string lost_page(const std::vector<kiosk::Language>& languages, std::size_t first);

// At the address that the wheel shows, for phones without a camera. On the museum's own web server the page's
// script finds the pot; our server does so without it.
[[nodiscard]] std::string ask_page(const std::vector<kiosk::Language>& languages, std::size_t first);

// The content of that script, a file beside the page.
[[nodiscard]] std::string_view ask_script();

constexpr std::string_view kPlainPolicy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'self'; base-uri 'none'; "
    "form-action 'self'";

}  // namespace onggi::sharing
