// See studio_export.h. Any thread but the haptic one.
#include "game/exporter/studio_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

namespace onggi::exporter {
namespace {

using clay::ClayBody;
using clay::Firing;

constexpr double kWallStepMm = 5.0;

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

std::string pot_name(ClayBody body, Firing stage) {
    return fmt::format("{} {}", stage == Firing::kGlaze ? "glazed" : name_of(stage), name_of(body));
}

std::optional<Neck> neck_of(const clay::StudioClay& clay, Firing stage) {
    constexpr double kOfBelly = 0.9;
    constexpr double kBelowRimMm = 5.0;
    constexpr double kWithinMm = 1.0;  // of the narrowest radius: where a straight neck begins
    const clay::studio::Rings& rings = clay.rings();
    const auto first = rings.inner_mm.begin() + rings.first_hollow;
    const auto end = rings.inner_mm.begin() + rings.count;
    if (first >= end) return std::nullopt;
    const auto belly = std::max_element(first, end);
    const double narrowest_mm = *std::min_element(belly, end);
    const auto neck =
        std::find_if(belly, end, [&](double inner_mm) { return inner_mm <= narrowest_mm + kWithinMm; });
    const int ring = static_cast<int>(neck - rings.inner_mm.begin());
    if (*neck > kOfBelly * *belly || *neck <= 0.0) return std::nullopt;
    if (rings.top_mm() - rings.centre_mm(ring) < kBelowRimMm) return std::nullopt;
    const double scale = clay::shrunk_scale(clay.lump().body, stage);
    clay::studio::Rings below = rings;
    below.remove(ring, rings.count);
    return Neck{.diameter_mm = 2.0 * rings.outer_mm[clay::studio::Rings::at(ring)] * scale,
                .height_mm = rings.bottom_mm(ring) * scale,
                .capacity_ml = clay::measure_pot(below, clay.lump().body, stage).capacity_ml};
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
    std::vector<asset::Extra> extras{{"height_mm", at_stage.height_mm},
                                     {"max_diameter_mm", at_stage.widest_mm},
                                     {"mouth_mm", at_stage.mouth_mm},
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
    if (const auto neck = neck_of(clay, stage)) {
        extras.insert(extras.end(), {{"neck_mm", neck->diameter_mm},
                                     {"neck_height_mm", neck->height_mm},
                                     {"capacity_to_neck_ml", neck->capacity_ml}});
    }
    return extras;
}

nlohmann::ordered_json measures_json(const clay::StudioClay& clay, Firing stage) {
    nlohmann::ordered_json measures;
    // clang 14 cannot capture structured bindings in a lambda.
    for (const auto& extra : pot_extras(clay, stage))
        std::visit([&](const auto& one) { measures[extra.first] = one; }, extra.second);
    return measures;
}

std::string pot_json(const clay::StudioClay& clay, const std::string& credit) {
    nlohmann::ordered_json pot{
        {"format", "onggi-pot"}, {"version", kPotJsonVersion}, {"program", program_name()}};
    if (!credit.empty()) pot["credit"] = credit;
    pot["wet"] = measures_json(clay, Firing::kWet);
    pot["fired"] = measures_json(clay, Firing::kGlaze);
    return pot.dump(2) + "\n";
}

Result<PotSolid> viewed_solid(const clay::StudioClay& clay, Firing stage) {
    return build_pot_solid(rings_of(clay.rings()), {.shrinkage = clay::shrunk_scale(clay.lump().body, stage),
                                                    .most_triangles = kMaxSharedTriangles,
                                                    .unwraps = true,
                                                    .is_glazed = stage == Firing::kGlaze});
}

Result<PotFile> pot_file(const clay::StudioClay& clay, Firing stage, PotStory story) {
    const ClayBody body = clay.lump().body;
    const double scale = clay::shrunk_scale(body, stage);
    Result<PotSolid> pot = build_pot_solid(rings_of(clay.rings()), {.shrinkage = scale});
    if (!pot) return pot.error();
    const clay::PotMeasures measures = clay::measure_pot(clay.rings(), body, stage);
    const std::string title = fmt::format(
        "{}, {:.1f} mm high",
        story.about.is_empty() ? "Onggi pot, " + pot_name(body, stage) : first_of(story.about.title),
        clay.height_mm() * scale);
    return PotFile{
        .content = pot_content("Pot, " + pot_name(body, stage), std::move(pot->mesh),
                               {.name = pot_name(body, stage)}, pot_extras(clay, stage), std::move(story)),
        .title = title,
        .note = printing_note(measures.thinnest_wall_mm, measures.height_mm, measures.widest_mm)};
}

}  // namespace onggi::exporter
