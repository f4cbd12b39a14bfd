// One device's life on its I/O thread: looked for, opened, heard, told, lost, looked for again. The loop
// without the thread: tests call round() with a time of their own. Everything here belongs to the I/O thread
// but for the mailboxes of HidLink, whose other end another thread has.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/haptics/hid/force_gate.h"
#include "engine/haptics/hid/hid_driver.h"
#include "engine/jobs/io_thread.h"
#include "engine/jobs/mailbox.h"

namespace onggi::haptics::hid {

// For screens and logs.
struct HidStatus {
    enum class State : std::uint8_t {
        kAbsent,   // not plugged in
        kReady,    // heard and told
        kRefused,  // plugged in, but not to be used: `message` says why
        kFailed,   // opened, but it did not do what it should: `message` says what
    };
    State state = State::kAbsent;
    std::string name = {};          // of the device, where there is one
    std::string path = {};          // its node
    std::string message = {};       // one line; empty when absent or ready
    bool is_heard = false;          // ready, and its input is not stale
    std::uint32_t buttons = 0;      // bit 0 the first; which those are is the driver's affair
    std::uint64_t times_found = 0;  // 1 after the first opening, one more after each plugging in again
};

struct HidLink {
    jobs::Mailbox<DeviceInput> input;  // I/O thread to haptic thread
    jobs::Mailbox<ForceOrder> force;   // haptic thread to I/O thread
    jobs::Mailbox<HidStatus> status;   // I/O thread to main thread
    // Watchdog to I/O thread: how often it asked for no force, because the haptic thread stands still.
    std::atomic<std::uint32_t> silences{0};
};

struct HidSessionOptions {
    HidKind kind = HidKind::kUnknown;
    std::string only = {};  // the one node to use; empty: any of the kind
    ForceGateLimits force;
};

// Between two looks at the bus, and at the node of an open device.
constexpr std::int64_t kSearchIntervalNs = 1000 * kMs;
constexpr std::int64_t kPresenceIntervalNs = 100 * kMs;
constexpr int kReadWaitMs = 4;
// Drained in one round: hidraw queues 63, and drops the new ones when it is full.
constexpr int kMostReportsARound = 256;

class HidSession final : public jobs::IoWork {
  public:
    HidSession(HidLink& link, std::unique_ptr<HidBus> bus, std::unique_ptr<HidDriver> driver,
               const HidSessionOptions& options);

    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;

  private:
    void search(std::int64_t now_ns);
    // Opens it and begins its session: ready, or why not.
    [[nodiscard]] HidStatus begin(const HidDeviceInfo& device);
    void exchange(std::int64_t now_ns);
    // False: the device is gone.
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
    HidStatus status_;
    std::uint64_t heartbeat_ = 0;
    std::uint64_t refreshed_ = 0;
    std::uint32_t silences_ = 0;
    std::optional<std::int64_t> next_search_ns_;  // none: at once
    std::int64_t next_presence_ns_ = 0;
};

}  // namespace onggi::haptics::hid
