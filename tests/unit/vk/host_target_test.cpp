// Pictures in a window's own memory, on the software device, with a window system that is simulated.
#include "engine/vk/host_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "engine/vk/check.h"
#include "engine/vk/image.h"

namespace onggi::vk {
namespace {

// What the window system was told, in order.
struct Told {
    std::vector<std::string> calls;
    std::vector<VkRect2D> changed;
    std::span<std::byte> memory;
    std::uint32_t row_px = 0;

    [[nodiscard]] std::array<int, 4> pixel(std::uint32_t x, std::uint32_t y) const {
        const std::byte* at = memory.data() + std::size_t{4} * (std::size_t{y} * row_px + x);
        return {std::to_integer<int>(at[0]), std::to_integer<int>(at[1]), std::to_integer<int>(at[2]),
                std::to_integer<int>(at[3])};
    }
};

class SimulatedSurface final : public HostSurface {
  public:
    explicit SimulatedSurface(Told& told) : told_(told) {}
    ~SimulatedSurface() override { std::free(told_.memory.data()); }
    Result<std::span<std::byte>> lend(std::size_t bytes) override {
        std::free(told_.memory.data());
        const std::size_t size = (bytes + kPage - 1) / kPage * kPage;
        told_.memory = {static_cast<std::byte*>(std::aligned_alloc(kPage, size)), size};
        std::memset(told_.memory.data(), 0, size);
        told_.calls.emplace_back("lend");
        return told_.memory;
    }
    Result<void> wait_until_read() override {
        told_.calls.emplace_back("wait");
        return {};
    }
    void show(VkExtent2D, std::uint32_t row_px, std::span<const VkRect2D> changed) override {
        told_.calls.emplace_back("show");
        told_.row_px = row_px;
        told_.changed.assign(changed.begin(), changed.end());
    }

  private:
    static constexpr std::size_t kPage = 4096;
    Told& told_;
};

class AHostTarget : public testing::Test {
  protected:
    void SetUp() override {
        auto instance = Instance::create({.validation = true, .extensions = {VK_KHR_SURFACE_EXTENSION_NAME}});
        ASSERT_TRUE(instance) << instance.error().message;
        instance_ = std::move(*instance);
        const auto chosen =
            choose_device(*instance_, VK_NULL_HANDLE, {}, {.cpu_first = true, .avoids_gpus = true});
        ASSERT_TRUE(chosen) << chosen.error().message;
        auto device = Device::create(*instance_, *chosen, Presenting::kImagesInStep);
        ASSERT_TRUE(device) << device.error().message;
        device_ = std::move(*device);
        ASSERT_NE(device_->host_pointer_properties(), nullptr) << "lavapipe imports memory of the host";
        auto target = HostTarget::create(*device_, std::make_unique<SimulatedSurface>(told_), {50, 30});
        ASSERT_TRUE(target) << target.error().message;
        target_ = std::move(*target);
        const auto commands = device_->allocate_commands("test");
        ASSERT_TRUE(commands);
        commands_ = *commands;
    }
    void TearDown() override {
        target_.reset();
        device_.reset();
        if (!instance_) return;
        for (const std::string& message : instance_->messages())
            ADD_FAILURE() << message;
    }
    // Fills the image with a colour. Returns the number of earlier frames in it.
    std::uint64_t clear(const VkClearColorValue& colour) {
        auto begun = target_->begin();
        EXPECT_TRUE(begun && begun->has_value());
        const TargetImage image = **begun;
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        EXPECT_EQ(vkBeginCommandBuffer(commands_, &begin), VK_SUCCESS);
        constexpr ImageState kCleared{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
        barrier(commands_, image.image, VK_IMAGE_ASPECT_COLOR_BIT, state::kDiscard, kCleared);
        const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands_, image.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &colour, 1,
                             &whole);
        const ImageState left{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                              image.final_layout};
        barrier(commands_, image.image, VK_IMAGE_ASPECT_COLOR_BIT, kCleared, left);
        EXPECT_EQ(vkEndCommandBuffer(commands_), VK_SUCCESS);
        const std::array changed{VkRect2D{{1, 2}, {3, 4}}};
        EXPECT_TRUE(target_->end(commands_, changed));
        return image.frames_before;
    }

    Told told_;
    std::unique_ptr<Instance> instance_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<HostTarget> target_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

TEST_F(AHostTarget, DrawsIntoTheWindowsMemory) {
    EXPECT_EQ(clear({{1.0F, 0.6F, 0.2F, 1.0F}}), 0U);
    EXPECT_EQ(told_.pixel(0, 0), (std::array{51, 153, 255, 255})) << "blue first";
    EXPECT_EQ(told_.pixel(49, 29), (std::array{51, 153, 255, 255}));
    ASSERT_EQ(told_.changed.size(), 1U);
    EXPECT_EQ(told_.changed[0].extent.height, 4U);
    EXPECT_EQ(clear({{0.0F, 0.0F, 1.0F, 1.0F}}), 1U) << "one image, so its contents are always known";
    EXPECT_EQ(told_.pixel(20, 10), (std::array{255, 0, 0, 255}));
}

TEST_F(AHostTarget, ChangesNoPictureThatIsBeingRead) {
    clear({});
    clear({});
    EXPECT_EQ(told_.calls, (std::vector<std::string>{"lend", "wait", "show", "wait", "show"}));
}

TEST_F(AHostTarget, TakesTheWindowsSizeAndDrawsNothingWithoutOne) {
    clear({});
    target_->resize({80, 20});
    EXPECT_EQ(clear({{0.0F, 1.0F, 0.0F, 1.0F}}), 0U);
    EXPECT_EQ(target_->extent().width, 80U);
    EXPECT_EQ(told_.pixel(79, 19), (std::array{0, 255, 0, 255}));
    target_->resize({0, 0});
    const auto begun = target_->begin();
    ASSERT_TRUE(begun);
    EXPECT_FALSE(begun->has_value());
    target_->resize({10, 10});
    EXPECT_EQ(clear({}), 0U);
}

TEST_F(AHostTarget, ReportsALostDevice) {
    device_->health().inject({.call = "vkQueueSubmit2"});
    EXPECT_FALSE(target_->end(commands_, {}));
    EXPECT_EQ(device_->health().trouble(), Trouble::kLost);
    EXPECT_EQ(std::count(told_.calls.begin(), told_.calls.end(), "show"), 0);
}

}  // namespace
}  // namespace onggi::vk
