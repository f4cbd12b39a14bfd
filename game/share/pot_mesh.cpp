// See pot_mesh.h. Any thread but the haptic one.
#include "game/share/pot_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace onggi::share {
namespace {

struct Fineness {
    double tolerance_mm;
    int sectors;
};

// Both errors grow together.
constexpr std::array<Fineness, 4> kFinenesses{{{0.008, 128}, {0.016, 96}, {0.032, 64}, {0.064, 48}}};

std::size_t triangle_count(const Profile& profile, int sectors) {
    // Two a sector in each band between rings, and one a sector in each of the two caps.
    return profile.size() * 2 * static_cast<std::size_t>(sectors);
}

// The outline's outward unit normal in its own plane: x along the radius, y up.
dvec2 normal_between(const ProfilePoint& below, const ProfilePoint& above) {
    const dvec2 along(above.radius_mm - below.radius_mm, above.y_mm - below.y_mm);
    return glm::normalize(dvec2(along.y, -along.x));
}

double length_between(const ProfilePoint& below, const ProfilePoint& above) {
    return glm::length(dvec2(above.radius_mm - below.radius_mm, above.y_mm - below.y_mm));
}

class Builder {
  public:
    Builder(asset::Mesh& mesh, int sectors) : mesh_(mesh), circle_(unit_circle(sectors)) {}

    // Appends a ring of vertices and gives the index of its first. The normal is the outline's, turned about
    // the axis.
    std::uint32_t add_ring(const ProfilePoint& point, const dvec2& normal) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions_m.size());
        for (const dvec2& direction : circle_) {
            add_vertex(dvec3(point.radius_mm * direction.x, point.y_mm, -point.radius_mm * direction.y),
                       dvec3(normal.x * direction.x, normal.y, -normal.x * direction.y));
        }
        return first;
    }

    void add_band(std::uint32_t lower, std::uint32_t upper) {
        for_each_sector([&](std::uint32_t k, std::uint32_t next) {
            add_triangle(lower + k, lower + next, upper + next);
            add_triangle(lower + k, upper + next, upper + k);
        });
    }

    void add_cap(const ProfilePoint& rim, bool faces_up) {
        const dvec2 normal(0.0, faces_up ? 1.0 : -1.0);
        const std::uint32_t ring = add_ring(rim, normal);
        const auto centre = static_cast<std::uint32_t>(mesh_.positions_m.size());
        add_vertex(dvec3(0.0, rim.y_mm, 0.0), dvec3(0.0, normal.y, 0.0));
        for_each_sector([&](std::uint32_t k, std::uint32_t next) {
            if (faces_up) {
                add_triangle(centre, ring + k, ring + next);
            } else {
                add_triangle(centre, ring + next, ring + k);
            }
        });
    }

  private:
    template <typename Visit>
    void for_each_sector(Visit visit) {
        const auto sectors = static_cast<std::uint32_t>(circle_.size());
        for (std::uint32_t k = 0; k < sectors; ++k)
            visit(k, (k + 1) % sectors);
    }

    void add_vertex(const dvec3& position_mm, const dvec3& normal) {
        // + 0: no negative zeros, which would part vertices that lie at one place in the eyes of a bitwise
        // checker.
        const vec3 zero(0.0F);
        mesh_.positions_m.push_back(vec3(position_mm * units::kMetresPerMm) + zero);
        mesh_.normals.push_back(vec3(normal) + zero);
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    }

    asset::Mesh& mesh_;
    std::vector<dvec2> circle_;
};

// Fills in all but the mesh and the scale.
PotMesh thinned_to_budget(const PotShape& shape) {
    PotMesh pot;
    const auto fits = [&pot](const PotShape& candidate, const Fineness& fineness) {
        pot.profile = simplified(full_profile(candidate), fineness.tolerance_mm);
        pot.tolerance_mm = fineness.tolerance_mm;
        pot.sectors = fineness.sectors;
        pot.elements = candidate.radii_mm.size();
        return triangle_count(pot.profile, fineness.sectors) <= kMaxTriangles;
    };
    for (const Fineness& fineness : kFinenesses) {
        if (fits(shape, fineness)) return pot;
    }
    // Ends at the latest with 173 elements: if each met the next in a ledge, three points an element would
    // fit.
    std::vector<float> merged(shape.radii_mm.begin(), shape.radii_mm.end());
    do {
        merged = resampled(merged, merged.size() / 2);
    } while (!fits({shape.height_mm, merged}, kFinenesses.back()));
    return pot;
}

void build_wall(Builder& builder, const Profile& profile) {
    const std::size_t pieces = profile.size() - 1;
    dvec2 normal_below = normal_between(profile[0], profile[1]);
    std::uint32_t lower = builder.add_ring(profile[0], normal_below);
    for (std::size_t i = 1; i <= pieces; ++i) {
        if (i == pieces) {
            builder.add_band(lower, builder.add_ring(profile[i], normal_below));
            return;
        }
        const dvec2 normal_above = normal_between(profile[i], profile[i + 1]);
        if (glm::dot(normal_below, normal_above) < kCreaseCosine) {
            builder.add_band(lower, builder.add_ring(profile[i], normal_below));
            lower = builder.add_ring(profile[i], normal_above);
        } else {
            // The longer piece counts for more: a straight wall stays flat up to where a groove begins, and
            // the bend lies in the groove.
            const double weight_below = length_between(profile[i - 1], profile[i]);
            const double weight_above = length_between(profile[i], profile[i + 1]);
            const dvec2 blended = glm::normalize(weight_below * normal_below + weight_above * normal_above);
            const std::uint32_t ring = builder.add_ring(profile[i], blended);
            builder.add_band(lower, ring);
            lower = ring;
        }
        normal_below = normal_above;
    }
}

}  // namespace

std::vector<dvec2> unit_circle(int n) {
    // A step of 90 or of 30 degrees is known exactly; halving it leads to 360/n.
    dvec2 step = n % 3 == 0 ? dvec2(0.5 * std::sqrt(3.0), 0.5) : dvec2(0.0, 1.0);
    for (int parts = n % 3 == 0 ? 12 : 4; parts < n; parts *= 2) {
        const double cosine = std::sqrt(0.5 * (1.0 + step.x));
        step = dvec2(cosine, step.y / (2.0 * cosine));
    }
    const auto quarter = static_cast<std::size_t>(n) / 4;
    std::vector<dvec2> circle(static_cast<std::size_t>(n));
    circle[0] = dvec2(1.0, 0.0);
    for (std::size_t k = 1; k < quarter; ++k) {
        const dvec2 last = circle[k - 1];
        circle[k] = dvec2(last.x * step.x - last.y * step.y, last.x * step.y + last.y * step.x);
    }
    // Quarter turns are exact, so that opposite corners are, too.
    for (std::size_t k = quarter; k < circle.size(); ++k) {
        circle[k] = dvec2(-circle[k - quarter].y, circle[k - quarter].x);
    }
    return circle;
}

PotMesh build_pot_mesh(const PotShape& shape) {
    PotMesh pot = thinned_to_budget(shape);
    // Of the circle's area.
    const double polygon_share = pot.sectors * unit_circle(pot.sectors)[1].y / (2.0 * std::numbers::pi);
    pot.radius_scale = std::sqrt(clay_volume_mm3(shape) / (polygon_share * volume_mm3(pot.profile)));
    for (ProfilePoint& point : pot.profile)
        point.radius_mm *= pot.radius_scale;

    const std::size_t triangles = triangle_count(pot.profile, pot.sectors);
    pot.mesh.indices.reserve(triangles * 3);
    pot.mesh.positions_m.reserve(triangles / 2 + 2 * static_cast<std::size_t>(pot.sectors) + 2);
    pot.mesh.normals.reserve(pot.mesh.positions_m.capacity());
    Builder builder(pot.mesh, pot.sectors);
    builder.add_cap(pot.profile.front(), false);
    build_wall(builder, pot.profile);
    builder.add_cap(pot.profile.back(), true);
    return pot;
}

}  // namespace onggi::share
