// Which of the fingers on a touch screen is the hand. Any thread; no clock of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/window/events.h"

namespace onggi::window {

struct Touch {
    enum class Phase { kBegin, kMove, kEnd };
    Phase phase = Phase::kBegin;
    std::uint32_t finger = 0;  // the same from its beginning to its end
    double x_px = 0.0;
    double y_px = 0.0;
    std::uint32_t time_ms = 0;  // of the display server; begins again at 0 after 49 days
};

// One finger throws. A second one changes nothing while the first is at work; but a first that lies still, a
// palm on the panel's edge or a sleeve, keeps nobody else from the wheel: it is nobody as soon as another
// comes. Who is nobody stays so until lifted.
class LeadingFinger {
  public:
    // What a pointer with one button would have done, into `events`.
    void follow(const Touch& touch, std::vector<Event>& events);

  private:
    void begin(const Touch& touch, std::vector<Event>& events);
    void move(const Touch& touch, std::vector<Event>& events);

    std::optional<std::uint32_t> finger_;
    Touch still_{};  // where it has been since when
};

}  // namespace onggi::window
