// What an audit asks of a composed screen, one rule a function; each fails the test that calls it. See
// audit_test.cpp.
#pragma once

#include "game/screens/page/composition.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {

// All that can be asked of places and words alone.
void audit_layout(const SampleView& sample, const Composition& screen);
// Words against what is painted behind them.
void audit_contrast(const SampleView& sample, const Composition& screen);
// The stage's texture holds all of its pictures at once: where they take turns, all of them are copied in
// every frame.
void audit_room(const SampleView& sample, const Composition& screen);

}  // namespace onggi::screens
