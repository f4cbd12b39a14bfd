// A composition as a picture, drawn without Vulkan: for the audit of contrast, and for inspection.
#pragma once

#include <optional>

#include "engine/asset/image.h"
#include "game/screens/page/composition.h"

namespace onggi::screens {

// Draws over a plain colour in place of the scene. with_words false: without texts, for their background.
// since_s: after the screen has come; empty: at the end of its motion.
[[nodiscard]] asset::Image flatten(const Composition& composition, const ui::Colour& ground, bool with_words,
                                   std::optional<double> since_s = {});

}  // namespace onggi::screens
