// The demonstrations of attract mode: plays recorded sessions one after another, each on its own start clay
// and with its recorded hand, tick by tick. (The clay would push back a simulated hand on a spring, which
// would make another pot.) mm, s, Hz.
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
    std::string name;  // file name
    record::Session session;

    [[nodiscard]] double seconds() const {
        return static_cast<double>(session.tick_count()) / session.header().rate_hz;
    }
};

struct Show {
    std::vector<Recording> recordings;
    std::optional<tool::Gesture> gesture;  // used without recordings; without it the wheel waits
};

// The kiosk's clay, with which the recordings must agree.
struct ShowClay {
    const haptic::HapticState& lump;
    bool forgiving = true;
};

// Loads the recordings listed in `folder`/shown.txt, one per line, in that order. Skips those that cannot be
// played on clay like the lump, with a remark each, and with forgiving clay those marked `unforgiving`,
// without a remark: they show what forgiving clay does not do. Loads the gesture file if none is left. Main
// thread, blocks.
[[nodiscard]] Show load_show(const std::filesystem::path& folder, const std::filesystem::path& gesture,
                             const ShowClay& clay, std::vector<std::string>& remarks);
// Loads the program's own demonstrations.
[[nodiscard]] Show load_show(const ShowClay& clay, std::vector<std::string>& remarks);

// Ticks of a demonstration count from here, so that a tick's number identifies the recording and its
// progress, and cannot be confused with a tick of a visitor's clay.
constexpr std::uint64_t kShownTicks = std::uint64_t{1} << 31U;
constexpr std::uint64_t kTicksEach = std::uint64_t{1} << 25U;  // an hour and a half at 6 kHz
constexpr std::size_t kMostRecordings = 32;

// The start state of that recording, to be put on the wheel.
[[nodiscard]] std::unique_ptr<haptic::HapticState> first_state_of(const Recording& recording,
                                                                  std::size_t place);
// The time for which that recording has played at that tick, s; nothing if it is not on the wheel.
[[nodiscard]] std::optional<double> played_s(std::uint64_t tick, std::size_t place, double rate_hz);

// The kiosk's first device: the visitor's mouse or touch, or during a demonstration the recorded hand.
class DemonstrationDevice final : public haptic::ToolDevice {
  public:
    // The recordings must outlive it. rate_hz is the loop's.
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
        double ticks_a_tick = 1.0;  // ticks of the recording per tick of the loop
    };
    [[nodiscard]] static tool::ToolState at(Player& player, std::uint64_t tick) noexcept;

    std::unique_ptr<haptic::SimulatedDevice> person_;
    std::vector<Player> players_;  // haptic thread only
    haptics::ControlSense sense_{1.0};
    bool plays_ = false;
    bool is_moving_ = false;
};

}  // namespace onggi::app
