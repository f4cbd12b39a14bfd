// A 3MF file read back: by lib3mf, strictly, and as the ZIP archive that it is.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "tests/support/mesh_check.h"

namespace onggi::support {

struct ThreeMfFile {
    SolidMesh mesh;  // turned back to metres and +Y up; without normals of its own, so each is zero
    std::map<std::string, std::string> words;  // metadata by name
    std::vector<std::byte> thumbnail;          // empty: no thumbnail
    bool is_millimetres = false;
    bool is_manifold = false;  // by the library: closed and oriented
    int objects = 0;
    int items = 0;  // on the build plate
};

// kBadInput: what the library refuses, and what it only warns of.
Result<ThreeMfFile> read_3mf(std::span<const std::byte> bytes);

// The parts of a ZIP archive by their names, unpacked. Throws std::runtime_error where it is none.
std::map<std::string, std::string> zip_parts(std::span<const std::byte> bytes);

}  // namespace onggi::support
