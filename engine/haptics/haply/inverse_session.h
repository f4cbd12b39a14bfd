// The session of one Inverse3 on its I/O thread, without the socket: it takes incoming messages, returns
// outgoing ones, and has the last gate before the motors. Tests call it with a virtual time. mm, N in the
// wheel's frame; everything belongs to the I/O thread except the other ends of InverseLink's mailboxes.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/haptics/haply/inverse_messages.h"
#include "engine/haptics/hid/force_gate.h"
#include "engine/haptics/hid/hid_session.h"
#include "engine/jobs/mailbox.h"

namespace onggi::haptics::haply {

struct InverseOptions {
    std::string host = "127.0.0.1";
    int port = 10001;
    std::string force_name = "vector";  // "values" for a service older than 3.5
    double rate_hz = 1000.0;            // messages per second: the client sets the rate
    // The kiosk's limits, not the ten newtons that the device can apply.
    double peak_n = kKioskPeakForceN;
    double continuous_n = kKioskContinuousForceN;
};

// The cursor in the wheel's axes, relative to its first reported position.
struct SpaceInput {
    dvec3 place_mm{0.0};
    bool is_live = false;
    double force_fraction = 0.0;  // fraction of the last ordered force that the gate passed, 0 to 1
    std::uint64_t heartbeat = 0;  // counts messages; if it stops, the service is silent
};
struct SpaceOrder {
    dvec3 force_n{0.0};
    std::uint64_t ticks = 0;  // counts orders; if it stops, the haptic thread hangs
};

struct InverseLink {
    jobs::Mailbox<SpaceInput> input;       // I/O thread to haptic thread
    jobs::Mailbox<SpaceOrder> order;       // haptic thread to I/O thread
    jobs::Mailbox<hid::HidStatus> status;  // I/O thread to main thread
    // Watchdog to I/O thread: the number of requests for zero force because the haptic thread hangs.
    std::atomic<std::uint32_t> silences{0};
};

// Converts the service's axes to the wheel's: x is the same, the service's z is up, and its y points away
// from the person, opposite to the wheel's z.
[[nodiscard]] inline dvec3 wheel_from_service(const dvec3& v) noexcept {
    return {v.x, v.z, -v.y};
}
[[nodiscard]] inline dvec3 service_from_wheel(const dvec3& v) noexcept {
    return {v.x, -v.z, v.y};
}

class InverseSession {
  public:
    InverseSession(InverseLink& link, const InverseOptions& options);

    // The socket is connected.
    void opened();
    // Takes a complete message. Error: it is not from an Inverse service; the caller closes the socket and
    // calls closed().
    Result<void> take(std::string_view message, std::int64_t now_ns);
    // Returns the message to send now; empty if no message is due. A zero force for the watchdog is sent at
    // once, even if the last message was not answered.
    [[nodiscard]] std::string next_message(std::int64_t now_ns);
    // The message to send before closing the socket: zero force.
    [[nodiscard]] std::string last_message() const;
    // The socket was closed. `why` is for users; empty if there is no service.
    void closed(const std::string& why);
    // The service has not answered within the timeout: reconnect.
    [[nodiscard]] bool is_silent(std::int64_t now_ns) const;

  private:
    void publish(hid::HidStatus status);

    InverseLink& link_;
    InverseOptions options_;
    hid::ForceGate gate_;
    hid::HidStatus status_;
    std::string device_id_;
    dvec3 first_m_{0.0};
    std::uint64_t heartbeat_ = 0;
    std::uint32_t silences_ = 0;
    bool is_open_ = false;
    bool has_spoken_ = false;  // in this connection
    bool is_answered_ = true;
    std::int64_t sent_ns_ = 0;
    std::int64_t heard_ns_ = 0;
    bool was_heard_ = false;
};

}  // namespace onggi::haptics::haply
