// The real bus: hidapi on Linux's hidraw. I/O threads, or the main thread; hidapi bears one caller at a time
// for all that is not a report, and gets one: a lock inside.
#pragma once

#include <memory>

#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {

[[nodiscard]] std::unique_ptr<HidBus> make_hidapi_bus();

}  // namespace onggi::haptics::hid
