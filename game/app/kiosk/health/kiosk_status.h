// The kiosk's heartbeat, which it writes once a minute for remote monitoring, as JSON in
// FOLDER/state/status.json. Pure; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::app {

// The main thread's view of the program's state.
struct KioskPulse {
    std::string screen{};               // the name of its visit::Step
    bool is_closed = false;             // the opening hours are over, and there is no visitor
    std::string fault{};                // latched by the safety chain, in words; may be empty
    std::uint64_t faults = 0;           // since the start
    double asked_hz = 0.0;              // of the haptic loop
    double achieved_hz = 0.0;           // 0: not measured yet
    std::uint64_t skipped_periods = 0;  // since the start, like late_periods
    std::uint64_t late_periods = 0;
    double frame_ms = 0.0;  // between two frames, mean of the last seconds
    double worst_frame_ms = 0.0;
    std::uint64_t frames_shown = 0;  // since the start
    std::uint64_t haptic_ticks = 0;  // any number that changes with a tick
    bool is_safe_mode = false;

    friend bool operator==(const KioskPulse&, const KioskPulse&) = default;
};

struct StatusNote {
    static constexpr int kFormat = 1;

    std::int64_t at_s = 0;      // time of writing, by the machine's clock, since 1970
    bool has_ended = false;     // intentionally, or by a reported error
    double running_s = 0.0;     // since the program's start
    bool picture_moves = true;  // frames were shown since the last note
    bool hand_turns = true;     // the same for ticks of the haptic loop
    std::string version{};
    KioskPulse pulse{};
    std::optional<double> celsius{};
    std::optional<double> resident_mb{};

    friend bool operator==(const StatusNote&, const StatusNote&) = default;
};

[[nodiscard]] std::string text_of(const StatusNote& note);
// Ignores unknown fields. Bad input: `file`, what was expected, what was found; also for a later format.
[[nodiscard]] Result<StatusNote> read_status_note(std::string_view text, const std::string& file);

}  // namespace onggi::app
