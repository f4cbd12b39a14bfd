#include "game/app/replay/session_marks.h"

#include "engine/core/quote.h"

namespace onggi::app {

Result<decoration::Recorded> decoration_in(const record::Session& session, const std::string& name) {
    if (session.supplement().empty()) return decoration::Recorded{};
    return decoration::recorded_from(session.supplement(), shown_path(name));
}

decoration::Wall wall_of(const pot::Pot& pot) {
    return decoration::wall_of(pot::outer_outline(pot));
}

}  // namespace onggi::app
