// The photographs of a background on their way to where a backend keeps them. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/scene.h"

namespace onggi::render {

// Both photographs, which stay until the background's let_go(). Errors: they cannot be read, or are not of
// the background's size.
[[nodiscard]] Result<const PhotographPair*> whole_pair(const Background& background);

}  // namespace onggi::render
