// The museums' pots that come with the program.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "game/heritage/target.h"
#include "tests/support/places.h"

namespace onggi::heritage {

inline std::vector<Target> bundled() {
    auto targets = load_targets(test::in_checkout("assets/heritage"));
    EXPECT_TRUE(targets) << (targets ? "" : targets.error().message);
    return targets ? *targets : std::vector<Target>{};
}

}  // namespace onggi::heritage
