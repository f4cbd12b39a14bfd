// Converts the haptic loop's newest snapshot to a sound scene, and plays it. Main thread, once a frame.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/sound/openal_player.h"
#include "engine/sound/sound_output.h"
#include "game/haptic/messages.h"

namespace onggi::app {

// Returns the sound scene of a snapshot: the wheel's speed, the pressure of both hands, the clay's speed
// under the first, its wetness. A new lump causes a slap. Pure.
[[nodiscard]] sound::SoundScene scene_of(const haptic::Snapshot& snapshot, double volume);

// The key of a caption for deaf visitors: wet clay under the hand, the wheel, or empty.
[[nodiscard]] std::string_view caption_key(const sound::SoundScene& scene);

class KioskSound {
  public:
    using MakePlace = std::function<std::unique_ptr<sound::SoundPlace>()>;

    // Opens no sound device until the volume is above 0. Never fails: without a device or a thread there is
    // no sound, and news() reports it. A fixed volume cannot be changed.
    explicit KioskSound(double volume, bool is_fixed = false,
                        MakePlace make_place = sound::make_openal_place);

    // Silent while muted, including the loudspeaker test.
    void hear(const haptic::Snapshot& snapshot, bool is_muted = false, bool kiln_burns = false);
    // Speaks a line over the wheel's sound, once; null stops it.
    void say(const std::shared_ptr<const sound::SpokenLine>& line);
    // From the next frame on; 0 to 1. Has no effect on a fixed volume.
    void set_volume(double volume);
    [[nodiscard]] bool is_audible() const { return volume_ > 0.0; }
    // Plays a tone on the left loudspeaker, the right one and both, from the next frame on.
    void test() { ++chimes_; }
    // The sound device's name; if it is empty, lack() returns the reason.
    [[nodiscard]] std::string device();
    [[nodiscard]] std::string lack();
    // Changes since the last call: a device that was lost or found again; may be empty.
    [[nodiscard]] std::string news();

  private:
    double volume_ = 0.0;
    bool is_fixed_ = false;
    std::uint32_t chimes_ = 0;
    MakePlace make_place_;
    std::optional<sound::SoundOutput> output_;
    std::shared_ptr<const sound::SpokenLine> said_;
    bool was_opened_ = false;  // or failed to open; tried once
    std::string trouble_;      // the missing thread's error
    bool trouble_is_told_ = false;
    bool was_heard_ = true;
};

}  // namespace onggi::app
