// What is not known is null in what the program writes as JSON.
#pragma once

#include <optional>

namespace onggi::app {

// Json: nlohmann's, whose order of fields is the caller's affair.
template <typename Json, typename T>
[[nodiscard]] Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

}  // namespace onggi::app
