#include "engine/haptics/hid/hidapi_bus.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>
#include <poll.h>

#include <unistd.h>
#include <cstdint>
#include <utility>

#include "engine/haptics/hid/hid_list.h"

namespace onggi::haptics::hid {
namespace {

// hidapi has global state, so one lock serves the whole program.
jobs::Turnstile& turnstile() {
    static jobs::Turnstile only;
    return only;
}

}  // namespace

HidapiTurn::HidapiTurn() : pass_(turnstile()) {}

Result<void> start_hidapi() {
    const HidapiTurn turn;
    if (hid_init() != 0)
        return system_lacks("hidapi: expected to start, found no access to the system's HID devices");
    return {};
}

// Device strings are UTF-16 in the descriptor and wchar_t in hidapi.
std::string utf8_from(const wchar_t* wide) {
    std::string text;
    for (; wide != nullptr && *wide != L'\0'; ++wide) {
        const auto point = static_cast<std::uint32_t>(*wide);
        const bool is_control = point < 0x20 || (point >= 0x7f && point < 0xa0);
        const bool is_surrogate = point >= 0xd800 && point < 0xe000;
        if (is_control || is_surrogate || point > 0x10ffff) continue;
        const auto continuation = [&](unsigned shift) {
            text.push_back(static_cast<char>(0x80U | ((point >> shift) & 0x3fU)));
        };
        if (point < 0x80) {
            text.push_back(static_cast<char>(point));
        } else if (point < 0x800) {
            text.push_back(static_cast<char>(0xc0U | (point >> 6U)));
            continuation(0);
        } else if (point < 0x10000) {
            text.push_back(static_cast<char>(0xe0U | (point >> 12U)));
            continuation(6);
            continuation(0);
        } else {
            text.push_back(static_cast<char>(0xf0U | (point >> 18U)));
            continuation(12);
            continuation(6);
            continuation(0);
        }
    }
    return text;
}

namespace {

struct CloseDevice {
    void operator()(hid_device* device) const noexcept {
        const HidapiTurn turn;
        hid_close(device);
    }
};
using Device = std::unique_ptr<hid_device, CloseDevice>;

class HidapiPort final : public HidPort {
  public:
    HidapiPort(Device device, std::string path) : device_(std::move(device)), path_(std::move(path)) {}

    Result<std::size_t> read(std::span<std::uint8_t> report, int timeout_ms) override {
        const int size = hid_read_timeout(device_.get(), report.data(), report.size(), timeout_ms);
        if (size < 0) return refusal("read");
        return static_cast<std::size_t>(size);
    }

    Result<void> write(std::span<const std::uint8_t> report) override {
        if (hid_write(device_.get(), report.data(), report.size()) < 0) return refusal("write");
        return {};
    }

    Result<void> set_feature(std::span<const std::uint8_t> report) override {
        if (hid_send_feature_report(device_.get(), report.data(), report.size()) < 0)
            return refusal("set a feature of");
        return {};
    }

    Result<std::size_t> get_feature(std::span<std::uint8_t> report) override {
        const int size = hid_get_feature_report(device_.get(), report.data(), report.size());
        if (size < 0) return refusal("get a feature of");
        return static_cast<std::size_t>(size);
    }

    bool is_there() override { return access(path_.c_str(), F_OK) == 0; }

    void pause_ms(int milliseconds) override { poll(nullptr, 0, milliseconds); }

  private:
    Error refusal(const char* what) const {
        return failed(fmt::format("{}: expected to {} the device, found: {}", path_, what,
                                  utf8_from(hid_error(device_.get()))));
    }

    Device device_;
    std::string path_;
};

class HidapiBus final : public HidBus {
  public:
    Result<std::vector<HidDeviceInfo>> list() override { return list_hid_devices(); }

    Result<std::unique_ptr<HidPort>> open(const HidDeviceInfo& info) override {
        if (auto started = start_hidapi(); !started) return started.error();
        Device device;
        {
            const HidapiTurn turn;
            device.reset(hid_open_path(info.path.c_str()));
            if (device == nullptr)
                return system_lacks(fmt::format("{}: expected to open the device, found: {}", info.path,
                                                utf8_from(hid_error(nullptr))));
        }
        return std::unique_ptr<HidPort>(std::make_unique<HidapiPort>(std::move(device), info.path));
    }
};

}  // namespace

std::unique_ptr<HidBus> make_hidapi_bus() {
    return std::make_unique<HidapiBus>();
}

}  // namespace onggi::haptics::hid
