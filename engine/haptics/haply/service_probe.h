// Whether anything listens where the Inverse service should: for whoever asks what there is to hold. Main
// thread; blocks for as long as it is told at most. Says nothing to whoever listens, and hangs up.
#pragma once

#include "engine/core/result.h"
#include "engine/haptics/haply/inverse_session.h"

namespace onggi::haptics::haply {

constexpr int kProbeMs = 200;

// Error: system lacks, one line that says why: nothing listens, or nobody answers in that time.
[[nodiscard]] Result<void> find_service(const InverseOptions& options, int within_ms = kProbeMs);

}  // namespace onggi::haptics::haply
