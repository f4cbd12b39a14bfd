#include "game/haptic/fault_report.h"

#include <fmt/format.h>

#include <system_error>

namespace onggi::haptic {

Result<std::optional<std::filesystem::path>> FaultReport::look(const TickRecord& record,
                                                               const History& history) {
    const bool is_fault = (record.flags & TickRecord::kFault) != 0;
    const bool begins = is_fault && !is_fault_;
    is_fault_ = is_fault;
    std::optional<std::filesystem::path> none;
    if (!begins || !history.is_whole()) return none;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    for (int number = 1; number <= kMost; ++number) {
        const std::filesystem::path place = folder_ / fmt::format("fault-{}.onggi", number);
        if (std::filesystem::exists(place, error)) continue;
        if (auto saved = history.save(place); !saved) return saved.error();
        return std::optional(place);
    }
    return none;
}

}  // namespace onggi::haptic
