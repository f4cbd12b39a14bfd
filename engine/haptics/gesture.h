// A gesture: the path of a tool over time, read from a CSV table, and the device that plays it back.
// Format: header line exactly t_s,x_mm,y_mm,z_mm,button,tool_radius_mm (more columns may follow to the
// right), then rows with t_s ascending from 0. Units as the column names say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/gesture_columns.h"
#include "engine/haptics/haptic_device.h"
#include "engine/haptics/tool_state.h"

namespace onggi::haptics {

constexpr std::string_view kGestureHeader = "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm";
constexpr double kMaxGestureSeconds = 3600.0;
constexpr std::size_t kMaxGestureLineBytes = 4096;
constexpr std::size_t kMaxGestureBytes = std::size_t{256} << 20U;
// Tick rates at which a gesture or session may be played.
constexpr double kMinRateHz = 100.0;
constexpr double kMaxRateHz = 10000.0;

// What a hand did, at the instants somebody wrote down. Immutable; any thread; at() is fit for the tick.
class Gesture {
  public:
    struct Row {
        double t_s = 0.0;
        ToolState tool;
    };

    // The tool at time t_s: positions linear between rows, of the second hand where both have one; all else
    // holds from its row's own t_s, inclusive, until the next row. Before the first row and after the last:
    // that row. No allocation.
    [[nodiscard]] ToolState at(double t_s) const noexcept;
    // floor(duration rate + 1e-9) + 1: ticks k = 0 ... tick_count - 1 at time (double)k / rate.
    [[nodiscard]] std::uint64_t tick_count(double rate_hz) const noexcept;
    [[nodiscard]] ToolState at_tick(std::uint64_t tick, double rate_hz) const noexcept {
        return at(static_cast<double>(tick) / rate_hz);
    }

    [[nodiscard]] double duration_s() const noexcept { return rows_.back().t_s; }
    [[nodiscard]] std::span<const Row> rows() const noexcept { return rows_; }

  private:
    friend Result<Gesture> parse_gesture(std::string_view text, std::string_view name,
                                         const GestureWords& words);
    Gesture() = default;
    std::vector<Row> rows_;  // at least one, t_s strictly ascending from 0
};

// The gesture that `text` says; `name` stands for it in messages. Lines end in LF or CRLF; numbers are plain
// decimal, whatever the locale. Every refusal is bad input and names line and column. `words` are those of
// the work it is meant for; without them a plain tool's columns are understood, and all that every work has.
// Main thread.
[[nodiscard]] Result<Gesture> parse_gesture(std::string_view text, std::string_view name,
                                            const GestureWords& words = {});

// Whether `start`, the first bytes of a file, can open a gesture: refuses what parse_gesture would refuse for
// its first line. Lets a caller turn away a huge file of the wrong kind unread.
[[nodiscard]] Result<void> check_gesture_start(std::string_view start, std::string_view name,
                                               const GestureWords& words = {});

// A gesture as a device: reads tick by tick, feels nothing. After the gesture's end the tool rests at its
// last row. The rate is given at the start because tick k is at exactly (double)k / rate.
class GesturePlayer final : public HapticDevice {
  public:
    GesturePlayer(Gesture gesture, double rate_hz);

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    [[nodiscard]] DeviceCapabilities capabilities() const override;
    [[nodiscard]] ToolState read(std::uint64_t tick, double dt_s) noexcept override;
    void write(const dvec3& force_n) noexcept override { last_force_n_ = force_n; }

    [[nodiscard]] const Gesture& gesture() const noexcept { return gesture_; }
    [[nodiscard]] std::uint64_t tick_count() const noexcept { return gesture_.tick_count(rate_hz_); }
    [[nodiscard]] dvec3 last_force_n() const noexcept { return last_force_n_; }

  private:
    Gesture gesture_;
    double rate_hz_;
    dvec3 last_force_n_{0.0};
};

}  // namespace onggi::haptics
