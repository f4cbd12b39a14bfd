// Whole numbers in JSON that anybody may have edited.
#pragma once

#include <algorithm>
#include <limits>

namespace onggi::app {

// As value.get<Number>(), which is undefined for a fraction, or a number of many digits, outside Number.
// Throws Json::exception for it, and for anything but a number. Json: as for or_null().
template <typename Number, typename Json>
[[nodiscard]] Number whole_number(const Json& value) {
    if (value.is_number_float()) {
        constexpr double kMostExact = 9007199254740992.0;  // 2^53: beyond it a double skips whole numbers
        using Limits = std::numeric_limits<Number>;
        const auto number = value.template get<double>();
        const bool is_within = number >= std::max(static_cast<double>(Limits::min()), -kMostExact) &&
                               number <= std::min(static_cast<double>(Limits::max()), kMostExact);
        if (!is_within) throw Json::other_error::create(501, "expected a smaller whole number", nullptr);
    }
    return value.template get<Number>();
}

}  // namespace onggi::app
