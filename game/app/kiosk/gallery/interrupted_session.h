// What an interrupted visit left on the disk (visit_journal.h), found when the program starts and worked out
// again tick by tick. Any one thread at a time but the haptic one and the frame's; blocks.
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

    // Looks for it, and puts it aside as FOLDER/left-over.onggi: new visits may be interrupted too. `start`
    // is what this kiosk's lumps start from; a session of another clay or rate cannot go on here. `remarks`
    // gets a line for all that was damaged or had to be dropped. Nothing there: nothing.
    static std::unique_ptr<InterruptedSession> find(const std::filesystem::path& folder,
                                                    const haptic::HapticState& start,
                                                    const haptic::HapticParameters& parameters,
                                                    std::vector<std::string>& remarks);

    // One session, as it was written, of a lump that starts so. kBadInput: it is none, or of another clay or
    // rate.
    static Result<std::unique_ptr<InterruptedSession>> read(const std::filesystem::path& file,
                                                            const haptic::HapticState& start,
                                                            const haptic::HapticParameters& parameters,
                                                            const std::filesystem::path& folder);
    // Where the clay that starts so had not been touched yet.
    static std::unique_ptr<InterruptedSession> of_nothing(const haptic::HapticState& start,
                                                          const haptic::HapticParameters& parameters,
                                                          const std::filesystem::path& folder);

    // Works out so many ticks more. True while there are more.
    Result<bool> work(int ticks);
    // Whether anything was done to the clay; where nothing was, nobody misses it. After the last work().
    [[nodiscard]] bool is_worth_it() const { return !history_.moves().empty(); }
    [[nodiscard]] haptic::History& history() { return history_; }
    // Of its file, for the log: how much there is.
    [[nodiscard]] double seconds() const { return seconds_; }
    // Takes the file away: it goes on elsewhere, or nobody wants it.
    static void remove(const std::filesystem::path& folder) noexcept;

  private:
    InterruptedSession(std::optional<record::Session> session, const haptic::HapticState& start,
                       const haptic::HapticParameters& parameters, const std::filesystem::path& folder)
        : session_(std::move(session)),
          history_(start, parameters, {.aside = folder}) {
        if (!session_) return;
        cursor_.emplace(*session_);
        seconds_ = static_cast<double>(session_->tick_count()) / session_->header().rate_hz;
    }

    std::optional<record::Session> session_;  // until it is worked out: its bytes are many
    std::optional<record::SessionCursor> cursor_;
    double seconds_ = 0.0;
    haptic::History history_;
    std::uint64_t played_ = 0;
};

}  // namespace onggi::app
