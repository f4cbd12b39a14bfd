#include "engine/haptics/haply/inverse_device.h"

#include <fmt/format.h>
#include <libwebsockets.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/haptics/haply/inverse_messages.h"

namespace onggi::haptics {

namespace haply {
namespace {

using hid::kMs;

constexpr std::int64_t kTryAgainNs = 2000 * kMs;
constexpr int kLongestWaitUs = 1000;  // a round of the loop: the largest delay of a message

}  // namespace

// libwebsockets calls the callback from within its loop, on the same thread.
struct InverseClient::Impl {
    Impl(InverseLink& link, const InverseOptions& with) : session(link, with), options(with) {}

    InverseSession session;
    InverseOptions options;
    lws_context* context = nullptr;
    lws* socket = nullptr;
    lws_sorted_usec_list_t timer{};
    bool is_open = false;
    std::string taken;  // the received parts of a fragmented message
    std::string to_say;
    std::vector<unsigned char> frame;  // with the space that the library needs in front
    std::string trouble;
    std::int64_t now_ns = 0;
    std::optional<std::int64_t> next_try_ns;

    static int called(lws* socket, lws_callback_reasons reason, void* user, void* in, std::size_t size);
    static void woken(lws_sorted_usec_list_t* timer);
    int heard(lws* from, const char* part, std::size_t size);
    int may_write();
    void connect();
    void disconnected(const std::string& why);
    void run_loop_once();
};

namespace {

const std::array<lws_protocols, 2>& protocols_with(lws_callback_function* callback) {
    static const std::array<lws_protocols, 2> protocols{
        lws_protocols{"onggi", callback, 0, 4096, 0, nullptr, 0}, lws_protocols{}};
    return protocols;
}

}  // namespace

int InverseClient::Impl::called(lws* socket, lws_callback_reasons reason, void* /*user*/, void* in,
                                std::size_t size) {
    auto* self = static_cast<Impl*>(lws_context_user(lws_get_context(socket)));
    switch (reason) {
        case LWS_CALLBACK_CLIENT_ESTABLISHED:
            self->is_open = true;
            self->taken.clear();
            self->session.opened();
            return 0;
        case LWS_CALLBACK_CLIENT_RECEIVE:
            return self->heard(socket, static_cast<const char*>(in), size);
        case LWS_CALLBACK_CLIENT_WRITEABLE:
            return self->may_write();
        case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
            // Nothing listens, as on any machine without the service: not worth a log line.
            self->disconnected({});
            return 0;
        case LWS_CALLBACK_CLIENT_CLOSED:
            self->disconnected(self->trouble);
            return 0;
        default:
            return 0;
    }
}

int InverseClient::Impl::heard(lws* from, const char* part, std::size_t size) {
    if (taken.size() + size > kMaxMessageBytes) {
        trouble = fmt::format("expected messages of at most {} bytes, found a longer one", kMaxMessageBytes);
        return -1;
    }
    taken.append(part, size);
    if (lws_is_final_fragment(from) == 0 || lws_remaining_packet_payload(from) != 0) return 0;
    const auto done = session.take(taken, now_ns);
    taken.clear();
    if (done) return 0;
    trouble = "not a message of the Inverse service: " + done.error().message;
    return -1;
}

int InverseClient::Impl::may_write() {
    if (to_say.empty()) return 0;
    frame.assign(LWS_PRE, 0);
    frame.insert(frame.end(), to_say.begin(), to_say.end());
    const std::size_t size = to_say.size();
    to_say.clear();
    return lws_write(socket, frame.data() + LWS_PRE, size, LWS_WRITE_TEXT) < static_cast<int>(size) ? -1 : 0;
}

void InverseClient::Impl::connect() {
    next_try_ns = now_ns + kTryAgainNs;
    trouble.clear();
    lws_client_connect_info info{};
    info.context = context;
    info.address = options.host.c_str();
    info.host = info.address;
    info.origin = info.address;
    info.port = options.port;
    info.path = "/";
    info.pwsi = &socket;
    if (lws_client_connect_via_info(&info) == nullptr) socket = nullptr;
}

void InverseClient::Impl::disconnected(const std::string& why) {
    socket = nullptr;
    to_say.clear();
    if (std::exchange(is_open, false) || !why.empty()) session.closed(why);
    next_try_ns = now_ns + kTryAgainNs;
}

// The loop waits until its next timer, whatever the time-out that it is given
// (findings/libwebsockets-waits-longer-than-its-timeout.sh); this timer keeps a round short.
void InverseClient::Impl::woken(lws_sorted_usec_list_t* /*timer*/) {}

void InverseClient::Impl::run_loop_once() {
    lws_sul_schedule(context, 0, &timer, &Impl::woken, kLongestWaitUs);
    lws_service(context, 0);
}

InverseClient::InverseClient(InverseLink& link, const InverseOptions& options)
    : impl_(std::make_unique<Impl>(link, options)) {}

InverseClient::~InverseClient() {
    finish();
}

std::int64_t InverseClient::round(std::int64_t now_ns) noexcept {
    Impl& my = *impl_;
    my.now_ns = now_ns;
    if (my.context == nullptr) {
        lws_set_log_level(0, nullptr);  // errors go into the status
        lws_context_creation_info info{};
        info.port = CONTEXT_PORT_NO_LISTEN;
        info.protocols = protocols_with(&Impl::called).data();
        info.user = &my;
        info.options = LWS_SERVER_OPTION_DISABLE_IPV6;
        my.context = lws_create_context(&info);
        if (my.context == nullptr) return kTryAgainNs;
    }
    if (my.socket == nullptr) {
        if (my.next_try_ns && now_ns < *my.next_try_ns) return *my.next_try_ns - now_ns;
        my.connect();
    }
    if (my.is_open) {
        if (my.to_say.empty()) my.to_say = my.session.next_message(now_ns);
        if (!my.to_say.empty()) lws_callback_on_writable(my.socket);
        if (my.session.is_silent(now_ns)) {
            my.trouble = "the service has stopped answering";
            lws_set_timeout(my.socket, PENDING_TIMEOUT_CLOSE_SEND, LWS_TO_KILL_ASYNC);
        }
    }
    my.run_loop_once();
    return 0;
}

void InverseClient::finish() noexcept {
    Impl& my = *impl_;
    if (my.context == nullptr) return;
    if (my.is_open) {
        my.to_say = my.session.last_message();
        for (int round = 0; round < 20 && my.is_open && !my.to_say.empty(); ++round) {
            lws_callback_on_writable(my.socket);
            my.run_loop_once();
        }
    }
    lws_context_destroy(my.context);
    my.context = nullptr;
    my.socket = nullptr;
    if (std::exchange(my.is_open, false)) my.session.closed({});
    my.next_try_ns.reset();
}

}  // namespace haply

namespace {

constexpr dvec3 kStartMm{110.0, 60.0, 0.0};  // outside the lump
constexpr double kSilenceS = 0.05;
constexpr double kNoiseMm = 1.5;

// The parameters of its stability check (stability.h). Its maker's public description states that forces are
// in newtons and that it answers each message with one, so the client sets the rate. The rest is assumed and
// not measured: a message waits up to one period on either side of the service; the arm is as light as a
// small stylus and has little friction (both make it less stable); its encoders are no finer than such a
// stylus's.
constexpr double kServicePeriods = 2.0;
constexpr double kMovingKg = 0.045;
constexpr double kDampingNSPerMm = 0.0001;
constexpr double kFrictionN = 0.0;
constexpr double kEncoderStepMm = 0.055;

}  // namespace

InverseDevice::InverseDevice(const haply::InverseOptions& options)
    : options_(options),
      client_(link_, options),
      offset_mm_(kStartMm),
      sample_{.position_mm = kStartMm},
      sense_(kNoiseMm) {}

Result<void> InverseDevice::open() {
    if (thread_.running()) return {};
    return thread_.start(client_, "onggi-inverse");
}

DeviceCapabilities InverseDevice::capabilities() const {
    return {.name = "Haply Inverse3",
            .force_axes = 3,
            .peak_force_n = options_.peak_n,
            .continuous_force_n = options_.continuous_n,
            .position_resolution_mm = kEncoderStepMm,
            .report_rate_hz = options_.rate_hz,
            .wire_delay_s = kServicePeriods / options_.rate_hz,
            .moving_mass_kg = kMovingKg,
            .damping_n_s_per_mm = kDampingNSPerMm,
            .coulomb_friction_n = kFrictionN};
}

HandSample InverseDevice::read(std::uint64_t /*tick*/, double dt_s) noexcept {
    const haply::SpaceInput& input = link_.input.latest();
    is_new_ = input.heartbeat != last_heartbeat_;
    silence_s_ = is_new_ ? 0.0 : silence_s_ + dt_s;
    last_heartbeat_ = input.heartbeat;
    force_fraction_ = input.force_fraction;
    const bool was_here = is_here_;
    is_here_ = input.is_live && silence_s_ <= kSilenceS;
    is_moving_ = is_here_ && sense_.moved_to(input.place_mm, dt_s);
    // After a reconnection the tool continues from where it was, wherever the hand is now.
    if (is_here_ && !was_here) offset_mm_ = sample_.position_mm - input.place_mm;
    if (is_here_) sample_.position_mm = input.place_mm + offset_mm_;
    return sample_;
}

void InverseDevice::write(const dvec3& force_n) noexcept {
    link_.order.put({.force_n = force_n, .ticks = ++ticks_});
}

void InverseDevice::take_over(const dvec3& position_mm) noexcept {
    offset_mm_ += position_mm - sample_.position_mm;
    sample_.position_mm = position_mm;
}

}  // namespace onggi::haptics
