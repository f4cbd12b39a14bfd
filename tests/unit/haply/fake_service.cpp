#include "tests/unit/haply/fake_service.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <libwebsockets.h>

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace onggi::testing {

struct FakeService::Impl {
    lws_context* context = nullptr;
    std::thread thread;
    std::atomic<bool> ends{false};
    int port = 0;
    std::mutex mutex;  // guards everything below
    dvec3 cursor_m{0.0, -0.1, 0.1};
    std::string instead;
    bool is_silent = false;
    std::string heard;
    int times_heard = 0;

    std::string answer() {
        const std::lock_guard lock(mutex);
        if (!instead.empty()) return instead;
        return fmt::format(
            R"({{"session_id":1,"inverse3":[{{"device_id":"049D","state":{{"cursor_position":{{"x":{},"y":{},"z":{}}}}}}}]}})",
            cursor_m.x, cursor_m.y, cursor_m.z);
    }
};

namespace {

int called(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t size) {
    auto* impl = static_cast<FakeService::Impl*>(lws_context_user(lws_get_context(socket)));
    switch (reason) {
        case LWS_CALLBACK_ESTABLISHED:
            lws_callback_on_writable(socket);  // the inventory, unasked
            return 0;
        case LWS_CALLBACK_RECEIVE: {
            const std::lock_guard lock(impl->mutex);
            impl->heard.assign(static_cast<const char*>(in), size);
            ++impl->times_heard;
            if (!impl->is_silent) lws_callback_on_writable(socket);
            return 0;
        }
        case LWS_CALLBACK_SERVER_WRITEABLE: {
            const std::string text = impl->answer();
            std::vector<unsigned char> frame(LWS_PRE);
            frame.insert(frame.end(), text.begin(), text.end());
            return lws_write(socket, frame.data() + LWS_PRE, text.size(), LWS_WRITE_TEXT) < 0 ? -1 : 0;
        }
        default:
            return 0;
    }
}

const lws_protocols kProtocols[] = {{"onggi", &called, 0, 65536, 0, nullptr, 0}, {}};

}  // namespace

FakeService::FakeService(int port) : impl_(std::make_unique<Impl>()) {
    lws_set_log_level(0, nullptr);
    lws_context_creation_info info{};
    info.port = port;
    info.iface = "127.0.0.1";
    info.protocols = kProtocols;
    info.user = impl_.get();
    info.options = LWS_SERVER_OPTION_DISABLE_IPV6;
    impl_->context = lws_create_context(&info);
    if (impl_->context == nullptr) {
        ADD_FAILURE() << "no service on loopback";
        return;
    }
    impl_->port = lws_get_vhost_listen_port(lws_get_vhost_by_name(impl_->context, "default"));
    impl_->thread = std::thread([this] {
        while (!impl_->ends)
            lws_service(impl_->context, 0);
    });
}

FakeService::~FakeService() {
    if (impl_->context == nullptr) return;
    impl_->ends = true;
    lws_cancel_service(impl_->context);
    impl_->thread.join();
    lws_context_destroy(impl_->context);
}

int FakeService::port() const {
    return impl_->port;
}

void FakeService::put_cursor_m(const dvec3& cursor_m) {
    const std::lock_guard lock(impl_->mutex);
    impl_->cursor_m = cursor_m;
}

void FakeService::be_silent(bool silent) {
    const std::lock_guard lock(impl_->mutex);
    impl_->is_silent = silent;
}

void FakeService::say(const std::string& instead) {
    const std::lock_guard lock(impl_->mutex);
    impl_->instead = instead;
}

std::string FakeService::last_heard() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->heard;
}

int FakeService::times_heard() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->times_heard;
}

}  // namespace onggi::testing
