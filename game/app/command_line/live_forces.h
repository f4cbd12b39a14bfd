// The forces over a picture that plays by itself: `onggi live`. A key turns them on and off. Main thread.
#pragma once

#include "engine/render/overlay.h"
#include "game/app/kiosk/presentation/force_view.h"
#include "game/screens/stage.h"

namespace onggi::app {

class LiveForces {
  public:
    explicit LiveForces(bool shown) : shown_(shown) {}
    ~LiveForces() { composer_.stop(); }
    LiveForces(const LiveForces&) = delete;
    LiveForces& operator=(const LiveForces&) = delete;

    Result<void> start() { return composer_.start(); }
    void turn_over() { shown_ = !shown_; }

    // Once a frame, shown or not, so that the plots have a past. Null: nothing to lay over the picture. Good
    // until the next call.
    [[nodiscard]] const render::Overlay* look(const haptic::Snapshot& snapshot, const wheel::WheelView& shown,
                                              const wheel::LiveView& view, double now_s);

  private:
    bool shown_;
    ForceView forces_;
    screens::Composer composer_;
    screens::Stage stage_;
    std::shared_ptr<const screens::View> asked_;
    render::Overlay overlay_;
};

}  // namespace onggi::app
