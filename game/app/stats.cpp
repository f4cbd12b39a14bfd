#include "game/app/stats.h"

namespace onggi::app {

nlohmann::ordered_json percentiles(const jobs::Histogram& histogram, double unit) {
    const auto of = [&](double share) { return static_cast<double>(histogram.percentile(share)) / unit; };
    return {{"p50", of(0.5)},
            {"p99", of(0.99)},
            {"p999", of(0.999)},
            {"max", static_cast<double>(histogram.max()) / unit}};
}

nlohmann::ordered_json common_stats(std::uint64_t ticks, const jobs::Histogram& tick_ns, double rate_hz,
                                    const clay::PaperClay& clay) {
    return {{"ticks", ticks},
            {"tick_ns", percentiles(tick_ns)},
            {"rate_hz", rate_hz},
            {"clay_volume_mm3", clay.volume_mm3()},
            {"ledger_error", nullptr}};
}

}  // namespace onggi::app
