// What there is to hear of the haptic loop's newest snapshot, and the speaker that plays it. Main thread,
// once a frame.
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

// The snapshot as a scene: the wheel as it turns, how hard both hands press, how fast the clay passes under
// the first, how wet it is. A lump that is put on is a slap. Pure.
[[nodiscard]] sound::SoundScene scene_of(const haptic::Snapshot& snapshot, double volume);

// What is heard of it, as a key of words for those who do not hear: wet clay under the hand, the wheel, or
// nothing.
[[nodiscard]] std::string_view caption_key(const sound::SoundScene& scene);

class KioskSound {
  public:
    using MakePlace = std::function<std::unique_ptr<sound::SoundPlace>()>;

    // No sound device is opened until the volume is above 0. Never fails: without a device or a thread there
    // is no sound, and news() says so. A volume that is fixed stays as it is.
    explicit KioskSound(double volume, bool is_fixed = false,
                        MakePlace make_place = sound::make_openal_place);

    // Silent while it is muted, whatever the volume; the test of the loudspeakers too.
    void hear(const haptic::Snapshot& snapshot, bool is_muted = false, bool kiln_burns = false);
    // Speaks a line over the wheel, once; null: stops.
    void say(const std::shared_ptr<const sound::SpokenLine>& line);
    // From the next frame on; 0 to 1. Nothing where it is fixed.
    void set_volume(double volume);
    [[nodiscard]] bool is_audible() const { return volume_ > 0.0; }
    // Left loudspeaker, right, both: a tone each, from the next frame on.
    void test() { ++chimes_; }
    // By what it is heard; empty: by nothing, and lack() says why.
    [[nodiscard]] std::string device();
    [[nodiscard]] std::string lack();
    // What has changed since the last call; empty: nothing. A device that is lost, or found again.
    [[nodiscard]] std::string news();

  private:
    double volume_ = 0.0;
    bool is_fixed_ = false;
    std::uint32_t chimes_ = 0;
    MakePlace make_place_;
    std::optional<sound::SoundOutput> output_;
    std::shared_ptr<const sound::SpokenLine> said_;
    bool was_opened_ = false;  // or could not be; tried once
    std::string trouble_;      // that there is no thread
    bool trouble_is_told_ = false;
    bool was_heard_ = true;
};

}  // namespace onggi::app
