// A composition as a picture, drawn without Vulkan: for the audit, which looks behind the words, and for
// eyes.
#pragma once

#include "engine/asset/image.h"
#include "game/screens/page/composition.h"

namespace onggi::screens {

// Over a plain ground where the scene would be. `with_words` false leaves the words out: what is behind them.
[[nodiscard]] asset::Image flatten(const Composition& composition, const ui::Colour& ground, bool with_words);

}  // namespace onggi::screens
