// The gate of the golden pictures: compares a picture with its approved, stored one.
//
//     EXPECT_TRUE(matches_golden("vase", image, render_info));
//
// Stored: NAME.png, and beside it NAME.json with the driver that drew it, the state it shows, and its
// tolerances. Two limits, because neither alone is enough: a fraction of pixels that differ visibly finds a
// moved edge but not light that is 1 % weaker, a mean difference finds the light but drowns a few wrong
// pixels. Nothing is ever stored by a test that merely runs; storing needs ONGGI_BLESS=NAME,NAME in the
// environment (target golden-bless), no CI=true, and a tree without changes outside tests/golden. Main
// thread.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "engine/asset/image.h"
#include "engine/core/result.h"

namespace onggi::support {

// The driver and the scene of a picture.
struct RenderInfo {
    std::string driver;  // VkPhysicalDeviceDriverProperties::driverName
    std::string
        version;  // its driverInfo's Mesa version or the like; a picture is exact only within one version
    std::string driver_info;  // the whole driverInfo, which names LLVM
    std::string state_hash;   // of the shown recording or state
};

struct Tolerances {
    int delta_limit = 2;         // of 255, in any channel
    double bad_fraction = 5e-4;  // of pixels above delta_limit
    double mean_delta = 0.02;
};

// The same driver and version drew both: measured noise is 0 pixels and 0.00004. On another driver: reported
// only, or failing if asked (ONGGI_GOLDEN_STRICT=1), and without a limit for the mean.
constexpr Tolerances kSameDriver{};
constexpr Tolerances kOtherDriver{.delta_limit = 5, .bad_fraction = 1e-3, .mean_delta = 255.0};

struct GateOptions {
    // NAME.png and NAME.json. A picture that another release of Mesa draws otherwise, such as words that its
    // suite of Debian shapes otherwise, lies beside it in lavapipe-MAJOR.MINOR; each release stores its
    // pictures there.
    std::filesystem::path golden_folder;
    std::filesystem::path output_folder;  // NAME.{actual,expected,diff}.png of what failed
    bool strict = false;                  // another driver's differences fail, too
    bool in_ci = false;
    std::set<std::string> bless;  // scenes to store instead of comparing
    // Returns the paths that differ from the last commit, outside the goldens; called before storing.
    std::function<Result<std::string>()> dirty_paths;
};

// Options from the environment: CI, ONGGI_BLESS, ONGGI_GOLDEN_STRICT; tests/golden/images/lavapipe-22.3;
// BUILD/golden.
GateOptions gate_options_from_environment();

// `git status` of the repository, without tests/golden; empty if clean. kFailed if git cannot tell.
Result<std::string> dirty_paths_outside_goldens(const std::filesystem::path& repository);

// Name: small letters, digits, - and _. Success may carry a note to print.
testing::AssertionResult matches_golden(const std::string& name, const asset::Image& image,
                                        const RenderInfo& info, const GateOptions& options);
testing::AssertionResult matches_golden(const std::string& name, const asset::Image& image,
                                        const RenderInfo& info);

}  // namespace onggi::support
