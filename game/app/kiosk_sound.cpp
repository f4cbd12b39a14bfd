#include "game/app/kiosk_sound.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/sound/openal_player.h"
#include "game/app/options.h"

namespace onggi::app {
namespace {

// The left and right edge of what the ear takes for the wheel.
constexpr double kEdgeMm = 150.0;
// The torque that nearly stalls a small studio wheel: 3 N at 100 mm.
constexpr double kStallNMm = 300.0;

double length_of(const dvec3& v) {
    return std::sqrt(glm::dot(v, v));
}

bool is_hard(haptics::ToolKind kind) {
    return kind == haptics::ToolKind::kRib || kind == haptics::ToolKind::kTrimmer;
}

}  // namespace

sound::SoundScene scene_of(const haptic::Snapshot& snapshot, double volume) {
    const dvec3& at = snapshot.tool.position_mm;
    const double press_n =
        length_of(snapshot.result.forces.stiffness_n) + length_of(snapshot.result.second_forces.stiffness_n);
    // Where the surface is: the tool's centre is off it by the tool's radius, which changes little.
    const double slip_mm_s = snapshot.wheel_speed_rad_s * std::sqrt(at.x * at.x + at.z * at.z);
    // The paper's clay knows no water; it sounds as clay does that has been wetted once.
    constexpr double kUnknownWetness = 0.6;
    const bool knows_water = snapshot.shape != nullptr && snapshot.shape->is_hollow;
    return {.wheel_rev_min = units::rev_min_from_rad_s(snapshot.wheel_speed_rad_s),
            .motor_load = std::clamp(std::abs(snapshot.result.wheel_load_n_mm) / kStallNMm, 0.0, 1.0),
            .contact_n = press_n,
            .slip_mm_s = slip_mm_s,
            .wetness = knows_water ? std::max(snapshot.hand_film, snapshot.tool.water) : kUnknownWetness,
            .is_hard_tool = is_hard(snapshot.tool.tool),
            .place = std::clamp(at.x / kEdgeMm, -1.0, 1.0),
            .slaps = static_cast<std::uint32_t>(snapshot.run),
            .volume = volume};
}

void add_volume_option(CLI::App& command, std::optional<double>& volume) {
    add_number_option(command, "--volume", volume, 0.0, 1.0,
                      "how loud the wheel is heard, 0 to 1; 0 opens no sound device (0.5)");
}

KioskSound::KioskSound(double volume) : volume_(volume) {
    if (!(volume > 0.0)) return;
    output_.emplace(sound::make_openal_place());
    if (auto opened = output_->open(); !opened) {
        trouble_ = opened.error().message;
        output_.reset();
    }
}

void KioskSound::hear(const haptic::Snapshot& snapshot) {
    if (output_) output_->play(scene_of(snapshot, volume_));
}

std::string KioskSound::news() {
    if (!trouble_.empty()) return "sound: " + std::exchange(trouble_, {});
    if (!output_) return {};
    const sound::SoundStatus& now = output_->status();
    const bool is_told = now.is_heard || !now.message.empty();
    if (!is_told || now.is_heard == was_heard_) return {};
    was_heard_ = now.is_heard;
    return now.is_heard ? fmt::format("sound: heard through {}", now.device)
                        : fmt::format("sound: none; {}", now.message);
}

}  // namespace onggi::app
