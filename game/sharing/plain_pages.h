// The two pages that are no pot's: what stands where there is none, and where a code is typed. In all
// languages at once, the one that is liked best first; they bring their look along. Any thread; pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "game/kiosk/strings.h"

namespace onggi::sharing {

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
