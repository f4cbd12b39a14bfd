// See pot_samples.h. Any thread.
#include "tests/support/pot_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>

#include "engine/files/read_file.h"
#include "game/clay/paper_clay.h"
#include "game/tool/gesture.h"
#include "tests/support/places.h"

namespace onggi::support {
namespace {

constexpr double kHeightMm = 200.0;

// The radius as a function of u = y/H in the middle of each element.
PotSample turned(std::string name, int element_count, const std::function<double(double)>& radius_mm) {
    PotSample pot{std::move(name), kHeightMm, {}, true};
    pot.radii_mm.reserve(static_cast<std::size_t>(element_count));
    for (int i = 0; i < element_count; ++i) {
        pot.radii_mm.push_back(static_cast<float>(radius_mm((i + 0.5) / element_count)));
    }
    return pot;
}

PotSample thin_neck() {
    return turned("thin_neck", 2000, [](double u) {
        const double towards_neck = std::abs(u - 0.7) / 0.3;
        return std::clamp(60.0 * towards_neck * towards_neck, 2.0, 60.0);
    });
}

PotSample sharp_steps(int element_count) {
    PotSample pot = turned("sharp_steps_" + std::to_string(element_count), element_count, [](double u) {
        constexpr double kRadiiMm[] = {60.0, 20.0, 55.0, 2.0, 40.0};
        return kRadiiMm[std::min(4, static_cast<int>(u * 5.0))];
    });
    return pot;
}

// A random radius from floor to lump for each element, by a fixed generator (Marsaglia's xorshift).
PotSample rough(int element_count) {
    std::uint32_t state = 2463534242U;
    PotSample pot = turned("rough_" + std::to_string(element_count), element_count, [&state](double) {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        return 2.0 + 58.0 * (state / 4294967296.0);
    });
    pot.hand_made = false;
    return pot;
}

}  // namespace

PotSample vase(int element_count) {
    return turned("vase_" + std::to_string(element_count), element_count, [](double u) {
        const double belly = 36.0 + 18.0 * std::sin(1.9 * kPi * u + 0.2) * (1.0 - 0.35 * u);
        const double lip = 9.0 * std::exp(-(1.0 - u) / 0.03);
        const double rings = 0.25 * std::sin(kTurn * kHeightMm * u / 8.5);
        return belly + lip + rings;
    });
}

PotSample pressed_lump(int element_count) {
    struct Press {
        double y_mm, depth_mm;
    };
    constexpr double kToolMm = 10.0;
    constexpr Press kPresses[] = {{30.0, 6.0}, {52.0, 14.0},  {60.0, 18.0},
                                  {95.5, 1.0}, {140.0, 30.0}, {143.0, 31.0}};
    return turned("pressed_" + std::to_string(element_count), element_count, [&](double u) {
        double radius_mm = 60.0;
        for (const Press& press : kPresses) {
            const double dy = u * kHeightMm - press.y_mm;
            if (std::abs(dy) >= kToolMm) continue;
            // The tool's near side: its centre stands one radius outside the pressed-in wall.
            const double centre_mm = 60.0 - press.depth_mm + kToolMm;
            radius_mm = std::min(radius_mm, centre_mm - std::sqrt(kToolMm * kToolMm - dy * dy));
        }
        return radius_mm;
    });
}

PotSample thrown_vase() {
    const Result<std::string> text =
        files::read_file(test::in_checkout("assets/gestures/vase.csv"), tool::kMaxGestureBytes);
    if (!text) throw std::runtime_error(text.error().message);
    const Result<tool::Gesture> gesture = tool::parse_gesture(*text, "vase.csv");
    if (!gesture) throw std::runtime_error(gesture.error().message);
    const clay::PaperParameters parameters;
    clay::PaperClay clay;
    const std::uint64_t ticks = gesture->tick_count(parameters.rate_hz);
    for (std::uint64_t k = 0; k < ticks; ++k) {
        const tool::ToolState tool = gesture->at_tick(k, parameters.rate_hz);
        clay.tick({tool.position_mm, tool.radius_mm, tool.wheel_button}, parameters);
    }
    const auto radii_mm = clay.radii_mm();
    return {"thrown_vase", clay.height_mm(), {radii_mm.begin(), radii_mm.end()}, true};
}

std::vector<PotSample> all_pot_samples() {
    std::vector<PotSample> pots;
    pots.push_back(thrown_vase());
    pots.push_back(turned("straight_2000", 2000, [](double) { return 60.0; }));
    pots.push_back(vase(100));
    pots.push_back(vase(2000));
    pots.push_back(vase(200000));
    pots.push_back(pressed_lump(2000));
    pots.push_back(thin_neck());
    pots.push_back(sharp_steps(100));
    pots.push_back(sharp_steps(2000));
    pots.push_back(rough(100));
    pots.push_back(rough(2000));
    pots.push_back(rough(200000));
    pots.push_back(turned("single_element", 1, [](double) { return 45.0; }));
    return pots;
}

}  // namespace onggi::support
