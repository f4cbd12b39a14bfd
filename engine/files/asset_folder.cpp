#include "engine/files/asset_folder.h"

#include <fmt/format.h>

#include <cstdlib>

#include "engine/files/file_errors.h"

namespace onggi::files {

AssetPlaces asset_places() {
    const char* chosen = std::getenv("ONGGI_ASSETS");
    std::error_code error;
    return {.chosen = chosen == nullptr ? "" : chosen,
            .program = std::filesystem::read_symlink("/proc/self/exe", error)};
}

Result<std::filesystem::path> find_asset(const std::string& part, const AssetPlaces& places) {
    std::error_code error;
    if (!places.chosen.empty()) {
        const std::filesystem::path found = std::filesystem::path(places.chosen) / part;
        if (std::filesystem::exists(found, error)) return found;
        return bad_input(fmt::format("ONGGI_ASSETS: expected a folder with {} in it, found none at {}", part,
                                     shown(found)));
    }
    // build/PRESET/tests/PROGRAM is the deepest location of a program in the source tree.
    constexpr int kMostFolders = 4;
    std::filesystem::path folder = places.program.parent_path();
    for (int up = 0; up < kMostFolders && !folder.empty(); ++up) {
        for (const char* name : {"share/onggi", "assets"}) {
            std::filesystem::path found = folder / name / part;
            if (std::filesystem::exists(found, error)) return found;
        }
        if (folder == folder.parent_path()) break;
        folder = folder.parent_path();
    }
    return system_lacks(
        fmt::format("{}: expected it in share/onggi or assets beside the program or above it, found "
                    "neither; set ONGGI_ASSETS to the folder that holds it",
                    part));
}

}  // namespace onggi::files
