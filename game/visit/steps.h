// The table of all steps of a visit: composes their screens and returns their spoken lines. Drawing: the
// composer's thread.
#pragma once

#include "game/visit/flow/step.h"

namespace onggi::visit {

// The complete screen for this view: the state's screen, or the panel over it.
[[nodiscard]] Composition compose(const View& view, ui::Painter& painter, PaintingStore& store);

// Returns the key of the line to speak now, or an empty one for silence. The key changes only when a new line
// is due. The line is the spoken text of the language tables; its recording is LANGUAGE/KEY.wav.
[[nodiscard]] std::string_view spoken_key(const State& state);

}  // namespace onggi::visit
