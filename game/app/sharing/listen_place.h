// The address of this machine for phones to connect to. Main thread.
#pragma once

#include <string>

#include "engine/core/result.h"

namespace onggi::app {

// Returns "10.0.0.5" and "fd00::5" unchanged, and for an interface such as "wlan0" its current IPv4 address.
// Bad input: no such interface. System lacks: it has no address at the moment.
[[nodiscard]] Result<std::string> address_of(const std::string& address_or_interface);

// Returns a listening socket, which the caller closes. Port 0 means any free port; port_of() returns it.
// System lacks: the address is not this machine's, in use, or not permitted. Bad input: as address_of.
[[nodiscard]] Result<int> listen_at(const std::string& address_or_interface, int port);
[[nodiscard]] int port_of(int listening_socket);

// Whether a server accepts a connection there within `most_ms` milliseconds.
[[nodiscard]] bool answers_at(const std::string& address, int port, int most_ms);

}  // namespace onggi::app
