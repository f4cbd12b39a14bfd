// The page of a shared pot: static HTML in one language, with links to the others, the picture and the files.
// It works without a script and asks no other host for anything. And the two pages that are no pot's. Any
// thread; pure.
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

// Text made fit to stand in HTML, between tags or between double quotes. Whatever it is, it opens no tag,
// ends no attribute and is UTF-8: what is not, and control characters but the end of a line, become U+FFFD.
[[nodiscard]] std::string html(std::string_view text);

// lang="ko" dir="ltr"
[[nodiscard]] std::string language_attributes(std::string_view code, bool right_to_left);

// A pot's outline as the page has it: numbers for the script that draws the pot, and a drawn shape.

// "50,0 54.2,5 ..." radius and height, mm to a tenth; at most 160 points, the first and the last among them.
// What is not finite or beyond two metres ends it.
[[nodiscard]] std::string outline_numbers(std::span<const OutlinePoint> outline);

// Two pots on one board at one scale, as SVG without words: ours, and the museum's after it.
[[nodiscard]] std::string two_pots_svg(std::span<const OutlinePoint> ours,
                                       std::span<const OutlinePoint> nearest);

// What the page's links name: files that lie beside it; empty: there is none.
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
    std::string gone_at;     // "18:00" where it goes today, else "2026-11-25, 18:00"
    bool is_gone_today;      //
    bool own_digits = true;  // Arabic-Indic ones in Arabic
    std::string page_url;    // "https://host/K73FQ9TX/"; without https: no augmented reality
};

[[nodiscard]] std::string phone_page(const PageFacts& facts);

// What the browser is told to allow, for the header and for a server that sends none: only what lies beside.
constexpr std::string_view kPagePolicy =
    "default-src 'none'; img-src 'self' data:; style-src 'self'; script-src 'self'; base-uri 'none'; "
    "form-action 'self'";

// The two pages that are no pot's: what stands where there is none, and where a code is typed. In all
// languages at once, the one that is liked best first; they bring their look along.

// For a code that is none, is over or was withdrawn: nobody can tell which.
[[nodiscard]] std::string lost_page(const std::vector<kiosk::Language>& languages, std::size_t first);

// At the address that the wheel shows, for those without a camera. With a house's own web server its script
// finds the pot; ours does so without.
[[nodiscard]] std::string ask_page(const std::vector<kiosk::Language>& languages, std::size_t first);

// What that script is: a file beside the page.
[[nodiscard]] std::string_view ask_script();

constexpr std::string_view kPlainPolicy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'self'; base-uri 'none'; "
    "form-action 'self'";

}  // namespace onggi::sharing
