// Pens of the X server: pressure and tilt, which the server's pointer lacks. The pointer itself still moves
// and presses by GLFW. Main thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/window/events.h"
#include "engine/window/input_server.h"

namespace onggi::window {

enum class PenAxis { kPressure, kTiltX, kTiltY };
constexpr std::size_t kPenAxes = 3;

// A device that has a valuator of pressure, as the server describes it.
struct PenDevice {
    struct Axis {
        int number = -1;  // of the valuator; -1: it has none
        double least = 0.0;
        double most = 0.0;
    };
    std::uint16_t id = 0;
    std::array<Axis, kPenAxes> axes{};
};

// A report of a pointer's device: valuator numbers with their values.
struct PointerReport {
    std::uint16_t device = 0;
    std::vector<std::pair<int, double>> values;
};

// Both read bytes in the order of this machine, as a server sends them to it (XInput 2.2). What is cut short
// yields what is whole.
// infos: the devices of a reply to XIQueryDevice. labels: the atoms of the axes.
[[nodiscard]] std::vector<PenDevice> read_pens(std::span<const std::byte> infos, int count,
                                               const std::array<std::uint32_t, kPenAxes>& labels);
// values: mask and values of a raw event. mask_words: of 32 bits.
[[nodiscard]] PointerReport read_report(std::uint16_t device, std::span<const std::byte> values,
                                        int mask_words);

// Which pen leads the pointer, and how it is held. Eraser and tip are two devices of a pen, and push alike.
class PenState {
  public:
    // The devices now. What is known of those that stay is kept.
    void know(const std::vector<PenDevice>& devices);
    // The device that reports leads. An axis that is not reported keeps its value
    // (findings/x-tells-no-pressure-when-a-pen-is-pressed.sh).
    void take(const PointerReport& report);
    void touched() { leader_.reset(); }
    // Whether the pointer's last report came from a device with pressure, be it a pen or not.
    [[nodiscard]] bool leads() const { return leader_.has_value(); }
    // Empty also for a device whose pressure has never changed while it pressed: some touch panels and mice
    // name one.
    [[nodiscard]] std::optional<Pen> pen() const;

  private:
    struct Held {
        PenDevice device;
        std::array<double, kPenAxes> fraction{};  // pressure 0 to 1, tilts -1 to 1
        double lightest = 1.0;                    // pressures other than none
        double firmest = 0.0;
    };
    std::vector<Held> held_;
    std::optional<std::size_t> leader_;
};

// The pens of the server in DISPLAY, also those that are plugged in later.
class Pens {
  public:
    // Null without XInput 2.2.
    static std::unique_ptr<Pens> open();

    // Takes the reports since the last call.
    void poll();
    [[nodiscard]] PenState& state() { return state_; }
    [[nodiscard]] const PenState& state() const { return state_; }

  private:
    explicit Pens(std::unique_ptr<InputServer> server) : server_(std::move(server)) {}
    void find();

    std::unique_ptr<InputServer> server_;
    std::array<std::uint32_t, kPenAxes> labels_{};
    PenState state_;
};

}  // namespace onggi::window
