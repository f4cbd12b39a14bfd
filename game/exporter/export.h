// A pot as files for other programs: GLB for the web and museums, USDZ for iPhones, STL and 3MF for 3D
// printers. pot_file() makes the solid and the data about it, encode_pot() the bytes of each format;
// engine/files writes them to disk. Any thread but the haptic one (it allocates).
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

enum class ExportKind { kGlb, kStl, k3mf, kUsdz };

// The kind for a path's extension, in any case. kBadInput for any other extension, listing the known ones.
Result<ExportKind> export_kind_of(std::string_view path);

// What a file says of its pot besides the measures; no word about the visitor.
struct PotStory {
    asset::About about{};                // without a title: the pot is named after its clay
    std::vector<asset::Extra> extras{};  // after the measures
};

struct PotFile {
    asset::GltfContent content;  // the solid; material and extras are for GLB and USDZ
    std::string title{};         // for the STL's header and the 3MF
    std::string note{};          // for the 3MF: advice on printing; may be empty
};

// Thinner walls break in prints of services and of slicers' usual settings.
constexpr double kThinnestPrintedMm = 2.0;
// The side of the cube that small home printers fill (Bambu A1 mini, Prusa MINI+): a larger pot is scaled
// down to fit.
constexpr double kPrintedSideMm = 180.0;
// The note for a pot whose walls are thin at the size at which it is printed, with the size from which they
// are thick enough; empty if they are thick enough. mm, at the file's size.
[[nodiscard]] std::string printing_note(double thinnest_wall_mm, double height_mm, double width_mm);

// This program as the generator of a pot's mesh. The story's title names the pot, or else `name`.
[[nodiscard]] asset::GltfContent pot_content(std::string name, asset::Mesh mesh, asset::Material material,
                                             std::vector<asset::Extra> measures, PotStory story = {});
// The program and its version, as files name their maker.
[[nodiscard]] std::string_view program_name();

// A shape without other data, as stoneware: the paper's clay. kBadInput: see build_pot_solid().
Result<PotFile> pot_file(const PotRings& rings);

// The bytes, the same for the same pot on every machine. `picture` may be null; it becomes the 3MF's
// thumbnail. Errors: that of `file`, or those of the format's encoder.
Result<std::vector<std::byte>> encode_pot(const Result<PotFile>& file, ExportKind kind,
                                          const asset::Image* picture = nullptr);

}  // namespace onggi::exporter
