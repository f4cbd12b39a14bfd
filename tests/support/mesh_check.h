// Checks that a file is a sound solid. Reads GLB and STL with readers that share no code with the writers,
// and looks for faults that a format validator misses: the Khronos validator finds nothing wrong with a pot
// turned inside out. Any thread.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/math/math.h"

namespace onggi::support {

// Metres, +Y up, whatever the file's own unit and axes. Values are exactly those of the file's floats.
struct SolidMesh {
    std::vector<dvec3> positions_m;
    std::vector<dvec3> normals;  // one a position
    std::vector<std::uint32_t> indices;
};

struct GlbFile {
    nlohmann::json json;
    SolidMesh mesh;
    dvec3 stated_min_m{0.0};  // the POSITION accessor's own bounds
    dvec3 stated_max_m{0.0};
    std::uint32_t index_bytes = 0;  // 2 or 4
};

// Reads a GLB with one mesh of one indexed triangle primitive. Error: kBadInput with the fault.
Result<GlbFile> read_glb(std::span<const std::byte> bytes);

// Binary STL, mm, +Z up, turned back to +Y up. Corners at bit-equal positions with bit-equal normals become
// one vertex.
Result<SolidMesh> read_stl(std::span<const std::byte> bytes);

struct ExpectedPot {
    double volume_m3 = 0.0;
    double height_m = 0.0;
    double max_radius_m = 0.0;
    double volume_tolerance = 1e-3;      // relative
    double radius_tolerance_m = 2e-5;    // of the largest radius
    double min_normal_agreement = 0.93;  // cosine between a vertex's normal and each of its faces'
    int euler = 2;                       // V - E + F: 0 for a tube, 2 more for each closed hollow
    int parts = 1;
    double off_axis_m = 0.0;  // allowed distance of the centre from the axis
};

// Returns one sentence per fault, at most one of each kind; empty for a sound pot. Checks: no unreferenced
// vertex, no degenerate triangle, each directed edge once and its opposite once (by position, bit for bit),
// the parts, V - E + F, faces outward, the volume, unit normals that agree with the faces, base at y = 0, the
// height, the largest radius, the axis.
std::vector<std::string> find_faults(const SolidMesh& mesh, const ExpectedPot& expected);

// Divergence theorem; negative for a solid turned inside out.
[[nodiscard]] double signed_volume_m3(const SolidMesh& mesh);

}  // namespace onggi::support
