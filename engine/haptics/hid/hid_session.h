// The session of one device on its I/O thread: search, open, read reports, send forces, lose it, search
// again. The loop without the thread: tests call round() with a virtual time. Everything here belongs to the
// I/O thread, except the other ends of HidLink's mailboxes.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/hid/force_gate.h"
#include "engine/haptics/hid/hid_driver.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"

namespace onggi::haptics::hid {

// For screens and logs.
struct HidStatus {
    enum class State : std::uint8_t {
        kAbsent,   // not plugged in
        kReady,    // in use
        kRefused,  // plugged in but not usable: see `message`
        kFailed,   // opened but failed: see `message`
    };
    State state = State::kAbsent;
    std::string name = {};          // of the device, if there is one
    std::string path = {};          // its node
    std::string message = {};       // one line; empty when absent or ready
    bool is_heard = false;          // ready, and its input is not stale
    std::uint32_t buttons = 0;      // bit 0 is the first; their meaning depends on the driver
    std::uint64_t times_found = 0;  // the number of openings so far
};

struct HidLink {
    jobs::Mailbox<DeviceInput> input;  // I/O thread to haptic thread
    jobs::Mailbox<ForceOrder> force;   // haptic thread to I/O thread
    jobs::Mailbox<HidStatus> status;   // I/O thread to main thread
    // Watchdog to I/O thread: the number of requests for zero force because the haptic thread hangs.
    std::atomic<std::uint32_t> silences{0};
};

struct HidSessionOptions {
    HidKind kind = HidKind::kUnknown;
    std::string only = {};  // use only this node; empty: any of the kind
    ForceGateLimits force;
};

// Poll intervals of the bus, and of an open device's node.
constexpr std::int64_t kSearchIntervalNs = 1000 * kMs;
constexpr std::int64_t kPresenceIntervalNs = 100 * kMs;
constexpr int kReadWaitMs = 4;
// The most reports read in one round: hidraw queues 63 and drops new ones when it is full.
constexpr int kMostReportsARound = 256;

class HidSession final : public jobs::IoWork {
  public:
    HidSession(HidLink& link, std::unique_ptr<HidBus> bus, std::unique_ptr<HidDriver> driver,
               const HidSessionOptions& options);

    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;

  private:
    void search(std::int64_t now_ns);
    // Opens the device and starts its driver. Returns ready, or the reason of the failure.
    [[nodiscard]] HidStatus begin(const HidDeviceInfo& device);
    void exchange(std::int64_t now_ns);
    // The first report of each id and size from a node.
    using FirstReports = std::vector<Report>;
    // Another node of the kind, read until a hand moves the one in use: a receiver has several, a stick may
    // lean, and only the one that a hand moves is wanted.
    struct Rival {
        HidDeviceInfo info;
        std::unique_ptr<HidPort> port;
        FirstReports firsts;
    };
    // Whether this report shows that a hand moves the node.
    [[nodiscard]] bool has_moved(FirstReports& firsts, std::span<const std::uint8_t> report) const;
    // Switches to the first rival that a hand moves, or that reports while the node in use never has.
    void hear_rivals(std::int64_t now_ns);
    // Returns false if the rival is still.
    [[nodiscard]] bool hear(Rival& rival, std::int64_t now_ns);
    // Returns false if the device is gone.
    [[nodiscard]] bool hear(std::int64_t now_ns);
    void lose(std::int64_t now_ns);
    void publish(const DeviceInput& input);
    void publish(HidStatus status);

    HidLink& link_;
    std::unique_ptr<HidBus> bus_;
    std::unique_ptr<HidDriver> driver_;
    HidSessionOptions options_;
    ForceGate gate_;

    std::unique_ptr<HidPort> port_;
    HidDeviceInfo used_;   // the node of port_
    FirstReports firsts_;  // of that node
    std::vector<Rival> rivals_;
    HidStatus status_;
    std::uint64_t heartbeat_ = 0;
    std::uint64_t refreshed_ = 0;
    std::uint32_t silences_ = 0;
    std::optional<std::int64_t> next_search_ns_;  // empty: search at once
    std::int64_t next_presence_ns_ = 0;
};

}  // namespace onggi::haptics::hid
