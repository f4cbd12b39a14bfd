// Language tags such as "ko", "ar-EG" and "zh-Hans" (BCP 47, RFC 5646). Any thread; pure.
#pragma once

#include <string_view>

namespace onggi {

// The language in any script and country: "zh" of "zh-Hans".
[[nodiscard]] constexpr std::string_view primary_language(std::string_view tag) {
    return tag.substr(0, tag.find('-'));
}

}  // namespace onggi
