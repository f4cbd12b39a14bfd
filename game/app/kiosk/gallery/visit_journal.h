// The visit in progress, on the disk while it goes on, so that a crash or a power cut leaves the pot behind:
// a session (game/record) that grows block by block and is synced once a second. Any one thread at a time
// but the haptic one and the frame's; blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/core/result.h"
#include "game/haptic/history.h"
#include "game/record/session_writer.h"

namespace onggi::app {

// Half an hour of two hands at 4 kHz.
constexpr std::size_t kMostSessionBytes = std::size_t{400} << 20U;

class VisitJournal {
  public:
    // Its files are FOLDER/visit-N.onggi, with .part behind while they grow. The folder is made when it is
    // needed.
    explicit VisitJournal(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Writes what the history has got since the last call, or begins anew where it went another way. What was
    // written before stays until the new one has caught up. now_ns: of any clock that goes on. After a
    // failure, a full disk among them, nothing more is tried until drop().
    Result<void> follow(const haptic::History& history, std::int64_t now_ns);
    // Whether all that the history had at the last follow() is written, but for a block in the making.
    [[nodiscard]] bool has_caught_up() const { return written_ && !next_; }
    // The file that tells most of the visit; empty: there is none.
    [[nodiscard]] std::filesystem::path file() const;
    // The visit is over, or its pot is on the shelf: nothing of it stays.
    void drop() noexcept;
    // The program ends while the visit goes on: what is written stays, but for a block in the making.
    Result<void> leave();

  private:
    Result<void> begin(const haptic::History& history);
    Result<void> give_up(const Error& error);

    std::filesystem::path folder_;
    std::optional<record::SessionWriter> written_;
    std::optional<record::SessionWriter> next_;  // takes the place of written_ when it has caught up
    std::optional<std::uint64_t> lineage_;       // of the history that is written now
    int number_ = 0;
    std::int64_t synced_ns_ = 0;
    bool gave_up_ = false;
};

}  // namespace onggi::app
