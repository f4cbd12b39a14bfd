// One Inverse3's life on its I/O thread, without the socket: what comes is taken, what is to be said is
// given, and between the two stands the last gate before its motors. Tests call it with a time of their own.
// mm, N in the wheel's frame; everything belongs to the I/O thread but for the mailboxes of InverseLink.
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
    double rate_hz = 1000.0;            // messages a second: the service follows its client
    // The kiosk's profile, not the ten newtons such a device can give.
    double peak_n = kKioskPeakForceN;
    double continuous_n = kKioskContinuousForceN;
};

// The cursor in the wheel's axes, from wherever it stood when it was first heard.
struct SpaceInput {
    dvec3 place_mm{0.0};
    bool is_live = false;
    double force_fraction = 0.0;  // of the force ordered last, what the gate let through; 0 to 1
    std::uint64_t heartbeat = 0;  // counts messages: it must not stand still
};
struct SpaceOrder {
    dvec3 force_n{0.0};
    std::uint64_t ticks = 0;  // counts orders: it must not stand still
};

struct InverseLink {
    jobs::Mailbox<SpaceInput> input;       // I/O thread to haptic thread
    jobs::Mailbox<SpaceOrder> order;       // haptic thread to I/O thread
    jobs::Mailbox<hid::HidStatus> status;  // I/O thread to main thread
    // Watchdog to I/O thread: how often it asked for no force, because the haptic thread stands still.
    std::atomic<std::uint32_t> silences{0};
};

// The service's axes and the wheel's: x is x, the service's z is up, its y goes away from the person as the
// wheel's z comes towards them.
[[nodiscard]] inline dvec3 wheel_from_service(const dvec3& v) noexcept {
    return {v.x, v.z, -v.y};
}
[[nodiscard]] inline dvec3 service_from_wheel(const dvec3& v) noexcept {
    return {v.x, -v.z, v.y};
}

class InverseSession {
  public:
    InverseSession(InverseLink& link, const InverseOptions& options);

    // The socket stands: from now on messages come and go.
    void opened();
    // A whole message. Error: it is not one of an Inverse service; the caller closes the socket and tells
    // closed().
    Result<void> take(std::string_view message, std::int64_t now_ns);
    // What is to be said now; empty: nothing yet. What the watchdog asks for is said at once, whatever is due
    // and whether the last message was answered or not.
    [[nodiscard]] std::string next_message(std::int64_t now_ns);
    // Before the socket is closed by us: no force, whatever was said last.
    [[nodiscard]] std::string last_message() const;
    // The socket is gone. `why` is for a person; empty: nobody answered, as where there is no service at all.
    void closed(const std::string& why);
    // The service has not answered for so long that the socket cannot be good.
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
