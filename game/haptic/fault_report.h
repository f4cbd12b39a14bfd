// What is kept of a fault: the whole lump's history up to it, as a session. `onggi replay` works the fault
// out again to the bit, so that a report is its own test. The thread that holds the history; writes a file.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "engine/core/result.h"
#include "game/haptic/history.h"
#include "game/haptic/messages.h"

namespace onggi::haptic {

class FaultReport {
  public:
    // At most so many in the folder: a loose cable must not fill a disk.
    static constexpr int kMost = 20;

    explicit FaultReport(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // After the history has got the record. Gives the file where a fault begins with it, a person's stop
    // among them; nothing otherwise. Errors: the folder or the file cannot be written.
    [[nodiscard]] Result<std::optional<std::filesystem::path>> look(const TickRecord& record,
                                                                    const History& history);

  private:
    std::filesystem::path folder_;
    bool is_fault_ = false;
};

}  // namespace onggi::haptic
