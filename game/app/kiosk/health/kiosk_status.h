// What a kiosk leaves on the disk once a minute for whoever looks after it from afar: its heartbeat, as JSON
// in FOLDER/state/status.json. Pure but for the clock's numbers that are given; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::app {

// What the main thread knows of the program at a moment.
struct KioskPulse {
    std::string screen{};               // the name of its visit::Step
    bool is_closed = false;             // the opening hours are over, and nobody is there
    std::string fault{};                // latched by the safety chain, in words; empty: none
    std::uint64_t faults = 0;           // since the start
    double asked_hz = 0.0;              // of the haptic loop
    double achieved_hz = 0.0;           // 0: not known yet
    std::uint64_t skipped_periods = 0;  // since the start, as late_periods
    std::uint64_t late_periods = 0;
    double frame_ms = 0.0;  // between two frames, of the last seconds
    double worst_frame_ms = 0.0;
    std::uint64_t frames_shown = 0;  // since the start
    std::uint64_t haptic_ticks = 0;  // any number that is another one after a tick
    bool is_safe_mode = false;

    friend bool operator==(const KioskPulse&, const KioskPulse&) = default;
};

struct StatusNote {
    static constexpr int kFormat = 1;

    std::int64_t at_s = 0;      // of the machine's clock since 1970, when it was written
    bool has_ended = false;     // as was meant, or by an error that was said
    double running_s = 0.0;     // since the program's start
    bool picture_moves = true;  // frames were shown since the note before
    bool hand_turns = true;     // likewise the haptic loop
    std::string version{};
    KioskPulse pulse{};
    std::optional<double> celsius{};
    std::optional<double> resident_mb{};

    friend bool operator==(const StatusNote&, const StatusNote&) = default;
};

[[nodiscard]] std::string text_of(const StatusNote& note);
// Fields that are not known are passed over. Bad input: `file`, what was expected, what was found; also for
// a later format.
[[nodiscard]] Result<StatusNote> read_status_note(std::string_view text, const std::string& file);

}  // namespace onggi::app
