// Text made fit to stand in HTML, between tags or between double quotes. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace onggi::sharing {

// Whatever it is, it opens no tag, ends no attribute and is UTF-8: what is not, and control characters but
// the end of a line, become U+FFFD.
[[nodiscard]] std::string html(std::string_view text);

// lang="ko" dir="ltr"
[[nodiscard]] std::string language_attributes(std::string_view code, bool right_to_left);

}  // namespace onggi::sharing
