// Writes 3MF (3D Manufacturing Format, core specification 1.2), which slicers for 3D printers read besides
// STL: it has a unit, shared vertices and a thumbnail. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

struct ThreeMfWords {  // any bytes, converted to valid text
    std::string title;
    std::string description;  // for the person who prints it; empty: omitted
    std::string application;  // program and version
    // Of the same name in the specification; empty: omitted.
    std::string copyright{};
    std::string licence_terms{};
    std::string creation_date{};  // "2026-11-28"
};

// Largest side of the picture in the file, pixels.
constexpr int kThumbnailSide = 256;

// Writes one object in millimetres, +Z up as encode_stl(), placed once on the build plate. Vertices at the
// same position are merged, because the format joins triangles by vertex index. `picture`, if any, becomes
// the package's thumbnail, scaled down if it is larger. The same input gives the same bytes. kBadInput as for
// encode_stl() and encode_png(); kFailed if the library fails.
Result<std::vector<std::byte>> encode_3mf(const Mesh& mesh, const ThreeMfWords& words,
                                          const Image* picture = nullptr);

}  // namespace onggi::asset
