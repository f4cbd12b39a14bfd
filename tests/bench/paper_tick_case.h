// The work of both paper_tick and paper_tick_scan: a tool at y = 100 mm works 1 mm +- 0.2 mm deep in a
// straight 60 mm wall while the wheel turns. After each tick the wall is put back, outside the timed part, so
// that every timed tick meets the same contact. One thread. Units: mm; times in s.
#pragma once

#include <chrono>
#include <vector>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_reference.h"

namespace onggi::bench {

// Seconds between two moments, minus the cost of reading the clock.
class StopWatch {
  public:
    StopWatch();
    void start() { start_ = std::chrono::steady_clock::now(); }
    [[nodiscard]] double stop_s() const;

  private:
    std::chrono::steady_clock::time_point start_;
    double overhead_s_ = 0.0;
};

class PaperTickCase {
  public:
    PaperTickCase(int element_count, double tool_radius_mm);

    // Each: one timed tick of the wall, which it restores afterwards. Returns the seconds it took.
    double tick_clay();
    double tick_scan();
    // The forces of the last tick of either.
    [[nodiscard]] const clay::ContactForces& forces() const { return forces_; }

    // Whether both touch the same elements and feel the same force at every position the tool takes.
    [[nodiscard]] bool both_agree();

  private:
    [[nodiscard]] clay::ToolInput next_tool();

    clay::PaperParameters parameters_;
    clay::PaperClay clay_;
    clay::PaperReference scan_;
    // The elements that the tool can reach at its deepest, and their saved radii.
    int first_ = 0;
    std::vector<float> straight_wall_mm_;
    std::vector<clay::ToolInput> path_;  // one period of the depth, off the element grid
    std::size_t step_ = 0;
    clay::ContactForces forces_;
    StopWatch watch_;
};

}  // namespace onggi::bench
