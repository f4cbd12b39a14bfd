// The real sound device: OpenAL Soft's default one.
#pragma once

#include <memory>
#include <string>

#include "engine/sound/sound_player.h"

namespace onggi::sound {

[[nodiscard]] std::unique_ptr<SoundPlace> make_openal_place();

// Whether there can be a sound device at all - a card, a sound server, or a driver chosen by ALSOFT_DRIVERS -
// without opening one: empty, or why not. Without this look the system's sound library complains on the
// terminal, line after line, of what a machine without loudspeakers has not.
[[nodiscard]] std::string why_no_sound();

}  // namespace onggi::sound
