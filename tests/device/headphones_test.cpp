// Headphones at jacks of sound cards that umockdev describes.
#include "engine/sound/headphones.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <umockdev.h>

#include <string>

#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::sound {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

// Input devices with switches; SW_HEADPHONE_INSERT is the bit 2, SW_MICROPHONE_INSERT the bit 4.
class Jacks : public testing::Test {
  protected:
    ~Jacks() override { g_object_unref(testbed_); }
    // can, on: the switches' bits, in hexadecimal.
    void plug_in(int number, const std::string& can, const std::string& on) {
        const std::string place = fmt::format("/devices/pci0/sound/card0/input{0}/event{0}", number);
        GError* error = nullptr;
        umockdev_testbed_add_from_string(
            testbed_,
            fmt::format("P: {}\nN: input/event{}\nE: SUBSYSTEM=input\nE: DEVNAME=/dev/input/event{}\n", place,
                        number, number)
                .c_str(),
            &error);
        ASSERT_EQ(error, nullptr) << error->message;
        const std::string file = (folder_ / fmt::format("ioctl{}", number)).string();
        test::put_file(
            file, fmt::format("@DEV /dev/input/event{}\nEVIOCGBIT(5) 3 {}0000\nEVIOCGSW 3 {}0000\n", number,
                              can, on));
        umockdev_testbed_load_ioctl(testbed_, fmt::format("/dev/input/event{}", number).c_str(), file.c_str(),
                                    &error);
        ASSERT_EQ(error, nullptr) << error->message;
    }

    const test::TemporaryFolder folder_;
    UMockdevTestbed* testbed_ = umockdev_testbed_new();
};

TEST_F(Jacks, AreAskedForHeadphonesAndNothingElse) {
    Headphones headphones;
    EXPECT_FALSE(headphones.are_in(0)) << "no sound card";
    plug_in(1, "10", "10");
    plug_in(2, "14", "10");
    EXPECT_FALSE(headphones.are_in(10 * kSecond)) << "microphones alone";
    plug_in(3, "14", "04");
    EXPECT_FALSE(headphones.are_in(11 * kSecond)) << "it looks for new cards every few seconds";
    EXPECT_TRUE(headphones.are_in(20 * kSecond));
}

}  // namespace
}  // namespace onggi::sound
