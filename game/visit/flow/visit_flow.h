// The state of a visit and how to advance it: the interface that the visit's parts outside the flow use. Main
// thread.
#pragma once

#include <string>

#include "game/kiosk/events.h"

namespace onggi::visit {

class VisitFlow {
  public:
    [[nodiscard]] virtual const kiosk::State& state() const = 0;
    // Advances the state and applies the effects before it returns. Precondition: called within frame(),
    // because the effects use the frame's moment.
    virtual void dispatch(const kiosk::Event& event) = 0;
    // Logs a line. warn() logs an error that does not end the visit.
    virtual void say(const std::string& line) = 0;
    virtual void warn(const std::string& line) = 0;

  protected:
    VisitFlow() = default;
    VisitFlow(const VisitFlow&) = default;
    VisitFlow& operator=(const VisitFlow&) = default;
    ~VisitFlow() = default;
};

}  // namespace onggi::visit
