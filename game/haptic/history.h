// The full history of a lump, for undo. It follows the haptic loop by its records and repeats every tick off
// the haptic thread, so that it always holds the exact clay on the wheel. It takes checkpoints; undo is a
// replay from the checkpoint before. One thread, but not the haptic one; allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "game/haptic/checkpoints.h"
#include "game/haptic/input_log.h"
#include "game/haptic/messages.h"
#include "game/haptic/start_state.h"
#include "game/record/session_writer.h"

namespace onggi::haptic {

struct HistoryOptions {
    double checkpoint_s = 1.0;                        // largest simulated time between checkpoints
    std::uint64_t checkpoint_ticks = 3000;            // likewise in ticks; bounds the replay of an undo
    double pause_s = 0.25;                            // a hand off the clay for longer ends its move
    std::size_t most_bytes = std::size_t{10} << 20U;  // of packed checkpoints; beyond it they thin out
    std::filesystem::path aside{};                    // folder for rarely read blocks; empty: memory only
};

// One action as a visitor sees it: from touching the clay with a tool on one side to letting go, or one cut
// of the wire. In ticks since the lump was fresh.
struct Move {
    std::uint64_t first_tick = 0;
    std::uint64_t end_tick = 0;  // one past the last; the newest move may still grow
    tool::Tool tool = tool::Tool::kHand;
    tool::Side side = tool::Side::kFree;
    bool is_cut = false;
};

class History {
  public:
    History(const HapticState& start, const HapticParameters& parameters, const HistoryOptions& options = {});

    // Adds the next record of the loop, which began with the given start. kFreshLump restarts the history;
    // kStatePut first goes back to the record's tick, so the state that was put must come from state_at().
    void add(const TickRecord& record);
    // Adds one tick played back from a session with the same start.
    void add_played(const tool::ToolState& tool);

    // False once a record was lost or could not be read back. Until the next fresh lump, the clay here may
    // then differ from the one on the wheel.
    [[nodiscard]] bool is_whole() const { return whole_; }
    // The clay after the last record.
    [[nodiscard]] const HapticState& state() const { return now_; }
    // Ticks since the lump was fresh.
    [[nodiscard]] std::uint64_t ticks() const { return now_.ticks; }
    [[nodiscard]] std::span<const Move> moves() const { return moves_; }

    // The start's own tick count.
    [[nodiscard]] std::uint64_t first_tick() const { return start_.state.ticks; }

    // The state before that tick. Precondition: first_tick() <= tick <= ticks(). Error if the disk does not
    // return the stored blocks.
    [[nodiscard]] Result<HapticState> state_at(std::uint64_t tick) const;
    // The number of ticks that state_at() replays: its cost, a few microseconds each.
    [[nodiscard]] std::uint64_t ticks_to_replay(std::uint64_t tick) const {
        return tick - checkpoints_.tick_before(tick);
    }
    // The tick to go back to in order to undo the last move; empty without a move.
    [[nodiscard]] std::optional<std::uint64_t> before_last_move() const;

    // Frees the checkpoints between start and now, when going back is over or rare. state_at() then replays
    // from the start.
    void let_go_of_states();

    // Writes the whole history as a session at once; no tick is replayed. supplement: later changes of the
    // pot, see record::SessionWriter.
    [[nodiscard]] Result<void> save(const std::filesystem::path& place,
                                    std::span<const std::byte> supplement = {}) const;
    // Writes only the present state, as a session without ticks: for a history that is not whole.
    [[nodiscard]] Result<void> save_outcome(const std::filesystem::path& place,
                                            std::span<const std::byte> supplement = {}) const;
    // Begins a session with this history's start while the history grows; write_on() fills it.
    [[nodiscard]] Result<record::SessionWriter> begin_session(
        const std::filesystem::path& place, files::Beside beside,
        std::span<const std::byte> supplement = {}) const;
    // Adds up to most_ticks ticks since the writer's last one. Precondition: lineage() is unchanged since
    // begin_session().
    [[nodiscard]] Result<void> write_on(record::SessionWriter& writer, std::size_t most_ticks) const;
    // Counts the breaks in the history: a fresh lump, a state put back. Sessions written before a break no
    // longer belong to the history.
    [[nodiscard]] std::uint64_t lineage() const { return lineage_; }

    // For a display and for tests.
    [[nodiscard]] std::size_t checkpoint_count() const { return checkpoints_.count(); }
    [[nodiscard]] std::size_t checkpoint_bytes() const { return checkpoints_.bytes(); }

  private:
    void begin_anew();
    void go_back_to(std::uint64_t tick);
    void keep_input(const tool::ToolState& tool, const dvec3& force_n);
    void keep_checkpoint();
    void follow_tick(const tool::ToolState& tool, const dvec3* force_n);
    void follow_moves(const TickResult& result);
    [[nodiscard]] tool::ToolState tool_of(const LoggedInput& input) const;

    Start start_;
    HistoryOptions options_;
    HapticState now_;
    InputLog inputs_;  // index i is tick first_tick() + i
    std::vector<tool::ToolState> settings_;
    std::vector<std::uint64_t> block_hashes_;  // after each full block of the session that save() writes
    Checkpoints checkpoints_;                  // the first is the start
    std::vector<Move> moves_;
    std::uint64_t lineage_ = 0;
    bool whole_ = true;
};

// Saves a fault: the lump's whole history up to it, as a session. `onggi replay` reproduces the fault to the
// bit. Runs on the thread that holds the history; writes a file.
class FaultReport {
  public:
    // The largest number of reports in the folder, so that a loose cable does not fill the disk.
    static constexpr int kMost = 20;

    explicit FaultReport(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Call it after the history got the record. Returns the file if a fault, or a person's stop, begins with
    // this record; otherwise empty. Errors: the folder or the file cannot be written.
    [[nodiscard]] Result<std::optional<std::filesystem::path>> look(const TickRecord& record,
                                                                    const History& history);

  private:
    std::filesystem::path folder_;
    bool is_fault_ = false;
};

}  // namespace onggi::haptic
