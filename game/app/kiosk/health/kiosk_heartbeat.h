// Writes what the house's monitoring reads: the heartbeat beside the visit in progress, and metrics where the
// settings name a folder for them. The keeper's thread; blocks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "game/app/kiosk/health/kiosk_status.h"
#include "game/kiosk/config.h"

namespace onggi::app {

class KioskHeartbeat {
  public:
    static constexpr double kEveryS = 60.0;

    explicit KioskHeartbeat(kiosk::Config config) : config_(std::move(config)) {}

    // Both files anew, each whole or as it was. An error is told once, until there is another or none.
    Result<void> beat(const KioskPulse& pulse, std::int64_t now_s);
    // The program ends; nothing where it had not begun.
    Result<void> end(std::int64_t now_s);
    // For a supervisor, after the death of its child, which could not say so itself; nothing where it had
    // said so or had not begun.
    Result<void> end_after_fall(std::int64_t now_s);

  private:
    Result<void> write(std::int64_t now_s);
    Result<void> write_metrics(std::int64_t now_s);

    kiosk::Config config_;
    std::optional<StatusNote> note_;
    std::string told_;  // what went wrong last
};

}  // namespace onggi::app
