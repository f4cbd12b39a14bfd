#include "game/app/kiosk/health/kiosk_heartbeat.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "engine/files/atomic_file.h"
#include "game/app/kiosk/health/house_status.h"
#include "game/app/kiosk/health/kiosk_health.h"
#include "game/app/system/process_use.h"
#include "game/app/system/version.h"

namespace onggi::app {
namespace {

constexpr const char* kMetricsFile = "onggi.prom";

}  // namespace

Result<void> KioskHeartbeat::beat(const KioskPulse& pulse, std::int64_t now_s) {
    const KioskPulse before = note_ ? note_->pulse : KioskPulse{};
    note_ = StatusNote{.at_s = now_s,
                       .running_s = since_start_s().value_or(0.0),
                       .picture_moves = pulse.frames_shown != before.frames_shown,
                       .hand_turns = pulse.haptic_ticks != before.haptic_ticks,
                       .version = version(),
                       .pulse = pulse,
                       .celsius = hottest_celsius(),
                       .resident_mb = resident_mb()};
    return write(now_s);
}

Result<void> KioskHeartbeat::end(std::int64_t now_s) {
    if (!note_) return {};
    note_->at_s = now_s;
    note_->has_ended = true;
    return write(now_s);
}

Result<void> KioskHeartbeat::end_after_fall(std::int64_t now_s) {
    auto note = read_status_note_of(config_.gallery.folder);
    if (!note) return note.error();
    if (!*note || (*note)->has_ended) return {};
    note_ = std::move(**note);
    return end(now_s);
}

Result<void> KioskHeartbeat::write(std::int64_t now_s) {
    std::error_code ignored;  // write_file_atomically() says what is wrong
    const std::filesystem::path file = status_file(config_.gallery.folder);
    std::filesystem::create_directories(file.parent_path(), ignored);
    Result<void> written = files::write_file_atomically(file, text_of(*note_));
    if (const auto metrics = write_metrics(now_s); written) written = metrics;
    const std::string trouble = written ? std::string() : written.error().message;
    if (std::exchange(told_, trouble) == trouble) return {};
    return written;
}

Result<void> KioskHeartbeat::write_metrics(std::int64_t now_s) {
    if (config_.staff.metrics_folder.empty()) return {};
    const auto status = look_at_house(config_, now_s);
    if (!status) return status.error();
    const std::filesystem::path file = std::filesystem::path(config_.staff.metrics_folder) / kMetricsFile;
    if (auto written = files::write_file_atomically(file, metrics_of(*status)); !written) return written;
    // Its reader is another user, whatever the umask; what is there already keeps what it has.
    using std::filesystem::perms;
    std::error_code error;
    std::filesystem::permissions(
        file, perms::owner_read | perms::owner_write | perms::group_read | perms::others_read, error);
    if (error)
        return system_lacks(file.string() + ": expected to let others read it, found: " + error.message());
    return {};
}

}  // namespace onggi::app
