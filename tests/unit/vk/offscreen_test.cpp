#include "engine/vk/offscreen.h"

#include <gtest/gtest.h>

#include "engine/vk/buffer.h"
#include "engine/vk/check.h"
#include "tests/support/validated_device.h"

namespace onggi::vk {
namespace {

class OnADevice : public support::ValidatedDevice {};

TEST_F(OnADevice, GivesBackTheColourThatWasClearedFrameAfterFrame) {
    auto target = Offscreen::create(*device_, {20, 10});
    ASSERT_TRUE(target);
    auto commands = device_->allocate_commands("test");
    ASSERT_TRUE(commands);
    for (const float red : {0.0F, 0.2F, 1.0F}) {
        auto begun = (*target)->begin();
        ASSERT_TRUE(begun);
        ASSERT_TRUE(begun->has_value());
        const TargetImage image = **begun;
        EXPECT_EQ(image.extent.width, 20U);
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        ASSERT_EQ(vkBeginCommandBuffer(*commands, &begin), VK_SUCCESS);
        constexpr ImageState kCleared{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
        barrier(*commands, image.image, VK_IMAGE_ASPECT_COLOR_BIT, state::kDiscard, kCleared);
        const VkClearColorValue colour{{red, 0.4F, 0.6F, 1.0F}};
        const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(*commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &colour, 1,
                             &whole);
        barrier(*commands, image.image, VK_IMAGE_ASPECT_COLOR_BIT, kCleared, state::kCopySource);
        ASSERT_EQ(vkEndCommandBuffer(*commands), VK_SUCCESS);
        ASSERT_TRUE((*target)->end(*commands, {}));
        const auto pixels = (*target)->read_back();
        ASSERT_TRUE(pixels);
        ASSERT_EQ(pixels->size(), 20U * 10U * 4U);
        for (std::size_t i = 0; i < pixels->size(); i += 4) {
            EXPECT_EQ((*pixels)[i], static_cast<std::uint8_t>(red * 255.0F + 0.5F));
            EXPECT_EQ((*pixels)[i + 1], 102);
            EXPECT_EQ((*pixels)[i + 2], 153);
            EXPECT_EQ((*pixels)[i + 3], 255);
        }
    }
}

TEST_F(OnADevice, KeepsTheHostsWritesToABuffer) {
    auto buffer =
        Buffer::create(*device_, {.name = "test", .size = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    ASSERT_TRUE(buffer);
    const std::array values{1.0F, 2.0F, 3.0F};
    buffer->write(std::as_bytes(std::span(values)), 4);
    float second = 0.0F;
    std::memcpy(&second, buffer->mapped() + 8, sizeof second);
    EXPECT_EQ(second, 2.0F);
    Buffer moved = std::move(*buffer);
    EXPECT_NE(moved.mapped(), nullptr);
}

TEST_F(OnADevice, ReceivesMessagesOfTheValidationLayer) {
    VkBufferCreateInfo wrong{};
    wrong.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    wrong.size = 0;  // not allowed
    wrong.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    vkCreateBuffer(device_->handle(), &wrong, nullptr, &buffer);
    if (buffer != VK_NULL_HANDLE) vkDestroyBuffer(device_->handle(), buffer, nullptr);
    ASSERT_FALSE(instance_->messages().empty());
    EXPECT_NE(instance_->messages().front().find("VUID-VkBufferCreateInfo-size"), std::string::npos);
    device_.reset();
    instance_.reset();  // it was to complain this time
}

TEST(Check, NamesTheCallAndTheResult) {
    const auto lost = check(VK_ERROR_DEVICE_LOST, "vkQueueSubmit2(queue, 1, &submit, fence)");
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(lost.error().message.find("vkQueueSubmit2:"), std::string::npos);
    EXPECT_NE(lost.error().message.find("VK_ERROR_DEVICE_LOST"), std::string::npos);
    EXPECT_TRUE(check(VK_SUCCESS, "vkQueueSubmit2"));
}

TEST(Check, TakesASwapchainOutOfDateForNeitherSuccessNorFailure) {
    EXPECT_EQ(*check_swapchain(VK_SUCCESS, "vkQueuePresentKHR"), SwapchainState::kGood);
    EXPECT_EQ(*check_swapchain(VK_SUBOPTIMAL_KHR, "vkQueuePresentKHR"), SwapchainState::kGood);
    EXPECT_EQ(*check_swapchain(VK_ERROR_OUT_OF_DATE_KHR, "vkQueuePresentKHR"), SwapchainState::kOutOfDate);
    EXPECT_FALSE(check_swapchain(VK_ERROR_SURFACE_LOST_KHR, "vkQueuePresentKHR"));
}

}  // namespace
}  // namespace onggi::vk
