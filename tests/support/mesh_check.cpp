// See mesh_check.h. Any thread.
#include "tests/support/mesh_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace onggi::support {
namespace {

using Bits = std::array<std::uint64_t, 3>;

Bits bits_of(const dvec3& v) {
    return {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y),
            std::bit_cast<std::uint64_t>(v.z)};
}

// Vertices numbered by place: those at bit-equal positions share a number.
struct Welded {
    std::vector<std::uint32_t> place_of_vertex;
    std::size_t place_count = 0;
};

Welded weld(const SolidMesh& mesh) {
    Welded welded;
    std::map<Bits, std::uint32_t> places;
    for (const dvec3& position : mesh.positions_m) {
        const auto number = static_cast<std::uint32_t>(places.size());
        welded.place_of_vertex.push_back(places.try_emplace(bits_of(position), number).first->second);
    }
    welded.place_count = places.size();
    return welded;
}

struct Corners {
    std::array<std::uint32_t, 3> vertex;
    std::array<dvec3, 3> at;

    [[nodiscard]] dvec3 doubled_area() const { return glm::cross(at[1] - at[0], at[2] - at[0]); }
};

Corners corners_of(const SolidMesh& mesh, std::size_t triangle) {
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        corners.vertex[k] = mesh.indices[3 * triangle + k];
        corners.at[k] = mesh.positions_m[corners.vertex[k]];
    }
    return corners;
}

using Fault = std::optional<std::string>;

Fault index_fault(const SolidMesh& mesh) {
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) {
        return fmt::format("triangles: expected whole ones, found {} indices", mesh.indices.size());
    }
    if (mesh.normals.size() != mesh.positions_m.size()) return "normals: expected one a vertex";
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.positions_m.size()) return fmt::format("index {}: no such vertex", index);
    }
    return {};
}

Fault unreferenced_fault(const SolidMesh& mesh) {
    std::vector<bool> used(mesh.positions_m.size(), false);
    for (const std::uint32_t index : mesh.indices)
        used[index] = true;
    const auto idle = std::count(used.begin(), used.end(), false);
    if (idle > 0) return fmt::format("unreferenced: {} vertices belong to no triangle", idle);
    return {};
}

Fault degenerate_fault(const SolidMesh& mesh) {
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        if (!(glm::length(corners_of(mesh, t).doubled_area()) > 0.0)) {
            return fmt::format("degenerate: triangle {} has no area", t);
        }
    }
    return {};
}

using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

Edges directed_edges(const SolidMesh& mesh, const Welded& welded) {
    Edges edges;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = welded.place_of_vertex[mesh.indices[t + k]];
            const std::uint32_t to = welded.place_of_vertex[mesh.indices[t + (k + 1) % 3]];
            ++edges[{from, to}];
        }
    }
    return edges;
}

Fault edge_fault(const Edges& edges) {
    std::size_t open = 0;
    std::size_t repeated = 0;
    for (const auto& [edge, uses] : edges) {
        if (uses > 1) ++repeated;
        if (!edges.contains({edge.second, edge.first})) ++open;
    }
    if (open + repeated == 0) return {};
    return fmt::format("closed: {} edges have no opposite, {} are used more than once a direction", open,
                       repeated);
}

Fault euler_fault(const SolidMesh& mesh, const Welded& welded, const Edges& edges, int expected) {
    // In a closed mesh each edge is there in both directions.
    const auto signed_count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
    const std::int64_t euler = signed_count(welded.place_count) - signed_count(edges.size() / 2) +
                               signed_count(mesh.indices.size() / 3);
    if (euler == expected) return {};
    return fmt::format("Euler: expected V - E + F = {}, found {}", expected, euler);
}

Fault part_fault(const Welded& welded, const Edges& edges, int expected) {
    std::vector<std::uint32_t> parent(welded.place_count);
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&parent](std::uint32_t place) {
        while (parent[place] != place)
            place = parent[place] = parent[parent[place]];
        return place;
    };
    std::size_t parts = welded.place_count;
    for (const auto& [edge, uses] : edges) {
        const std::uint32_t a = root(edge.first);
        const std::uint32_t b = root(edge.second);
        if (a != b) {
            parent[a] = b;
            --parts;
        }
    }
    if (parts == static_cast<std::size_t>(expected)) return {};
    return fmt::format("parts: expected {}, found {}", expected, parts);
}

Fault volume_fault(const SolidMesh& mesh, const ExpectedPot& expected) {
    const double volume = signed_volume_m3(mesh);
    if (volume <= 0.0) return fmt::format("outward: the signed volume is {} m^3", volume);
    if (std::abs(volume - expected.volume_m3) <= expected.volume_tolerance * expected.volume_m3) return {};
    return fmt::format("volume: expected {} m^3 within {}, found {}", expected.volume_m3,
                       expected.volume_tolerance, volume);
}

Fault normal_fault(const SolidMesh& mesh, const ExpectedPot& expected) {
    constexpr double kUnitTolerance = 6e-5;  // half a step of 14 bits on three axes
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (!(std::abs(glm::length(mesh.normals[i]) - 1.0) <= kUnitTolerance)) {
            return fmt::format("normals: vertex {}'s has the length {}", i, glm::length(mesh.normals[i]));
        }
    }
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners corners = corners_of(mesh, t);
        const dvec3 face = glm::normalize(corners.doubled_area());
        for (const std::uint32_t vertex : corners.vertex) {
            const double agreement = glm::dot(face, mesh.normals[vertex]);
            if (!(agreement >= expected.min_normal_agreement)) {
                return fmt::format("normals: vertex {}'s agrees with triangle {} by {} only", vertex, t,
                                   agreement);
            }
        }
    }
    return {};
}

Fault place_fault(const SolidMesh& mesh, const ExpectedPot& expected) {
    dvec3 low = mesh.positions_m.front();
    dvec3 high = low;
    for (const dvec3& position : mesh.positions_m) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    constexpr double kExactM = 1e-7;  // a float of 0.2 m is good to 1e-8
    if (low.y != 0.0) return fmt::format("base: expected y = 0, found {} m", low.y);
    if (std::abs(high.y - expected.height_m) > kExactM) {
        return fmt::format("height: expected {} m, found {}", expected.height_m, high.y);
    }
    const double twice_off = std::max(kExactM, 2.0 * expected.off_axis_m);
    if (std::abs(low.x + high.x) > twice_off || std::abs(low.z + high.z) > twice_off) {
        return fmt::format("axis: expected the middle at 0, found x {} and z {} m", 0.5 * (low.x + high.x),
                           0.5 * (low.z + high.z));
    }
    if (std::abs(high.x - expected.max_radius_m) > expected.radius_tolerance_m + expected.off_axis_m) {
        return fmt::format("radius: expected {} m at most, found {}", expected.max_radius_m, high.x);
    }
    return {};
}

}  // namespace

double signed_volume_m3(const SolidMesh& mesh) {
    double six_volumes = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const Corners corners = corners_of(mesh, t);
        six_volumes += glm::dot(corners.at[0], glm::cross(corners.at[1], corners.at[2]));
    }
    return six_volumes / 6.0;
}

std::vector<std::string> find_faults(const SolidMesh& mesh, const ExpectedPot& expected) {
    if (const Fault fault = index_fault(mesh)) return {*fault};
    const Welded welded = weld(mesh);
    const Edges edges = directed_edges(mesh, welded);
    std::vector<std::string> faults;
    for (const Fault& fault :
         {unreferenced_fault(mesh), degenerate_fault(mesh), edge_fault(edges),
          euler_fault(mesh, welded, edges, expected.euler), part_fault(welded, edges, expected.parts),
          volume_fault(mesh, expected), normal_fault(mesh, expected), place_fault(mesh, expected)}) {
        if (fault) faults.push_back(*fault);
    }
    return faults;
}

}  // namespace onggi::support
