// Where a visit stands, and how it is taken on: what its parts beside the frame know of it. Main thread.
#pragma once

#include <string>

#include "game/kiosk/events.h"

namespace onggi::visit {

class VisitFlow {
  public:
    [[nodiscard]] virtual const kiosk::State& state() const = 0;
    // Takes the state on and applies the effects before it returns. Precondition: a frame is being made, to
    // whose moment the effects are applied.
    virtual void dispatch(const kiosk::Event& event) = 0;
    // A line for the log; warn(): of what went wrong and is borne.
    virtual void say(const std::string& line) = 0;
    virtual void warn(const std::string& line) = 0;

  protected:
    VisitFlow() = default;
    VisitFlow(const VisitFlow&) = default;
    VisitFlow& operator=(const VisitFlow&) = default;
    ~VisitFlow() = default;
};

}  // namespace onggi::visit
