// The real bus: hidapi on Linux's hidraw. I/O threads, or the main thread; hidapi allows one caller at a time
// for everything but reports, so there is a lock inside.
#pragma once

#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/haptics/hid/hid_port.h"
#include "engine/jobs/io_thread.h"

namespace onggi::haptics::hid {

// Helpers for this folder's users of hidapi: the lock for everything but the reports of an open device, and
// string conversion.

// Holds the lock: no other thread lists, opens or closes devices meanwhile.
class HidapiTurn {
  public:
    HidapiTurn();

  private:
    jobs::TurnstilePass pass_;
};

// Starts hidapi; may be called again. hidapi is never shut down: another thread may still use it, and the end
// of the program frees its resources. Takes the lock itself.
Result<void> start_hidapi();

// Converts hidapi's wide strings to UTF-8; null becomes empty. Drops invalid and control characters, which
// could corrupt a terminal.
[[nodiscard]] std::string utf8_from(const wchar_t* wide);

[[nodiscard]] std::unique_ptr<HidBus> make_hidapi_bus();

}  // namespace onggi::haptics::hid
