// Writes the visit in progress to the disk, so that a crash or a power cut does not lose the pot: a session
// (game/record) that grows block by block and is synced once a second. Any one thread at a time but the
// haptic one and the frame's; blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "game/haptic/history.h"
#include "game/record/session_writer.h"

namespace onggi::app {

// Half an hour of two hands at 4 kHz.
constexpr std::size_t kMostSessionBytes = std::size_t{400} << 20U;

// The choices of the visit in progress, besides its clay and its decoration.
struct VisitPlace {
    std::string target{};  // id of the museum's pot that was chosen; empty: free throwing
    int glaze = 0;
    bool is_cut_off = false;  // the throwing is over

    friend bool operator==(const VisitPlace&, const VisitPlace&) = default;
};
// In FOLDER/place.json. write_place() creates the folder when needed; read_place() returns the default
// without a file. kBadInput: the file is damaged, or of a later version.
Result<void> write_place(const std::filesystem::path& folder, const VisitPlace& place);
[[nodiscard]] Result<VisitPlace> read_place(const std::filesystem::path& folder);
void remove_place(const std::filesystem::path& folder) noexcept;

class VisitJournal {
  public:
    // Its files are FOLDER/visit-N.onggi, with the suffix .part while they grow. Creates the folder when
    // needed.
    explicit VisitJournal(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Writes the history's ticks since the last call, or begins a new file after an undo; the old file stays
    // until the new one has caught up. now_ns: any monotonic clock. After a failure, such as a full disk, it
    // does nothing until drop().
    Result<void> follow(const haptic::History& history, std::int64_t now_ns);
    // Whether the history of the last follow() is written, except for an incomplete block.
    [[nodiscard]] bool has_caught_up() const { return written_ && !next_; }
    // The file that holds the longest part of the visit, or empty.
    [[nodiscard]] std::filesystem::path file() const;
    // Deletes the files, when the visit is over or its pot is on the shelf.
    void drop() noexcept;
    // Keeps the files, except for an incomplete block, when the program ends during the visit.
    Result<void> leave();

  private:
    Result<void> begin(const haptic::History& history);
    Result<void> give_up(const Error& error);

    std::filesystem::path folder_;
    std::optional<record::SessionWriter> written_;
    std::optional<record::SessionWriter> next_;  // replaces written_ when it has caught up
    std::optional<std::uint64_t> lineage_;       // of the history being written
    int number_ = 0;
    std::int64_t synced_ns_ = 0;
    bool gave_up_ = false;
};

}  // namespace onggi::app
