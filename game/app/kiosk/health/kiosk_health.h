// How a kiosk fares, measured: the haptic loop's rate and the frames' times of the last ten seconds, seen
// frame by frame; the machine's temperature. Main thread, but for the temperature: any, it blocks.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "game/screens/page/view.h"

namespace onggi::app {

class HealthMeter {
  public:
    // Once a frame: the time since the one before, what the device took for the one before that (0: not
    // measured), and how many periods the haptic loop has done since its start. now_s: of a monotonic clock.
    void see(double now_s, double frame_ms, double device_ms, std::uint64_t periods);

    // Ticks a second over the last second or two; 0 before there is one.
    [[nodiscard]] double achieved_hz() const { return achieved_hz_; }
    // Over the last ten seconds.
    [[nodiscard]] double mean_frame_ms() const;
    [[nodiscard]] double worst_frame_ms() const;
    // The worst of each tenth of a second, the oldest first.
    [[nodiscard]] screens::FramePlot plot() const;

  private:
    static constexpr std::size_t kBins = 100;
    static constexpr double kBinS = 0.1;
    struct Bin {
        double worst_ms = 0.0;
        double device_ms = 0.0;
        double sum_ms = 0.0;
        int frames = 0;
    };

    std::array<Bin, kBins> bins_{};
    std::int64_t newest_ = -1;  // number of the bin of now, since the clock's zero
    double rated_s_ = 0.0;      // since when the rate is counted
    std::uint64_t rated_periods_ = 0;
    bool has_start_ = false;
    double achieved_hz_ = 0.0;
};

// Of the hottest place that the kernel knows, degrees Celsius; none where it knows none.
[[nodiscard]] std::optional<double> hottest_celsius(
    const std::filesystem::path& zones = "/sys/class/thermal");

}  // namespace onggi::app
