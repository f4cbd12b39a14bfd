#include "tests/golden/golden_scenes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.h"

namespace onggi::golden {
namespace {

constexpr int kElements = 2000;
constexpr double kHeightMm = 200.0;

// By height above the wheel head.
template <typename Outline>
std::vector<float> radii_of(Outline outline) {
    std::vector<float> radii;
    for (int i = 0; i < kElements; ++i)
        radii.push_back(static_cast<float>(outline((i + 0.5) * kHeightMm / kElements)));
    return radii;
}

double bump(double y, double centre, double width) {
    const double share = (y - centre) / width;
    return std::exp(-share * share);
}

double throwing_rings(double y) {
    return 0.35 * std::sin(y * 0.78 + 2.3 * std::sin(y * 0.026));
}

double vase(double y) {
    return 30.0 + 26.0 * bump(y, 70.0, 52.0) + 12.0 * bump(y, 205.0, 26.0) + throwing_rings(y);
}

// A sphere of 16 mm pressed 9 mm deep into a straight wall, and the trace of it higher up.
double pressed(double y) {
    const double off = y - 95.0;
    const double dent = std::abs(off) < 16.0 ? 60.0 - 9.0 + 16.0 - std::sqrt(16.0 * 16.0 - off * off) : 60.0;
    return std::min({60.0, dent, 60.0 - 5.0 * bump(y, 150.0, 20.0)});
}

double bottle(double y) {
    return 7.0 + 46.0 * bump(y, 48.0, 42.0) + 9.0 * bump(y, 203.0, 12.0);
}

// Wide, and rough: grooves of 5 mm, and fine ones of 1.2 mm, which two pixels span.
double grooved(double y) {
    return 55.0 - 6.0 * bump(y, 20.0, 30.0) + 1.6 * std::sin(y * 1.25) + 0.12 * std::sin(y * 5.2);
}

// Ledges, where outline and rings have corners.
double stepped(double y) {
    return y < 40.0 ? 60.0 : (y < 90.0 ? 38.0 : (y < 130.0 ? 52.0 : 24.0));
}

}  // namespace

wheel::PotView GoldenScene::pot() const {
    return {.radii_mm = radii_mm,
            .height_mm = kHeightMm,
            .tool_position_mm = tool_position_mm,
            .tool_radius_mm = tool_radius_mm,
            .wheel_direction = wheel_direction,
            .wheel_turning = true,
            .contacts = contacts};
}

std::uint64_t GoldenScene::hash() const {
    StateHash hash;
    hash.add(std::span<const float>(radii_mm));
    for (const double value : {tool_position_mm.x, tool_position_mm.y, tool_position_mm.z, tool_radius_mm,
                               wheel_direction.x, wheel_direction.y})
        hash.add(value);
    return hash.value();
}

std::string test_name(const GoldenScene& scene) {
    std::string name = scene.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::vector<GoldenScene> golden_scenes() {
    return {
        {.name = "fresh-lump", .radii_mm = radii_of([](double) { return 60.0; })},
        {.name = "vase", .radii_mm = radii_of(vase), .wheel_direction = {0.6, 0.8}},
        {.name = "tool-pressing",
         .radii_mm = radii_of(pressed),
         .tool_position_mm = {67.0, 95.0, 0.0},
         .tool_radius_mm = 16.0,
         .contacts = 320},
        {.name = "tool-in-front",
         .radii_mm = radii_of(pressed),
         .tool_position_mm = {-20.0, 95.0, 64.0},
         .tool_radius_mm = 16.0,
         .contacts = 320},
        {.name = "thin-neck", .radii_mm = radii_of(bottle)},
        {.name = "grooved", .radii_mm = radii_of(grooved), .tool_radius_mm = 2.0},
        {.name = "stepped",
         .radii_mm = radii_of(stepped),
         .tool_position_mm = {-95.0, 40.0, 0.0},
         .tool_radius_mm = 40.0},
        {.name = "vase-portrait", .width = 405, .height = 720, .radii_mm = radii_of(vase)},
        {.name = "vase-wide", .width = 960, .height = 540, .radii_mm = radii_of(vase)},
    };
}

}  // namespace onggi::golden
