// A pot of the studio clay as a file that others open: both walls, rim and floor, at the size and with the
// surface of its stage of firing. Any thread but the haptic one; gives bytes, engine/files puts them on a
// disk.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/asset/gltf.h"
#include "engine/core/result.h"
#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"
#include "game/exporter/export.h"

namespace onggi::exporter {

// What the surface is made of at that stage: wet clay shines under its water, a glaze under its glass
// (KHR_materials_clearcoat), dry and bisque clay is matt. Stoneware takes a celadon, the others a clear
// glaze.
asset::Material pot_material(clay::ClayBody body, clay::Firing stage);

std::string_view name_of(clay::ClayBody body);  // "stoneware", "porcelain", "earthenware"
std::string_view name_of(clay::Firing stage);   // "wet", "dry", "bisque", "glaze"

// What a file says of its pot, lengths in mm at that stage unless named wet_ or fired_: height_mm,
// max_diameter_mm, mouth_mm (across the rim's outside, as museums measure), foot_mm, floor_mm, volume_mm3 (of
// the solid), capacity_ml, mass_g, thinnest_wall_mm, thickest_wall_mm; wall_y_mm and wall_mm, the wall every
// five millimetres of height; body, stage, shrinkage_percent, wet_height_mm, fired_height_mm and the same for
// max_diameter; the ledger of the wet clay: ledger_lump_mm3, ledger_on_wheel_mm3, ledger_trimmings_mm3,
// ledger_slip_mm3, ledger_error_mm3.
std::vector<asset::Extra> pot_extras(const clay::StudioClay& clay, clay::Firing stage);

// The file's bytes, the same for the same clay on every machine. kBadInput as build_pot_solid.
// `material` replaces that of body and stage: a glaze of the visitor's choice. `picture`, if there is one,
// goes into a 3MF.
Result<std::vector<std::byte>> export_pot(const clay::StudioClay& clay, clay::Firing stage, ExportKind kind,
                                          const asset::Material* material = nullptr,
                                          const asset::Image* picture = nullptr);

}  // namespace onggi::exporter
