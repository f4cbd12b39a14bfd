// All steps of a visit: what their screens look like, and what is said there. Drawing: the composer's thread.
#pragma once

#include "game/visit/flow/step.h"

namespace onggi::visit {

// The whole screen for this view: the state's screen, or the panel that lies over it.
[[nodiscard]] Composition compose(const View& view, ui::Painter& painter, PaintingStore& store);

// Returns the key of the line to be spoken, or an empty one for silence. It changes only when a new line is
// due. The line is the spoken text of the language tables; its recording is LANGUAGE/KEY.wav.
[[nodiscard]] std::string_view spoken_key(const State& state);

}  // namespace onggi::visit
