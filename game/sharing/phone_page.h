// The page of a shared pot: static HTML in one language, with links to the others, the picture and the files.
// It works without a script and asks no other host for anything. Any thread; pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "game/kiosk/strings.h"
#include "game/sharing/share_code.h"
#include "game/sharing/shared_pot.h"

namespace onggi::sharing {

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

}  // namespace onggi::sharing
