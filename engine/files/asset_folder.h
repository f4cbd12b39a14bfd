// Where the program finds what it brings with it: pictures, rooms, sounds, texts. Any thread but the haptic
// one; blocks.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::files {

// What decides it, so that tests can ask for any machine.
struct AssetPlaces {
    std::string chosen;             // what the user asked for; empty: nothing
    std::filesystem::path program;  // the program's own file, absolute
};
// $ONGGI_ASSETS, and the file that is running.
[[nodiscard]] AssetPlaces asset_places();

// The folder that holds `part` (a folder or file in it, such as "workshop"): the one chosen, and no other, if
// the user chose one; else share/onggi or assets beside the program's folder or above it, the nearest first.
// That finds an installed program's (bin/onggi, share/onggi) as well as a build folder's inside the source
// tree. Bad input if the chosen folder has no such part; system lacks where none is found.
[[nodiscard]] Result<std::filesystem::path> find_asset(const std::string& part,
                                                       const AssetPlaces& places = asset_places());

}  // namespace onggi::files
