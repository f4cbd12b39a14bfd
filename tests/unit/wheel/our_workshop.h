// The photographed workshop that the house comes with.
#pragma once

#include <filesystem>

#include "tests/support/places.h"

namespace onggi::wheel {

inline const std::filesystem::path kOurs = test::in_checkout("assets/workshop");

}  // namespace onggi::wheel
