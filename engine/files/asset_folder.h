// Finds the program's assets: pictures, rooms, sounds, texts. Any thread but the haptic one; blocks.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::files {

// The inputs of the search, which tests can set.
struct AssetPlaces {
    std::string chosen;             // the folder that the user chose; empty if none was chosen
    std::filesystem::path program;  // the program's own file, absolute
};
// $ONGGI_ASSETS, and the file that is running.
[[nodiscard]] AssetPlaces asset_places();

// Finds `part` (a folder or file of the assets, such as "workshop"): in the chosen folder only, if the user
// chose one; otherwise in share/onggi or assets beside the program's folder or above it, the nearest first.
// That covers an installed program (bin/onggi, share/onggi) and a build folder inside the source tree.
// Errors: bad input if the chosen folder has no such part; system lacks if none is found.
[[nodiscard]] Result<std::filesystem::path> find_asset(const std::string& part,
                                                       const AssetPlaces& places = asset_places());

}  // namespace onggi::files
