// Selects the backend, and wraps a frame for the caller.
#include "engine/render/renderer.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/render/cpu/cpu_backend.h"
#include "engine/render/vulkan/vulkan_backend.h"

namespace onggi::render {
namespace {

std::unique_ptr<RenderBackend> make_backend(vk::Device& device, const RendererDesc& desc) {
    if (desc.backend == Backend::kCpu) return std::make_unique<CpuBackend>(device, desc);
    return std::make_unique<VulkanBackend>(device, desc);
}

}  // namespace

struct Renderer::Impl {
    std::unique_ptr<RenderBackend> backend;
    bool drew_scene = false;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() {
    const FrameContext& frame = impl_->backend->frame();
    vkDeviceWaitIdle(frame.device.handle());
    frame.device.free_commands(frame.commands);
}

const FrameStats& Renderer::stats() const {
    return impl_->backend->frame().stats;
}
const RendererDesc& Renderer::desc() const {
    return impl_->backend->frame().desc;
}

Result<std::unique_ptr<Renderer>> Renderer::create(vk::Device& device, const RendererDesc& desc) {
    if (auto checked = check_desc(desc); !checked) return checked.error();
    auto impl = std::make_unique<Impl>();
    impl->backend = make_backend(device, desc);
    if (auto created = impl->backend->create(); !created) return created.error();
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

void Renderer::measure_parts(bool measures) {
    impl_->backend->frame().clock.measure_parts(measures);
}

Result<bool> Renderer::draw(const Scene& scene, vk::FrameTarget& target, const Overlay* overlay) {
    auto begun = target.begin();
    if (!begun) return begun.error();
    if (!*begun) return false;
    const vk::TargetImage& image = **begun;
    FrameContext& frame = impl_->backend->frame();
    const HostClock clock = frame.desc.host_clock;
    const std::int64_t began_ns = clock == nullptr ? 0 : clock();
    std::vector<PassTime> parts = std::move(frame.stats.parts);
    // The target has waited for the previous frame.
    const double device_ms = frame.clock.read(frame.device, parts);
    if (auto fitted = impl_->backend->fit(scene, image.extent); !fitted) return fitted.error();
    frame.work = {};
    frame.changed.clear();
    frame.stats.still_life_drawn = frame.stats.shadow_drawn = frame.stats.next_view_ready = false;
    auto drawn = impl_->backend->draw(scene, image, overlay);
    if (!drawn) return drawn.error();
    frame.stats.work = frame.work;
    frame.stats.device_ms = device_ms;
    frame.stats.device_drew_scene = std::exchange(impl_->drew_scene, *drawn);
    frame.stats.parts = std::move(parts);
    if (clock != nullptr) frame.stats.host_ms = 1e-6 * static_cast<double>(clock() - began_ns);
    if (auto ended = target.end(frame.commands, frame.changed); !ended) return ended.error();
    return true;
}

}  // namespace onggi::render
