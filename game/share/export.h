// A pot as a file that others open: GLB for the web and museums, STL for 3D printers. Any thread but the
// haptic one (it allocates); gives bytes, engine/files puts them on a disk.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::share {

enum class ExportKind { kGlb, kStl };

// A pot of the cylindrical element method: elements of equal height, bottom first. It refers to radii that
// must outlive the call; clay::PaperClay gives both members.
struct PotShape {
    double height_mm = 0.0;
    std::span<const float> radii_mm;
};

// The clay of a shape: sum of pi R_i^2 H/N, mm^3.
[[nodiscard]] double clay_volume_mm3(const PotShape& shape);

// The kind that a path's ending names, in small or capital letters. kBadInput for any other, naming those
// known.
Result<ExportKind> export_kind_of(std::string_view path);

// The file's bytes, the same for the same shape on every machine. kBadInput if the shape is outside what a
// pot can be (see pot_mesh.h).
Result<std::vector<std::byte>> export_pot(const PotShape& shape, ExportKind kind);

}  // namespace onggi::share
