// See pot_solid.h. Any thread but the haptic one.
#include "game/share/pot_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "engine/core/units.h"
#include "game/share/pot_mesh.h"

namespace onggi::share {
namespace {

using clay::studio::Rings;

struct SolidFineness {
    double tolerance_mm;
    int corners;
};
// Both errors grow together; the last three are for what a wild hand leaves.
constexpr std::array<SolidFineness, 7> kSolidFinenesses{
    {{0.008, 128}, {0.016, 96}, {0.032, 64}, {0.064, 48}, {0.125, 48}, {0.25, 48}, {0.5, 48}}};

// A surface walked row by row such that its outside lies to the right of the walk in the plane of radius and
// height: up the outside, in over the rim, down the inside. Both ends are closed by discs, the first facing
// down and the last facing up; or the last row meets the first.
struct Walk {
    std::vector<FaceRow> rows;
    bool meets_itself = false;
};

void append_up(Walk& walk, Face face) {
    std::move(face.begin(), face.end(), std::back_inserter(walk.rows));
}

void append_down(Walk& walk, Face face) {
    std::move(face.rbegin(), face.rend(), std::back_inserter(walk.rows));
}

// Every surface of the clay; take gives the rows of rings [first, end) of a face.
template <typename Take>
std::vector<Walk> walks_over(const Rings& rings, Take take) {
    std::vector<Walk> walks;
    Walk outside;
    Face inside;  // of the run that is open at the top
    for (const RingRun& run : ring_runs(rings)) {
        if (!run.hollow) continue;
        Face face = take(Which::kInner, run.first, run.end);
        if (run.end == rings.count) {
            inside = std::move(face);
            outside.meets_itself = run.first == 0;
        } else if (run.first == 0) {
            append_down(outside, std::move(face));  // a cup upside down: its inside leads to the foot
        } else {
            append_down(walks.emplace_back(), std::move(face));
        }
    }
    append_up(outside, take(Which::kOuter, 0, rings.count));
    append_down(outside, std::move(inside));
    walks.push_back(std::move(outside));
    return walks;
}

std::size_t row_count(const std::vector<Walk>& walks) {
    std::size_t rows = 0;
    for (const Walk& walk : walks)
        rows += walk.rows.size();
    return rows;
}

// Two a corner between rows, and one a corner in each of two discs or two in the band that closes.
std::size_t triangle_count(const std::vector<Walk>& walks, int corners) {
    return row_count(walks) * 2 * static_cast<std::size_t>(corners);
}

struct Rows {
    std::vector<Walk> walks;
    SolidFineness fineness;
};

Rows rows_within_budget(const Rings& rings) {
    const bool dented = has_dents(rings);
    const double thinnest = thinnest_wall_mm(rings);
    for (const SolidFineness& fineness : kSolidFinenesses) {
        // Each face may move by the tolerance, and a wall must be left between them.
        if (thinnest > 0.0 && !(4.0 * fineness.tolerance_mm <= thinnest)) break;
        const Corners corners{fineness.corners, dented};
        auto walks = walks_over(rings, [&](Which which, int first, int end) {
            return thinned(face_of(rings, which, first, end, corners), fineness.tolerance_mm);
        });
        if (triangle_count(walks, fineness.corners) <= kMaxTriangles) return {std::move(walks), fineness};
    }
    // Both faces keep rows of the same rings, so that the wall between them stays.
    const Corners corners{kSolidFinenesses.back().corners, dented};
    for (std::size_t stride = 2;; stride *= 2) {
        auto walks = walks_over(rings, [&](Which which, int first, int end) {
            const Face face = face_of(rings, which, first, end, corners);
            Face kept{face.front()};
            for (std::size_t i = stride; i + 1 < face.size(); i += stride)
                kept.push_back(face[i]);
            kept.push_back(face.back());
            return kept;
        });
        if (triangle_count(walks, corners.count) <= kMaxTriangles)
            return {std::move(walks), {0.0, corners.count}};
    }
}

// The walk's right-hand normal between two rows at a corner, in the plane of that corner and the axis.
dvec2 normal_between(const FaceRow& from, const FaceRow& to, std::size_t corner, const dvec2& direction) {
    const double out =
        to.corner_mm(corner) - from.corner_mm(corner) + glm::dot(to.centre_mm - from.centre_mm, direction);
    return glm::normalize(dvec2(to.y_mm - from.y_mm, -out));
}

// Whether the surface turns so much at `row` that it has an edge there.
bool is_edge(const FaceRow& before, const FaceRow& row, const FaceRow& after,
             const std::vector<dvec2>& circle) {
    for (std::size_t k = 0; k < circle.size(); ++k) {
        const dvec2 below = normal_between(before, row, k, circle[k]);
        const dvec2 above = normal_between(row, after, k, circle[k]);
        if (glm::dot(below, above) < kCreaseCosine) return true;
    }
    return false;
}

// Vertices in mm with the normals summed so far, triangles as they come.
class SolidBuilder {
  public:
    explicit SolidBuilder(int corners) : circle_(unit_circle(corners)) {}

    std::uint32_t add_row(const FaceRow& row) {
        const auto first = static_cast<std::uint32_t>(positions_mm.size());
        for (std::size_t k = 0; k < circle_.size(); ++k) {
            const dvec2 across = row.centre_mm + row.corner_mm(k) * circle_[k];
            positions_mm.emplace_back(across.x, row.y_mm, -across.y);
            normals.emplace_back(0.0);
        }
        return first;
    }

    // From one row of the walk to the next. Normals: each four-cornered face gives its area to its corners.
    void add_band(std::uint32_t from, std::uint32_t to) {
        for_each_corner([&](std::uint32_t k, std::uint32_t next) {
            add_triangle(from + k, from + next, to + next);
            add_triangle(from + k, to + next, to + k);
            const dvec3 area = glm::cross(positions_mm[to + next] - positions_mm[from + k],
                                          positions_mm[to + k] - positions_mm[from + next]);
            for (const std::uint32_t corner : {from + k, from + next, to + k, to + next})
                normals[corner] += area;
        });
    }

    void add_disc(const FaceRow& rim, bool faces_up) {
        const std::uint32_t ring = add_row(rim);
        const auto centre = static_cast<std::uint32_t>(positions_mm.size());
        positions_mm.emplace_back(rim.centre_mm.x, rim.y_mm, -rim.centre_mm.y);
        normals.emplace_back(0.0);
        for (std::uint32_t vertex = ring; vertex <= centre; ++vertex)
            normals[vertex] = dvec3(0.0, faces_up ? 1.0 : -1.0, 0.0);
        for_each_corner([&](std::uint32_t k, std::uint32_t next) {
            if (faces_up)
                add_triangle(ring + k, ring + next, centre);
            else
                add_triangle(ring + next, ring + k, centre);
        });
    }

    void add_walk(const Walk& walk) {
        const std::vector<FaceRow>& rows = walk.rows;
        if (!walk.meets_itself) add_disc(rows.front(), false);
        std::uint32_t from = add_row(rows.front());
        for (std::size_t i = 1; i < rows.size(); ++i) {
            std::uint32_t to = add_row(rows[i]);
            add_band(from, to);
            if (i + 1 < rows.size() && is_edge(rows[i - 1], rows[i], rows[i + 1], circle_))
                to = add_row(rows[i]);
            from = to;
        }
        if (walk.meets_itself)
            add_band(add_row(rows.back()), add_row(rows.front()));
        else
            add_disc(rows.back(), true);
    }

    [[nodiscard]] double volume_mm3() const {
        double six_volumes = 0.0;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            six_volumes += glm::dot(positions_mm[indices[i]],
                                    glm::cross(positions_mm[indices[i + 1]], positions_mm[indices[i + 2]]));
        }
        return six_volumes / 6.0;
    }

    std::vector<dvec3> positions_mm;
    std::vector<dvec3> normals;
    std::vector<std::uint32_t> indices;

  private:
    template <typename Visit>
    void for_each_corner(Visit visit) {
        const auto corners = static_cast<std::uint32_t>(circle_.size());
        for (std::uint32_t k = 0; k < corners; ++k)
            visit(k, (k + 1) % corners);
    }
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        indices.insert(indices.end(), {a, b, c});
    }

    std::vector<dvec2> circle_;
};

Result<void> check_rings(const Rings& rings) {
    if (rings.count == 0) return bad_input("pot: expected clay on the wheel, found none");
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = Rings::at(i);
        const bool sound = rings.inner_mm[at] >= 0.0 && rings.outer_mm[at] > rings.inner_mm[at] &&
                           rings.outer_mm[at] <= kMaxRadiusMm && rings.height_mm[at] > 0.0 &&
                           rings.volume_mm3[at] > 0.0 &&
                           std::fabs(rings.centre_x_mm[at]) <= static_cast<float>(kMaxRadiusMm) &&
                           std::fabs(rings.centre_z_mm[at]) <= static_cast<float>(kMaxRadiusMm);
        if (!sound) {
            return bad_input(
                fmt::format("pot: ring {}: expected 0 <= inner < outer <= {} mm and some "
                            "height, found {} and {} mm, height {}",
                            i, kMaxRadiusMm, rings.inner_mm[at], rings.outer_mm[at], rings.height_mm[at]));
        }
    }
    if (!(rings.top_mm() >= kMinHeightMm && rings.top_mm() <= kMaxHeightMm)) {
        return bad_input(fmt::format("pot: expected a height of {} to {} mm, found {}", kMinHeightMm,
                                     kMaxHeightMm, rings.top_mm()));
    }
    return {};
}

}  // namespace

Result<PotSolid> build_pot_solid(const Rings& rings, double shrinkage) {
    if (const Result<void> good = check_rings(rings); !good) return good.error();
    const Rows rows = rows_within_budget(rings);
    SolidBuilder builder(rows.fineness.corners);
    for (const Walk& walk : rows.walks)
        builder.add_walk(walk);

    PotSolid pot;
    pot.corners = rows.fineness.corners;
    pot.tolerance_mm = rows.fineness.tolerance_mm;
    pot.rows = row_count(rows.walks);
    pot.across_scale = std::sqrt(rings.on_wheel_mm3() / builder.volume_mm3());
    if (!std::isfinite(pot.across_scale)) return bad_input("pot: expected clay that encloses a volume");
    const double up = shrinkage * units::kMetresPerMm;
    const double across = up * pot.across_scale;
    // + 0: no negative zeros, which would part vertices that lie at one place in the eyes of a bitwise
    // checker.
    const vec3 zero(0.0F);
    pot.mesh.positions_m.reserve(builder.positions_mm.size());
    pot.mesh.normals.reserve(builder.positions_mm.size());
    for (std::size_t i = 0; i < builder.positions_mm.size(); ++i) {
        const dvec3& p = builder.positions_mm[i];
        pot.mesh.positions_m.push_back(vec3(p * dvec3(across, up, across)) + zero);
        pot.mesh.normals.push_back(vec3(glm::normalize(builder.normals[i])) + zero);
    }
    pot.mesh.indices = std::move(builder.indices);
    return pot;
}

}  // namespace onggi::share
