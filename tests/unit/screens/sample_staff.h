// Views of the staff's keypad and panel, for tests and pictures.
#pragma once

#include <vector>

#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {

// After those that are there, each as `base` but for what it shows.
void add_staff_views(const View& base, std::vector<SampleView>& all);

}  // namespace onggi::screens
