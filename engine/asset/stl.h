// Writes binary STL, the triangles that slicers for 3D printers read. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

// STL knows no unit and no axis; printers' programs take mm and +Z up, so that is what is written: (x, y, z)
// m becomes (x, -z, y) mm. Vertices at one place in the mesh stay bit-equal, and no zero is negative, because
// checkers join triangles by comparing bits. `title` goes into the 80-byte header, cut to fit. kBadInput as
// for encode_glb, and if a triangle has no area.
Result<std::vector<std::byte>> encode_stl(const Mesh& mesh, std::string_view title);

}  // namespace onggi::asset
