// See stl.h. Any thread.
#include "engine/asset/stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "engine/asset/mesh_rules.h"

namespace onggi::asset {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;  // normal, three vertices, 16 zero bits
constexpr std::string_view kHeaderStart = "Binary STL, mm, Z up: ";

void append_word(std::vector<std::byte>& bytes, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(std::byte{static_cast<unsigned char>(word >> shift)});
}

void append_vector(std::vector<std::byte>& bytes, const vec3& v) {
    // Adding +0 turns a normal's -0 into +0 and changes nothing else.
    for (const float number : {v.x, v.y, v.z})
        append_word(bytes, std::bit_cast<std::uint32_t>(number + 0.0F));
}

// A header that starts with "solid" would mark a text STL.
void append_header(std::vector<std::byte>& bytes, std::string_view title) {
    std::array<char, kStlHeaderBytes> header{};
    const auto end = std::copy(kHeaderStart.begin(), kHeaderStart.end(), header.begin());
    const auto room = static_cast<std::size_t>(header.end() - end);
    title = title.substr(0, room);
    std::transform(title.begin(), title.end(), end, [](char c) { return c >= ' ' && c <= '~' ? c : '?'; });
    const auto raw = std::as_bytes(std::span(header));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

}  // namespace

Result<std::vector<std::byte>> encode_stl(const Mesh& mesh, std::string_view title) {
    if (const Result<void> good = check_mesh(mesh); !good) return good.error();

    std::vector<std::byte> bytes;
    bytes.reserve(kStlHeaderBytes + 4 + mesh.triangle_count() * kTriangleBytes);
    append_header(bytes, title);
    append_word(bytes, static_cast<std::uint32_t>(mesh.triangle_count()));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = z_up_mm(mesh.positions_m[mesh.indices[i + k]]);
        // In double: the cross product of thin triangles loses its direction in float.
        const dvec3 a(corners[0]);
        const dvec3 across = glm::cross(dvec3(corners[1]) - a, dvec3(corners[2]) - a);
        const double doubled_area_mm2 = glm::length(across);
        if (!(doubled_area_mm2 > 0.0)) {
            return bad_input(fmt::format("mesh: triangle {}: expected an area above zero", i / 3));
        }
        append_vector(bytes, vec3(across / doubled_area_mm2));
        for (const vec3& corner : corners)
            append_vector(bytes, corner);
        bytes.insert(bytes.end(), 2, std::byte{0});
    }
    return bytes;
}

}  // namespace onggi::asset
