// Checks the copies of constants in the workshop's maker, which is Python and runs in Blender.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "game/finish/clay_body.h"
#include "shaders/curve.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::house {
namespace {

bool stands_in(const char* file, const std::string& text) {
    return test::content_of(test::in_checkout(file)).find(text) != std::string::npos;
}

TEST(CopiedNumbers, AreThoseOfTheProgram) {
    const dvec3& clay = finish::kStoneware.raw;
    EXPECT_TRUE(
        stands_in("assets/workshop/maker/paint.py", fmt::format("({}, {}, {})", clay.x, clay.y, clay.z)));
    EXPECT_TRUE(stands_in("assets/workshop/maker/tone.py",
                          fmt::format("c / (c * {} + {})", shaders::kCurveSlope, shaders::kCurveFoot)));
}

}  // namespace
}  // namespace onggi::house
