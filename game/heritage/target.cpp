#include "game/heritage/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/number_in.h"
#include "engine/core/quote.h"
#include "engine/core/table.h"
#include "engine/files/read_file.h"

namespace onggi::heritage {
namespace {

constexpr double kLongestMm = 2000.0;
constexpr double kHeaviestG = 100000.0;
constexpr double kAgreesMm = 0.05;
constexpr std::size_t kFewestPoints = 4;

// Reads the fields of one row and keeps the first error.
class Fields {
  public:
    Fields(const TableRow& row, std::string_view name) : row_(row), name_(name) {}

    [[nodiscard]] const std::string& text(std::size_t column) const { return row_.fields[column]; }

    std::optional<double> number(std::size_t column, std::string_view what, double least, double most) {
        const std::string& field = row_.fields[column];
        if (field.empty()) return std::nullopt;
        const auto value = number_in<double>(field);
        if (!value || !(*value >= least && *value <= most)) {
            fail(fmt::format("{}: expected nothing or {} to {}, found {}", what, least, most,
                             in_quotes(field)));
            return std::nullopt;
        }
        return value;
    }
    double needed_number(std::size_t column, std::string_view what, double least, double most) {
        const auto value = number(column, what, least, most);
        if (!value) fail(fmt::format("{}: expected {} to {}, found nothing", what, least, most));
        return value.value_or(least);
    }
    void fail(std::string_view what) {
        if (!error_) error_ = at_row(name_, row_.line, what);
    }
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    const TableRow& row_;
    std::string_view name_;
    std::optional<Error> error_;
};

bool is_id(std::string_view id) {
    return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
}

auto found(std::vector<Target>& targets, std::string_view id) {
    return std::find_if(targets.begin(), targets.end(),
                        [&](const Target& target) { return target.id == id; });
}

Result<std::vector<Target>> parse_table_of_targets(std::string_view text, std::string_view name) {
    auto table = parse_table(text, name, kTargetsHeader);
    if (!table) return table.error();
    if (table->rows.empty()) return at_row(name, 2, "expected at least one row, found none");
    std::vector<Target> targets;
    for (const TableRow& row : table->rows) {
        Fields fields(row, name);
        Target target;
        target.id = fields.text(0);
        target.name = fields.text(1);
        target.place = fields.text(2);
        target.culture_date = fields.text(3);
        target.height_mm = fields.needed_number(4, "height_mm", 1.0, kLongestMm);
        target.max_diameter_mm = fields.number(5, "max_diameter_mm", 1.0, kLongestMm);
        target.mouth_mm = fields.number(6, "mouth_mm", 1.0, kLongestMm);
        target.foot_mm = fields.number(7, "foot_mm", 1.0, kLongestMm);
        target.wall_mm = fields.number(8, "wall_mm", 1.0, kLongestMm);
        target.mass_g = fields.number(9, "mass_g", 1.0, kHeaviestG);
        target.source = fields.text(10);
        target.note = fields.text(11);
        if (!is_id(target.id))
            fields.fail(
                fmt::format("id: expected letters a to z, digits and -, found {}", in_quotes(target.id)));
        if (found(targets, target.id) != targets.end())
            fields.fail(fmt::format("id: expected each target once, found {} again", target.id));
        if (target.name.empty() || target.place.empty() || target.source.empty())
            fields.fail("name, object and source: expected all three");
        for (const auto& part : {target.mouth_mm, target.foot_mm}) {
            if (part && target.max_diameter_mm && *part > *target.max_diameter_mm)
                fields.fail(
                    fmt::format("mouth_mm and foot_mm: expected at most the largest diameter of {}, "
                                "found {}",
                                *target.max_diameter_mm, *part));
        }
        if (fields.error()) return *fields.error();
        targets.push_back(std::move(target));
    }
    return targets;
}

// Returns the first fault of a whole outline; empty if it is valid.
std::string outline_fault(const Target& target) {
    const auto& points = target.outline;
    if (points.size() < kFewestPoints)
        return fmt::format("expected at least {} points, found {}", kFewestPoints, points.size());
    if (points.front().y_mm != 0.0) return fmt::format("expected y = 0 first, found {}", points.front().y_mm);
    if (std::fabs(points.back().y_mm - target.height_mm) > kAgreesMm)
        return fmt::format("expected to end at {} mm, found {}", target.height_mm, points.back().y_mm);
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!(points[i].y_mm > points[i - 1].y_mm))
            return fmt::format("expected heights that rise, found {} after {}", points[i].y_mm,
                               points[i - 1].y_mm);
    }
    const auto disagrees = [](double radius_mm, const std::optional<double>& diameter_mm) {
        return diameter_mm && std::fabs(2.0 * radius_mm - *diameter_mm) > 2.0 * kAgreesMm;
    };
    if (disagrees(points.front().radius_mm, target.foot_mm))
        return fmt::format("expected the published foot of {} mm", *target.foot_mm);
    if (disagrees(points.back().radius_mm, target.mouth_mm))
        return fmt::format("expected the published mouth of {} mm", *target.mouth_mm);
    if (disagrees(0.5 * target.drawn_diameter_mm(), target.max_diameter_mm))
        return fmt::format("expected the published largest diameter of {} mm, found {}",
                           *target.max_diameter_mm, target.drawn_diameter_mm());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_published =
            (i == 0 && target.foot_mm) || (i + 1 == points.size() && target.mouth_mm) ||
            (target.max_diameter_mm && !disagrees(points[i].radius_mm, target.max_diameter_mm));
        if (points[i].published != is_published)
            return fmt::format("expected the basis {} at {} mm", is_published ? "published" : "drawn",
                               points[i].y_mm);
    }
    return {};
}

Result<void> add_outlines(std::vector<Target>& targets, std::string_view text, std::string_view name) {
    auto table = parse_table(text, name, kOutlinesHeader);
    if (!table) return table.error();
    std::vector<std::size_t> last_line(targets.size(), 1);
    for (const TableRow& row : table->rows) {
        Fields fields(row, name);
        const auto target = found(targets, fields.text(0));
        if (target == targets.end())
            return at_row(name, row.line,
                          fmt::format("id: expected a target's, found {}", in_quotes(fields.text(0))));
        const std::string& basis = fields.text(3);
        if (basis != "published" && basis != "drawn")
            fields.fail(fmt::format("basis: expected published or drawn, found {}", in_quotes(basis)));
        target->outline.push_back({.y_mm = fields.needed_number(1, "y_mm", 0.0, kLongestMm),
                                   .radius_mm = fields.needed_number(2, "radius_mm", 0.5, kLongestMm),
                                   .published = basis == "published"});
        if (fields.error()) return *fields.error();
        last_line[static_cast<std::size_t>(target - targets.begin())] = row.line;
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (const std::string fault = outline_fault(targets[i]); !fault.empty())
            return at_row(name, last_line[i], fmt::format("outline of {}: {}", targets[i].id, fault));
    }
    return {};
}

// The slope of the curve at point i: the weighted harmonic mean of the adjacent pieces' slopes, 0 if one
// rises and one falls; at the ends the piece's own slope.
double slope_at(const std::vector<OutlinePoint>& points, std::size_t i) {
    const auto step = [&](std::size_t k) { return points[k + 1].y_mm - points[k].y_mm; };
    const auto rise = [&](std::size_t k) {
        return (points[k + 1].radius_mm - points[k].radius_mm) / step(k);
    };
    if (i == 0) return rise(0);
    if (i + 1 == points.size()) return rise(i - 1);
    const double below = rise(i - 1);
    const double above = rise(i);
    if (below * above <= 0.0) return 0.0;
    const double a = 2.0 * step(i) + step(i - 1);
    const double b = step(i) + 2.0 * step(i - 1);
    return (a + b) / (a / below + b / above);
}

}  // namespace

double Target::radius_at(double y_mm) const {
    if (outline.empty()) return 0.0;
    if (!(y_mm > outline.front().y_mm)) return outline.front().radius_mm;
    if (y_mm >= outline.back().y_mm) return outline.back().radius_mm;
    const auto above = std::upper_bound(outline.begin(), outline.end(), y_mm,
                                        [](double y, const OutlinePoint& point) { return y < point.y_mm; });
    const auto i = static_cast<std::size_t>(above - outline.begin()) - 1;
    const double step = outline[i + 1].y_mm - outline[i].y_mm;
    const double s = (y_mm - outline[i].y_mm) / step;
    const double s2 = s * s;
    const double s3 = s2 * s;
    return (2.0 * s3 - 3.0 * s2 + 1.0) * outline[i].radius_mm +
           (s3 - 2.0 * s2 + s) * step * slope_at(outline, i) +
           (3.0 * s2 - 2.0 * s3) * outline[i + 1].radius_mm + (s3 - s2) * step * slope_at(outline, i + 1);
}

double Target::drawn_diameter_mm() const {
    double widest = 0.0;
    for (const OutlinePoint& point : outline)
        widest = std::max(widest, 2.0 * point.radius_mm);
    return widest;
}

Result<std::vector<Target>> parse_targets(std::string_view table, std::string_view outlines,
                                          std::string_view table_name, std::string_view outlines_name) {
    auto targets = parse_table_of_targets(table, table_name);
    if (!targets) return targets;
    if (auto added = add_outlines(*targets, outlines, outlines_name); !added) return added.error();
    return targets;
}

Result<std::vector<Target>> load_targets(const std::filesystem::path& folder) {
    const std::filesystem::path table_place = folder / "targets.csv";
    const std::filesystem::path outlines_place = folder / "outlines.csv";
    auto table = files::read_file(table_place, kMaxTableBytes);
    if (!table) return table.error();
    auto outlines = files::read_file(outlines_place, kMaxTableBytes);
    if (!outlines) return outlines.error();
    return parse_targets(*table, *outlines, table_place.string(), outlines_place.string());
}

Result<Target> find_target(std::span<const Target> targets, std::string_view id) {
    std::string known;
    for (const Target& target : targets) {
        if (target.id == id) return target;
        known += (known.empty() ? "" : ", ") + target.id;
    }
    return bad_input(fmt::format("target: expected one of {}; found {}", known, in_quotes(id)));
}

std::string sentence(const Target& target) {
    std::string text = fmt::format("{}, {}, {}: {:g} mm high", target.name, target.culture_date, target.place,
                                   target.height_mm);
    if (target.max_diameter_mm) text += fmt::format(", {:g} mm across", *target.max_diameter_mm);
    if (!target.note.empty()) text += fmt::format("; {}", target.note);
    return text + ".";
}

}  // namespace onggi::heritage
