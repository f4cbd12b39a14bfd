// The descriptors of public devices: each is parsed, as by Linux, and becomes what it is for us.
#include "tests/support/public_devices.h"

#include <set>

#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/hid/report_descriptor.h"

namespace onggi::haptics::hid {
namespace {

std::string what_becomes_of(HidDeviceInfo device) {
    recognise(device);
    if (device.kind == HidKind::kUnknown && device.refusal == "no driver here knows it") return "none";
    if (!device.refusal.empty()) return "refused: " + device.refusal;
    return std::string(words_for(device.kind));
}

TEST(PublicDevices, BecomeWhatTheyAreOrAreRefusedWithAReason) {
    for (const testing::PublicDevice& device : testing::public_devices())
        EXPECT_EQ(what_becomes_of(device.info), device.becomes) << device.name;
}

// Linux 6.1 accepts every one of them (tests/support/public_devices.md).
TEST(PublicDevices, ParseAsInLinuxAndAreMoreThanAHundred) {
    std::set<std::vector<std::uint8_t>> different;
    for (const testing::PublicDevice& device : testing::public_devices()) {
        const auto descriptor = ReportDescriptor::parse(device.info.report_descriptor);
        EXPECT_TRUE(descriptor) << device.name << ": " << (descriptor ? "" : descriptor.error().message);
        if (descriptor) different.insert(device.info.report_descriptor);
    }
    EXPECT_GT(different.size(), 100U);
}

}  // namespace
}  // namespace onggi::haptics::hid
