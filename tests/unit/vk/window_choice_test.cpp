// The choice of the device for a window on a machine with two, and the queries to each. The drivers' answers
// are simulated, because software drivers present to every window and none crashes on one.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/vk/physical_device.h"
#include "tests/support/two_drivers.h"

namespace onggi::vk {
namespace {

// Which of the two counts as a GPU, and which of them present; set by each test.
VkPhysicalDevice gpu = VK_NULL_HANDLE;
std::vector<VkPhysicalDevice> presents;
std::vector<VkPhysicalDevice> asked;

template <typename Function>
Function driver(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace onggi::vk

// Replaces the loader's function in this program.
extern "C" VkResult vkGetPhysicalDeviceSurfaceSupportKHR(VkPhysicalDevice device, std::uint32_t /*family*/,
                                                         VkSurfaceKHR /*surface*/, VkBool32* supported) {
    using namespace onggi::vk;
    asked.push_back(device);
    *supported = std::find(presents.begin(), presents.end(), device) != presents.end() ? VK_TRUE : VK_FALSE;
    return VK_SUCCESS;
}
extern "C" void vkGetPhysicalDeviceProperties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* said) {
    using namespace onggi::vk;
    driver<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(device, said);
    if (device == gpu) said->properties.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
}

namespace onggi::vk {
namespace {

class ForAWindow : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
            setenv(name, drivers_.manifests().c_str(), 1);
        auto made = Instance::create({});
        ASSERT_TRUE(made) << made.error().message;
        instance_ = std::move(*made);
        std::uint32_t count = 2;
        ASSERT_EQ(vkEnumeratePhysicalDevices(instance_->handle(), &count, devices_.data()), VK_SUCCESS);
        ASSERT_EQ(count, 2U);
        gpu = devices_[1];
        presents = {devices_[0], devices_[1]};
        asked.clear();
    }
    void TearDown() override {
        gpu = VK_NULL_HANDLE;
        for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
            unsetenv(name);
    }
    [[nodiscard]] Result<ChosenDevice> choose_with(const DevicePreference& preference) const {
        // No driver sees it.
        static int some_window = 0;
        return choose_device(*instance_, reinterpret_cast<VkSurfaceKHR>(&some_window), "", preference);
    }
    test::TwoDrivers drivers_;
    std::unique_ptr<Instance> instance_;
    std::array<VkPhysicalDevice, 2> devices_{};
};

TEST_F(ForAWindow, TheBestDrawsAndNoOtherIsAskedAboutIt) {
    const auto chosen = choose_with({});
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen->handle, gpu);
    EXPECT_EQ(std::count(asked.begin(), asked.end(), devices_[0]), 0);
}

TEST_F(ForAWindow, AnAvoidedGpuIsNotQueried) {
    const auto chosen = choose_with({.avoids_gpus = true});
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen->handle, devices_[0]);
    EXPECT_EQ(std::count(asked.begin(), asked.end(), gpu), 0)
        << "its driver may be what the program fell over";
}

TEST_F(ForAWindow, ADeviceThatCannotPresentIsSkipped) {
    presents = {devices_[0]};
    const auto chosen = choose_with({});
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_EQ(chosen->handle, devices_[0]);
    EXPECT_EQ(asked.front(), gpu);
}

TEST_F(ForAWindow, IfNoDevicePresentsTheErrorNamesThemAll) {
    presents.clear();
    const auto chosen = choose_with({});
    ASSERT_FALSE(chosen);
    EXPECT_EQ(chosen.error().kind, ErrorKind::kSystemLacks);
    const std::string& words = chosen.error().message;
    const std::string lack = "(lacks a graphics queue that presents to the window)";
    EXPECT_NE(words.find(lack), words.rfind(lack)) << words;
}

// Every library in this process.
std::set<std::string> libraries() {
    std::set<std::string> found;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        if (line.find(".so") != std::string::npos) found.insert(line.substr(line.find('/')));
    }
    return found;
}

TEST(Drivers, StayLoadedWhenTheLastInstanceIsGone) {
    auto made = Instance::create({});
    ASSERT_TRUE(made) << made.error().message;
    const std::set<std::string> loaded = libraries();
    made = failed("let go of");
    EXPECT_EQ(libraries(), loaded);
}

}  // namespace
}  // namespace onggi::vk
