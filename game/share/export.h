// A pot as a file that others open: GLB for the web and museums, STL for 3D printers. Any thread but the
// haptic one (it allocates); gives bytes, engine/files puts them on a disk.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/asset/gltf.h"
#include "engine/core/result.h"
#include "game/share/pot_rings.h"

namespace onggi::share {

enum class ExportKind { kGlb, kStl };

// The kind that a path's ending names, in small or capital letters. kBadInput for any other, naming those
// known.
Result<ExportKind> export_kind_of(std::string_view path);

// What stands in a file beside the mesh.
struct PotFile {
    std::string title{};  // of the STL's header
    asset::Material material{};
    std::vector<asset::Extra> extras{};
    double shrinkage = 1.0;  // what every length is times
};
// The file's bytes, the same for the same rings on every machine. kBadInput as build_pot_solid().
Result<std::vector<std::byte>> export_pot(const PotRings& rings, ExportKind kind, PotFile file);
// A pot of stoneware of which only the shape is known: the paper's clay.
Result<std::vector<std::byte>> export_pot(const PotRings& rings, ExportKind kind);

}  // namespace onggi::share
