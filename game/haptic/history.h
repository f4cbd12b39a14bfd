// All that was done to a lump, kept so that any of it can be taken back. It follows the haptic loop by its
// records: every tick is worked out again here, off the tick, so that it always holds the very clay that is
// on the wheel, and now and then a checkpoint of it. To go back is to replay from the checkpoint before. One
// thread that is not the haptic one; allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/record/session_writer.h"
#include "game/haptic/checkpoints.h"
#include "game/haptic/input_log.h"
#include "game/haptic/messages.h"
#include "game/haptic/start_state.h"

namespace onggi::haptic {

struct HistoryOptions {
    double checkpoint_s = 1.0;                        // of simulated time between checkpoints, at most
    std::uint64_t checkpoint_ticks = 3000;            // likewise: what is undone is worked out again
    double pause_s = 0.25;                            // a hand off the clay for longer has ended its move
    std::size_t most_bytes = std::size_t{10} << 20U;  // of checkpoints, packed; beyond it they thin out
    std::filesystem::path aside{};  // a folder for what is seldom read again; empty: it stays in memory
};

// What a visitor would call one thing done: from touching the clay with a tool on one side of it to letting
// go; or one cut of the wire. Ticks since the lump was fresh.
struct Move {
    std::uint64_t first_tick = 0;
    std::uint64_t end_tick = 0;  // behind the last; the newest move may still grow
    haptics::ToolKind tool = haptics::ToolKind::kHand;
    clay::studio::Side side = clay::studio::Side::kFree;
    bool is_cut = false;
};

class History {
  public:
    History(const HapticState& start, const HapticParameters& parameters, const HistoryOptions& options = {});

    // The next record of the loop that began with that start. One that says kFreshLump begins anew; one that
    // says kStatePut goes back to its tick first, so what was put has to come from state_at().
    void add(const TickRecord& record);
    // One tick more that is played back from a session which began with the same start.
    void add_played(const haptics::ToolState& tool);

    // False once a record was missing, or was not given back: then the clay here is not the one on the wheel,
    // until a fresh lump.
    [[nodiscard]] bool is_whole() const { return whole_; }
    // The clay as it was after the last record.
    [[nodiscard]] const HapticState& state() const { return now_; }
    // Ticks since the lump was fresh.
    [[nodiscard]] std::uint64_t ticks() const { return now_.ticks; }
    [[nodiscard]] std::span<const Move> moves() const { return moves_; }

    // Those that the start had behind it.
    [[nodiscard]] std::uint64_t first_tick() const { return start_.state.ticks; }

    // The state before that tick. Precondition: between the start's ticks and ticks(). An error where the
    // disk does not give back what was put aside.
    [[nodiscard]] Result<HapticState> state_at(std::uint64_t tick) const;
    // How many ticks that works out again: what it costs, a few microseconds each.
    [[nodiscard]] std::uint64_t ticks_to_replay(std::uint64_t tick) const {
        return tick - checkpoints_.tick_before(tick);
    }
    // Where to go back to so that the last move is undone; none where nothing was done.
    [[nodiscard]] std::optional<std::uint64_t> before_last_move() const;

    // Nobody will go back any more, or seldom: the states between the start and now are let go, and what they
    // were is worked out from the start.
    void let_go_of_states();

    // All up to now as a session, written at once: no tick is worked out again.
    // supplement: what was done to the pot since, see record::SessionWriter.
    [[nodiscard]] Result<void> save(const std::filesystem::path& place,
                                    std::span<const std::byte> supplement = {}) const;
    // Only what came of it, as a session of no ticks that begins there: for a history that is not whole.
    [[nodiscard]] Result<void> save_outcome(const std::filesystem::path& place,
                                            std::span<const std::byte> supplement = {}) const;
    // All up to now while it goes on: a session that begins as this history does, for write_on() to fill.
    [[nodiscard]] Result<record::SessionWriter> begin_session(
        const std::filesystem::path& place, files::Beside beside,
        std::span<const std::byte> supplement = {}) const;
    // Adds what was done since the writer's last tick, at most so many ticks. Precondition: lineage() is what
    // it was at begin_session().
    [[nodiscard]] Result<void> write_on(record::SessionWriter& writer, std::size_t most_ticks) const;
    // How often the clay did not just go on: a fresh lump, a state put back. What was written of a history
    // before is no part of it any more.
    [[nodiscard]] std::uint64_t lineage() const { return lineage_; }

    // For a display and for tests.
    [[nodiscard]] std::size_t checkpoint_count() const { return checkpoints_.count(); }
    [[nodiscard]] std::size_t checkpoint_bytes() const { return checkpoints_.bytes(); }

  private:
    void begin_anew();
    void go_back_to(std::uint64_t tick);
    void keep_input(const haptics::ToolState& tool, const dvec3& force_n);
    void keep_checkpoint();
    void follow_tick(const haptics::ToolState& tool, const dvec3* force_n);
    void follow_moves(const TickResult& result);
    [[nodiscard]] haptics::ToolState tool_of(const LoggedInput& input) const;

    Start start_;
    HistoryOptions options_;
    HapticState now_;
    InputLog inputs_;  // of tick first_tick() + index
    std::vector<haptics::ToolState> settings_;
    std::vector<std::uint64_t> block_hashes_;  // after each full block of the session that save() writes
    Checkpoints checkpoints_;                  // the first is the start
    std::vector<Move> moves_;
    std::uint64_t lineage_ = 0;
    bool whole_ = true;
};

// What is kept of a fault: the whole lump's history up to it, as a session. `onggi replay` works the fault
// out again to the bit, so that a report is its own test. The thread that holds the history; writes a file.
class FaultReport {
  public:
    // At most so many in the folder: a loose cable must not fill a disk.
    static constexpr int kMost = 20;

    explicit FaultReport(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // After the history has got the record. Gives the file where a fault begins with it, a person's stop
    // among them; nothing otherwise. Errors: the folder or the file cannot be written.
    [[nodiscard]] Result<std::optional<std::filesystem::path>> look(const TickRecord& record,
                                                                    const History& history);

  private:
    std::filesystem::path folder_;
    bool is_fault_ = false;
};

}  // namespace onggi::haptic
