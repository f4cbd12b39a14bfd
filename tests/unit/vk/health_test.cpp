#include "engine/vk/health.h"

#include <gtest/gtest.h>

namespace onggi::vk {
namespace {

TEST(Health, LetsEverythingThroughWithoutAFault) {
    Health health;
    EXPECT_EQ(health.before("vkQueueSubmit2(queue, 1)"), VK_SUCCESS);
    health.note(VK_SUCCESS);
    EXPECT_EQ(health.trouble(), Trouble::kNone);
}

TEST(Health, StrikesTheNamedCallAfterAsManyAsItWasTold) {
    Health health;
    health.inject({.call = "vkQueueSubmit2", .result = VK_ERROR_OUT_OF_DEVICE_MEMORY, .after = 2});
    EXPECT_EQ(health.before("vkQueueSubmit2(a)"), VK_SUCCESS);
    EXPECT_EQ(health.before("vkQueueSubmit(a)"), VK_SUCCESS) << "another call, whose name begins alike";
    EXPECT_EQ(health.before("vkQueueSubmit2(b)"), VK_SUCCESS);
    EXPECT_EQ(health.before("vkQueueSubmit2(c)"), VK_ERROR_OUT_OF_DEVICE_MEMORY);
    EXPECT_EQ(health.before("vkQueueSubmit2(d)"), VK_SUCCESS) << "it strikes once";
}

TEST(Health, KeepsALostDeviceLost) {
    Health health;
    health.inject({.call = "vkQueueSubmit2"});
    health.note(health.before("vkQueueSubmit2(a)"));
    EXPECT_EQ(health.trouble(), Trouble::kLost);
    EXPECT_EQ(health.before("vkWaitSemaphores(b)"), VK_ERROR_DEVICE_LOST);
    health.note(VK_ERROR_OUT_OF_HOST_MEMORY);
    EXPECT_EQ(health.trouble(), Trouble::kLost);
}

TEST(Health, TellsTroublesApart) {
    for (const auto& [result, trouble] : {std::pair{VK_ERROR_DEVICE_LOST, Trouble::kLost},
                                          {VK_ERROR_OUT_OF_DEVICE_MEMORY, Trouble::kOutOfMemory},
                                          {VK_ERROR_OUT_OF_HOST_MEMORY, Trouble::kOutOfMemory},
                                          {VK_ERROR_SURFACE_LOST_KHR, Trouble::kSurfaceLost},
                                          {VK_ERROR_OUT_OF_DATE_KHR, Trouble::kNone},
                                          {VK_SUBOPTIMAL_KHR, Trouble::kNone}}) {
        Health health;
        health.note(result);
        EXPECT_EQ(health.trouble(), trouble) << result;
    }
}

}  // namespace
}  // namespace onggi::vk
