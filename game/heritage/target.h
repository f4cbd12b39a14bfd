// A pot of a museum to throw after: what its museum publishes of it, and an outline through that. Lengths are
// those of the fired pot, mm. Any thread but the haptic one.
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

// One point of an outline. Published: its radius is a published dimension's; else it is drawn by us.
struct OutlinePoint {
    double y_mm = 0.0;
    double radius_mm = 0.0;
    bool published = false;
};

struct Target {
    std::string id;  // letters a to z, digits and -
    std::string name;
    std::string place;  // which one it is: museum and number
    std::string culture_date;
    // What is not published is not there, and no score counts it.
    double height_mm = 0.0;
    std::optional<double> max_diameter_mm;
    std::optional<double> mouth_mm;  // across the rim's outside
    std::optional<double> foot_mm;
    std::optional<double> wall_mm;
    std::optional<double> mass_g;
    std::string source;
    std::string note;
    std::vector<OutlinePoint> outline;  // from the foot up

    // The outline's radius at a height, smooth through its points and never beyond the radii of the two next
    // to it (monotone cubic pieces, Fritsch and Carlson 1980).
    [[nodiscard]] double radius_at(double y_mm) const;
    // Twice the outline's largest radius: published, or else ours.
    [[nodiscard]] double drawn_diameter_mm() const;
};

// Targets of a table and their outlines of another. kBadInput naming the line: what parse_table refuses; an
// id that is none or comes twice; a number that is none, or not from 1 to 2000 (mass to 100000); a mouth or
// foot wider than the pot; an outline of an unknown target, of fewer than four points, not rising from y = 0
// to the height, wider than the pot, off a published dimension by more than 0.05 mm, or of a basis other than
// published and drawn or not the one it has.
Result<std::vector<Target>> parse_targets(std::string_view table, std::string_view outlines,
                                          std::string_view table_name, std::string_view outlines_name);

// The same from targets.csv and outlines.csv of a folder.
Result<std::vector<Target>> load_targets(const std::filesystem::path& folder);

// The target of that id. kBadInput listing those known.
Result<Target> find_target(std::span<const Target> targets, std::string_view id);

// One line for a visitor: what it is, from when, where it is, how large.
std::string sentence(const Target& target);

}  // namespace onggi::heritage
