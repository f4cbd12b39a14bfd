// What there is to hear of the haptic loop's newest snapshot, and the speaker that plays it. Main thread,
// once a frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/sound/sound_output.h"
#include "game/app/cli_names.h"
#include "game/haptic/messages.h"

namespace onggi::app {

// The snapshot as a scene: the wheel as it turns, how hard both hands press, how fast the clay passes under
// the first, how wet it is. A lump that is put on is a slap. Pure.
[[nodiscard]] sound::SoundScene scene_of(const haptic::Snapshot& snapshot, double volume);

// --volume, 0 to 1; 0: no sound device is opened at all.
void add_volume_option(CLI::App& command, std::optional<double>& volume);
constexpr double kUsualVolume = 0.5;

class KioskSound {
  public:
    // Silent at 0. Never fails: without a device or a thread there is no sound, and news() says so.
    explicit KioskSound(double volume);

    void hear(const haptic::Snapshot& snapshot);
    // From the next frame on; 0 to 1.
    void set_volume(double volume) { volume_ = volume; }
    // What has changed since the last call; empty: nothing. A device that is lost, or found again.
    [[nodiscard]] std::string news();

  private:
    double volume_;
    std::optional<sound::SoundOutput> output_;
    std::string trouble_;  // that there is no thread
    bool was_heard_ = true;
};

}  // namespace onggi::app
