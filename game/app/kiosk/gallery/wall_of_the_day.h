// The wall of the day: pots that their makers show to everyone, without a name, until the museum closes.
// Stored on the disk, so that a restart loses none. Any one thread at a time but the haptic one and the
// frame's; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/pot/section.h"

namespace onggi::app {

struct WallPot {
    std::string gallery_name;  // "2026-11-21/pot-014": identifies the pot for removal
    int glaze = 0;             // index for finish::glaze_at()
    pot::Section shape;
};

class WallOfTheDay {
  public:
    static constexpr std::size_t kMostPots = 27;  // beyond that the oldest are removed

    explicit WallOfTheDay(std::filesystem::path file) : file_(std::move(file)) {}

    // Reads that day's wall from the disk; the wall is empty if the file is of another day. Until the
    // machine's clock is set, the day on the disk continues. The wall is empty after an error. Bad input: the
    // file is damaged, and the next put() replaces it. System lacks: memory or rights; the file stays, and is
    // read again before it changes.
    Result<void> open(const std::string& today);
    // Switches to another day of the machine's clock, which may have gone forwards or back, and reads that
    // day's wall from the disk. Deletes a past day's file, but keeps a future day's, because the clock may be
    // corrected.
    Result<void> turn_to(const std::string& today);
    // Puts each pot only once. Errors of these three functions: those of open(), without effect; the disk's,
    // and the wall in memory changes all the same.
    Result<void> put(WallPot pot, const std::string& today);
    Result<void> take(const std::string& gallery_name);
    Result<void> clear();

    [[nodiscard]] const std::vector<WallPot>& pots() const { return pots_; }  // the oldest first
    [[nodiscard]] const std::string& day() const { return day_; }

  private:
    Result<void> read();
    Result<void> write() const;

    std::filesystem::path file_;
    std::string day_;
    std::string day_on_disk_;  // read by open()
    bool is_unread_ = false;   // for want of memory or rights
    std::vector<WallPot> pots_;
};

}  // namespace onggi::app
