// What `onggi throw` leaves behind: each file whole or not at all, and none if any of them fails.
// Main thread; blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/files/atomic_file.h"
#include "engine/jobs/histogram.h"
#include "game/app/command_line/options.h"
#include "game/clay/studio/pot.h"
#include "game/exporter/export.h"
#include "game/haptic/start_state.h"
#include "game/heritage/target.h"
#include "game/record/session_writer.h"

namespace onggi::app {

// `throw --target`: the museum's pots to score a thrown one beside. All targets, and the one chosen; none:
// the nearest by shape, once the pot is there.
struct TargetChoice {
    std::vector<heritage::Target> targets;
    std::optional<std::size_t> chosen;
};

// Reads the targets from the assets where an id is given, "nearest" included. Bad input listing those known
// for another; system lacks where there are no assets.
[[nodiscard]] Result<std::optional<TargetChoice>> find_target_choice(const std::optional<std::string>& id);

struct ThrowOutputs {
    std::optional<std::string> profile;     // .csv
    std::optional<std::string> forces;      // .csv
    std::optional<std::string> model;       // .glb, .stl, .3mf
    std::optional<std::string> screenshot;  // .png
    std::optional<std::string> session;     // .onggi
    std::optional<std::string> stats;       // .json
    PictureSize size;
    wheel::StillView view = wheel::StillView::kThrowing;  // that the screenshot shows
    bool beauty = false;                                  // the screenshot as the mean of many
    std::optional<render::BackendChoice> backend = {};    // that draws it; cpu: as the live window does
    clay::Firing stage = clay::Firing::kWet;              // that model and screenshot show
    std::optional<TargetChoice> target;                   // to score the pot beside
};

// Before the work: whether every output has an ending that can be written and a place of its own where it can
// be written.
[[nodiscard]] Result<void> check_outputs(const ThrowOutputs& outputs);

// The pot on the wheel as a file of that kind, whichever clay it is of; the stage is the studio clay's. A 3MF
// shows the picture, if there is one.
[[nodiscard]] Result<std::vector<std::byte>> model_bytes(const haptic::HapticState& state,
                                                         exporter::ExportKind kind,
                                                         clay::Firing stage = clay::Firing::kWet,
                                                         const asset::Image* picture = nullptr);

// Takes the ticks as they come, and writes everything at the end.
class OutputWriter {
  public:
    // Opens what is written while the pot is thrown.
    [[nodiscard]] static Result<OutputWriter> create(const ThrowOutputs& outputs, const haptic::Start& start);

    // `state` is the one after the tick.
    Result<void> add_tick(const haptic::HapticState& state, const haptic::TickResult& result);
    // Everything is made and synced before the first file takes its place. Gives what is to be said of the
    // pot: its score, where a target was chosen.
    Result<std::string> finish(const haptic::HapticState& state, const haptic::TickResult& last,
                               const jobs::Histogram& tick_ns);

  private:
    OutputWriter(const ThrowOutputs& outputs, const haptic::HapticParameters& parameters)
        : outputs_(outputs),
          parameters_(parameters) {}
    Result<void> prepare(const std::string& place, Result<std::vector<std::byte>> bytes);
    Result<void> prepare_text(const std::string& place, std::string_view text);

    ThrowOutputs outputs_;
    haptic::HapticParameters parameters_;
    std::uint64_t tick_ = 0;
    std::string row_;
    std::optional<files::AtomicFile> forces_;
    std::optional<record::SessionWriter> session_;
    std::vector<files::AtomicFile> prepared_;
};

}  // namespace onggi::app
