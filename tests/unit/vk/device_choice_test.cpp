#include <gtest/gtest.h>

#include "engine/vk/physical_device.h"

namespace onggi::vk {
namespace {

std::vector<DeviceDescription> machine() {
    std::vector<DeviceDescription> devices(4);
    devices[0] = {.index = 0, .name = "llvmpipe (LLVM 15.0.6)", .type = VK_PHYSICAL_DEVICE_TYPE_CPU};
    devices[1] = {.index = 1, .name = "Intel UHD 770", .type = VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU};
    devices[2] = {.index = 2, .name = "NVIDIA RTX", .type = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU};
    devices[3] = {
        .index = 3, .name = "AMD old", .type = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, .lacks = "Vulkan 1.3"};
    return devices;
}

TEST(DeviceChoice, TakesTheBestByType) {
    EXPECT_EQ(*choose(machine(), ""), 2U);
    auto devices = machine();
    devices.erase(devices.begin() + 2);
    EXPECT_EQ(*choose(devices, ""), 1U);
}

TEST(DeviceChoice, TakesTheFirstOfEquals) {
    auto devices = machine();
    devices[3].lacks.clear();
    EXPECT_EQ(*choose(devices, ""), 2U);
}

TEST(DeviceChoice, ObeysAnIndexOrAPartOfANameInAnyCase) {
    EXPECT_EQ(*choose(machine(), "0"), 0U);
    EXPECT_EQ(*choose(machine(), "LLVMPIPE"), 0U);
    EXPECT_EQ(*choose(machine(), "intel"), 1U);
}

TEST(DeviceChoice, RefusesAnUnknownRequestAndListsTheDevices) {
    for (const char* request : {"7", "matrox", "amd"}) {
        const auto chosen = choose(machine(), request);
        ASSERT_FALSE(chosen) << request;
        EXPECT_EQ(chosen.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(chosen.error().message.find(request), std::string::npos);
        EXPECT_NE(chosen.error().message.find("AMD old (lacks Vulkan 1.3)"), std::string::npos);
        EXPECT_EQ(chosen.error().message.find('\n'), std::string::npos);
    }
}

TEST(DeviceChoice, StatesTheRemedyIfThereIsNoDevice) {
    const auto none = choose({}, "");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(none.error().message.find("install"), std::string::npos);
    const auto old = choose({machine()[3]}, "");
    ASSERT_FALSE(old);
    EXPECT_EQ(old.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(old.error().message.find("Vulkan 1.3"), std::string::npos);
}

TEST(DeviceChoice, TakesTheProcessorFirstWhereItIsAskedTo) {
    EXPECT_EQ(*choose(machine(), "", {.cpu_first = true}), 0U);
    EXPECT_EQ(*choose(machine(), "intel", {.cpu_first = true}), 1U) << "a named device is chosen";
    auto devices = machine();
    devices.erase(devices.begin());
    EXPECT_EQ(*choose(devices, "", {.cpu_first = true}), 1U) << "there is none: the best of the others";
}

TEST(DeviceChoice, AvoidsAFailedDeviceForAnyRequestWhileThereIsAnother) {
    EXPECT_EQ(*choose(machine(), "", {.avoided = {2}}), 1U);
    EXPECT_EQ(*choose(machine(), "nvidia", {.avoided = {2}}), 1U);
    EXPECT_EQ(*choose(machine(), "2", {.avoided = {2, 1}}), 0U);
    EXPECT_EQ(*choose(machine(), "", {.avoided = {0, 1, 2}}), 2U) << "all have failed: the best again";
    EXPECT_EQ(*choose(machine(), "intel", {.avoids_gpus = true}), 0U);
    auto devices = machine();
    devices.erase(devices.begin());
    EXPECT_EQ(*choose(devices, "", {.avoids_gpus = true}), 1U) << "there is nothing but GPUs";
    EXPECT_FALSE(choose(machine(), "matrox", {.avoids_gpus = true})) << "a request for none stays an error";
}

TEST(DeviceDescriptions, ListTheMachinesDevicesAndTheChosenOne) {
    const auto devices = describe_devices("");
    ASSERT_TRUE(devices) << devices.error().message;
    ASSERT_FALSE(devices->empty());
    int chosen = 0;
    for (const DeviceDescription& device : *devices) {
        EXPECT_FALSE(device.name.empty());
        EXPECT_GT(device.api_version, 0U);
        chosen += device.chosen ? 1 : 0;
    }
    EXPECT_EQ(chosen, 1);
}

TEST(VersionName, MatchesTheSpecification) {
    EXPECT_EQ(version_name(VK_MAKE_API_VERSION(0, 1, 3, 230)), "1.3.230");
}

}  // namespace
}  // namespace onggi::vk
