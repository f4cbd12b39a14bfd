// Compiles every pipeline for GPUs with Mesa's drivers, without hardware. It can do no more than compile: it
// creates no image views.
#include <gtest/gtest.h>

#include "engine/render/frame/still_meshes.h"
#include "engine/render/quality.h"
#include "engine/render/vulkan/overlay_pass.h"
#include "engine/render/vulkan/vulkan_backend.h"
#include "engine/render/vulkan/vulkan_frame.h"
#include "shaders/frame_data.h"

namespace onggi::render {
namespace {

TEST(MesasCompiler, TakesEveryShaderOfEveryStep) {
    auto opened = vk::OffscreenDevice::open();
    ASSERT_TRUE(opened) << opened.error().message;
    vk::Device& device = *opened->device;
    ASSERT_FALSE(device.is_cpu());
    const auto expect = [](const Result<void>& made, const char* what) {
        EXPECT_TRUE(made) << what << ": " << (made ? "" : made.error().message);
    };
    // One sample a pixel, and four.
    for (const QualityStep step : {QualityStep::kSlowGpu, QualityStep::kDiscreteGpu}) {
        VulkanFrame frame{{.device = device, .desc = quality_desc(step, VK_FORMAT_B8G8R8A8_UNORM, 720)}};
        expect(frame.create_layout(shaders::kBindings), "layout");
        expect(create_pipelines(frame, frame.pipelines), "with a room's photographs");
        expect(fit_pipelines(frame, Scene{}, frame.pipelines), "without");
        expect(fit_shadow_map(frame), "shadow map");
        PropPass props;
        expect(props.create(frame), "hands and tools");
        OverlayPass overlay;
        expect(overlay.create(frame), "overlay");
        EXPECT_NE(frame.pipelines.lathe.get(), VkPipeline{VK_NULL_HANDLE});
        EXPECT_NE(frame.pipelines.lathe_section.get(), VkPipeline{VK_NULL_HANDLE});
        EXPECT_NE(frame.pipelines.still.get(), VkPipeline{VK_NULL_HANDLE});
    }
    // AMD's driver crashes when it waits for absent hardware on destruction, so both objects are leaked until
    // the process ends.
    static const vk::Device* const kept_device = opened->device.release();
    static const vk::Instance* const kept_instance = opened->instance.release();
    EXPECT_NE(kept_device, nullptr);
    EXPECT_NE(kept_instance, nullptr);
}

}  // namespace
}  // namespace onggi::render
