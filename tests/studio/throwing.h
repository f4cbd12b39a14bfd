// Gestures that throw whole pots: a hand's way as straight pieces of time, and the settings that hold on
// each.
#pragma once

#include <vector>

#include "tests/studio/bench.h"

namespace onggi::clay::studio {

struct Stroke {
    double seconds;
    double x_mm;  // where the hand is at the stroke's end
    double y_mm;
    double gap_mm = 0.0;  // of the assist
    double shaft_mm = 0.0;
    tool::Tool tool = tool::Tool::kHand;
};

// Throws from far above the lump. The same way at every rate: tick k is at t = k/rate.
inline void throw_pot(Bench& bench, const std::vector<Stroke>& strokes) {
    double x0 = 120.0;
    double y0 = 200.0;
    bench.input.water = 1.0;
    double start = 0.0;
    long tick = 0;
    for (const Stroke& stroke : strokes) {
        bench.input.assist_gap_mm = stroke.gap_mm;
        bench.input.shaft_mm = stroke.shaft_mm;
        bench.input.tool = stroke.tool;
        const double end = start + stroke.seconds;
        for (; static_cast<double>(tick) / bench.parameters.rate_hz < end; ++tick) {
            const double part =
                (static_cast<double>(tick) / bench.parameters.rate_hz - start) / stroke.seconds;
            bench.at(x0 + part * (stroke.x_mm - x0), y0 + part * (stroke.y_mm - y0));
        }
        x0 = stroke.x_mm;
        y0 = stroke.y_mm;
        start = end;
    }
}

// Centres, opens and widens a lump of 500 g.
inline std::vector<Stroke> opened() {
    return {{1.0, 62.0, 30.0},
            {1.0, 58.5, 18.0},
            {2.5, 58.5, 24.0},  // centred
            {0.5, 120.0, 30.0},
            {0.5, 120.0, 200.0},
            {0.5, 0.0, 80.0},
            {4.0, 0.0, 20.0},  // opened
            {0.5, 0.0, 20.0},
            {4.0, 28.0, 20.0, 0.0, 9.0},  // widened
            {0.5, 28.0, 20.0, 0.0, 9.0},
            {0.5, 24.0, 20.0, 0.0, 9.0},
            {1.0, 0.0, 200.0}};
}

// One pull at 20 mm/s from the floor past the rim, the outer face to `outer_mm` there and the gap to the
// assist.
inline void add_pull(std::vector<Stroke>& strokes, double outer_low, double outer_high, double gap,
                     double top) {
    const double r1 = 10.0;
    strokes.push_back({0.5, 120.0, 200.0});
    strokes.push_back({0.5, 80.0, 14.0});
    strokes.push_back({1.0, outer_low + r1 - 0.25, 14.0, gap});
    strokes.push_back({(top - 14.0) / 20.0, outer_high + r1 - 0.25, top, gap});
    strokes.push_back({0.3, 80.0, top});
}

// A cylinder of 90 mm, from 500 g.
inline std::vector<Stroke> cylinder() {
    std::vector<Stroke> strokes = opened();
    strokes.push_back({0.5, 120.0, 200.0});
    strokes.push_back({0.5, 62.0, 3.0});
    strokes.push_back({1.5, 54.5, 3.0});  // the foot
    strokes.push_back({1.5, 54.5, 12.0});
    strokes.push_back({0.3, 80.0, 12.0});
    add_pull(strokes, 47.0, 46.0, 13.0, 75.0);
    add_pull(strokes, 46.0, 45.0, 10.0, 95.0);
    add_pull(strokes, 45.5, 45.0, 8.0, 115.0);
    add_pull(strokes, 45.0, 45.0, 6.6, 125.0);
    add_pull(strokes, 45.0, 45.0, 5.9, 135.0);
    add_pull(strokes, 45.0, 45.0, 5.7, 138.0);
    add_pull(strokes, 45.0, 45.0, 5.3, 142.0);
    strokes.push_back({1.0, 120.0, 200.0});
    return strokes;
}

// A vase from that cylinder: a belly from inside, then a collar.
inline std::vector<Stroke> vase() {
    std::vector<Stroke> strokes = cylinder();
    strokes.push_back({1.0, 0.0, 200.0});
    strokes.push_back({1.0, 0.0, 50.0});
    strokes.push_back({2.0, 32.0, 50.0});
    strokes.push_back({1.0, 32.0, 70.0});
    strokes.push_back({1.0, 34.0, 45.0});
    strokes.push_back({0.5, 0.0, 60.0});
    strokes.push_back({1.0, 0.0, 220.0});
    strokes.push_back({1.0, 120.0, 220.0});
    strokes.push_back({1.0, 60.0, 105.0});
    strokes.push_back({4.0, 44.0, 105.0});
    strokes.push_back({1.0, 80.0, 105.0});
    strokes.push_back({1.0, 120.0, 220.0});
    return strokes;
}

}  // namespace onggi::clay::studio
