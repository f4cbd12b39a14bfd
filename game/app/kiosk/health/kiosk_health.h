// Measures the kiosk's health: the haptic loop's rate and the frame times of the last ten seconds, and the
// machine's temperature. Main thread; the temperature: any thread, blocks.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "game/screens/page/view.h"

namespace onggi::app {

class HealthMeter {
  public:
    // Call it once a frame with the time since the last frame, the device's time for the frame before that
    // (0: not measured), and the number of periods of the haptic loop since its start. now_s is of a
    // monotonic clock.
    void see(double now_s, double frame_ms, double device_ms, std::uint64_t periods);

    // Ticks per second over the last second or two; 0 before the first measurement.
    [[nodiscard]] double achieved_hz() const { return achieved_hz_; }
    // Over the last ten seconds.
    [[nodiscard]] double mean_frame_ms() const;
    [[nodiscard]] double worst_frame_ms() const;
    // The longest frame of each tenth of a second, oldest first.
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
    std::int64_t newest_ = -1;  // number of the present bin, since the clock's zero
    double rated_s_ = 0.0;      // start of the rate's measurement
    std::uint64_t rated_periods_ = 0;
    bool has_start_ = false;
    double achieved_hz_ = 0.0;
};

// The temperature of the hottest sensor of the kernel, degrees Celsius, or nothing without a sensor.
[[nodiscard]] std::optional<double> hottest_celsius(
    const std::filesystem::path& zones = "/sys/class/thermal");

}  // namespace onggi::app
