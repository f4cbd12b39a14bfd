// An address of this machine for phones to come to. Main thread.
#pragma once

#include <string>

#include "engine/core/result.h"

namespace onggi::app {

// "10.0.0.5" and "fd00::5" are themselves; an interface such as "wlan0" is its IPv4 address now. Bad input:
// no such interface. System lacks: it has no address at the moment.
[[nodiscard]] Result<std::string> address_of(const std::string& address_or_interface);

// A socket that listens there, closed by who has it. Port 0: any; port_of() tells which. System lacks: it is
// not this machine's, it is taken, or may not be had. Bad input: as address_of.
[[nodiscard]] Result<int> listen_at(const std::string& address_or_interface, int port);
[[nodiscard]] int port_of(int listening_socket);

// Whether somebody answers there within so many milliseconds.
[[nodiscard]] bool answers_at(const std::string& address, int port, int most_ms);

}  // namespace onggi::app
