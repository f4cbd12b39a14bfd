// Writes binary STL, the triangles that slicers for 3D printers read. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

// STL has no unit and no up axis; slicers assume mm and +Z up, so (x, y, z) m becomes (x, -z, y) mm. Vertices
// at the same position stay bit-equal, and -0 is never written, because checkers join triangles by comparing
// bits. `title` goes into the 80-byte header, truncated to fit. kBadInput as for encode_glb, and if a
// triangle has no area.
Result<std::vector<std::byte>> encode_stl(const Mesh& mesh, std::string_view title);

}  // namespace onggi::asset
