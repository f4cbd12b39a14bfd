#include "game/app/kiosk/health/kiosk_health.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "engine/core/list_folder.h"

namespace onggi::app {

void HealthMeter::see(double now_s, double frame_ms, double device_ms, std::uint64_t periods) {
    const auto number = static_cast<std::int64_t>(std::floor(now_s / kBinS));
    const auto at = [&](std::int64_t bin) -> Bin& { return bins_[static_cast<std::size_t>(bin) % kBins]; };
    if (newest_ < 0) newest_ = number;
    // A frame longer than a bin fills all bins that it spans, so that a standstill is visible.
    for (std::int64_t bin = std::max(newest_ + 1, number - static_cast<std::int64_t>(kBins) + 1);
         bin < number; ++bin)
        at(bin) = {.worst_ms = frame_ms};
    if (number > newest_) at(number) = {};
    newest_ = std::max(newest_, number);
    Bin& now = at(newest_);
    now.worst_ms = std::max(now.worst_ms, frame_ms);
    now.device_ms = std::max(now.device_ms, device_ms);
    now.sum_ms += frame_ms;
    ++now.frames;

    if (!has_start_) {
        has_start_ = true;
        rated_s_ = now_s;
        rated_periods_ = periods;
    } else if (now_s - rated_s_ >= 1.0) {
        achieved_hz_ = static_cast<double>(periods - rated_periods_) / (now_s - rated_s_);
        rated_s_ = now_s;
        rated_periods_ = periods;
    }
}

double HealthMeter::mean_frame_ms() const {
    double sum_ms = 0.0;
    int frames = 0;
    for (const Bin& bin : bins_) {
        sum_ms += bin.sum_ms;
        frames += bin.frames;
    }
    return frames > 0 ? sum_ms / frames : 0.0;
}

double HealthMeter::worst_frame_ms() const {
    double worst_ms = 0.0;
    for (const Bin& bin : bins_)
        worst_ms = std::max(worst_ms, bin.worst_ms);
    return worst_ms;
}

screens::FramePlot HealthMeter::plot() const {
    screens::FramePlot plot;
    for (std::size_t i = 1; i <= kBins && newest_ >= 0; ++i) {
        const Bin& bin = bins_[(static_cast<std::size_t>(newest_) + i) % kBins];
        plot.frame_ms.push_back(static_cast<float>(bin.worst_ms));
        plot.device_ms.push_back(static_cast<float>(bin.device_ms));
    }
    return plot;
}

std::optional<double> hottest_celsius(const std::filesystem::path& zones) {
    constexpr double kMilliCelsius = 1e3;
    // Ignores the values of a broken sensor.
    constexpr double kLeast = -60.0;
    constexpr double kMost = 200.0;
    std::optional<double> hottest;
    for (const std::filesystem::path& zone : list_folder(zones).entries) {
        if (!zone.filename().string().starts_with("thermal_zone")) continue;
        std::ifstream file(zone / "temp");
        double value = 0.0;
        if (!(file >> value)) continue;
        const double celsius = value / kMilliCelsius;
        if (celsius > kLeast && celsius < kMost) hottest = std::max(celsius, hottest.value_or(celsius));
    }
    return hottest;
}

}  // namespace onggi::app
