// Writes 3MF (3D Manufacturing Format, core specification 1.2), what slicers for 3D printers read besides
// STL: it says its unit, shares its corners and shows a picture. Any thread; touches no file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

struct ThreeMfWords {  // any bytes, made valid text
    std::string title;
    std::string description;  // for whoever prints it; empty: none
    std::string application;  // program and version
};

// Largest side of the picture in the file, pixels.
constexpr int kThumbnailSide = 256;

// One object of millimetres, +Z up as encode_stl(), on the build plate once. Vertices at one place
// become one, because the format joins triangles by number. `picture`, if any, becomes the package's
// thumbnail, made smaller where it is larger. The same input gives the same bytes. kBadInput as for
// encode_stl() and encode_png(); kFailed if the library fails.
Result<std::vector<std::byte>> encode_3mf(const Mesh& mesh, const ThreeMfWords& words,
                                          const Image* picture = nullptr);

}  // namespace onggi::asset
