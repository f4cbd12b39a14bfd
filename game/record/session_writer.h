// Writes a session while it happens, block by block: memory does not grow with its length.
// One thread at a time, never the haptic one (that hands its ticks over through a ring).
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
    // The file appears at `destination` when finish() succeeds; with files::Beside::kNamed what was recorded
    // up to the last whole block survives a crash in `destination`.part. Bad input: a header outside the
    // bounds of session_format.h, or a supplement that is larger. The supplement, which may be empty, is what
    // was done to the work after its last tick.
    [[nodiscard]] static Result<SessionWriter> create(const std::filesystem::path& destination,
                                                      const SessionHeader& header,
                                                      std::span<const std::byte> start_state,
                                                      files::Beside beside = files::Beside::kNameless,
                                                      std::span<const std::byte> supplement = {});

    // One tick: what the hand did and the force F that was answered. Fails if the tool is outside the limits
    // of tool_state.h, which the tick never lets through. Precondition: !block_is_full().
    Result<void> add_tick(const tool::ToolState& tool, const dvec3& force_n);
    // The same for a force of which only its force_check() was kept.
    Result<void> add_tick(const tool::ToolState& tool, std::uint32_t kept_force_check);
    // After every kHashInterval ticks a block is full, and wants the hash of the state after its last tick.
    [[nodiscard]] bool block_is_full() const { return ticks_in_block_ == kHashInterval; }
    Result<void> end_block(std::uint64_t state_hash);
    // What was ended of it is on the disk when this returns, and outlives the machine's power.
    Result<void> sync();
    // Ends the recording without an end: its whole blocks stay, synced, in `destination`.part.
    Result<void> leave();
    // Ends the session: `state_hash` is that of the state after the last tick. The file is whole and synced,
    // not yet in its place.
    Result<void> prepare(std::uint64_t state_hash);
    // Puts the prepared file in its place.
    Result<void> commit();

    [[nodiscard]] std::uint64_t tick_count() const { return tick_count_; }
    // Where it grows, empty where that has no name.
    [[nodiscard]] const std::filesystem::path& beside() const { return file_.beside(); }

  private:
    SessionWriter(files::AtomicFile file, const SessionHeader& header, std::span<const std::byte> supplement);
    void keep_tool(const tool::ToolState& tool);
    void flush_run();

    files::AtomicFile file_;
    SessionHeader header_;
    std::vector<std::byte> supplement_;
    std::uint64_t tick_count_ = 0;
    std::uint64_t block_count_ = 0;
    std::uint32_t ticks_in_block_ = 0;
    std::vector<std::byte> records_;            // of the block in the making
    std::vector<std::uint32_t> checks_;         // one a tick of it
    std::optional<tool::ToolState> last_tool_;  // within this block: each block stands by itself
    std::uint32_t run_ = 0;                     // how many ticks more like last_tool_
};

}  // namespace onggi::record
