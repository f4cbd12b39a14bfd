#include "engine/render/profile_mesh.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr float kCosOfCorner = 0.82F;  // 35 degrees

// A row of vertices: an outline point with its normal in the half plane. A corner makes two rows.
struct Row {
    vec2 point;
    vec2 normal;
    bool joins_next;  // whether a triangle strip connects this row to the next
};

vec2 outward(vec2 from, vec2 to) {
    const vec2 along = to - from;
    return glm::normalize(vec2(along.y, -along.x));
}

std::vector<Row> rows_of(const Profile& profile) {
    const std::vector<vec2>& points = profile.points;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_first = i == 0;
        const bool is_last = i + 1 == points.size();
        const vec2 before = is_first ? vec2(0.0F) : outward(points[i - 1], points[i]);
        const vec2 after = is_last ? vec2(0.0F) : outward(points[i], points[i + 1]);
        if (is_first || is_last) {
            rows.push_back({points[i], is_first ? after : before, !is_last});
        } else if (glm::dot(before, after) >= kCosOfCorner) {
            rows.push_back({points[i], glm::normalize(before + after), true});
        } else {
            rows.push_back({points[i], before, false});
            rows.push_back({points[i], after, true});
        }
    }
    return rows;
}

// Whether a ray from p meets the frustum between two outline points, at a distance above kHair.
bool meets(vec3 p, vec3 d, vec2 a, vec2 b) {
    // Points of the frustum satisfy x^2 + z^2 = (r0 + k y)^2; a flat ring is the plane y = a.y.
    const float kHair = 0.05F;
    const float rise = b.y - a.y;
    if (std::abs(rise) < 1e-4F) {
        if (std::abs(d.y) < 1e-6F) return false;
        const float t = (a.y - p.y) / d.y;
        const float r = glm::length(vec2(p.x + d.x * t, p.z + d.z * t));
        return t > kHair && r > std::min(a.x, b.x) && r < std::max(a.x, b.x);
    }
    const float k = (b.x - a.x) / rise;
    const float r_at_p = a.x + k * (p.y - a.y);
    const float qa = d.x * d.x + d.z * d.z - k * k * d.y * d.y;
    const float qb = p.x * d.x + p.z * d.z - k * d.y * r_at_p;
    const float qc = p.x * p.x + p.z * p.z - r_at_p * r_at_p;
    if (std::abs(qa) < 1e-9F) return false;
    const float root = qb * qb - qa * qc;
    if (root < 0.0F) return false;
    const float half = std::sqrt(root);
    for (const float t : {(-qb - half) / qa, (-qb + half) / qa}) {
        const float y = p.y + d.y * t;
        if (t > kHair && y > std::min(a.y, b.y) && y < std::max(a.y, b.y)) return true;
    }
    return false;
}

float open_sky_at(const Row& row, std::span<const Profile> profiles) {
    constexpr int kRings = 6;
    constexpr int kSpokes = 12;
    const vec3 normal(row.normal.x, row.normal.y, 0.0F);
    const vec3 along(-row.normal.y, row.normal.x, 0.0F);
    const vec3 around(0.0F, 0.0F, 1.0F);
    const vec3 p = vec3(row.point.x, row.point.y, 0.0F) + 0.2F * normal;
    int open = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        // Cosine-weighted: the square of the distance from the disc's centre is uniform.
        const float out = std::sqrt((static_cast<float>(ring) + 0.5F) / kRings);
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const float angle =
                kTurnF * (static_cast<float>(spoke) + 0.5F * static_cast<float>(ring % 2)) / kSpokes;
            const vec3 d = out * (std::cos(angle) * along + std::sin(angle) * around) +
                           std::sqrt(1.0F - out * out) * normal;
            const bool is_blocked =
                std::any_of(profiles.begin(), profiles.end(), [&](const Profile& profile) {
                    for (std::size_t i = 1; i < profile.points.size(); ++i) {
                        if (meets(p, d, profile.points[i - 1], profile.points[i])) return true;
                    }
                    return false;
                });
            open += is_blocked ? 0 : 1;
        }
    }
    return static_cast<float>(open) / (kRings * kSpokes);
}

}  // namespace

Mesh turned_mesh(const Profile& profile, int sectors) {
    Mesh mesh;
    const std::vector<Row> rows = rows_of(profile);
    const auto row_size = static_cast<std::uint32_t>(sectors + 1);
    for (const Row& row : rows) {
        for (int sector = 0; sector <= sectors; ++sector) {
            const float angle = kTurnF * static_cast<float>(sector % sectors) / static_cast<float>(sectors);
            const float c = std::cos(angle);
            const float s = std::sin(angle);
            mesh.vertices.push_back({.position_mm = {row.point.x * c, row.point.y, row.point.x * s},
                                     .normal = {row.normal.x * c, row.normal.y, row.normal.x * s}});
        }
    }
    for (std::uint32_t row = 0; row + 1 < rows.size(); ++row) {
        if (!rows[row].joins_next) continue;
        for (std::uint32_t sector = 0; sector + 1 < row_size; ++sector) {
            const std::uint32_t here = row * row_size + sector;
            const std::uint32_t above = here + row_size;
            // The angle grows from +X to +Z, clockwise seen from above; this index order faces outwards.
            if (rows[row].point.x > 0.0F) mesh.indices.insert(mesh.indices.end(), {here, above, here + 1});
            if (rows[row + 1].point.x > 0.0F)
                mesh.indices.insert(mesh.indices.end(), {here + 1, above, above + 1});
        }
    }
    return mesh;
}

Mesh sphere_mesh(int rows, int sectors) {
    Profile profile;
    for (int row = 0; row <= rows; ++row) {
        const float angle = kPiF * static_cast<float>(row) / static_cast<float>(rows);
        const bool is_pole = row == 0 || row == rows;
        profile.points.emplace_back(is_pole ? 0.0F : std::sin(angle), -std::cos(angle));
    }
    Mesh mesh = turned_mesh(profile, sectors);
    for (Mesh::Vertex& vertex : mesh.vertices)
        vertex.normal = glm::normalize(vertex.position_mm);
    return mesh;
}

void add_rounded(Profile& profile, vec2 before, vec2 corner, vec2 after, float radius_mm, int steps) {
    const vec2 in = glm::normalize(before - corner);
    const vec2 out = glm::normalize(after - corner);
    const float cosine = std::clamp(glm::dot(in, out), -0.999F, 0.999F);
    const float half_angle = 0.5F * std::acos(cosine);
    const float reach = radius_mm / std::tan(half_angle);
    const vec2 centre = corner + glm::normalize(in + out) * (radius_mm / std::sin(half_angle));
    const vec2 first = corner + in * reach - centre;
    const vec2 last = corner + out * reach - centre;
    for (int step = 0; step <= steps; ++step) {
        const float fraction = static_cast<float>(step) / static_cast<float>(steps);
        profile.points.push_back(centre + radius_mm * glm::normalize(glm::mix(first, last, fraction)));
    }
}

void set_open_sky(std::span<const Profile> profiles, std::span<Mesh> meshes, int sectors) {
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const std::vector<Row> rows = rows_of(profiles[i]);
        const auto row_size = static_cast<std::size_t>(sectors) + 1;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const float open = open_sky_at(rows[row], profiles);
            for (std::size_t sector = 0; sector < row_size; ++sector)
                meshes[i].vertices[row * row_size + sector].open_sky = open;
        }
    }
}

}  // namespace onggi::render
