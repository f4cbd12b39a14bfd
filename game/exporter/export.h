// A pot as a file that others open: GLB for the web and museums, STL and 3MF for 3D printers. Any thread but
// the haptic one (it allocates); gives bytes, engine/files puts them on a disk.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/asset/gltf.h"
#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/exporter/pot_rings.h"

namespace onggi::exporter {

enum class ExportKind { kGlb, kStl, k3mf };

// The kind that a path's ending names, in small or capital letters. kBadInput for any other, naming those
// known.
Result<ExportKind> export_kind_of(std::string_view path);

// What stands in a file beside the mesh.
struct PotFile {
    std::string title{};  // of the STL's header and the 3MF
    std::string note{};   // of the 3MF: what whoever prints it should know; empty: nothing
    asset::Material material{};
    std::vector<asset::Extra> extras{};
    double shrinkage = 1.0;                 // what every length is times
    const asset::Image* picture = nullptr;  // of the 3MF
};

// Below it printing services, and slicers' usual settings, print no wall that holds.
constexpr double kThinnestPrintedMm = 2.0;
// What to say of a pot whose walls are that thin at the size of the file: nothing where they are thick
// enough.
[[nodiscard]] std::string printing_note(double thinnest_wall_mm);

// A pot's mesh as a GLB that says who made it.
Result<std::vector<std::byte>> glb_of(asset::Mesh mesh, asset::Material material,
                                      std::vector<asset::Extra> extras);

// The file's bytes, the same for the same rings on every machine. kBadInput as build_pot_solid().
Result<std::vector<std::byte>> export_pot(const PotRings& rings, ExportKind kind, PotFile file);
// A pot of stoneware of which only the shape is known: the paper's clay.
Result<std::vector<std::byte>> export_pot(const PotRings& rings, ExportKind kind,
                                          const asset::Image* picture = nullptr);

}  // namespace onggi::exporter
