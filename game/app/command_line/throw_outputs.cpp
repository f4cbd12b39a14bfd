#include "game/app/command_line/throw_outputs.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/asset/image.h"
#include "engine/asset/utf8.h"
#include "engine/core/quote.h"
#include "engine/core/units.h"
#include "engine/files/asset_folder.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/stats.h"
#include "game/clay/studio/studio_clay.h"
#include "game/exporter/studio_export.h"
#include "game/haptic/tick.h"
#include "game/heritage/advice.h"
#include "game/look/pot_drawing.h"
#include "game/look/pot_pictures.h"
#include "game/wheel/clay_look.h"
#include "game/wheel/still.h"

namespace onggi::app {
namespace {

// The score of a pot against a museum's pot, which was chosen or is the nearest by shape.
struct TargetScore {
    std::string text;  // readable text, one line per measure
    nlohmann::ordered_json json;
};

// Precondition: there is clay on the wheel.
TargetScore score_beside(const TargetChoice& choice, const clay::StudioClay& clay) {
    const heritage::PotForm form = heritage::form_of(clay);
    const heritage::Nearest nearest = heritage::nearest(form, choice.targets);
    const heritage::Target& target = choice.targets[choice.chosen.value_or(nearest.target)];
    const heritage::Score score = heritage::score(form, target, clay.lump().body);
    const heritage::Target& resembled = choice.targets[nearest.target];

    nlohmann::ordered_json measures;
    for (const heritage::Measure& measure : score.measures) {
        nlohmann::ordered_json museum = nullptr;  // not published
        if (measure.target) museum = *measure.target;
        measures[measure.name] = {{"pot", measure.pot}, {"museum", museum}};
    }
    const heritage::Advice advice =
        heritage::advise(form, target, choice.chosen ? std::optional(score.size.fraction) : std::nullopt);
    TargetScore result;
    result.json = {{"id", target.id},
                   {"text", heritage::sentence(target)},
                   {"source", target.source},
                   {"fraction", score.size.fraction},
                   {"wet_scale", score.size.wet_scale},
                   {"measures", measures},
                   {"profile_rms_mm", score.profile_rms_mm},
                   {"published_points", score.published_points},
                   {"drawn_points", score.drawn_points},
                   {"mean_off_mm", score.mean_off_mm},
                   {"good", heritage::good_key(advice)},
                   {"try_next", heritage::next_key(advice)},
                   {"nearest", resembled.id},
                   {"nearest_unlikeness", nearest.unlikeness}};
    result.text = heritage::report(score, target) + heritage::report(advice);
    if (choice.chosen) {
        result.text += fmt::format("nearest in shape: {} ({:.3f} unlike, 0 the same)\n", resembled.id,
                                   nearest.unlikeness);
    }
    return result;
}

// The tables that `throw` writes: profile and forces as CSV, with nine significant digits, independent of the
// locale.

void append(std::string& table, double number) {
    // Adding 0 turns -0 into 0: a zero force is printed without a sign.
    fmt::format_to(std::back_inserter(table), ",{:.9g}", number + 0.0);
}

std::string_view name_of(tool::Side side) {
    switch (side) {
        case tool::Side::kFree:
            return "free";
        case tool::Side::kOut:
            return "outer";
        case tool::Side::kIn:
            return "inner";
        case tool::Side::kTop:
            return "rim";
    }
    return "free";
}

std::string profile_of(const clay::StudioClay& clay) {
    std::string table = "y_mm,outer_mm,inner_mm\n";
    for (int i = 0; i < clay.ring_count(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        fmt::format_to(std::back_inserter(table), "{:.9g}", clay.centre_height_mm(i));
        append(table, clay.outer_mm()[at]);
        append(table, clay.inner_mm()[at]);
        table += '\n';
    }
    return table;
}

std::string profile_of(const clay::PaperClay& clay) {
    std::string table = "y_mm,outer_mm\n";
    const auto radii_mm = clay.radii_mm();
    for (std::size_t i = 0; i < radii_mm.size(); ++i) {
        const double y_mm = (static_cast<double>(i) + 0.5) * clay.element_height_mm();
        fmt::format_to(std::back_inserter(table), "{:.9g}", y_mm);
        append(table, static_cast<double>(radii_mm[i]));
        table += '\n';
    }
    return table;
}

// Columns y_mm, outer_mm, and for the studio clay inner_mm (0 if solid). One row per element or ring, bottom
// first; y is its middle.
std::string profile_table(const haptic::HapticState& state) {
    return std::visit([](const auto& clay) { return profile_of(clay); }, state.clay);
}

// Returns the header line of the forces with its line break. The columns are the first hand's; for the studio
// clay also its side (free, outer, inner or rim), the number of rings that the second hand or the assist
// touches, the wheel's speed, the hands' friction on it, and the largest load index.
std::string forces_header(const haptic::HapticState& state) {
    std::string header = "tick,t_s,contacts,fs_x_N,fs_y_N,fs_z_N,fv_x_N,fv_y_N,fv_z_N,ff_x_N,ff_y_N,ff_z_N";
    if (state.studio() != nullptr) {
        header += ",side,contacts_2,wheel_rev_min,wheel_load_N_mm,load_index";
    }
    return header + '\n';
}

// Appends the row of one tick; `state` is the state after the tick.
void append_forces_row(std::string& table, std::uint64_t tick, double rate_hz,
                       const haptic::TickResult& result, const haptic::HapticState& state) {
    const clay::ContactForces& forces = result.forces;
    fmt::format_to(std::back_inserter(table), "{},{:.9g},{}", tick, static_cast<double>(tick) / rate_hz,
                   forces.contacts);
    for (const dvec3& force_n : {forces.stiffness_n, forces.viscosity_n, forces.friction_n}) {
        append(table, force_n.x);
        append(table, force_n.y);
        append(table, force_n.z);
    }
    if (const clay::StudioClay* studio = state.studio()) {
        fmt::format_to(std::back_inserter(table), ",{},{}", name_of(result.side),
                       result.second_forces.contacts);
        append(table, units::rev_min_from_rad_s(studio->wheel().speed_rad_s()));
        append(table, result.wheel_load_n_mm);
        append(table, studio->load_index());
    }
    table += '\n';
}

}  // namespace

Result<std::optional<TargetChoice>> find_target_choice(const std::optional<std::string>& id) {
    if (!id) return std::optional<TargetChoice>();
    const auto folder = files::find_asset("heritage");
    if (!folder) return folder.error();
    auto targets = heritage::load_targets(*folder);
    if (!targets) return targets.error();
    TargetChoice choice{std::move(targets).value(), std::nullopt};
    if (*id != "nearest") {
        if (const auto known = heritage::find_target(choice.targets, *id); !known)
            return bad_input(fmt::format("--{}", known.error().message));
        for (std::size_t i = 0; i < choice.targets.size(); ++i) {
            if (choice.targets[i].id == *id) choice.chosen = i;
        }
    }
    return std::optional(std::move(choice));
}

namespace {

Result<void> check_endings(const ThrowOutputs& outputs) {
    if (outputs.model) {
        if (auto kind = exporter::export_kind_of(*outputs.model); !kind) return kind.error();
    }
    if (outputs.screenshot && !outputs.screenshot->ends_with(".png")) {
        return bad_input(
            fmt::format("{}: expected a picture's ending (.png)", shown_path(*outputs.screenshot)));
    }
    return {};
}

// Written and synced, not yet in its place.
Result<files::AtomicFile> prepared_file(const std::string& place, std::span<const std::byte> bytes) {
    auto file = files::AtomicFile::create(place);
    if (!file) return file.error();
    if (auto written = file->write(bytes); !written) return written.error();
    if (auto ready = file->prepare(); !ready) return ready.error();
    return file;
}

Result<std::vector<std::byte>> model_for(const std::string& place, const haptic::HapticState& state,
                                         clay::Firing stage, const asset::Image* picture) {
    const auto kind = exporter::export_kind_of(place);
    if (!kind) return kind.error();
    return model_bytes(state, *kind, stage, picture);
}

Result<asset::Image> picture_of(const ThrowOutputs& outputs, const haptic::HapticState& state,
                                const haptic::TickResult& last, const haptic::HapticParameters& parameters,
                                const pot::Pot& pot) {
    haptic::Snapshot snapshot;
    haptic::fill_snapshot(snapshot, state, last, parameters);
    const pot::Pot fired = pot::fired(pot, outputs.stage);
    snapshot.pot = &fired;
    return wheel::render_still(snapshot, outputs.size.width, outputs.size.height,
                               {.view = outputs.view,
                                .beauty = outputs.beauty,
                                .quick = outputs.backend == render::BackendChoice::kCpu});
}

}  // namespace

Result<std::vector<std::byte>> model_bytes(const haptic::HapticState& state, exporter::ExportKind kind,
                                           clay::Firing stage, const asset::Image* picture) {
    const clay::StudioClay* studio = state.studio();
    const bool is_viewed = kind == exporter::ExportKind::kGlb || kind == exporter::ExportKind::kUsdz;
    if (is_viewed && studio != nullptr) {
        const clay::ClayBody body = studio->lump().body;
        const look::PotLook worn =
            look::lathe_look(wheel::clay_material(body, stage), exporter::pot_name(body, stage));
        return exporter::encode_pot(look::dressed_pot(*studio, stage, worn), kind);
    }
    return exporter::encode_pot(studio != nullptr ? exporter::pot_file(*studio, stage)
                                                  : exporter::pot_file(exporter::rings_of(
                                                        state.height_mm(), state.paper()->radii_mm())),
                                kind, picture);
}

Result<void> check_drawings(const DrawingOptions& options) {
    for (const std::string& place : options.drawings) {
        if (auto kind = look::drawing_kind_of(place); !kind) return kind.error();
        if (auto checked = files::check_output_place(place); !checked) return checked;
    }
    return options.measures ? files::check_output_place(*options.measures) : Result<void>();
}

Result<std::vector<NamedFile>> drawn_files(const haptic::HapticState& state, clay::Firing stage,
                                           const DrawingOptions& options) {
    std::vector<NamedFile> drawn;
    if (options.drawings.empty() && !options.measures) return drawn;
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr)
        return bad_input("--drawing, --measures: expected the studio clay, found the paper's");
    const std::string credit = asset::valid_utf8(options.credit);
    for (const std::string& place : options.drawings) {
        auto bytes = look::pot_drawing(*studio, stage, look::drawing_kind_of(place).value(), credit);
        if (!bytes) return bytes.error();
        drawn.push_back({place, std::move(*bytes)});
    }
    if (options.measures) {
        const std::string text = exporter::pot_json(*studio, credit);
        const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
        drawn.push_back({*options.measures, {bytes.begin(), bytes.end()}});
    }
    return drawn;
}

Result<void> write_all(const std::vector<NamedFile>& named) {
    std::vector<files::AtomicFile> prepared;
    for (const auto& [place, bytes] : named) {
        auto file = prepared_file(place, bytes);
        if (!file) return file.error();
        prepared.push_back(std::move(file).value());
    }
    for (files::AtomicFile& file : prepared)
        if (auto done = file.commit(); !done) return done;
    return {};
}

Result<void> check_outputs(const ThrowOutputs& outputs) {
    if (auto endings = check_endings(outputs); !endings) return endings;
    if (auto drawings = check_drawings(outputs.drawing); !drawings) return drawings;
    std::set<std::filesystem::path> places;
    std::vector<std::optional<std::string>> all{outputs.profile,         outputs.forces,  outputs.model,
                                                outputs.screenshot,      outputs.session, outputs.stats,
                                                outputs.drawing.measures};
    all.insert(all.end(), outputs.drawing.drawings.begin(), outputs.drawing.drawings.end());
    for (const auto& place : all) {
        if (!place) continue;
        if (auto checked = files::check_output_place(*place); !checked) return checked;
        // Makes the path absolute first, because weakly_canonical() leaves a missing relative path relative.
        std::error_code ignored;
        const auto absolute = std::filesystem::absolute(*place, ignored);
        if (!places.insert(std::filesystem::weakly_canonical(absolute, ignored)).second) {
            return bad_input(
                fmt::format("{}: expected a separate file for each output, found two outputs for this one",
                            shown_path(*place)));
        }
    }
    return {};
}

Result<OutputWriter> OutputWriter::create(const ThrowOutputs& outputs, const haptic::Start& start) {
    OutputWriter writer(outputs, start.parameters);
    if (outputs.forces) {
        auto file = files::AtomicFile::create(*outputs.forces);
        if (!file) return file.error();
        if (auto written = file->write(forces_header(start.state)); !written) return written.error();
        writer.forces_.emplace(std::move(file).value());
    }
    if (outputs.session) {
        auto session =
            record::SessionWriter::create(*outputs.session, haptic::session_header(start),
                                          haptic::start_state_bytes(start.state, start.parameters));
        if (!session) return session.error();
        writer.session_.emplace(std::move(session).value());
    }
    return writer;
}

Result<void> OutputWriter::add_tick(const haptic::HapticState& state, const haptic::TickResult& result) {
    if (forces_) {
        row_.clear();
        append_forces_row(row_, tick_, parameters_.rate_hz(), result, state);
        if (auto written = forces_->write(row_); !written) return written;
    }
    ++tick_;
    if (!session_) return {};
    if (auto added = session_->add_tick(state.tool, result.forces.total_n()); !added) return added;
    return session_->block_is_full() ? session_->end_block(state.hash()) : Result<void>{};
}

Result<void> OutputWriter::prepare(const std::string& place, Result<std::vector<std::byte>> bytes) {
    if (!bytes) return bytes.error();
    auto file = prepared_file(place, *bytes);
    if (!file) return file.error();
    prepared_.push_back(std::move(file).value());
    return {};
}

Result<void> OutputWriter::prepare_text(const std::string& place, std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    return prepare(place, std::vector<std::byte>(bytes.begin(), bytes.end()));
}

Result<std::string> OutputWriter::finish(const haptic::HapticState& state, const haptic::TickResult& last,
                                         const jobs::Histogram& tick_ns) {
    Result<void> done;
    const pot::Pot pot = haptic::pot_of(state);
    // The picture comes first, because its device may be missing.
    std::optional<asset::Image> picture;
    if (outputs_.screenshot) {
        auto drawn = picture_of(outputs_, state, last, parameters_, pot);
        if (!drawn) return drawn.error();
        picture = std::move(drawn).value();
        done = prepare(*outputs_.screenshot, asset::encode_png(*picture));
    }
    if (done && outputs_.model)
        done = prepare(*outputs_.model,
                       model_for(*outputs_.model, state, outputs_.stage, picture ? &*picture : nullptr));
    if (done && outputs_.profile) done = prepare_text(*outputs_.profile, profile_table(state));
    const clay::StudioClay* studio = state.studio();
    std::optional<TargetScore> target;
    if (outputs_.target && studio != nullptr && studio->ring_count() > 0)
        target = score_beside(*outputs_.target, *studio);
    if (done && outputs_.stats) {
        auto stats = common_stats(tick_, tick_ns, parameters_.rate_hz(), state);
        if (target) stats["target"] = target->json;
        done = prepare_text(*outputs_.stats, stats.dump(2) + "\n");
    }
    auto drawn = drawn_files(state, outputs_.stage, outputs_.drawing);
    if (!drawn) return drawn.error();
    for (NamedFile& file : *drawn)
        if (done) done = prepare(file.place, std::move(file.bytes));
    if (done && forces_) done = forces_->prepare();
    if (done && session_) done = session_->prepare(state.hash());

    for (std::size_t i = 0; done && i < prepared_.size(); ++i)
        done = prepared_[i].commit();
    if (done && forces_) done = forces_->commit();
    if (done && session_) done = session_->commit();
    if (!done) return done.error();
    return target ? target->text : std::string();
}

}  // namespace onggi::app
