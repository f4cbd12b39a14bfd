#include "tests/support/paper_gestures.h"

#include "game/clay/exact_math.h"

namespace onggi::clay {
namespace {

// The hand's path is straight between these.
struct Station {
    double duration_s;  // from the one before
    double r_mm;        // distance of the tool's surface from the axis
    double y_mm;
    double bearing_rad;
    double tool_radius_mm;
    bool turning;
};

constexpr Station kVase[] = {
    {0.2, 70.0, 12.3, 0.0, 12.0, false},  // beside the foot
    {0.2, 58.9, 12.3, 0.1, 12.0, false},  // a touch on the standing clay
    {0.1, 58.9, 12.3, 0.1, 12.0, true},   // the wheel starts
    {2.0, 52.4, 101.7, 0.3, 12.0, true},  // first pass, up to the belly
    {1.5, 47.1, 188.2, 0.4, 12.0, true},  // shoulder
    {0.4, 66.0, 203.0, 0.2, 12.0, true},  // off over the rim
    {0.6, 66.0, 31.4, -0.2, 12.0, true},  // and down again
    {0.3, 46.5, 22.6, -0.3, 12.0, true},  // the foot
    {1.8, 49.9, 84.1, -0.1, 12.0, true},  // belly
    {1.6, 33.8, 163.9, 0.2, 12.0, true},  // neck
    {0.9, 41.2, 197.3, 0.5, 12.0, true},  // lip
    {0.3, 72.0, 197.3, 0.5, 6.0, false},  // the wheel stands; a smaller tool
    {0.4, 40.3, 186.1, 0.5, 6.0, false},  // feels the lip
    {0.3, 62.0, 150.5, 0.5, 6.0, true},  {0.7, 31.7, 158.8, 0.6, 6.0, true},  // a groove in the neck
    {1.1, 30.9, 171.0, 0.9, 6.0, true},  {0.6, 36.5, 180.6, 1.4, 6.0, true},
    {0.5, 75.0, 180.6, 1.6, 6.0, false},
};

// Numbers in [0, 1) from a 64-bit linear congruential generator (Knuth's MMIX constants).
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) { next(); }

    double next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    double between(double least, double most) { return least + (most - least) * next(); }

  private:
    std::uint64_t state_;
};

ToolInput at(double r_mm, double y_mm, double bearing_rad, double tool_radius_mm, bool turning) {
    const Rotation bearing = rotation_by(bearing_rad);
    const double r3 = r_mm + tool_radius_mm;
    return {.position_mm = {r3 * bearing.cosine, y_mm, -r3 * bearing.sine},
            .radius_mm = tool_radius_mm,
            .wheel_turning = turning};
}

}  // namespace

std::vector<ToolInput> vase_gesture(double rate_hz) {
    std::vector<ToolInput> ticks;
    Station from{0.0, 95.0, 12.3, 0.0, 12.0, false};
    double start_s = 0.0;
    for (const Station& to : kVase) {
        for (;;) {
            const double t_s = static_cast<double>(ticks.size()) / rate_hz;
            if (t_s >= start_s + to.duration_s) break;
            const double part = (t_s - start_s) / to.duration_s;
            const auto blend = [&](double a, double b) { return a + (b - a) * part; };
            ticks.push_back(at(blend(from.r_mm, to.r_mm), blend(from.y_mm, to.y_mm),
                               blend(from.bearing_rad, to.bearing_rad), to.tool_radius_mm, to.turning));
        }
        start_s += to.duration_s;
        from = to;
    }
    return ticks;
}

std::vector<ToolInput> random_gesture(std::uint64_t seed, int ticks) {
    Dice dice(seed);
    std::vector<ToolInput> gesture;
    ToolInput from = at(80.0, 100.0, 0.0, 10.0, false);
    double tool_radius_mm = 10.0;
    while (gesture.size() < static_cast<std::size_t>(ticks)) {
        if (dice.next() < 0.2) tool_radius_mm = dice.between(2.0, 40.0);
        const bool turning = dice.next() < 0.7;
        const double kind = dice.next();
        double r_mm = dice.between(54.0, 62.0);           // along the wall
        if (kind < 0.2) r_mm = dice.between(20.0, 55.0);  // deep
        if (kind < 0.05) r_mm = -tool_radius_mm;          // to the axis
        if (kind > 0.9) r_mm = dice.between(61.0, 90.0);  // distance from the clay
        // One statement each: the order of two calls among a call's arguments is the compiler's.
        const double bearing_rad = dice.between(-3.0, 3.0);
        const double y_mm = dice.between(-20.0, 220.0);
        const ToolInput to = at(r_mm, y_mm, bearing_rad, tool_radius_mm, turning);
        const int steps = 1 + static_cast<int>(dice.between(1.0, 400.0));
        for (int step = 1; step <= steps; ++step) {
            const double part = static_cast<double>(step) / steps;
            gesture.push_back({.position_mm = from.position_mm + (to.position_mm - from.position_mm) * part,
                               .radius_mm = tool_radius_mm,
                               .wheel_turning = turning});
        }
        from = to;
    }
    gesture.resize(static_cast<std::size_t>(ticks));
    return gesture;
}

}  // namespace onggi::clay
