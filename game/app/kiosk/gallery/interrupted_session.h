// Restores an interrupted visit from its file on the disk (visit_journal.h) when the program starts, by
// replaying it tick by tick. One thread at a time, but neither the haptic thread nor the frame's; blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/haptic/history.h"
#include "game/record/session.h"

namespace onggi::app {

class InterruptedSession {
  public:
    InterruptedSession(const InterruptedSession&) = delete;  // the cursor points into the session
    InterruptedSession& operator=(const InterruptedSession&) = delete;

    // Searches for the file and renames it to FOLDER/left-over.onggi, because new visits may be interrupted
    // too. `start` is the start of this kiosk's lumps; a session with another clay or rate is refused.
    // Appends a line to `remarks` for each damaged or dropped file. The last dropped file stays as
    // FOLDER/dropped.onggi: another version of the program may read it. Returns null if there is no file.
    static std::unique_ptr<InterruptedSession> find(const std::filesystem::path& folder,
                                                    const haptic::HapticState& start,
                                                    const haptic::HapticParameters& parameters,
                                                    std::vector<std::string>& remarks);

    // Reads one session that begins with the lump `start`. kBadInput: the file is not a session, or has
    // another clay or rate.
    static Result<std::unique_ptr<InterruptedSession>> read(const std::filesystem::path& file,
                                                            const haptic::HapticState& start,
                                                            const haptic::HapticParameters& parameters,
                                                            const std::filesystem::path& folder);
    // A session without ticks, for a lump that was never touched.
    static std::unique_ptr<InterruptedSession> of_nothing(const haptic::HapticState& start,
                                                          const haptic::HapticParameters& parameters,
                                                          const std::filesystem::path& folder);

    // Replays up to `ticks` more ticks. Returns true while there are more. kFailed: the clay is not the
    // recorded one; see set_aside().
    Result<bool> work(int ticks);
    // Whether the session changed the clay; otherwise it need not be restored. Valid after the last work().
    [[nodiscard]] bool is_worth_it() const { return !history_.moves().empty(); }
    [[nodiscard]] haptic::History& history() { return history_; }
    // The session's duration, for the log.
    [[nodiscard]] double seconds() const { return seconds_; }
    // Deletes the file, once the visit continues in another file or is declined.
    static void remove(const std::filesystem::path& folder) noexcept;
    // Renames the file to FOLDER/dropped.onggi, in place of an older one.
    static void set_aside(const std::filesystem::path& folder) noexcept;

  private:
    InterruptedSession(std::optional<record::Session> session, const haptic::HapticState& start,
                       const haptic::HapticParameters& parameters, const std::filesystem::path& folder)
        : folder_(folder),
          session_(std::move(session)),
          history_(start, parameters, {.aside = folder}) {
        if (!session_) return;
        cursor_.emplace(*session_);
        seconds_ = static_cast<double>(session_->tick_count()) / session_->header().rate_hz;
    }

    std::filesystem::path folder_;
    std::optional<record::Session> session_;  // until it is replayed, to free its memory
    std::optional<record::SessionCursor> cursor_;
    double seconds_ = 0.0;
    haptic::History history_;
    std::uint64_t played_ = 0;
};

}  // namespace onggi::app
