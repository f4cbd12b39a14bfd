// The real bus: hidapi on Linux's hidraw. I/O threads, or the main thread; hidapi bears one caller at a time
// for all that is not a report, and gets one: a lock inside.
#pragma once

#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/haptics/hid/hid_port.h"
#include "engine/jobs/io_thread.h"

namespace onggi::haptics::hid {

// hidapi as a whole: one call at a time for everything that is not a report of an open device (its own
// rule), and its strings. Only for this folder's users of hidapi.

// While it lives, nobody else lists, opens or closes.
class HidapiTurn {
  public:
    HidapiTurn();

  private:
    jobs::TurnstilePass pass_;
};

// Harmless when it has been started. Never ended: another thread may be about to use it, and it holds nothing
// that the end of the program does not give back. Takes its own turn.
Result<void> start_hidapi();

// hidapi's wide strings as UTF-8; null is empty. What is no character, or would spoil a terminal, is left
// out.
[[nodiscard]] std::string utf8_from(const wchar_t* wide);

[[nodiscard]] std::unique_ptr<HidBus> make_hidapi_bus();

}  // namespace onggi::haptics::hid
