#include "game/app/command_line/throw_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "engine/asset/image.h"
#include "engine/core/quote.h"
#include "game/app/command_line/performance.h"
#include "game/app/command_line/stats.h"
#include "game/app/command_line/tables.h"
#include "game/app/command_line/target_score.h"
#include "game/app/kiosk/presentation/snapshot_view.h"
#include "game/exporter/studio_export.h"
#include "game/look/pot_pictures.h"
#include "game/wheel/clay_look.h"
#include "game/wheel/still.h"

namespace onggi::app {
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
    return wheel::render_still(wheel_view(snapshot), outputs.size.width, outputs.size.height,
                               {.view = outputs.view,
                                .beauty = outputs.beauty,
                                .quick = outputs.backend == render::BackendChoice::kCpu});
}

}  // namespace

Result<std::vector<std::byte>> model_bytes(const haptic::HapticState& state, exporter::ExportKind kind,
                                           clay::Firing stage, const asset::Image* picture) {
    if (kind == exporter::ExportKind::kGlb && state.studio() != nullptr) {
        const clay::ClayBody body = state.studio()->lump().body;
        return look::dressed_glb(
            exporter::rings_of(state.studio()->rings()),
            look::lathe_look(wheel::clay_material(body, stage), exporter::pot_material(body, stage).name),
            {.extras = exporter::pot_extras(*state.studio(), stage),
             .shrinkage = clay::shrunk_scale(body, stage)});
    }
    if (const clay::StudioClay* studio = state.studio())
        return exporter::export_pot(*studio, stage, kind, nullptr, picture);
    return exporter::export_pot(exporter::rings_of(state.height_mm(), state.paper()->radii_mm()), kind,
                                picture);
}

Result<void> check_outputs(const ThrowOutputs& outputs) {
    if (auto endings = check_endings(outputs); !endings) return endings;
    std::set<std::filesystem::path> places;
    for (const auto& place : {outputs.profile, outputs.forces, outputs.model, outputs.screenshot,
                              outputs.session, outputs.stats}) {
        if (!place) continue;
        if (auto checked = files::check_output_place(*place); !checked) return checked;
        // Absolute first: what is not there yet would otherwise stay as it was written.
        std::error_code ignored;
        const auto absolute = std::filesystem::absolute(*place, ignored);
        if (!places.insert(std::filesystem::weakly_canonical(absolute, ignored)).second) {
            return bad_input(
                fmt::format("{}: expected a file of its own for each output, found two for this one",
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
    auto file = files::AtomicFile::create(place);
    if (!file) return file.error();
    if (auto written = file->write(std::span<const std::byte>(*bytes)); !written) return written;
    if (auto ready = file->prepare(); !ready) return ready;
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
    // The picture first: it is what may be missing its device.
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
