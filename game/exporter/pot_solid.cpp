// See pot_solid.h. Any thread but the haptic one.
#include "game/exporter/pot_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/core/units.h"

namespace onggi::exporter {
namespace {

using pot::SurfaceBuilder;
using pot::Walk;

struct Fineness {
    double tolerance_mm;
    int corners;
};
// Both errors grow together; the last three settings are for very rough pots.
constexpr std::array<Fineness, 7> kFinenesses{
    {{0.008, 128}, {0.016, 96}, {0.032, 64}, {0.064, 48}, {0.125, 48}, {0.25, 48}, {0.5, 48}}};

void append_up(Walk& walk, Face face) {
    std::move(face.begin(), face.end(), std::back_inserter(walk.rows));
}

void append_down(Walk& walk, Face face) {
    std::move(face.rbegin(), face.rend(), std::back_inserter(walk.rows));
}

// Collects every surface of the clay; take returns the rows of rings [first, end) of a face.
template <typename Take>
std::vector<Walk> walks_over(const PotRings& rings, Take take) {
    std::vector<Walk> walks;
    Walk outside;
    Face inside;  // of the run that is open at the top
    for (const RingRun& run : ring_runs(rings)) {
        if (!run.hollow) continue;
        Face face = take(Which::kInner, run.first, run.end);
        if (run.end == rings.count()) {
            inside = std::move(face);
            outside.meets_itself = run.first == 0;
        } else if (run.first == 0) {
            append_down(outside, std::move(face));  // a cup upside down: its inside ends at the foot
        } else {
            append_down(walks.emplace_back(), std::move(face));
        }
    }
    append_up(outside, take(Which::kOuter, 0, rings.count()));
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

// Two triangles a corner between rows, and one a corner in each of two discs or two in the closing band.
std::size_t triangle_count(const std::vector<Walk>& walks, int corners) {
    return row_count(walks) * 2 * static_cast<std::size_t>(corners);
}

struct Rows {
    std::vector<Walk> walks;
    Fineness fineness;
    int rings = 0;  // rings they were taken from
};

// The rows at one setting; empty if its tolerance might push one face through the other, or if they exceed
// the budget.
std::optional<Rows> rows_at(const PotRings& rings, const Fineness& fineness, const SolidOptions& options) {
    // Each face may move by the tolerance, and a distance must remain between them.
    const double most_mm = thinnest_mm(rings) / 4.0;
    if (!(fineness.tolerance_mm <= most_mm)) return std::nullopt;
    const double apart_mm = std::min(kNearestGlazedRowsMm / options.shrinkage, most_mm);
    auto walks = walks_over(rings, [&](Which which, int first, int end) {
        Face face = face_of(rings, which, first, end, fineness.corners);
        if (fineness.tolerance_mm > 0.0) face = thinned(face, fineness.tolerance_mm);
        return options.is_glazed ? spread(face, apart_mm) : face;
    });
    const pot::Rounding rounding{.within_mm = kGlazeRoundingMm / options.shrinkage, .apart_mm = apart_mm};
    for (Walk& walk : walks)
        if (options.is_glazed) walk = pot::rounded(walk, rounding, fineness.corners);
    if (triangle_count(walks, fineness.corners) > options.most_triangles) return std::nullopt;
    return Rows{std::move(walks), fineness, rings.count()};
}

SurfaceBuilder built(const Rows& rows, bool unwraps = false) {
    SurfaceBuilder builder(rows.fineness.corners, unwraps);
    for (const Walk& walk : rows.walks)
        builder.add_walk(walk);
    return builder;
}

// The horizontal scale that restores the clay's volume.
double across_scale(const SurfaceBuilder& builder, const PotRings& rings) {
    return std::sqrt(rings.volume_mm3 / builder.volume_mm3());
}

// v of each strip, 0 at the end of the last walk to 1 at the start of the first.
std::vector<double> rows_of_pictures(const std::vector<SurfaceBuilder::Strip>& strips) {
    std::vector<double> lengths_mm{0.0};  // from the strip before
    double outside_mm = 0.0;
    const auto is_outside = [&](std::size_t i) {
        return !strips[i].inside && !strips[i - 1].inside && !strips[i].is_middle && !strips[i - 1].is_middle;
    };
    for (std::size_t i = 1; i < strips.size(); ++i) {
        lengths_mm.push_back(strips[i].along_mm - strips[i - 1].along_mm);
        if (is_outside(i)) outside_mm += lengths_mm.back();
    }
    const double rest_mm = strips.back().along_mm - strips.front().along_mm - outside_mm;
    const double fair = kOutsideOfPictures / (1.0 - kOutsideOfPictures) * rest_mm;
    const double stretch = outside_mm > 0.0 ? std::max(fair / outside_mm, 1.0) : 1.0;
    const double total_mm = rest_mm + stretch * outside_mm;
    std::vector<double> v;
    double along_mm = 0.0;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        along_mm += i > 0 && is_outside(i) ? stretch * lengths_mm[i] : lengths_mm[i];
        v.push_back(std::clamp(1.0 - along_mm / total_mm, 0.0, 1.0));
    }
    return v;
}

// To 14 bits after the point, so that zlib finds repeated bytes: within 0.003 degrees, its length within 6e-5
// of 1.
vec3 direction_in_file(const dvec3& direction) {
    constexpr double kSteps = 16384.0;
    return vec3(glm::round(direction * kSteps) / kSteps) + vec3(0.0F);
}

// Adds texture coordinates and tangents to the solid's mesh, and lists the rows of the pictures. The builder
// must be unwrapped and have its normals.
void unwrap(const SurfaceBuilder& builder, double shrinkage, PotSolid& pot) {
    asset::Mesh& mesh = pot.mesh;
    mesh.uvs.resize(builder.positions_mm.size());
    mesh.tangents.resize(builder.positions_mm.size());
    const auto& strips = builder.strips();
    const std::vector<double> vs = rows_of_pictures(strips);
    for (auto strip = strips.rbegin(); strip != strips.rend(); ++strip) {
        const double v = vs[static_cast<std::size_t>(strips.rend() - strip) - 1];
        dvec2 mean(0.0);
        for (std::uint32_t k = 0; k < strip->count; ++k) {
            const std::uint32_t vertex = strip->first + k;
            mesh.uvs[vertex] = vec2(builder.turns(*strip, k), v);
            // The tangent round the pot, made orthogonal to the normal.
            const dvec2 outward = builder.outward(*strip, k);
            const dvec3& normal = builder.normals[vertex];
            const dvec3 round(-outward.y, 0.0, -outward.x);
            const dvec3 square = glm::normalize(round - glm::dot(round, normal) * normal);
            mesh.tangents[vertex] = vec4(direction_in_file(square), 1.0F);
            mean += dvec2(normal.x * outward.x - normal.z * outward.y, normal.y);
        }
        pot.picture_rows.push_back({.v = v,
                                    .radius_mm = strip->radius_mm * shrinkage,
                                    .y_mm = strip->y_mm * shrinkage,
                                    .normal = glm::normalize(mean),
                                    .inside = strip->inside});
    }
}

// Whether the chosen rows represent the clay that was left out.
bool is_like(const Rows& rows, const PotRings& rings) {
    constexpr double kMostOff = 0.01;
    return std::fabs(across_scale(built(rows), rings) - 1.0) < kMostOff;
}

std::optional<Rows> rows_within_budget(const PotRings& rings, const SolidOptions& options) {
    for (const Fineness& fineness : kFinenesses)
        if (auto rows = rows_at(rings, fineness, options)) return rows;
    // The pot is rough all over: try every second ring, or fourth, while those represent the rest; else
    // merged rings.
    for (const Halving how : {Halving::kEverySecond, Halving::kMerged}) {
        for (PotRings fewer = halved(rings, how), last = rings; fewer.count() < last.count();
             last = std::exchange(fewer, halved(fewer, how))) {
            for (const double tolerance_mm : {0.0, kFinenesses.back().tolerance_mm}) {
                auto rows = rows_at(fewer, {tolerance_mm, kFinenesses.back().corners}, options);
                if (rows && is_like(*rows, rings)) return rows;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

Result<PotSolid> build_pot_solid(const PotRings& rings, const SolidOptions& options) {
    if (const Result<void> good = check_rings(rings); !good) return good.error();
    std::optional<Rows> rows = rows_within_budget(rings, options);
    if (!rows) return bad_input("pot: expected clay that is not split into thousands of hollows");
    SurfaceBuilder builder = built(*rows, options.unwraps);
    PotSolid pot;
    pot.corners = rows->fineness.corners;
    pot.tolerance_mm = rows->fineness.tolerance_mm;
    pot.rows = row_count(rows->walks);
    pot.rings = rows->rings;
    pot.across_scale = across_scale(builder, rings);
    if (!std::isfinite(pot.across_scale)) return bad_input("pot: expected clay that encloses a volume");
    const double up = options.shrinkage * units::kMetresPerMm;
    const double across = up * pot.across_scale;
    builder.finish_normals();
    if (options.unwraps) unwrap(builder, options.shrinkage, pot);
    // + 0 removes negative zeros, which a bitwise checker would see as different positions.
    const vec3 zero(0.0F);
    pot.mesh.positions_m.reserve(builder.positions_mm.size());
    pot.mesh.normals.reserve(builder.positions_mm.size());
    for (std::size_t i = 0; i < builder.positions_mm.size(); ++i) {
        const dvec3& p = builder.positions_mm[i];
        pot.mesh.positions_m.push_back(vec3(p * dvec3(across, up, across)) + zero);
        const dvec3& normal = builder.normals[i];
        pot.mesh.normals.push_back(options.unwraps ? direction_in_file(normal) : vec3(normal) + zero);
    }
    pot.mesh.indices = std::move(builder.indices);
    pot.walks = std::move(rows->walks);
    return pot;
}

}  // namespace onggi::exporter
