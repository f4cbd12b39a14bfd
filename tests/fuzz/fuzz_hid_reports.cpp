// Any bytes as reports of any device: the tool's position is finite and within its reach, and output stays
// within a report. Byte 0 chooses the device; then each report is a length and its bytes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "engine/haptics/hid/dual_sense_driver.h"
#include "engine/haptics/hid/pid_driver.h"
#include "engine/haptics/hid/simple_drivers.h"
#include "engine/haptics/hid/tool_tracker.h"
#include "tests/fuzz/fuzz_expect.h"
#include "tests/support/pid_descriptors.h"

namespace {

using namespace onggi;                // NOLINT: one program
using namespace onggi::haptics::hid;  // NOLINT

// Accepts everything; answers feature requests with the given bytes.
class WillingPort final : public HidPort {
  public:
    explicit WillingPort(std::span<const std::uint8_t> answer) : answer_(answer) {}
    Result<std::size_t> read(std::span<std::uint8_t>, int) override { return std::size_t{0}; }
    Result<void> write(std::span<const std::uint8_t> report) override {
        fuzz::expect(!report.empty() && report.size() <= kMaxReportBytes);
        return {};
    }
    Result<void> set_feature(std::span<const std::uint8_t> report) override { return write(report); }
    Result<std::size_t> get_feature(std::span<std::uint8_t> report) override {
        // Usually a good answer, so that the session continues; sometimes the input's bytes.
        if (answer_.size() % 4 == 3) {
            const std::size_t size = std::min(report.size(), answer_.size());
            std::copy_n(answer_.begin(), size, report.begin());
            return size;
        }
        report[1] = 1;
        report[2] = 1;
        return report.size();
    }
    bool is_there() override { return true; }
    void pause_ms(int) override {}

  private:
    std::span<const std::uint8_t> answer_;
};

std::unique_ptr<HidDriver> driver_for(std::uint8_t choice, haptics::HidDeviceInfo& device) {
    switch (choice % 7) {
        case 6:
            device.bus = haptics::HidBusType::kBluetooth;
            return std::make_unique<DualSenseDriver>();
        case 0:
            return std::make_unique<SpaceMouseDriver>();
        case 1:
            return std::make_unique<DualSenseDriver>();
        case 2:
            return std::make_unique<VecPedalDriver>();
        case 3:
            device.report_descriptor = testing::open_ffboard_descriptor();
            break;
        case 4:
            device.report_descriptor = testing::rhino_descriptor();
            break;
        default:
            device.report_descriptor = testing::sparse_descriptor();
            break;
    }
    return std::make_unique<PidDriver>();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::span<const std::uint8_t> bytes(data, size);
    if (bytes.empty()) return 0;
    haptics::HidDeviceInfo device;
    const auto driver = driver_for(bytes[0], device);
    bytes = bytes.subspan(1);
    WillingPort port(bytes);
    if (!driver->start(device, port)) return 0;

    const ToolReach reach;
    ToolTracker prop(reach);
    std::uint64_t heartbeat = 0;
    std::int64_t now_ns = 0;
    while (!bytes.empty()) {
        const std::size_t length = std::min<std::size_t>(bytes[0] % (kMaxReportBytes + 1), bytes.size() - 1);
        driver->take_report(bytes.subspan(1, length), now_ns);
        if (device.bus == haptics::HidBusType::kBluetooth) {
            // A fuzzer cannot guess a checksum, so the same bytes are also used as a complete report.
            std::array<std::uint8_t, kMaxReportBytes> whole{0x31};
            std::copy_n(bytes.begin() + 1, std::min<std::size_t>(length, 73), whole.begin() + 1);
            const std::uint32_t checksum = radio_checksum(kInputSeed, std::span(whole).first(74));
            for (std::size_t byte = 0; byte < 4; ++byte)
                whole[74 + byte] = static_cast<std::uint8_t>(checksum >> (8 * byte));
            fuzz::expect(dual_sense_state(whole).has_value());
            driver->take_report(whole, now_ns);
        }
        bytes = bytes.subspan(1 + length);
        DeviceInput input = driver->input(now_ns);
        input.heartbeat = ++heartbeat;
        const haptics::HandSample tool = prop.moved(input, 0.01);
        fuzz::expect(tool.position_mm.x >= reach.least_radius_mm &&
                     tool.position_mm.x <= reach.most_radius_mm);
        fuzz::expect(tool.position_mm.y >= reach.least_height_mm &&
                     tool.position_mm.y <= reach.most_height_mm);
        const double push_n = static_cast<double>(length) / 10.0 - 3.0;
        fuzz::expect(static_cast<bool>(driver->send(port,
                                                    {.force_n = {push_n, -push_n},
                                                     .tangential_n = push_n,
                                                     .tool_mm = {tool.position_mm.x, tool.position_mm.y},
                                                     .turns = tool.button,
                                                     .ticks = heartbeat},
                                                    now_ns)));
        now_ns += 10 * kMs;
    }
    driver->stop(port);
    return 0;
}
