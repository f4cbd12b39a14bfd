// The real sound device: OpenAL Soft's default one.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "engine/sound/sound_player.h"

namespace onggi::sound {

[[nodiscard]] std::unique_ptr<SoundPlace> make_openal_place();

// Checks for a sound card among the device files of `cards`, a sound server or a driver chosen by
// ALSOFT_DRIVERS, without opening a device. Returns empty, or the reason. Without this check the system's
// sound library prints many errors on a machine without loudspeakers.
[[nodiscard]] std::string why_no_sound(const std::filesystem::path& cards = "/dev/snd");

}  // namespace onggi::sound
