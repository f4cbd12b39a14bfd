#include "game/look/pot_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/core/quote.h"
#include "engine/ui/sketch.h"
#include "game/exporter/pot_solid.h"
#include "game/exporter/studio_export.h"
#include "game/pot/surface_builder.h"

namespace onggi::look {
namespace {

constexpr float kOutlineMm = 0.5F;
constexpr float kRimMm = 0.35F;
constexpr float kAxisMm = 0.25F;
constexpr float kDimensionMm = 0.18F;
constexpr float kHatchMm = 0.13F;
constexpr double kHatchedMm = 1.1;  // from one line to the next
constexpr float kMarginMm = 10.0F;
constexpr float kLeastPageMm = 120.0F;  // wide enough for the measures
constexpr float kBarMm = 1.6F;          // height of the scale bar

constexpr ui::Colour kInk = ui::hex(0x000000);

// Lengths in mm at the stage; x to the right from the axis, y up from the foot.
struct Profile {
    std::vector<std::vector<dvec2>> section;  // outlines of the clay left of the axis, open at it
    std::vector<dvec2> elevation;             // right of the axis, from the foot up to the rim
    dvec2 rim_inside{0.0};                    // of the section
    double left_mm = 0.0;                     // largest distance from the axis
    double right_mm = 0.0;

    [[nodiscard]] double height_mm() const { return elevation.back().y; }
};

Profile profile_of(const exporter::PotSolid& solid, double scale) {
    const std::vector<dvec2> circle = pot::unit_circle(solid.corners);
    const double across = scale * solid.across_scale;
    const auto place = [&](const pot::SurfaceRow& row, std::size_t corner) {
        return dvec2((row.centre_mm.x + row.corner_mm(corner) * circle[corner].x) * across, row.y_mm * scale);
    };
    Profile profile;
    for (const pot::Walk& walk : solid.walks) {
        std::vector<dvec2>& outline = profile.section.emplace_back();
        for (const pot::SurfaceRow& row : walk.rows) {
            outline.push_back(place(row, circle.size() / 2));
            outline.back().x = std::min(outline.back().x, 0.0);
            profile.left_mm = std::max(profile.left_mm, -outline.back().x);
        }
        if (walk.meets_itself) {
            outline.push_back(outline.front());
        } else {
            outline.insert(outline.begin(), {0.0, outline.front().y});
            outline.push_back({0.0, outline.back().y});
        }
    }
    // The last walk goes up the outside and down the inside.
    for (const pot::SurfaceRow& row : solid.walks.back().rows) {
        if (row.inside) continue;
        dvec2 farthest = place(row, 0);
        for (std::size_t k = 1; k < circle.size(); ++k)
            if (const dvec2 other = place(row, k); other.x > farthest.x) farthest = other;
        profile.elevation.push_back(farthest);
        profile.right_mm = std::max(profile.right_mm, farthest.x);
    }
    const auto& rows = solid.walks.back().rows;
    profile.rim_inside = {0.0, profile.height_mm()};
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i].inside && !rows[i - 1].inside) profile.rim_inside = place(rows[i], circle.size() / 2);
    return profile;
}

// The parts of lines at 45 degrees that lie within the outlines, by the even-odd rule.
std::vector<std::pair<dvec2, dvec2>> hatching(const std::vector<std::vector<dvec2>>& outlines) {
    // Along the lines, and from one to the next.
    const auto turned = [](const dvec2& p) { return dvec2(p.x + p.y, p.y - p.x) * std::sqrt(0.5); };
    const auto back = [](const dvec2& p) { return dvec2(p.x - p.y, p.x + p.y) * std::sqrt(0.5); };
    double low = 0.0;
    double high = 0.0;
    for (const auto& outline : outlines) {
        for (const dvec2& point : outline) {
            low = std::min(low, turned(point).y);
            high = std::max(high, turned(point).y);
        }
    }
    std::vector<std::pair<dvec2, dvec2>> lines;
    for (double at = low + 0.5 * kHatchedMm; at < high; at += kHatchedMm) {
        std::vector<double> crossings;
        for (const auto& outline : outlines) {
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const dvec2 from = turned(outline[i]);
                const dvec2 to = turned(outline[(i + 1) % outline.size()]);
                if ((from.y > at) != (to.y > at))
                    crossings.push_back(from.x + (to.x - from.x) * (at - from.y) / (to.y - from.y));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            lines.emplace_back(back({crossings[i], at}), back({crossings[i + 1], at}));
    }
    return lines;
}

// Heights at which the outside has an edge, away from foot and rim.
std::vector<dvec2> edges_of(const std::vector<dvec2>& elevation) {
    constexpr double kSharp = 0.82;   // cosine of 35 degrees
    constexpr double kAwayMm = 1.5;   // of the ends, and of each other
    constexpr double kPieceMm = 1.0;  // over which a direction is taken
    std::vector<dvec2> edges;
    const auto direction = [&](std::size_t from, int step) {
        std::size_t to = from;
        while (to + static_cast<std::size_t>(step) < elevation.size() &&
               glm::distance(elevation[from], elevation[to]) < kPieceMm)
            to += static_cast<std::size_t>(step);
        return to == from ? dvec2(0.0, 1.0) : glm::normalize(elevation[to] - elevation[from]);
    };
    for (std::size_t i = 1; i + 1 < elevation.size(); ++i) {
        const double y = elevation[i].y;
        if (y < kAwayMm || y > elevation.back().y - kAwayMm) continue;
        if (!edges.empty() && y - edges.back().y < kAwayMm) continue;
        if (glm::dot(direction(i, 1), -direction(i, -1)) < kSharp) edges.push_back(elevation[i]);
    }
    return edges;
}

std::vector<std::string> captions_of(const clay::StudioClay& clay, clay::Firing stage,
                                     const std::string& credit) {
    const clay::ClayBody body = clay.lump().body;
    const clay::PotMeasures pot = clay::measure_pot(clay.rings(), body, stage);
    std::vector<std::string> lines{
        fmt::format("Height {:.1f}, rim Ø {:.1f}, largest Ø {:.1f}, foot Ø {:.1f} mm", pot.height_mm,
                    pot.mouth_mm, pot.widest_mm, pot.foot_mm)};
    if (pot.thickest_wall_mm > 0.0) {
        lines.push_back(fmt::format("Wall {:.1f} to {:.1f}, floor {:.1f} mm; {:.0f} g", pot.thinnest_wall_mm,
                                    pot.thickest_wall_mm, pot.floor_mm, pot.mass_g));
    }
    if (pot.capacity_ml > 0.0) lines.push_back(fmt::format("Capacity {:.0f} ml to the rim", pot.capacity_ml));
    if (const auto neck = exporter::neck_of(clay, stage)) {
        lines.back() += fmt::format(", {:.0f} ml to the neck (Ø {:.1f} at {:.1f} mm)", neck->capacity_ml,
                                    neck->diameter_mm, neck->height_mm);
    }
    if (stage != clay::Firing::kWet) {
        lines.push_back(fmt::format("Thrown {:.1f} mm high, shrunk by {:.1f} %", clay.height_mm(),
                                    100.0 * (1.0 - clay::shrunk_scale(body, stage))));
    }
    lines.push_back(credit + (credit.empty() ? "" : "; ") + std::string(exporter::program_name()));
    return lines;
}

// Page of the drawing: x to the right, y down, mm.
class Page {
  public:
    Page(const Profile& profile, ui::Painter& painter) : profile_(profile), painter_(painter) {
        constexpr float kDimensions = 22.0F;  // right of the pot
        const auto pot_mm = static_cast<float>(profile.left_mm + profile.right_mm);
        sketch_.size.x = std::max(pot_mm + kDimensions + 2.0F * kMarginMm, kLeastPageMm);
        const float free_mm = sketch_.size.x - pot_mm - kDimensions;
        axis_ = {0.5F * free_mm + static_cast<float>(profile.left_mm),
                 kMarginMm + 12.0F + static_cast<float>(profile.height_mm())};
        below_ = axis_.y + 10.0F;
    }

    void draw_pot() {
        const double top = profile_.height_mm();
        std::string hatched;
        for (const auto& [from, to] : hatching(profile_.section))
            hatched += path_of({from, to});
        stroke(hatched, kHatchMm);
        for (const dvec2& edge : edges_of(profile_.elevation))
            line({0.0, edge.y}, edge, kAxisMm);
        line({0.0, 0.0}, {0.0, top}, kAxisMm);
        line({profile_.rim_inside.x, top}, profile_.elevation.back(), kRimMm);
        line({0.0, 0.0}, profile_.elevation.front(), kRimMm);
        for (const std::vector<dvec2>& outline : profile_.section)
            stroke(path_of(outline), kOutlineMm);
        stroke(path_of(profile_.elevation), kOutlineMm);
    }

    // Dimension lines end in short bars.
    void draw_dimensions(double rim_mm) {
        constexpr double kBar = 1.2;
        const double top = profile_.height_mm();
        const double right = profile_.right_mm + 7.0;
        const double above = top + 6.0;
        const double rim_left = rim_left_mm();
        const double rim_right = profile_.elevation.back().x;
        line({rim_left, above}, {rim_right, above}, kDimensionMm);
        line({right, 0.0}, {right, top}, kDimensionMm);
        for (const double x : {rim_left, rim_right})
            line({x, above - kBar}, {x, above + kBar}, kDimensionMm);
        for (const double y : {0.0, top})
            line({right - kBar, y}, {right + kBar, y}, kDimensionMm);
        const vec2 over_rim = on_page({0.5 * (rim_left + rim_right), above});
        write(fmt::format("Ø {:.1f}", rim_mm), {over_rim.x - 30.0F, over_rim.y - 5.0F}, 60.0F,
              ui::Align::kCentre);
        const vec2 beside = on_page({right + 2.0, 0.5 * top});
        write(fmt::format("{:.1f}", top), {beside.x, beside.y - 2.2F}, 0.0F, ui::Align::kStart);
    }

    // Centimetres, black and white in turn.
    void draw_scale() {
        const int length_cm = profile_.left_mm + profile_.right_mm >= 100.0 ? 10 : 5;
        const float left = axis_.x - 5.0F * static_cast<float>(length_cm);
        for (int i = 0; i < length_cm; ++i) {
            const ui::Rect piece{left + 10.0F * static_cast<float>(i), below_, 10.0F, kBarMm};
            if (i % 2 == 0) sketch_.add(ui::Box{.rect = piece, .fill = ui::Fill::flat(kInk)});
        }
        sketch_.add(ui::Frame{.rect = {left, below_, 10.0F * static_cast<float>(length_cm), kBarMm},
                              .width = kAxisMm,
                              .colour = kInk});
        write("0", {left - 10.0F, below_ + 2.2F}, 20.0F, ui::Align::kCentre);
        write(fmt::format("{} cm", length_cm),
              {left + 10.0F * static_cast<float>(length_cm) - 10.0F, below_ + 2.2F}, 20.0F,
              ui::Align::kCentre);
        below_ += 10.0F;
    }

    void write_captions(const std::string& title, const std::vector<std::string>& lines) {
        below_ += caption(title, true);
        for (const std::string& one : lines)
            below_ += caption(one, false);
    }

    // The finished page, on white.
    ui::Sketch finished() {
        sketch_.size.y = below_ + kMarginMm;
        const ui::Box paper{.rect = {0.0F, 0.0F, sketch_.size.x, sketch_.size.y},
                            .fill = ui::Fill::flat(ui::hex(0xFFFFFF))};
        sketch_.items.insert(sketch_.items.begin(), paper);
        return std::move(sketch_);
    }

  private:
    [[nodiscard]] vec2 on_page(const dvec2& place) const {
        return {axis_.x + static_cast<float>(place.x), axis_.y - static_cast<float>(place.y)};
    }
    [[nodiscard]] std::string path_of(const std::vector<dvec2>& points) const {
        std::string path;
        for (const dvec2& point : points) {
            const vec2 at = on_page(point);
            path += fmt::format("{}{:.3f} {:.3f}", path.empty() ? 'M' : 'L', at.x, at.y);
        }
        return path;
    }
    // The outside of the section at the rim.
    [[nodiscard]] double rim_left_mm() const {
        double left = 0.0;
        for (const dvec2& point : profile_.section.back())
            if (point.y >= profile_.height_mm() - 1e-6) left = std::min(left, point.x);
        return left;
    }
    void stroke(std::string path, float width_mm) {
        if (path.empty()) return;
        sketch_.add(ui::Shape{.path = std::move(path), .stroke = kInk, .stroke_width = width_mm});
    }
    void line(const dvec2& from, const dvec2& to, float width_mm) { stroke(path_of({from, to}), width_mm); }
    void write(std::string words, const vec2& at, float box_width, ui::Align align) {
        sketch_.add(
            ui::Writing{.at = at, .text = text(std::move(words), false, align), .box_width = box_width});
    }
    // Its height.
    float caption(const std::string& words, bool is_bold) {
        if (words.empty()) return 0.0F;
        ui::Text written = text(words, is_bold, ui::Align::kStart);
        written.width = sketch_.size.x - 2.0F * kMarginMm;
        sketch_.add(ui::Writing{.at = {kMarginMm, below_}, .text = written});
        return painter_.measure(written).height;
    }
    static ui::Text text(std::string words, bool is_bold, ui::Align align) {
        return {
            .words = std::move(words),
            .style = {.bold = is_bold, .size = 3.2F, .line_height = 4.6F, .colour = kInk, .align = align}};
    }

    const Profile& profile_;
    ui::Painter& painter_;
    ui::Sketch sketch_;
    vec2 axis_{0.0F};  // its foot
    float below_ = 0.0F;
};

}  // namespace

Result<ui::VectorKind> drawing_kind_of(std::string_view path) {
    if (path.ends_with(".svg")) return ui::VectorKind::kSvg;
    if (path.ends_with(".pdf")) return ui::VectorKind::kPdf;
    return bad_input(fmt::format("{}: expected a drawing's ending (.svg or .pdf)", shown_path(path)));
}

Result<std::vector<std::byte>> pot_drawing(const clay::StudioClay& clay, clay::Firing stage,
                                           ui::VectorKind kind, const std::string& credit) {
    const clay::ClayBody body = clay.lump().body;
    const double scale = clay::shrunk_scale(body, stage);
    const auto solid = exporter::build_pot_solid(exporter::rings_of(clay.rings()), {.shrinkage = scale});
    if (!solid) return solid.error();
    const Profile profile = profile_of(*solid, scale);
    const std::string title = "Pot, " + exporter::pot_name(body, stage);
    ui::Painter painter;
    Page page(profile, painter);
    page.draw_pot();
    page.draw_dimensions(clay::measure_pot(clay.rings(), body, stage).mouth_mm);
    page.draw_scale();
    page.write_captions(title, captions_of(clay, stage, credit));
    return painter.draw_vectors(page.finished(), kind, title, credit);
}

}  // namespace onggi::look
