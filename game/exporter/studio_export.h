// A pot of the studio clay as a file for other programs: both walls, rim and floor, with the size and the
// surface of its stage of firing. Any thread but the haptic one. Returns bytes; engine/files writes them to
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

// The surface at that stage: wet clay has a gloss of water, a glaze one of glass (KHR_materials_clearcoat);
// dry and bisque clay is matt. Stoneware gets a celadon, the others a clear glaze.
asset::Material pot_material(clay::ClayBody body, clay::Firing stage);

std::string_view name_of(clay::ClayBody body);  // "stoneware", "porcelain", "earthenware"
std::string_view name_of(clay::Firing stage);   // "wet", "dry", "bisque", "glaze"

// A file's data about its pot, lengths in mm at that stage unless named wet_ or fired_: height_mm,
// max_diameter_mm, mouth_mm (outer diameter at the rim, as museums measure), foot_mm, floor_mm, volume_mm3
// (of the solid), capacity_ml, mass_g, thinnest_wall_mm, thickest_wall_mm; wall_y_mm and wall_mm, the wall
// every five millimetres of height; body, stage, shrinkage_percent, wet_height_mm, fired_height_mm and the
// same for max_diameter; the ledger of the wet clay: ledger_lump_mm3, ledger_on_wheel_mm3,
// ledger_trimmings_mm3, ledger_slip_mm3, ledger_error_mm3.
std::vector<asset::Extra> pot_extras(const clay::StudioClay& clay, clay::Firing stage);

// The file's bytes, the same for the same clay on every machine. kBadInput: see build_pot_solid. `material`
// replaces that of body and stage, for a glaze of the visitor's choice. `picture` may be null; it goes into a
// 3MF.
Result<std::vector<std::byte>> export_pot(const clay::StudioClay& clay, clay::Firing stage, ExportKind kind,
                                          const asset::Material* material = nullptr,
                                          const asset::Image* picture = nullptr);

}  // namespace onggi::exporter
