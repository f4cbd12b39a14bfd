// Reads a session: checks the whole file, then plays it tick by tick.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "game/record/session_format.h"
#include "game/tool/tool_state.h"

namespace onggi::record {

// Immutable; any thread.
class Session {
  public:
    // A complete block: the ticks from first_tick on, and the hash of the state after the last of them.
    struct Block {
        std::uint64_t first_tick = 0;
        std::uint32_t tick_count = 0;
        std::uint64_t state_hash = 0;
        std::size_t records_at = 0;  // byte offsets in the file; of a packed block, beyond it
        std::size_t checks_at = 0;
        bool is_packed = false;
    };

    [[nodiscard]] const SessionHeader& header() const noexcept { return header_; }
    [[nodiscard]] std::span<const std::byte> start_state() const noexcept;
    // The changes of the work after the last tick, opaque like the start state; empty if there are none.
    [[nodiscard]] std::span<const std::byte> supplement() const noexcept;
    [[nodiscard]] std::span<const Block> blocks() const noexcept { return blocks_; }
    [[nodiscard]] std::uint64_t tick_count() const noexcept { return tick_count_; }
    // False if the file ends before its end marker, as after a crash or an interrupted copy. It then holds
    // all ticks up to the last complete block.
    [[nodiscard]] bool is_complete() const noexcept { return complete_; }
    // The damage after the last complete block, in one line; empty if there is none or the file just ends.
    [[nodiscard]] const std::string& damage() const noexcept { return damage_; }
    [[nodiscard]] std::size_t usable_bytes() const noexcept { return usable_bytes_; }
    [[nodiscard]] std::size_t file_bytes() const noexcept { return bytes_.size(); }
    // Whether the force is the tick's recorded one, as far as its check tells (force_check()). Precondition:
    // tick < tick_count().
    [[nodiscard]] bool has_force_at(std::uint64_t tick, const dvec3& force_n) const noexcept;

  private:
    friend class SessionReader;
    friend class SessionCursor;
    Session() = default;
    [[nodiscard]] const std::byte* at(std::size_t offset) const noexcept;

    std::string bytes_;  // the whole file; ticks are decoded during playback
    std::vector<std::byte>
        unpacked_;  // bodies of its packed blocks; their offsets count on from the file's end
    SessionHeader header_;
    std::size_t start_state_at_ = 0;
    std::size_t start_state_bytes_ = 0;
    std::size_t supplement_at_ = 0;
    std::size_t supplement_bytes_ = 0;
    std::vector<Block> blocks_;
    std::uint64_t tick_count_ = 0;
    std::size_t usable_bytes_ = 0;
    bool complete_ = false;
    std::string damage_;
};

// How to treat a damaged block, which a power cut may leave.
enum class Damage {
    kRefuse,
    kCutThere,  // treat the file as if it ended before the block; header and start state must be intact
};

// Parses a whole session file; error messages call it `name`. Checks everything before any playback: magic,
// version, bounds, all checksums, all records, and that nothing follows the end marker. Errors: bad input,
// with the byte offset. Main thread.
[[nodiscard]] Result<Session> parse_session(std::string bytes, std::string_view name,
                                            Damage damage = Damage::kRefuse);

// Plays a session's ticks in order. Does not allocate or fail: fit for the tick. The session must outlive it.
class SessionCursor {
  public:
    explicit SessionCursor(const Session& session) noexcept : session_(&session) {}

    // The tool at `tick`; after the last tick, that of the last; a resting tool if there are no ticks. Cheap
    // for the same tick and the next; for another, it searches from the start of its block.
    [[nodiscard]] tool::ToolState at(std::uint64_t tick) noexcept;

  private:
    void enter(std::size_t block) noexcept;
    void step() noexcept;

    const Session* session_;
    std::size_t block_ = 0;
    std::size_t record_at_ = 0;  // offset of the next record
    std::uint32_t held_ = 0;     // number of ticks that the current repeat record still covers
    std::uint64_t tick_ = 0;     // the tick of `tool_`, if entered_
    bool entered_ = false;
    tool::ToolState tool_;
};

}  // namespace onggi::record
