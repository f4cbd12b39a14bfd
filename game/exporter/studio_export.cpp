// See studio_export.h. Any thread but the haptic one.
#include "game/exporter/studio_export.h"

#include <fmt/format.h>

#include <cmath>

namespace onggi::exporter {
namespace {

using clay::ClayBody;
using clay::Firing;

constexpr double kWallStepMm = 5.0;

// Linear reflectance of the fired surface without a glaze.
dvec3 dry_colour(ClayBody body) {
    switch (body) {
        case ClayBody::kStoneware:
            return {0.36, 0.29, 0.215};
        case ClayBody::kPorcelain:
            return {0.72, 0.69, 0.63};
        case ClayBody::kEarthenware:
            return {0.40, 0.155, 0.075};
    }
    return dvec3(0.5);
}

// Iron in the clay turns red in the bisque fire; porcelain has none.
dvec3 bisque_colour(ClayBody body) {
    return body == ClayBody::kPorcelain ? dvec3(0.76, 0.71, 0.64) : dvec3(0.60, 0.33, 0.20);
}

dvec3 glazed_colour(ClayBody body) {
    switch (body) {
        case ClayBody::kStoneware:
            return {0.30, 0.40, 0.31};
        case ClayBody::kPorcelain:
            return {0.74, 0.74, 0.70};
        case ClayBody::kEarthenware:
            return {0.34, 0.11, 0.05};
    }
    return dvec3(0.5);
}

// Water between grains sends the fraction p of the light back inside: A (1 - p)/(1 - p A), after Lekner and
// Dorf. Dark clay darkens much, pale clay little.
dvec3 wetted(const dvec3& dry) {
    constexpr double kTurnedBack = 0.66;
    return dry * (1.0 - kTurnedBack) / (dvec3(1.0) - kTurnedBack * dry);
}

double micrometres(double length_mm) {
    return std::round(length_mm * 1e3) * 1e-3;
}

}  // namespace

std::string_view name_of(ClayBody body) {
    switch (body) {
        case ClayBody::kStoneware:
            return "stoneware";
        case ClayBody::kPorcelain:
            return "porcelain";
        case ClayBody::kEarthenware:
            return "earthenware";
    }
    return "clay";
}

std::string_view name_of(Firing stage) {
    switch (stage) {
        case Firing::kWet:
            return "wet";
        case Firing::kDry:
            return "dry";
        case Firing::kBisque:
            return "bisque";
        case Firing::kGlaze:
            return "glaze";
    }
    return "wet";
}

asset::Material pot_material(ClayBody body, Firing stage) {
    asset::Material material{
        .name = fmt::format("{} {}", stage == Firing::kGlaze ? "glazed" : name_of(stage), name_of(body))};
    switch (stage) {
        case Firing::kWet:
            material.base_colour_linear = wetted(dry_colour(body));
            material.roughness = 0.55;
            material.clearcoat = {.factor = 0.6, .roughness = 0.2};
            break;
        case Firing::kDry:
            material.base_colour_linear = dry_colour(body);
            material.roughness = 0.9;
            break;
        case Firing::kBisque:
            material.base_colour_linear = bisque_colour(body);
            material.roughness = 0.85;
            break;
        case Firing::kGlaze:
            material.base_colour_linear = glazed_colour(body);
            material.roughness = 0.45;
            material.clearcoat = {.factor = 1.0, .roughness = 0.08};
            break;
    }
    return material;
}

std::vector<asset::Extra> pot_extras(const clay::StudioClay& clay, Firing stage) {
    const ClayBody body = clay.lump().body;
    const clay::studio::Rings& rings = clay.rings();
    const double scale = clay::shrunk_scale(body, stage);
    const auto at_stage = clay::measure_pot(rings, body, stage);
    const auto wet = clay::measure_pot(rings, body, Firing::kWet);
    const auto fired = clay::measure_pot(rings, body, Firing::kGlaze);
    std::vector<double> wall_y_mm;
    std::vector<double> wall_mm;
    for (double y = kWallStepMm; y < clay.height_mm(); y += kWallStepMm) {
        if (!rings.is_hollow(rings.ring_at(y))) continue;
        wall_y_mm.push_back(micrometres(y * scale));
        wall_mm.push_back(micrometres(clay::wall_thickness_mm(rings, y) * scale));
    }
    const clay::studio::Ledger& ledger = clay.ledger();
    return {{"height_mm", at_stage.height_mm},
            {"max_diameter_mm", at_stage.widest_mm},
            {"mouth_mm", rings.count > 0 ? 2.0 * clay.outer_mm().back() * scale : 0.0},
            {"foot_mm", at_stage.foot_mm},
            {"floor_mm", at_stage.floor_mm},
            {"volume_mm3", clay.volume_mm3() * scale * scale * scale},
            {"capacity_ml", at_stage.capacity_ml},
            {"mass_g", at_stage.mass_g},
            {"thinnest_wall_mm", at_stage.thinnest_wall_mm},
            {"thickest_wall_mm", at_stage.thickest_wall_mm},
            {"wall_y_mm", std::move(wall_y_mm)},
            {"wall_mm", std::move(wall_mm)},
            {"body", std::string(name_of(body))},
            {"stage", std::string(name_of(stage))},
            {"shrinkage_percent", 100.0 * clay::linear_shrinkage(body)},
            {"wet_height_mm", wet.height_mm},
            {"wet_max_diameter_mm", wet.widest_mm},
            {"fired_height_mm", fired.height_mm},
            {"fired_max_diameter_mm", fired.widest_mm},
            {"ledger_lump_mm3", ledger.lump_mm3},
            {"ledger_on_wheel_mm3", clay.volume_mm3()},
            {"ledger_trimmings_mm3", ledger.trimmings_mm3},
            {"ledger_slip_mm3", ledger.slip_mm3},
            {"ledger_error_mm3", clay.ledger_error_mm3()}};
}

Result<std::vector<std::byte>> export_pot(const clay::StudioClay& clay, Firing stage, ExportKind kind,
                                          const asset::Material* material, const asset::Image* picture) {
    const ClayBody body = clay.lump().body;
    const double scale = clay::shrunk_scale(body, stage);
    return export_pot(rings_of(clay.rings()), kind,
                      {.title = fmt::format("Onggi pot, {} {}, {:.1f} mm high", name_of(stage), name_of(body),
                                            clay.height_mm() * scale),
                       .note = printing_note(clay::measure_pot(clay.rings(), body, stage).thinnest_wall_mm),
                       .material = material != nullptr ? *material : pot_material(body, stage),
                       .extras = pot_extras(clay, stage),
                       .shrinkage = scale,
                       .picture = picture});
}

}  // namespace onggi::exporter
