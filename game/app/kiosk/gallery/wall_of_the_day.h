// The wall of the day: pots that their makers have put there for all to see, without a name, until the museum
// closes. On the disk, so that a start in the middle of a day loses none. Any one thread at a time but the
// haptic one and the frame's; blocks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/pot/section.h"

namespace onggi::app {

struct WallPot {
    std::string gallery_name;  // "2026-11-21/pot-014": by which it is taken down
    int glaze = 0;             // as finish::glaze_at() counts
    pot::Section shape;
};

class WallOfTheDay {
  public:
    static constexpr std::size_t kMostPots = 27;  // the oldest leave first

    explicit WallOfTheDay(std::filesystem::path file) : file_(std::move(file)) {}

    // What is on the disk of that day; of another day, nothing. Until the machine's clock is set, the day on the disk goes
    // on. Bad input: the file is damaged; the wall is
    // empty then, and the next pot that is put there writes it anew.
    Result<void> open(const std::string& today);
    // It is another day by the machine's clock, whichever way that went: what is on the disk of that day. A
    // day that is over leaves the disk; one to come stays there, for a clock that will be set right.
    Result<void> turn_to(const std::string& today);
    // Once each. The errors of these three: the disk does not take it. What was changed is changed.
    Result<void> put(WallPot pot, const std::string& today);
    Result<void> take(const std::string& gallery_name);
    Result<void> clear();

    [[nodiscard]] const std::vector<WallPot>& pots() const { return pots_; }  // the oldest first
    [[nodiscard]] const std::string& day() const { return day_; }

  private:
    Result<void> write() const;

    std::filesystem::path file_;
    std::string day_;
    std::string day_on_disk_;  // as open() found it
    std::vector<WallPot> pots_;
};

}  // namespace onggi::app
