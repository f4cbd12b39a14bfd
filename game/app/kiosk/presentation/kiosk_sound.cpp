#include "game/app/kiosk/presentation/kiosk_sound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/units.h"
#include "game/tool/tool.h"

namespace onggi::app {
namespace {

// The distance of the stereo picture's left and right edge from the axis.
constexpr double kEdgeMm = 150.0;
// The torque that nearly stalls a small studio wheel: 3 N at 100 mm.
constexpr double kStallNMm = 300.0;

}  // namespace

sound::SoundScene scene_of(const haptic::Snapshot& snapshot, double volume) {
    const dvec3& at = snapshot.tool.position_mm;
    const double press_n = glm::length(snapshot.result.forces.stiffness_n) +
                           glm::length(snapshot.result.second_forces.stiffness_n);
    // Uses the tool's centre for the surface: its distance, the tool's radius, makes little difference.
    const double slip_mm_s = snapshot.wheel_speed_rad_s * std::sqrt(at.x * at.x + at.z * at.z);
    // The paper's clay has no wetness; it sounds like clay that was wetted once.
    constexpr double kUnknownWetness = 0.6;
    const bool knows_water = snapshot.pot != nullptr && snapshot.pot->can_be_hollow();
    return {.rev_min = units::rev_min_from_rad_s(snapshot.wheel_speed_rad_s),
            .motor_load = std::clamp(std::abs(snapshot.result.wheel_load_n_mm) / kStallNMm, 0.0, 1.0),
            .contact_n = press_n,
            .slip_mm_s = slip_mm_s,
            .wetness = knows_water ? std::max(snapshot.hand_film, snapshot.tool.water) : kUnknownWetness,
            .is_hard_tool = tool::is_hard(snapshot.tool.tool),
            .place = std::clamp(at.x / kEdgeMm, -1.0, 1.0),
            .slaps = static_cast<std::uint32_t>(snapshot.run),
            .is_plucked = snapshot.tool.wire != tool::Wire::kNone,
            .volume = volume};
}

std::string_view caption_key(const sound::SoundScene& scene) {
    constexpr double kHeardN = 0.1;
    constexpr double kWet = 0.4;
    constexpr double kTurnsRevMin = 5.0;
    const bool turns = std::abs(scene.rev_min) > kTurnsRevMin;
    if (turns && scene.contact_n > kHeardN && scene.wetness > kWet) return "cap.water";
    return turns ? "cap.wheel" : std::string_view();
}

KioskSound::KioskSound(double volume, bool is_fixed, MakePlace make_place)
    : make_place_(std::move(make_place)) {
    set_volume(volume);
    is_fixed_ = is_fixed;
}

void KioskSound::set_volume(double volume) {
    if (is_fixed_) return;
    volume_ = volume;
    if (!(volume > 0.0) || was_opened_) return;
    was_opened_ = true;
    output_.emplace(make_place_());
    if (auto opened = output_->open(); !opened) {
        trouble_ = opened.error().message;
        output_.reset();
    }
}

void KioskSound::hear(const haptic::Snapshot& snapshot, bool is_muted, bool kiln_burns) {
    if (!output_) return;
    sound::SoundScene scene = scene_of(snapshot, is_muted ? 0.0 : volume_);
    scene.chimes = chimes_;
    scene.fire_burns = kiln_burns;
    output_->play(scene);
}

std::string KioskSound::device() {
    return output_ && output_->status().is_heard ? output_->status().device : std::string();
}

std::string KioskSound::lack() {
    if (!trouble_.empty()) return trouble_;
    if (!output_) return is_fixed_ ? "switched off for this run by --volume 0" : "the volume is 0";
    const sound::SoundStatus& now = output_->status();
    if (now.is_heard) return {};
    return now.message.empty() ? "still searching for a sound device" : now.message;
}

void KioskSound::say(const std::shared_ptr<const sound::SpokenLine>& line) {
    if (line == said_) return;
    said_ = line;
    if (output_) output_->say(line);
}

std::string KioskSound::news() {
    if (!trouble_.empty() && !std::exchange(trouble_is_told_, true)) return "sound: " + trouble_;
    if (!output_) return {};
    const sound::SoundStatus& now = output_->status();
    const bool is_told = now.is_heard || !now.message.empty();
    if (!is_told || now.is_heard == was_heard_) return {};
    was_heard_ = now.is_heard;
    return now.is_heard ? fmt::format("sound: playing through {}", now.device)
                        : fmt::format("sound: none; {}", now.message);
}

}  // namespace onggi::app
