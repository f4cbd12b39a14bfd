// A museum's pot as a target to throw: its published data, and an outline through them. Lengths are those of
// the fired pot, mm. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace onggi::heritage {

constexpr std::string_view kTargetsHeader =
    "id,name,object,culture_date,height_mm,max_diameter_mm,mouth_mm,foot_mm,wall_mm,mass_g,source,note";
constexpr std::string_view kOutlinesHeader = "id,y_mm,radius_mm,basis";

// One point of an outline. published: its radius is a published dimension; otherwise we drew it.
struct OutlinePoint {
    double y_mm = 0.0;
    double radius_mm = 0.0;
    bool published = false;
};

struct Target {
    std::string id;  // letters a to z, digits and -
    std::string name;
    std::string place;  // museum and object number
    std::string culture_date;
    // Unpublished values are empty and do not count in a score.
    double height_mm = 0.0;
    std::optional<double> max_diameter_mm;
    std::optional<double> mouth_mm;  // outer diameter at the rim
    std::optional<double> foot_mm;
    std::optional<double> wall_mm;
    std::optional<double> mass_g;
    std::string source;
    std::string note;
    std::vector<OutlinePoint> outline;  // from the foot up

    // The outline's radius at a height: smooth through its points, and always between the radii of the two
    // adjacent points (monotone cubic pieces, Fritsch and Carlson 1980).
    [[nodiscard]] double radius_at(double y_mm) const;
    // Twice the outline's largest radius, published or drawn.
    [[nodiscard]] double drawn_diameter_mm() const;
};

// Reads targets from one table and their outlines from another. kBadInput naming the line: an error of
// parse_table; an id that is malformed or comes twice; a number that is malformed, or not from 1 to 2000
// (mass to 100000); a mouth or foot wider than the pot; an outline of an unknown target, of fewer than four
// points, not rising from y = 0 to the height, wider than the pot, off a published dimension by more than
// 0.05 mm, or with a basis that is not published or drawn or not the right one.
Result<std::vector<Target>> parse_targets(std::string_view table, std::string_view outlines,
                                          std::string_view table_name, std::string_view outlines_name);

// The same from a folder's targets.csv and outlines.csv.
Result<std::vector<Target>> load_targets(const std::filesystem::path& folder);

// The target with that id. kBadInput listing the known ids.
Result<Target> find_target(std::span<const Target> targets, std::string_view id);

// One line for a visitor: name, date, place, size.
std::string sentence(const Target& target);

}  // namespace onggi::heritage
