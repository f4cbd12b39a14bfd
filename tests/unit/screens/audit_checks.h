// The rules of the audit of a composed screen, one per function; each fails the calling test. See
// audit_test.cpp.
#pragma once

#include "game/screens/page/composition.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {

// The rules for positions and texts alone.
void audit_layout(const SampleView& sample, const Composition& screen);
// The contrast of texts against their background.
void audit_contrast(const SampleView& sample, const Composition& screen);
// The stage's texture must hold all of its pictures at once: otherwise all are copied in every frame.
void audit_room(const SampleView& sample, const Composition& screen);

}  // namespace onggi::screens
