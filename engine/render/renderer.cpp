// What both ways to a picture share, and which of them it is.
#include "engine/render/renderer.h"

#include <memory>
#include <utility>
#include <vector>

#include "engine/render/cached/cached_picture.h"
#include "engine/render/direct/direct_picture.h"

namespace onggi::render {

struct Renderer::Impl {
    Impl(vk::Device& owner, const RendererDesc& wanted) : frame{.device = owner, .desc = wanted} {}

    Result<void> create();
    Result<void> fit_to(const Scene& scene, VkExtent2D extent);

    FrameContext frame;
    std::unique_ptr<PictureWay> way;
    bool drew_scene = false;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() {
    vkDeviceWaitIdle(impl_->frame.device.handle());
    impl_->frame.device.free_commands(impl_->frame.commands);
}

const FrameStats& Renderer::stats() const {
    return impl_->frame.stats;
}
const RendererDesc& Renderer::desc() const {
    return impl_->frame.desc;
}

Result<std::unique_ptr<Renderer>> Renderer::create(vk::Device& device, const RendererDesc& desc) {
    if (desc.cached && (desc.samples != 1 || desc.transfer != Transfer::kSquareRoot || desc.inside_out)) {
        return failed(
            "renderer: expected one sample a pixel, square roots and outer faces with cached layers, found "
            "others");
    }
    auto impl = std::make_unique<Impl>(device, desc);
    if (auto created = impl->create(); !created) return created.error();
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

Result<void> Renderer::Impl::create() {
    vk::Device& device = frame.device;
    auto made = create_pipelines(device, frame.desc);
    if (!made) return made.error();
    frame.pipelines = std::move(*made);
    if (auto fixed = create_fixed_images(device, frame.desc, frame.images); !fixed) return fixed;
    auto allocated = device.allocate_commands("frame");
    if (!allocated) return allocated.error();
    frame.commands = *allocated;
    auto buffer = vk::Buffer::create(
        device,
        {.name = "frame", .size = sizeof(shaders::FrameData), .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
    if (!buffer) return buffer.error();
    frame.uniforms = std::move(*buffer);
    auto clock = PassClock::create(device, frame.desc);
    if (!clock) return clock.error();
    frame.clock = std::move(*clock);

    const vk::Image& key_map = frame.images.key_map;
    vk::write_buffer(device, frame.set(), shaders::kBindFrame, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                     frame.uniforms.handle());
    vk::write_image(device, frame.set(), shaders::kBindKeyMap, key_map.view(),
                    frame.pipelines.compared.get());
    // What is bound must be laid out, though not every scene has it drawn or read.
    auto laid_out = device.run_once([&](VkCommandBuffer once) {
        vk::barrier(once, key_map, vk::state::kUndefined, vk::state::kSampled);
    });
    if (!laid_out) return laid_out;
    if (frame.desc.cached) {
        way = std::make_unique<CachedPicture>();
    } else {
        way = std::make_unique<DirectPicture>();
    }
    return way->create(frame);
}

// Whatever the size and the contents of the picture ask for. The device is idle.
Result<void> Renderer::Impl::fit_to(const Scene& scene, VkExtent2D wanted) {
    if (wanted.width != frame.extent.width || wanted.height != frame.extent.height) {
        if (auto made = create_sized_images(frame.device, frame.desc, wanted, frame.images); !made)
            return made;
        frame.extent = wanted;
        way->resized();
    }
    if (auto made = fit_pipelines(frame.device, frame.desc, scene, frame.pipelines); !made) return made;
    return way->fit(frame, scene);
}

void Renderer::measure_parts(bool measures) {
    impl_->frame.clock.measure_parts(measures);
}

Result<bool> Renderer::draw(const Scene& scene, vk::FrameTarget& target, const Overlay* overlay) {
    auto begun = target.begin();
    if (!begun) return begun.error();
    if (!*begun) return false;
    const vk::TargetImage& image = **begun;
    FrameContext& frame = impl_->frame;
    std::vector<PassTime> parts = std::move(frame.stats.parts);
    const double device_ms = frame.clock.read(frame.device, parts);  // the target has waited for it
    if (auto fitted = impl_->fit_to(scene, image.extent); !fitted) return fitted.error();
    frame.stats.still_life_drawn = frame.stats.shadow_drawn = frame.stats.next_view_ready = false;
    auto drawn = impl_->way->draw(frame, scene, image, overlay);
    if (!drawn) return drawn.error();
    frame.stats.device_ms = device_ms;
    frame.stats.device_drew_scene = std::exchange(impl_->drew_scene, *drawn);
    frame.stats.parts = std::move(parts);
    if (auto ended = target.end(frame.commands); !ended) return ended.error();
    return true;
}

}  // namespace onggi::render
