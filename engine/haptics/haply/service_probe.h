// Checks whether something listens on the Inverse service's port, for `onggi devices`. Main thread; blocks up
// to a given time. Sends nothing and closes the connection.
#pragma once

#include "engine/core/result.h"
#include "engine/haptics/haply/inverse_session.h"

namespace onggi::haptics::haply {

constexpr int kProbeMs = 200;

// Error: system lacks, with one line: nothing listens, or there was no answer in time.
[[nodiscard]] Result<void> find_service(const InverseOptions& options, int within_ms = kProbeMs);

}  // namespace onggi::haptics::haply
