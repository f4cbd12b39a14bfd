// Writes unknown values as null in the program's JSON.
#pragma once

#include <optional>

namespace onggi::app {

// Json: nlohmann's ordered or unordered type.
template <typename Json, typename T>
[[nodiscard]] Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

}  // namespace onggi::app
