// What the wheel shows by itself while nobody is there: recorded sessions, one after another, each on the
// clay that it was thrown on and by its own hand, tick by tick. A hand on a spring, as a mouse is, would be
// pushed back by the clay and make another pot. mm, s, Hz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/control_sense.h"
#include "engine/haptics/haptic_device.h"
#include "game/haptic/simulated_device.h"
#include "game/haptic/tick.h"
#include "game/record/session.h"
#include "game/tool/gesture.h"

namespace onggi::app {

struct Recording {
    std::string name;  // of its file
    record::Session session;

    [[nodiscard]] double seconds() const {
        return static_cast<double>(session.tick_count()) / session.header().rate_hz;
    }
};

struct Show {
    std::vector<Recording> recordings;
    std::optional<tool::Gesture> gesture;  // where there are no recordings; without it the wheel waits
};

// What the recordings are to be played on.
struct ShowClay {
    const haptic::HapticState& lump;
    bool forgiving = true;
};

// The recordings that `folder`/shown.txt names, a line each, in that order; those that cannot be played on
// clay like the lump are left out, with a remark each. So are, without one, those with the word `unforgiving`
// behind their name where the clay is forgiving: they are of what it does not do. Where none is left, the
// gesture in the file. Main thread, blocks.
[[nodiscard]] Show load_show(const std::filesystem::path& folder, const std::filesystem::path& gesture,
                             const ShowClay& clay, std::vector<std::string>& remarks);
// The program's own.
[[nodiscard]] Show load_show(const ShowClay& clay, std::vector<std::string>& remarks);

// Ticks of a recorded clay are counted from here on, so that the number of a tick says what is shown and how
// far it has come, and no history of a visitor's clay takes it for its own.
constexpr std::uint64_t kShownTicks = std::uint64_t{1} << 31U;
constexpr std::uint64_t kTicksEach = std::uint64_t{1} << 25U;  // an hour and a half at 6 kHz
constexpr std::size_t kMostRecordings = 32;

// What the recording at that place begins with, to be put on the wheel.
[[nodiscard]] std::unique_ptr<haptic::HapticState> first_state_of(const Recording& recording,
                                                                  std::size_t place);
// How long the recording at that place has played at that tick, s; none: it is not on the wheel.
[[nodiscard]] std::optional<double> played_s(std::uint64_t tick, std::size_t place, double rate_hz);

// The kiosk's first hand: the visitor's, by mouse or touch, and on a recorded clay the recorded one.
class DemonstrationDevice final : public haptic::ToolDevice {
  public:
    // The recordings outlive it. rate_hz: of the loop.
    DemonstrationDevice(std::unique_ptr<haptic::SimulatedDevice> person,
                        const std::vector<Recording>& recordings, double rate_hz);

    Result<void> open() override { return person_->open(); }
    void close() noexcept override { person_->close(); }
    [[nodiscard]] haptics::DeviceCapabilities capabilities() const override {
        return person_->capabilities();
    }
    [[nodiscard]] tool::ToolState read_tool(std::uint64_t tick, double dt_s) noexcept override;
    void write(const dvec3& force_n) noexcept override { person_->write(force_n); }

    [[nodiscard]] bool is_moving() const noexcept override { return is_moving_; }
    void take_over(const dvec3& position_mm) noexcept override { person_->take_over(position_mm); }

  private:
    struct Player {
        record::SessionCursor now;
        record::SessionCursor next;
        double ticks_a_tick = 1.0;  // of the recording, in one of the loop
    };
    [[nodiscard]] static tool::ToolState at(Player& player, std::uint64_t tick) noexcept;

    std::unique_ptr<haptic::SimulatedDevice> person_;
    std::vector<Player> players_;  // haptic thread only
    haptics::ControlSense sense_{1.0};
    bool plays_ = false;
    bool is_moving_ = false;
};

}  // namespace onggi::app
