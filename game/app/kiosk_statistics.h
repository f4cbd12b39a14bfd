// The measured use of a kiosk: one line a visit in a local CSV, with the day, the hour, how long, how far,
// and whether a pot was kept. Nothing says who it was: no minute, no number, no shape. Any one thread at a
// time but the haptic one; blocks.
#pragma once

#include <filesystem>

#include "engine/core/result.h"
#include "game/kiosk/state.h"

namespace onggi::app {

struct VisitNote {
    int dwell_s = 0;
    kiosk::Screen last = kiosk::Screen::kAttract;  // where it ended
    bool kept = false;
};

// Appends to folder/visits.csv, with a line of names first where the file is new. System lacks: no permission
// or no room.
Result<void> note_visit(const std::filesystem::path& folder, const VisitNote& note);

}  // namespace onggi::app
