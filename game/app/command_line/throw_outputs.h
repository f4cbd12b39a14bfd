// The output files of `onggi throw`: each complete or absent, and none if any of them fails. Main thread;
// blocks.
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

// The museum's pots to score a thrown pot against, for `throw --target`: all targets and the chosen one;
// without a choice, the nearest by shape.
struct TargetChoice {
    std::vector<heritage::Target> targets;
    std::optional<std::size_t> chosen;
};

// Reads the targets from the assets if an id or "nearest" is given. Bad input: an unknown id, with the list
// of known ones; system lacks: no assets.
[[nodiscard]] Result<std::optional<TargetChoice>> find_target_choice(const std::optional<std::string>& id);

struct ThrowOutputs {
    std::optional<std::string> profile;     // .csv
    std::optional<std::string> forces;      // .csv
    std::optional<std::string> model;       // .glb, .stl, .3mf
    std::optional<std::string> screenshot;  // .png
    std::optional<std::string> session;     // .onggi
    std::optional<std::string> stats;       // .json
    DrawingOptions drawing{};
    PictureSize size;
    wheel::StillView view = wheel::StillView::kThrowing;  // shown by the screenshot
    bool beauty = false;                                  // averages many pictures for the screenshot
    std::optional<render::BackendChoice> backend = {};  // draws the screenshot; cpu: as the live window does
    clay::Firing stage = clay::Firing::kWet;            // shown by model, drawing and screenshot
    std::optional<TargetChoice> target;                 // the target to score the pot against
};

// Checks before the work starts that every output has a supported extension and its own writable place.
[[nodiscard]] Result<void> check_outputs(const ThrowOutputs& outputs);

// Returns the pot on the wheel as a file of that kind. The stage applies only to the studio clay. A 3MF
// includes the picture, if there is one.
[[nodiscard]] Result<std::vector<std::byte>> model_bytes(const haptic::HapticState& state,
                                                         exporter::ExportKind kind,
                                                         clay::Firing stage = clay::Firing::kWet,
                                                         const asset::Image* picture = nullptr);

// Endings and writable places. Bad input as check_outputs().
[[nodiscard]] Result<void> check_drawings(const DrawingOptions& options);

// The drawings and the measures of the pot on the wheel, each with its place, in that order. Bad input: the
// paper's clay, an empty wheel.
struct NamedFile {
    std::string place;
    std::vector<std::byte> bytes;
};
[[nodiscard]] Result<std::vector<NamedFile>> drawn_files(const haptic::HapticState& state, clay::Firing stage,
                                                         const DrawingOptions& options);

// All of them, or none.
[[nodiscard]] Result<void> write_all(const std::vector<NamedFile>& files);

// Collects the ticks, and writes the files at the end.
class OutputWriter {
  public:
    // Opens the files that are written while the pot is thrown.
    [[nodiscard]] static Result<OutputWriter> create(const ThrowOutputs& outputs, const haptic::Start& start);

    // `state` is the state after the tick.
    Result<void> add_tick(const haptic::HapticState& state, const haptic::TickResult& result);
    // Creates and syncs all files before it renames the first one into place. Returns the text to print: the
    // score, if a target was chosen.
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
