// A gesture: the path of a tool over time, read from a CSV table.
// Format: header line exactly t_s,x_mm,y_mm,z_mm,button,tool_radius_mm (more columns may follow to the
// right; a name that gesture.cpp does not know is ignored), then rows with t_s ascending from 0. Units as the
// column names say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "game/tool/tool_state.h"

namespace onggi::tool {

constexpr std::string_view kGestureHeader = "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm";
constexpr double kMaxGestureSeconds = 3600.0;
constexpr std::size_t kMaxGestureLineBytes = 4096;
constexpr std::size_t kMaxGestureBytes = std::size_t{256} << 20U;
// The tick rates at which a gesture or session can be played.
constexpr double kMinRateHz = 100.0;
constexpr double kMaxRateHz = 10000.0;

// The recorded motion of a hand, as rows in time. Immutable; any thread; at() is fit for the tick.
class Gesture {
  public:
    struct Row {
        double t_s = 0.0;
        ToolState tool;
    };

    // The tool at time t_s. Positions are interpolated linearly between rows (the second hand's if both rows
    // have one); every other field holds from its row's t_s, inclusive, until the next row. Before the first
    // row returns the first, after the last the last. No allocation.
    [[nodiscard]] ToolState at(double t_s) const noexcept;
    // The number of ticks, floor(duration * rate + 1e-9) + 1; tick k is at time (double)k / rate.
    [[nodiscard]] std::uint64_t tick_count(double rate_hz) const noexcept;
    [[nodiscard]] ToolState at_tick(std::uint64_t tick, double rate_hz) const noexcept {
        return at(static_cast<double>(tick) / rate_hz);
    }

    [[nodiscard]] double duration_s() const noexcept { return rows_.back().t_s; }
    [[nodiscard]] std::span<const Row> rows() const noexcept { return rows_; }

  private:
    friend Result<Gesture> parse_gesture(std::string_view text, std::string_view name);
    Gesture() = default;
    std::vector<Row> rows_;  // at least one, t_s strictly ascending from 0
};

// Parses a gesture from `text`; error messages call it `name`. Lines end in LF or CRLF; numbers are plain
// decimal, independent of the locale. Errors: bad input, with line and column. Main thread.
[[nodiscard]] Result<Gesture> parse_gesture(std::string_view text, std::string_view name);

// Checks the header line in `start`, the first bytes of a file, as parse_gesture does: a caller can reject a
// huge file of another kind without reading it.
[[nodiscard]] Result<void> check_gesture_start(std::string_view start, std::string_view name);

}  // namespace onggi::tool
