// See surface_builder.h. Any thread but the haptic one.
#include "game/pot/surface_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace onggi::pot {
namespace {

// Adjacent pieces of the outline that turn by more than this form an edge: cos 20 degrees. A line thinned to
// the finest setting turns by 15 degrees a corner where a tool of 2 mm has pressed, so round shapes stay
// smooth.
constexpr double kCreaseCosine = 0.9396926207859084;

// The right-hand normal of the walk between two rows at a corner, in the plane of that corner and the axis.
dvec2 normal_between(const SurfaceRow& from, const SurfaceRow& to, std::size_t corner,
                     const dvec2& direction) {
    const double out =
        to.corner_mm(corner) - from.corner_mm(corner) + glm::dot(to.centre_mm - from.centre_mm, direction);
    return glm::normalize(dvec2(to.y_mm - from.y_mm, -out));
}

// Whether the surface has an edge at `row`, at any corner.
bool is_edge(const SurfaceRow& before, const SurfaceRow& row, const SurfaceRow& after,
             const std::vector<dvec2>& circle) {
    for (std::size_t k = 0; k < circle.size(); ++k) {
        const dvec2 below = normal_between(before, row, k, circle[k]);
        const dvec2 above = normal_between(row, after, k, circle[k]);
        if (glm::dot(below, above) < kCreaseCosine) return true;
    }
    return false;
}

// The row on the straight surface between two others.
SurfaceRow between(const SurfaceRow& from, const SurfaceRow& to, double fraction) {
    SurfaceRow row{.y_mm = glm::mix(from.y_mm, to.y_mm, fraction),
                   .radius_mm = glm::mix(from.radius_mm, to.radius_mm, fraction),
                   .centre_mm = glm::mix(from.centre_mm, to.centre_mm, fraction),
                   .inside = fraction < 0.5 ? from.inside : to.inside,
                   .dents_mm = from.dents_mm};
    for (std::size_t k = 0; k < row.dents_mm.size(); ++k)
        row.dents_mm[k] = glm::mix(from.dents_mm[k], to.dents_mm[k], fraction);
    return row;
}

// A walk's outline by the distance along it, and which of its rows are edges.
class EdgedLine {
  public:
    EdgedLine(const Walk& walk, int corners) : rows_(walk.rows) {
        const std::vector<dvec2> circle = unit_circle(corners);
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const bool is_end = i == 0 || i + 1 == rows_.size();
            along_mm_.push_back(i == 0 ? 0.0 : along_mm_.back() + distance_mm(rows_[i - 1], rows_[i]));
            is_edge_.push_back(is_end ? !walk.meets_itself
                                      : is_edge(rows_[i - 1], rows_[i], rows_[i + 1], circle));
        }
    }

    [[nodiscard]] bool has_edge(std::size_t i) const { return is_edge_[i]; }
    [[nodiscard]] double along_mm(std::size_t i) const { return along_mm_[i]; }

    // From the edge i to where its rounding begins; beyond an end of the walk lies its disc. Two edges divide
    // what is between them.
    [[nodiscard]] double room_mm(std::size_t i, bool after, double within_mm) const {
        const std::size_t last = rows_.size() - 1;
        if (i == (after ? last : 0)) return std::min(within_mm, rows_[i].radius_mm / 3.0);
        std::size_t next = i;
        do
            next = after ? next + 1 : next - 1;
        while (next > 0 && next < last && !is_edge_[next]);
        return std::min(within_mm, std::abs(along_mm_[next] - along_mm_[i]) / 2.0);
    }

    [[nodiscard]] SurfaceRow at(double along_mm) const {
        if (along_mm < 0.0) return on_disc(rows_.front(), -along_mm);
        if (along_mm > along_mm_.back()) return on_disc(rows_.back(), along_mm - along_mm_.back());
        const auto above = std::lower_bound(along_mm_.begin() + 1, along_mm_.end() - 1, along_mm);
        const auto next = static_cast<std::size_t>(above - along_mm_.begin());
        const double length_mm = along_mm_[next] - along_mm_[next - 1];
        const double fraction = length_mm > 0.0 ? (along_mm - along_mm_[next - 1]) / length_mm : 0.0;
        return between(rows_[next - 1], rows_[next], fraction);
    }

  private:
    static SurfaceRow on_disc(const SurfaceRow& rim, double inwards_mm) {
        SurfaceRow middle = rim;
        middle.radius_mm = 0.0;
        return between(rim, middle, inwards_mm / rim.radius_mm);
    }

    const std::vector<SurfaceRow>& rows_;
    std::vector<double> along_mm_;
    std::vector<bool> is_edge_;
};

struct PlacedRow {
    double along_mm = 0.0;
    SurfaceRow row;
};

// The parabola that touches both sides of an edge at that distance.
std::vector<PlacedRow> parabola(const EdgedLine& line, std::size_t edge, double room_mm) {
    const double at_mm = line.along_mm(edge);
    const SurfaceRow corner = line.at(at_mm);
    const SurfaceRow from = line.at(at_mm - room_mm);
    const SurfaceRow to = line.at(at_mm + room_mm);
    SurfaceRow middle = between(corner, between(from, to, 0.5), 0.5);
    middle.inside = corner.inside;
    return {{at_mm - room_mm, from}, {at_mm, middle}, {at_mm + room_mm, to}};
}

// Gap between two walks in the pictures, so that they do not bleed into each other.
constexpr double kBetweenWalksMm = 3.0;

}  // namespace

std::vector<dvec2> unit_circle(int n) {
    // Steps of 90 or 30 degrees are exact; halving leads to 360/n.
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
    // Quarter turns are exact, so opposite corners are too.
    for (std::size_t k = quarter; k < circle.size(); ++k) {
        circle[k] = dvec2(-circle[k - quarter].y, circle[k - quarter].x);
    }
    return circle;
}

std::vector<double> dents_at_corners(std::span<const float> sectors_mm, int count) {
    std::vector<double> dents(static_cast<std::size_t>(sectors_mm.empty() ? 0 : count), 0.0);
    const auto sectors = static_cast<int>(sectors_mm.size());
    const int width = std::max(sectors / count, 2);  // sectors a corner represents
    for (int k = 0; k < std::ssize(dents); ++k) {
        const int middle = k * sectors / count;  // the sector just after the corner
        double sum = 0.0;
        for (int j = -width / 2; j < width - width / 2; ++j)
            sum += static_cast<double>(
                sectors_mm[static_cast<std::size_t>((middle + j + sectors) & (sectors - 1))]);
        dents[static_cast<std::size_t>(k)] = sum / width;
    }
    return dents;
}

double distance_mm(const SurfaceRow& a, const SurfaceRow& b) {
    return std::hypot(b.radius_mm - a.radius_mm, b.y_mm - a.y_mm);
}

Walk rounded(const Walk& walk, const Rounding& rounding, int corners) {
    const std::vector<SurfaceRow>& rows = walk.rows;
    const EdgedLine line(walk, corners);
    std::vector<PlacedRow> placed;                       // of edges
    std::vector<std::pair<double, double>> replaced_mm;  // parts of the line
    const auto is_near = [&](const SurfaceRow& a, const SurfaceRow& b) {
        return distance_mm(a, b) < rounding.apart_mm;
    };
    const auto put = [&](double along_mm) { placed.push_back({along_mm, line.at(along_mm)}); };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!line.has_edge(i)) continue;
        const double at_mm = line.along_mm(i);
        const double before_mm = line.room_mm(i, false, rounding.within_mm);
        const double after_mm = line.room_mm(i, true, rounding.within_mm);
        const double room_mm = std::min(before_mm, after_mm);
        const double least_mm = 2.0 * rounding.apart_mm;
        if (room_mm < least_mm) {
            // The ring keeps the disc flat.
            if (i == 0 && before_mm >= least_mm) put(at_mm - before_mm);
            placed.push_back({at_mm, rows[i]});
            if (i + 1 == rows.size() && after_mm >= least_mm) put(at_mm + after_mm);
            continue;
        }
        // A flat ring keeps the disc's normal from the parabola.
        if (i == 0) put(at_mm - 2.0 * room_mm);
        std::vector<PlacedRow> round = parabola(line, i, room_mm);
        // Two roundings meet in a row.
        if (!placed.empty() && is_near(placed.back().row, round.front().row)) round.erase(round.begin());
        std::move(round.begin(), round.end(), std::back_inserter(placed));
        if (i + 1 == rows.size()) put(at_mm + 2.0 * room_mm);
        replaced_mm.emplace_back(at_mm - room_mm, at_mm + room_mm);
    }
    Walk out{.meets_itself = walk.meets_itself, .is_smooth = true};
    auto next = placed.begin();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (line.has_edge(i)) continue;
        const double at_mm = line.along_mm(i);
        for (; next != placed.end() && next->along_mm <= at_mm; ++next)
            out.rows.push_back(next->row);
        const bool is_end = i == 0 || i + 1 == rows.size();
        const bool is_replaced =
            std::any_of(replaced_mm.begin(), replaced_mm.end(),
                        [&](const auto& part) { return at_mm > part.first && at_mm < part.second; }) ||
            (next != placed.end() && is_near(rows[i], next->row)) ||
            (next != placed.begin() && is_near(rows[i], (next - 1)->row));
        if (is_end || !is_replaced) out.rows.push_back(rows[i]);
    }
    for (; next != placed.end(); ++next)
        out.rows.push_back(next->row);
    return out;
}

SurfaceBuilder::SurfaceBuilder(int corners, bool unwraps)
    : circle_(unit_circle(corners)),
      unwraps_(unwraps) {}

// With texture coordinates, a row's first corner is doubled at the seam.
std::uint32_t SurfaceBuilder::in_row() const {
    return static_cast<std::uint32_t>(circle_.size()) + (unwraps_ ? 1U : 0U);
}

std::uint32_t SurfaceBuilder::next_of(std::uint32_t corner) const {
    return unwraps_ ? corner + 1 : (corner + 1) % static_cast<std::uint32_t>(circle_.size());
}

std::uint32_t SurfaceBuilder::add_row(const SurfaceRow& row) {
    const auto first = static_cast<std::uint32_t>(positions_mm.size());
    for (std::uint32_t k = 0; k < in_row(); ++k) {
        const std::size_t corner = k % circle_.size();
        const dvec2 across = row.centre_mm + row.corner_mm(corner) * circle_[corner];
        positions_mm.emplace_back(across.x, row.y_mm, -across.y);
        normals.emplace_back(0.0);
    }
    strips_.push_back({first, in_row(), along_mm_, row.radius_mm, row.y_mm, row.inside, false});
    return first;
}

// Connects one row of the walk to the next. Normals: each four-cornered face adds its area to its corners.
void SurfaceBuilder::add_band(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t k = 0; k < circle_.size(); ++k) {
        const std::uint32_t next = next_of(k);
        add_triangle(from + k, from + next, to + next);
        add_triangle(from + k, to + next, to + k);
        const dvec3 area = glm::cross(positions_mm[to + next] - positions_mm[from + k],
                                      positions_mm[to + k] - positions_mm[from + next]);
        for (const std::uint32_t corner : {from + k, from + next, to + k, to + next})
            normals[corner] += area;
    }
}

void SurfaceBuilder::add_middle(const SurfaceRow& rim, bool faces_up) {
    const auto first = static_cast<std::uint32_t>(positions_mm.size());
    const auto count = unwraps_ ? static_cast<std::uint32_t>(circle_.size()) : 1U;
    strips_.push_back({first, count, along_mm_, 0.0, rim.y_mm, rim.inside, true});
    for (std::uint32_t k = 0; k < count; ++k) {
        positions_mm.emplace_back(rim.centre_mm.x, rim.y_mm, -rim.centre_mm.y);
        normals.emplace_back(0.0, faces_up ? 1.0 : -1.0, 0.0);
    }
}

void SurfaceBuilder::add_disc(const SurfaceRow& rim, bool faces_up) {
    const double from_mm = along_mm_;
    along_mm_ += faces_up ? 0.0 : rim.radius_mm;
    const std::uint32_t ring = add_row(rim);
    for (std::uint32_t k = 0; k < in_row(); ++k)
        normals[ring + k] = dvec3(0.0, faces_up ? 1.0 : -1.0, 0.0);
    const std::uint32_t middle = ring + in_row();
    const double rim_along_mm = along_mm_;
    along_mm_ = faces_up ? rim_along_mm + rim.radius_mm : from_mm;
    add_middle(rim, faces_up);
    if (!faces_up) {
        // The walk comes from the middle of the disc.
        along_mm_ = rim_along_mm;
        std::swap(strips_[strips_.size() - 1], strips_[strips_.size() - 2]);
    }
    for (std::uint32_t k = 0; k < circle_.size(); ++k) {
        const std::uint32_t centre = middle + (unwraps_ ? k : 0U);
        if (faces_up)
            add_triangle(ring + k, ring + next_of(k), centre);
        else
            add_triangle(ring + next_of(k), ring + k, centre);
    }
}

void SurfaceBuilder::add_walk(const Walk& walk) {
    const std::vector<SurfaceRow>& rows = walk.rows;
    if (!strips_.empty()) along_mm_ += kBetweenWalksMm;
    if (!walk.meets_itself) add_disc(rows.front(), false);
    std::uint32_t from = add_row(rows.front());
    for (std::size_t i = 1; i < rows.size(); ++i) {
        along_mm_ += distance_mm(rows[i - 1], rows[i]);
        std::uint32_t to = add_row(rows[i]);
        add_band(from, to);
        const bool is_parted =
            !walk.is_smooth && i + 1 < rows.size() && is_edge(rows[i - 1], rows[i], rows[i + 1], circle_);
        if (is_parted) to = add_row(rows[i]);
        from = to;
    }
    if (walk.meets_itself) {
        const std::uint32_t last = add_row(rows.back());
        along_mm_ += distance_mm(rows.back(), rows.front());
        add_band(last, add_row(rows.front()));
    } else {
        add_disc(rows.back(), true);
    }
}

void SurfaceBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices.insert(indices.end(), {a, b, c});
}

double SurfaceBuilder::volume_mm3() const {
    double six_volumes = 0.0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        six_volumes += glm::dot(positions_mm[indices[i]],
                                glm::cross(positions_mm[indices[i + 1]], positions_mm[indices[i + 2]]));
    }
    return six_volumes / 6.0;
}

void SurfaceBuilder::finish_normals() {
    // Both copies of a doubled corner get the same normal.
    for (const Strip& strip : strips_) {
        if (!unwraps_ || strip.is_middle) continue;
        const std::uint32_t last = strip.first + in_row() - 1;
        const dvec3 discs(0.0, normals[strip.first].y > 0.0 ? 1.0 : -1.0, 0.0);
        const bool is_disc = normals[strip.first] == discs && normals[last] == discs;
        if (!is_disc) normals[strip.first] = normals[last] = normals[strip.first] + normals[last];
    }
    for (dvec3& normal : normals)
        normal = glm::normalize(normal);
    mend_normals();
}

// In a deep, narrow dent the area-weighted mean of a corner's faces can point away from a small face. Such a
// normal is turned towards that face until it agrees with all its faces, or kMostTurns is reached.
void SurfaceBuilder::mend_normals() {
    constexpr int kMostTurns = 32;
    constexpr double kAgrees = 0.05;  // cosine
    std::vector<dvec3> faces;
    faces.reserve(indices.size() / 3);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const dvec3& a = positions_mm[indices[i]];
        const dvec3 area = glm::cross(positions_mm[indices[i + 1]] - a, positions_mm[indices[i + 2]] - a);
        faces.push_back(area / std::max(glm::length(area), 1e-300));
    }
    for (int turn = 0; turn < kMostTurns; ++turn) {
        bool is_mended = false;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            dvec3& normal = normals[indices[i]];
            const double agreement = glm::dot(normal, faces[i / 3]);
            if (agreement >= kAgrees) continue;
            normal = glm::normalize(normal + (2.0 * kAgrees - agreement) * faces[i / 3]);
            is_mended = true;
        }
        if (!is_mended) return;
    }
}

double SurfaceBuilder::turns(const Strip& strip, std::uint32_t k) const {
    return (k + (strip.is_middle ? 0.5 : 0.0)) / static_cast<double>(circle_.size());
}

dvec2 SurfaceBuilder::outward(const Strip& strip, std::uint32_t k) const {
    const dvec2& corner = circle_[k % circle_.size()];
    return strip.is_middle ? glm::normalize(corner + circle_[(k + 1) % circle_.size()]) : corner;
}

}  // namespace onggi::pot
