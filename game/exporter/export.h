// A pot as a file for other programs: GLB for the web and museums, STL and 3MF for 3D printers. Any thread
// but the haptic one (it allocates). Returns bytes; engine/files writes them to disk.
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

// The kind for a path's extension, in any case. kBadInput for any other extension, listing the known ones.
Result<ExportKind> export_kind_of(std::string_view path);

// Contents of a file besides the mesh.
struct PotFile {
    std::string title{};  // for the STL's header and the 3MF
    std::string note{};   // for the 3MF: advice on printing; may be empty
    asset::Material material{};
    std::vector<asset::Extra> extras{};
    double shrinkage = 1.0;                 // factor on every length
    const asset::Image* picture = nullptr;  // thumbnail of the 3MF
};

// Thinner walls break in prints of services and of slicers' usual settings.
constexpr double kThinnestPrintedMm = 2.0;
// The note for a pot with walls that thin at the file's size; empty if they are thick enough.
[[nodiscard]] std::string printing_note(double thinnest_wall_mm);

// A pot's mesh as a GLB with this program as its generator.
Result<std::vector<std::byte>> glb_of(asset::Mesh mesh, asset::Material material,
                                      std::vector<asset::Extra> extras);

// The file's bytes, the same for the same rings on every machine. kBadInput: see build_pot_solid().
Result<std::vector<std::byte>> export_pot(const PotRings& rings, ExportKind kind, PotFile file);
// Exports a shape without other data as stoneware: the paper's clay.
Result<std::vector<std::byte>> export_pot(const PotRings& rings, ExportKind kind,
                                          const asset::Image* picture = nullptr);

}  // namespace onggi::exporter
