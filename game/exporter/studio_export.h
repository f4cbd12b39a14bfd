// A pot of the studio clay as files for other programs: both walls, rim and floor, with the size of its stage
// of firing. look/pot_pictures.h adds its surface. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/asset/gltf.h"
#include "engine/core/result.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"
#include "game/exporter/export.h"
#include "game/exporter/pot_solid.h"

namespace onggi::exporter {

std::string_view name_of(clay::ClayBody body);                  // "stoneware", "porcelain", "earthenware"
std::string_view name_of(clay::Firing stage);                   // "wet", "dry", "bisque", "glaze"
std::string pot_name(clay::ClayBody body, clay::Firing stage);  // "wet stoneware", "glazed porcelain"

// Where a pot is narrowest above its belly: the lowest such place at least 5 mm below the rim, not wider
// inside than nine tenths of the belly. mm, ml, at the stage.
struct Neck {
    double diameter_mm = 0.0;  // outer
    double height_mm = 0.0;
    double capacity_ml = 0.0;  // up to it
};
[[nodiscard]] std::optional<Neck> neck_of(const clay::StudioClay& clay, clay::Firing stage);

// A file's data about its pot, lengths in mm at that stage unless named wet_ or fired_: height_mm,
// max_diameter_mm, mouth_mm (outer diameter at the rim, as museums measure), foot_mm, floor_mm, volume_mm3
// (of the solid), capacity_ml, mass_g, thinnest_wall_mm, thickest_wall_mm; wall_y_mm and wall_mm, the wall
// every five millimetres of height; body, stage, shrinkage_percent, wet_height_mm, fired_height_mm and the
// same for max_diameter; of a pot with a neck neck_mm, neck_height_mm, capacity_to_neck_ml; the ledger of the
// wet clay: ledger_lump_mm3, ledger_on_wheel_mm3, ledger_trimmings_mm3, ledger_slip_mm3, ledger_error_mm3.
std::vector<asset::Extra> pot_extras(const clay::StudioClay& clay, clay::Firing stage);
// The same as JSON.
[[nodiscard]] nlohmann::ordered_json measures_json(const clay::StudioClay& clay, clay::Firing stage);
// The file pot.json, as docs/pot.schema.json describes it; `credit`: whose it is, under which licence.
[[nodiscard]] std::string pot_json(const clay::StudioClay& clay, const std::string& credit = {});
constexpr int kPotJsonVersion = 1;

// The unwrapped solid for viewing, glazed at the last stage. kBadInput: see build_pot_solid().
Result<PotSolid> viewed_solid(const clay::StudioClay& clay, clay::Firing stage);

// The solid for 3D printers, with a material that has a name alone. kBadInput: see build_pot_solid().
Result<PotFile> pot_file(const clay::StudioClay& clay, clay::Firing stage, PotStory story = {});

}  // namespace onggi::exporter
