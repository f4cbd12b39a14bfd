// A pot's surface of revolution as triangles, for exported files and for pictures on the screens: rows of
// corners become one closed surface, with dents and off-centre. Any thread but the haptic one. mm, the clay's
// frame: x along its direction 0, y up, corners counter-clockwise seen from above.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"

namespace onggi::pot {

// Corners of a regular polygon, without libm trigonometry, which differs between machines. Any thread.

// n unit vectors (cos, sin) at 2 pi k/n, from halved angles and exact square roots. n = 2^a or 3 x 2^a, a
// >= 2.
std::vector<dvec2> unit_circle(int n);

// The mean of the sectors around each of `count` corners; none without sectors. Corner k is at k/count of a
// turn, sector s around (s + 1/2)/S: with half as many corners as sectors each corner takes its two
// neighbours. The number of sectors is a power of two.
std::vector<double> dents_at_corners(std::span<const float> sectors_mm, int count);

// A circle with its own centre; the dents move its corners outwards.
struct SurfaceRow {
    double y_mm = 0.0;
    double radius_mm = 0.0;
    dvec2 centre_mm{0.0};
    bool inside = false;
    std::vector<double> dents_mm{};  // one a corner; empty if the whole pot is round

    [[nodiscard]] double corner_mm(std::size_t k) const {
        return dents_mm.empty() ? radius_mm : radius_mm + dents_mm[k];
    }
};

// Distance along the outline from one row to another.
[[nodiscard]] double distance_mm(const SurfaceRow& a, const SurfaceRow& b);

// Rows closer than this would make triangles without area in float metres.
constexpr double kNearestRowsMm = 1e-3;
// A narrower opening is drawn this wide, for the same reason.
constexpr double kNarrowestOpeningMm = 0.02;

// A surface as a sequence of rows whose outside lies to the right of the walk in the plane of radius and
// height: up the outside, in over the rim, down the inside. Both ends are closed by discs, the first facing
// down and the last facing up; or the last row connects to the first.
struct Walk {
    std::vector<SurfaceRow> rows{};
    bool meets_itself = false;
    bool is_smooth = false;  // shares the normals of its edges instead of doubling their corners
};

// The walk as a glaze covers it: smooth, and each edge, also of a closing disc, is a parabola of three rows.
// It begins within_mm from the edge along the outline, or half way to the next edge if that is less, and
// replaces the rows there: an edge that shares its normals with a row close to it shows as dark pixels, where
// such a normal points away from the eye. An edge without room for rows apart_mm from each other stays where
// it is, smooth; a small disc and the foot of a walk that meets itself keep their edges.
struct Rounding {
    double within_mm = 0.0;
    double apart_mm = 0.0;
};
[[nodiscard]] Walk rounded(const Walk& walk, const Rounding& rounding, int corners);

class SurfaceBuilder {
  public:
    // Vertices of one row, or of the middle of a disc.
    struct Strip {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        double along_mm = 0.0;  // distance along all walks so far
        double radius_mm = 0.0;
        double y_mm = 0.0;
        bool inside = false;
        bool is_middle = false;
    };

    // corners: of a row, as in unit_circle(). unwraps: each vertex has a texture coordinate of its own, so a
    // row's first corner is doubled, at 0 and at a whole turn, and a disc's middle is repeated for each of
    // its triangles.
    SurfaceBuilder(int corners, bool unwraps);

    void add_walk(const Walk& walk);
    [[nodiscard]] double volume_mm3() const;
    // Normalises the normals, so that none points away from a face of its vertex. Call once, after the last
    // walk.
    void finish_normals();

    [[nodiscard]] const std::vector<Strip>& strips() const { return strips_; }  // in the order of the walks
    // Direction of a strip's vertex about the axis, in turns from the clay's direction 0; for unwrapped
    // surfaces.
    [[nodiscard]] double turns(const Strip& strip, std::uint32_t k) const;
    // Outward direction there.
    [[nodiscard]] dvec2 outward(const Strip& strip, std::uint32_t k) const;

    std::vector<dvec3> positions_mm;
    std::vector<dvec3> normals;  // sums over faces until finish_normals()
    std::vector<std::uint32_t> indices;

  private:
    std::uint32_t add_row(const SurfaceRow& row);
    void add_band(std::uint32_t from, std::uint32_t to);
    void add_disc(const SurfaceRow& rim, bool faces_up);
    void add_middle(const SurfaceRow& rim, bool faces_up);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void mend_normals();
    [[nodiscard]] std::uint32_t next_of(std::uint32_t corner) const;
    [[nodiscard]] std::uint32_t in_row() const;

    std::vector<dvec2> circle_;
    bool unwraps_;
    double along_mm_ = 0.0;
    std::vector<Strip> strips_;
};

}  // namespace onggi::pot
