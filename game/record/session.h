// A session read back: checked as a whole when it is read, then played tick by tick.
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

// Immutable once read; any thread.
class Session {
  public:
    // A whole block: the ticks from first_tick, and the hash of the state after the last of them.
    struct Block {
        std::uint64_t first_tick = 0;
        std::uint32_t tick_count = 0;
        std::uint64_t state_hash = 0;
        std::size_t records_at = 0;  // byte offsets in the file
        std::size_t checks_at = 0;
    };

    [[nodiscard]] const SessionHeader& header() const noexcept { return header_; }
    [[nodiscard]] std::span<const std::byte> start_state() const noexcept;
    // What was done to the work after the last tick, opaque here as the start state is; empty: nothing.
    [[nodiscard]] std::span<const std::byte> supplement() const noexcept;
    [[nodiscard]] std::span<const Block> blocks() const noexcept { return blocks_; }
    [[nodiscard]] std::uint64_t tick_count() const noexcept { return tick_count_; }
    // False if the file ends before its end marker, as after a crash or a broken copy: it then holds every
    // tick up to the last whole block.
    [[nodiscard]] bool is_complete() const noexcept { return complete_; }
    // What is wrong behind the last whole block, as one line; empty: nothing, or the file just ends.
    [[nodiscard]] const std::string& damage() const noexcept { return damage_; }
    [[nodiscard]] std::size_t usable_bytes() const noexcept { return usable_bytes_; }
    [[nodiscard]] std::size_t file_bytes() const noexcept { return bytes_.size(); }
    // force_check() of a tick as recorded. Precondition: tick < tick_count().
    [[nodiscard]] std::uint32_t force_check_at(std::uint64_t tick) const noexcept;

  private:
    friend class SessionReader;
    friend class SessionCursor;
    Session() = default;
    [[nodiscard]] const std::byte* at(std::size_t offset) const noexcept;

    std::string bytes_;  // the whole file: ticks are decoded from it as they are played
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

// What to do about a block that is damaged, as a power cut leaves one behind.
enum class Damage {
    kRefuse,
    kCutThere,  // take the file as one that ends before it; header and start state have to be whole
};

// The session in `bytes`, the whole of a file; `name` stands for it in messages. Everything is checked before
// anything is played: magic, version, bounds, every checksum, every record, and that nothing follows the end.
// Refusals are bad input and name the byte offset. Main thread.
[[nodiscard]] Result<Session> parse_session(std::string bytes, std::string_view name,
                                            Damage damage = Damage::kRefuse);

// Walks a session's ticks in order. No allocation, nothing fails: fit for the tick. The session must outlive
// it.
class SessionCursor {
  public:
    explicit SessionCursor(const Session& session) noexcept : session_(&session) {}

    // The tool at `tick`; after the last tick, that of the last; a resting tool where there is none. Cheap
    // for the same and the next tick; any other is looked for from its block's start.
    [[nodiscard]] tool::ToolState at(std::uint64_t tick) noexcept;

  private:
    void enter(std::size_t block) noexcept;
    void step() noexcept;

    const Session* session_;
    std::size_t block_ = 0;
    std::size_t record_at_ = 0;  // offset of the next record
    std::uint32_t held_ = 0;     // ticks that the present run still covers
    std::uint64_t tick_ = 0;     // whose tool `tool_` is, if entered_
    bool entered_ = false;
    tool::ToolState tool_;
};

}  // namespace onggi::record
