// The slopes that a straight line from an anchor may have and still pass every point so far within a
// tolerance: what thins an outline in one pass. Plain value, any thread.
#pragma once

#include <algorithm>
#include <limits>

namespace onggi::exporter {

// Each point that the line passes narrows the range. Once a point leaves nothing of it, the line ends at the
// point before, on `end`: the slope within the range that is nearest to that point's own. Each point is
// looked at once or twice, so that noise costs no more than smoothness. (The idea is the "swinging door" of
// process historians, with a free end point.)
class SlopeRange {
  public:
    // Takes a point `run` away, `rise` above the anchor. False if it leaves nothing; then nothing changed.
    // Never false for the first point. Precondition: run > 0.
    bool pass(double run, double rise, double tolerance) {
        const double low = std::max(low_, (rise - tolerance) / run);
        const double high = std::min(high_, (rise + tolerance) / run);
        if (!(low <= high)) return false;
        low_ = low;
        high_ = high;
        end_ = std::clamp(rise / run, low, high);
        return true;
    }
    [[nodiscard]] double end() const { return end_; }

  private:
    double low_ = -std::numeric_limits<double>::infinity();
    double high_ = std::numeric_limits<double>::infinity();
    double end_ = 0.0;
};

}  // namespace onggi::exporter
