#include "game/app/command_line/stats.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "game/app/system/or_null.h"
#include "game/clay/studio/pot.h"
#include "game/exporter/studio_export.h"

namespace onggi::app {

nlohmann::ordered_json percentiles(const jobs::Histogram& histogram, double unit) {
    const auto of = [&](double fraction) {
        return static_cast<double>(histogram.percentile(fraction)) / unit;
    };
    return {{"p50", of(0.5)},
            {"p99", of(0.99)},
            {"p999", of(0.999)},
            {"max", static_cast<double>(histogram.max()) / unit}};
}

namespace {

nlohmann::ordered_json ledger_error(const haptic::HapticState& state) {
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr) return nullptr;
    return studio->ledger_error_mm3() / studio->ledger().lump_mm3;
}

std::string_view name_of(clay::studio::Cause cause) {
    switch (cause) {
        case clay::studio::Cause::kNone:
            return "none";
        case clay::studio::Cause::kWeight:
            return "weight";
        case clay::studio::Cause::kSpin:
            return "spin";
        case clay::studio::Cause::kOverhang:
            return "overhang";
        case clay::studio::Cause::kTwist:
            return "twist";
    }
    return "none";
}

// Adds the studio clay's statistics; the failure is a sentence, or null while the pot stands.
void add_studio_stats(nlohmann::ordered_json& stats, const clay::StudioClay& clay) {
    const auto pot = clay::measure_pot(clay.rings(), clay.lump().body);
    stats["mass_g"] = pot.mass_g;
    stats["height_mm"] = pot.height_mm;
    stats["max_diameter_mm"] = pot.widest_mm;
    stats["floor_mm"] = pot.floor_mm;
    stats["thinnest_wall_mm"] = pot.thinnest_wall_mm;
    stats["thickest_wall_mm"] = pot.thickest_wall_mm;
    stats["capacity_ml"] = pot.capacity_ml;
    stats["trimmings_mm3"] = clay.ledger().trimmings_mm3;
    stats["slip_mm3"] = clay.ledger().slip_mm3;
    stats["rings"] = clay.ring_count();
    stats["cut_off"] = clay.is_cut_off();
    stats["load_index"] = clay.load_index();
    stats["load_height_mm"] = clay.load_height_mm();
    stats["load_cause"] = name_of(clay.load_cause());
    stats["wet"] = exporter::measures_json(clay, clay::Firing::kWet);
    stats["fired"] = exporter::measures_json(clay, clay::Firing::kGlaze);
    stats["failure"] = nullptr;
    if (clay.failure().cause != clay::studio::Cause::kNone) stats["failure"] = clay::sentence(clay.failure());
}

}  // namespace

nlohmann::ordered_json common_stats(std::uint64_t ticks, const jobs::Histogram& tick_ns, double rate_hz,
                                    const haptic::HapticState& state) {
    nlohmann::ordered_json stats{{"ticks", ticks},
                                 {"tick_ns", percentiles(tick_ns)},
                                 {"rate_hz", rate_hz},
                                 {"clay_volume_mm3", state.volume_mm3()},
                                 {"ledger_error", ledger_error(state)}};
    if (const clay::StudioClay* studio = state.studio()) add_studio_stats(stats, *studio);
    return stats;
}

nlohmann::ordered_json live_stats(const LiveReport& report) {
    constexpr double kNsPerUs = 1e3;
    constexpr double kNsPerMs = 1e6;
    const bool pinned = report.real_time.pinning.grant == jobs::Grant::kGranted;
    nlohmann::ordered_json stats =
        common_stats(report.ticks.ticks, report.ticks.tick_ns, report.rate_hz, report.state);
    stats["missed_deadlines"] = report.ticks.missed_deadlines();
    stats["skipped_periods"] = report.ticks.skipped_periods;
    stats["wake_latency_us"] = percentiles(report.ticks.wake_latency_ns, kNsPerUs);
    stats["haptic_core"] = pinned ? report.real_time.core.core : -1;
    stats["haptic_core_shared"] = report.real_time.core.shared();
    stats["scheduler"] = report.real_time.scheduler();
    stats["memory_locked"] = report.real_time.memory_lock.grant == jobs::Grant::kGranted;
    stats["frames"] = report.frames;
    stats["first_frame_s"] = or_null<nlohmann::ordered_json>(report.first_frame_s);
    stats["resident_mb"] = or_null<nlohmann::ordered_json>(report.resident_mb);
    stats["own_mb"] = or_null<nlohmann::ordered_json>(report.own_mb);
    stats["frame_ms"] = percentiles(report.frame_ns, kNsPerMs);
    stats["frame_interval_ms"] = percentiles(report.frame_interval_ns, kNsPerMs);
    stats["lumps"] = report.lumps;
    stats["dropped_records"] = report.dropped_records;
    stats["safety"] = {
        {"late_periods", report.safety.late_periods}, {"gain", report.safety.gain},
        {"faults", report.safety.fault_count},        {"silences", report.safety.silences},
        {"energy_taken_mj", report.safety.taken_mj},  {"energy_given_mj", report.safety.given_mj},
        {"mean_force_n", report.safety.mean_force_n}, {"largest_force_n", report.safety.largest_force_n},
        {"most_force_n", report.most_force_n}};
    return stats;
}

}  // namespace onggi::app
