// See pot_faces.h. Any thread but the haptic one.
#include "game/exporter/pot_faces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace onggi::exporter {
namespace {

// The range of slopes for which a straight line from an anchor passes all points so far within a tolerance.
// It thins an outline in one pass. Plain value, any thread.

// Each point narrows the range. Once a point leaves it empty, the line ends at the point before, with slope
// `end`: the slope in the range nearest to that point's own. Each point is visited once or twice, so that
// noise costs no more than smooth data. (This is the "swinging door" of process historians, with a free end
// point.)
class SlopeRange {
  public:
    // Adds a point `run` away and `rise` above the anchor. Returns false without a change if the range would
    // be empty, which never happens for the first point. Precondition: run > 0.
    bool pass(double run, double rise, double tolerance) {
        const double low = std::max(low_, (rise - tolerance) / run);
        const double high = std::min(high_, (rise + tolerance) / run);
        if (!(low <= high)) return false;
        low_ = low;
        high_ = high;
        end_ = std::clamp(rise / run, low, high);
        return true;
    }
    [[nodiscard]] double end() const { return end_; }

  private:
    double low_ = -std::numeric_limits<double>::infinity();
    double high_ = std::numeric_limits<double>::infinity();
    double end_ = 0.0;
};

using pot::kNarrowestOpeningMm;
using pot::kNearestRowsMm;
using pot::SurfaceRow;

constexpr double kFlakeMm = 0.05;

constexpr double kLedgeSteepness = 4.0;
constexpr double kLedgeVolumeFraction = 1e-3;

// Replacing a step between two rings by a straight slope removes pi h/6 (a - b)^2 of clay; the halves of the
// two rings that it spans hold pi h/2 (a^2 + b^2).
bool is_ledge(double below_mm, double above_mm, double ring_mm) {
    const double step = std::fabs(below_mm - above_mm);
    const double lost_fraction = step * step / (3.0 * (below_mm * below_mm + above_mm * above_mm));
    return step > kLedgeSteepness * ring_mm && lost_fraction > kLedgeVolumeFraction;
}

SurfaceRow row_at(const PotRings& rings, Which which, int ring, double y_mm, int corners) {
    SurfaceRow row;
    row.y_mm = y_mm;
    row.inside = which == Which::kInner;
    row.radius_mm = which == Which::kOuter ? rings.outer_mm[PotRings::at(ring)]
                                           : std::max(rings.inner(ring), kNarrowestOpeningMm);
    if (!rings.centre_mm.empty()) row.centre_mm = rings.centre_mm[PotRings::at(ring)];
    row.dents_mm = pot::dents_at_corners(rings.dents_of(ring), corners);
    return row;
}

// Calls visit(number of a row, same number of another row) for every number that thinning must preserve.
template <typename Visit>
void visit_numbers(const SurfaceRow& a, const SurfaceRow& b, Visit visit) {
    visit(a.radius_mm, b.radius_mm);
    visit(a.centre_mm.x, b.centre_mm.x);
    visit(a.centre_mm.y, b.centre_mm.y);
    for (std::size_t k = 0; k < a.dents_mm.size(); ++k)
        visit(a.dents_mm[k], b.dents_mm[k]);
}

// The row at y_mm on the lines from `anchor` with the end slopes of those ranges.
SurfaceRow on_lines(const SurfaceRow& anchor, const std::vector<SlopeRange>& slopes, double y_mm) {
    SurfaceRow row = anchor;
    row.y_mm = y_mm;
    const double run = y_mm - anchor.y_mm;
    row.radius_mm += slopes[0].end() * run;
    row.centre_mm += dvec2(slopes[1].end(), slopes[2].end()) * run;
    for (std::size_t k = 0; k < row.dents_mm.size(); ++k)
        row.dents_mm[k] += slopes[3 + k].end() * run;
    return row;
}

}  // namespace

std::vector<RingRun> ring_runs(const PotRings& rings) {
    std::vector<RingRun> runs;
    for (int i = 0; i < rings.count();) {
        const bool hollow = rings.is_hollow(i);
        const int first = i;
        while (i < rings.count() && rings.is_hollow(i) == hollow)
            ++i;
        const double height = rings.bottom_mm(i) - rings.bottom_mm(first);
        const bool joins = !runs.empty() && (height < kFlakeMm || runs.back().hollow == hollow);
        if (joins)
            runs.back().end = i;
        else
            runs.push_back({first, i, hollow});
    }
    if (runs.size() > 1 && rings.bottom_mm(runs[1].first) < kFlakeMm) {
        runs[1].first = 0;
        runs.erase(runs.begin());
    }
    return runs;
}

Face face_of(const PotRings& rings, Which which, int first, int end, int corners) {
    const auto has_face = [&](int ring) { return which == Which::kOuter || rings.is_hollow(ring); };
    const double top_mm = rings.bottom_mm(end);
    const double bottom_mm = rings.bottom_mm(first);
    // A flake of the other kind at either end contributes only its height.
    while (first + 1 < end && !has_face(first))
        ++first;
    while (first + 1 < end && !has_face(end - 1))
        --end;
    Face face{row_at(rings, which, first, bottom_mm, corners)};
    int below = first;
    for (int i = first; i < end; ++i) {
        if (!has_face(i)) continue;
        const SurfaceRow row = row_at(rings, which, i, rings.middle_mm(i), corners);
        const double ring_mm = row.y_mm - (i > first ? rings.middle_mm(below) : bottom_mm);
        if (is_ledge(face.back().radius_mm, row.radius_mm, ring_mm)) {
            const double edge_mm = rings.bottom_mm(i);
            if (edge_mm - face.back().y_mm >= kNearestRowsMm)
                face.push_back(row_at(rings, which, below, edge_mm, corners));
            face.push_back(row_at(rings, which, i, face.back().y_mm, corners));
        }
        below = i;
        if (row.y_mm - face.back().y_mm >= kNearestRowsMm) face.push_back(row);
    }
    if (face.size() > 1 && top_mm - face.back().y_mm < kNearestRowsMm) face.pop_back();
    face.push_back(row_at(rings, which, end - 1, top_mm, corners));
    return face;
}

Face thinned(const Face& face, double tolerance_mm) {
    Face out{face.front()};
    const std::size_t numbers = 3 + face.front().dents_mm.size();
    std::vector<SlopeRange> slopes(numbers);
    for (std::size_t i = 1; i < face.size();) {
        const double run = face[i].y_mm - out.back().y_mm;
        const bool is_ledge_here = face[i].y_mm <= face[i - 1].y_mm;
        if (is_ledge_here) {
            if (run > 0.0) out.push_back(on_lines(out.back(), slopes, face[i - 1].y_mm));
            out.push_back(face[i++]);
            slopes.assign(numbers, {});
            continue;
        }
        bool passes = true;
        std::size_t number = 0;
        visit_numbers(out.back(), face[i], [&](double from, double to) {
            passes = passes && slopes[number++].pass(run, to - from, tolerance_mm);
        });
        if (passes) {
            ++i;
            continue;
        }
        // The ranges narrowed by the rejected point still pass all points before it.
        out.push_back(on_lines(out.back(), slopes, face[i - 1].y_mm));
        slopes.assign(numbers, {});
    }
    out.push_back(on_lines(out.back(), slopes, face.back().y_mm));
    return out;
}

Face spread(const Face& face, double nearest_mm) {
    Face out{face.front()};
    for (const SurfaceRow& row : std::span(face).subspan(1)) {
        const bool is_last = &row == &face.back();
        while (is_last && out.size() > 1 && pot::distance_mm(out.back(), row) < nearest_mm)
            out.pop_back();
        if (is_last || pot::distance_mm(out.back(), row) >= nearest_mm) out.push_back(row);
    }
    return out;
}

double thinnest_mm(const PotRings& rings) {
    double thinnest = rings.outer_mm.front();
    for (int i = 0; i < rings.count(); ++i)
        thinnest = std::min(thinnest, rings.outer_mm[PotRings::at(i)] - rings.inner(i));
    return thinnest;
}

}  // namespace onggi::exporter
