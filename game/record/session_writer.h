// Writes a session in progress, block by block: its memory does not grow with the session. One thread at a
// time, never the haptic one, which passes its ticks on through a ring.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/files/atomic_file.h"
#include "game/record/session_format.h"
#include "game/tool/tool_state.h"

namespace onggi::record {

class SessionWriter {
  public:
    // The file appears at `destination` with commit(). With files::Beside::kNamed, all complete blocks
    // survive a crash in `destination`.part. `supplement` holds the changes of the work after its last tick
    // and may be empty. Bad input: a header outside the limits of session_format.h, or a supplement that is
    // too large.
    [[nodiscard]] static Result<SessionWriter> create(const std::filesystem::path& destination,
                                                      const SessionHeader& header,
                                                      std::span<const std::byte> start_state,
                                                      files::Beside beside = files::Beside::kNameless,
                                                      std::span<const std::byte> supplement = {});

    // Adds a tick: the hand's tool and the resulting force F. Fails if the tool is outside the limits of
    // tool_state.h, which the haptic tick never lets through. Precondition: !block_is_full().
    Result<void> add_tick(const tool::ToolState& tool, const dvec3& force_n);
    // Adds a tick of which only the force_check() was kept.
    Result<void> add_tick(const tool::ToolState& tool, std::uint32_t kept_force_check);
    // True after every kHashInterval ticks: call end_block() with the hash of the state after the last tick.
    [[nodiscard]] bool block_is_full() const { return ticks_in_block_ == kHashInterval; }
    Result<void> end_block(std::uint64_t state_hash);
    // Syncs all complete blocks to the disk, so that they survive a power cut.
    Result<void> sync();
    // Ends the recording without an end marker; its complete blocks stay, synced, in `destination`.part.
    Result<void> leave();
    // Writes the end of the session and syncs the file, but does not move it into place. `state_hash`: the
    // state after the last tick.
    Result<void> prepare(std::uint64_t state_hash);
    // Moves the prepared file into place.
    Result<void> commit();

    [[nodiscard]] std::uint64_t tick_count() const { return tick_count_; }
    // The path of the growing file; empty if it has no name.
    [[nodiscard]] const std::filesystem::path& beside() const { return file_.beside(); }

  private:
    SessionWriter(files::AtomicFile file, const SessionHeader& header, std::span<const std::byte> supplement);
    void keep_tool(const tool::ToolState& tool);
    void flush_run();
    // Sessions of whole tools are packed: theirs are the long ones, which visits leave.
    [[nodiscard]] bool is_packed() const { return header_.tool_detail == ToolDetail::kWhole; }

    files::AtomicFile file_;
    SessionHeader header_;
    std::vector<std::byte> supplement_;
    std::uint64_t tick_count_ = 0;
    std::uint64_t block_count_ = 0;
    std::uint32_t ticks_in_block_ = 0;
    std::vector<std::byte> records_;            // of the current block
    std::vector<std::uint32_t> checks_;         // one per tick of the current block
    std::optional<tool::ToolState> last_tool_;  // of the current block: each block is independent
    std::uint32_t run_ = 0;                     // number of further ticks equal to last_tool_
};

}  // namespace onggi::record
