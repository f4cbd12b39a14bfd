#include "engine/render/renderer.h"

#include <algorithm>
#include <array>

#include "engine/render/detail_texture.h"
#include "engine/render/frame_build.h"
#include "engine/render/frame_images.h"
#include "engine/render/pass.h"
#include "engine/render/pipelines.h"
#include "engine/render/profile_mesh.h"
#include "engine/render/still_meshes.h"
#include "engine/vk/buffer.h"
#include "engine/vk/check.h"

namespace onggi::render {

RendererDesc still_desc(VkFormat colour_format) {
    return {.colour_format = colour_format,
            .samples = 4,
            .cached = false,
            .transfer = Transfer::kExactSrgb,
            .sectors = 192,
            .max_rings = kMaxRings,
            .ring_error_px = 0.05F};
}

RendererDesc live_desc(VkFormat colour_format, bool device_is_cpu, int height_px) {
    if (!device_is_cpu) return still_desc(colour_format);
    return {.colour_format = colour_format,
            .samples = 1,
            .cached = true,
            .transfer = Transfer::kSquareRoot,
            .sectors = height_px > 800 ? 96 : 64,
            .max_rings = 128,
            .ring_error_px = 0.25F};  // its edges are not smoothed, so a finer line would not be seen
}

struct Renderer::Impl {
    Impl(vk::Device& owner, const RendererDesc& wanted) : device(owner), desc(wanted) {}

    Result<void> create();
    Result<void> upload_fixed();
    Result<void> fit_to(const Scene& scene, VkExtent2D extent);
    Result<void> upload(const Scene& scene);
    Result<void> record(const Scene& scene, const vk::TargetImage& target);

    void record_normals() const;
    void record_key_map() const;
    void record_layers() const;
    void record_mask() const;
    void record_cached(const Scene& scene, const vk::TargetImage& target) const;
    void record_direct(const Scene& scene, const vk::TargetImage& target) const;

    void bind(const vk::Pipeline& pipeline) const;
    template <typename Constants>
    void push(const Constants& constants) const {
        vkCmdPushConstants(commands, pipelines.layout.get(),
                           VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof constants,
                           &constants);
    }
    void draw_screen(const vk::Pipeline& pipeline) const;
    void draw_still(const vk::Pipeline& pipeline) const;
    void draw_lathe() const;
    void draw_spheres(const Scene& scene) const;

    vk::Device& device;
    RendererDesc desc;
    Pipelines pipelines;
    FrameImages images;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    vk::Buffer frame_buffer;
    vk::Buffer radii_buffer;
    vk::Buffer ring_buffer;
    vk::Buffer normal_buffer;
    vk::Buffer index_buffer;
    StillMeshes sphere;
    StillMeshes still;
    std::shared_ptr<const StillLife> uploaded_still;  // held, so that its revision is compared with itself
    std::uint64_t uploaded_revision = 0;
    std::uint64_t drawn_still = 0;   // hash of what the cached layers show
    std::uint64_t drawn_shadow = 0;  // and the mask
    bool has_layers = false;
    bool has_mask = false;
    VkExtent2D extent{};
    BuiltFrame built;
    FrameStats stats;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() {
    vkDeviceWaitIdle(impl_->device.handle());
}

const FrameStats& Renderer::stats() const {
    return impl_->stats;
}
const RendererDesc& Renderer::desc() const {
    return impl_->desc;
}

Result<std::unique_ptr<Renderer>> Renderer::create(vk::Device& device, const RendererDesc& desc) {
    if (desc.cached && desc.samples != 1) {
        return failed("renderer: expected one sample a pixel with cached layers, found more");
    }
    auto impl = std::make_unique<Impl>(device, desc);
    if (auto created = impl->create(); !created) return created.error();
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

Result<void> Renderer::Impl::create() {
    auto made = create_pipelines(device, desc);
    if (!made) return made.error();
    pipelines = std::move(*made);
    if (auto fixed = create_fixed_images(device, images); !fixed) return fixed;
    auto allocated = device.allocate_commands("frame");
    if (!allocated) return allocated.error();
    commands = *allocated;

    const std::vector<std::uint16_t> indices = lathe_indices(desc.max_rings, desc.sectors);
    struct Wish {
        vk::Buffer& into;
        vk::BufferDesc desc;
    };
    for (const Wish& wish :
         {Wish{frame_buffer,
               {.name = "frame",
               .size = sizeof(shaders::FrameData),
               .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT}},
          Wish{ring_buffer,
               {.name = "rings",
               .size = sizeof(shaders::RingData) * kMaxRings,
               .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}},
          Wish{radii_buffer,
               {.name = "radii", .size = sizeof(float) * 2000, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}},
          Wish{normal_buffer,
               {.name = "outline normals",
               .size = sizeof(NormalTexels),
               .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT}},
          Wish{index_buffer,
               {.name = "lathe indices",
               .size = indices.size() * sizeof(std::uint16_t),
               .usage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT}}}) {
        auto buffer = vk::Buffer::create(device, wish.desc);
        if (!buffer) return buffer.error();
        wish.into = std::move(*buffer);
    }
    index_buffer.write(std::as_bytes(std::span(indices)));
    StillLife ball;
    ball.parts.push_back({.mesh = std::make_shared<const Mesh>(sphere_mesh(24, 40)), .material = {}});
    if (auto uploaded = sphere.upload(device, ball); !uploaded) return uploaded;

    const VkDescriptorSet set = pipelines.set.set;
    vk::write_buffer(device, set, shaders::kBindFrame, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                     frame_buffer.handle());
    vk::write_buffer(device, set, shaders::kBindRadii, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                     radii_buffer.handle());
    vk::write_buffer(device, set, shaders::kBindRings, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                     ring_buffer.handle());
    vk::write_image(device, set, shaders::kBindNormals, images.normals.view(), pipelines.clamped.get());
    vk::write_image(device, set, shaders::kBindDetail, images.detail.view(), pipelines.repeated.get());
    vk::write_image(device, set, shaders::kBindMask, images.mask.view(), pipelines.clamped.get());
    vk::write_image(device, set, shaders::kBindKeyMap, images.key_map.view(), pipelines.compared.get());
    // No direct shader reads the layers, and Vulkan lets such bindings stay empty; lavapipe 22.3 follows them
    // all the same and crashes.
    for (const int binding :
         {shaders::kBindStillKey, shaders::kBindStillAmbient, shaders::kBindStillCoords}) {
        vk::write_image(device, set, static_cast<std::uint32_t>(binding), images.mask.view(),
                        pipelines.exact.get());
    }
    return upload_fixed();
}

Result<void> Renderer::Impl::upload_fixed() {
    const std::vector<std::uint8_t> texels = detail_texture();
    auto staging = vk::Buffer::create(
        device, {.name = "slip upload", .size = texels.size(), .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    if (!staging) return staging.error();
    staging->write(std::as_bytes(std::span(texels)));
    return device.run_once([&](VkCommandBuffer once) {
        vk::barrier(once, images.detail, vk::state::kUndefined, vk::state::kCopyTarget);
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {kDetailTexels, kDetailTexels, 1};
        vkCmdCopyBufferToImage(once, staging->handle(), images.detail.handle(),
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
        vk::barrier(once, images.detail, vk::state::kCopyTarget, vk::state::kSampled);
    });
}

// Whatever the size and the still life of the picture ask for. The device is idle.
Result<void> Renderer::Impl::fit_to(const Scene& scene, VkExtent2D wanted) {
    if (wanted.width != extent.width || wanted.height != extent.height) {
        if (auto made = create_sized_images(device, desc, wanted, images); !made) return made;
        extent = wanted;
        has_layers = false;
        if (desc.cached) {
            const VkDescriptorSet set = pipelines.set.set;
            const VkSampler exact = pipelines.exact.get();
            vk::write_image(device, set, shaders::kBindStillKey, images.still_key.view(), exact);
            vk::write_image(device, set, shaders::kBindStillAmbient, images.still_ambient.view(), exact);
            vk::write_image(device, set, shaders::kBindStillCoords, images.still_coords.view(), exact);
        }
    }
    const std::uint64_t revision = scene.still_life ? scene.still_life->revision : 0;
    if (scene.still_life != uploaded_still || revision != uploaded_revision) {
        const StillLife nothing;
        if (auto uploaded = still.upload(device, scene.still_life ? *scene.still_life : nothing); !uploaded) {
            return uploaded;
        }
        uploaded_still = scene.still_life;
        uploaded_revision = revision;
        has_layers = false;
    }
    const std::size_t radii_bytes = scene.lathe ? scene.lathe->radii_mm.size_bytes() : 0;
    if (radii_bytes > radii_buffer.size()) {
        auto larger = vk::Buffer::create(
            device, {.name = "radii", .size = radii_bytes, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
        if (!larger) return larger.error();
        radii_buffer = std::move(*larger);
        vk::write_buffer(device, pipelines.set.set, shaders::kBindRadii, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                         radii_buffer.handle());
    }
    return {};
}

Result<void> Renderer::Impl::upload(const Scene& scene) {
    const auto width = static_cast<int>(extent.width);
    const auto height = static_cast<int>(extent.height);
    build_frame(scene, still.bounds(), desc, width, height, built);
    stats = {.rings = static_cast<int>(built.rings.size()), .ring_error_px = built.ring_error_px};

    const std::uint64_t still_now = still_hash(scene, width, height);
    stats.still_life_drawn = !desc.cached || !has_layers || still_now != drawn_still;
    drawn_still = still_now;
    const std::uint64_t shadow_now = shadow_hash(scene);
    stats.shadow_drawn = !has_mask || shadow_now != drawn_shadow;
    drawn_shadow = shadow_now;

    const auto write = [&](const vk::Buffer& buffer, std::span<const std::byte> bytes) {
        buffer.write(bytes);
        stats.bytes_uploaded += bytes.size();
    };
    write(frame_buffer, std::as_bytes(std::span(&built.frame, 1)));
    if (built.lathe_indices > 0) {
        write(radii_buffer, std::as_bytes(scene.lathe->radii_mm));
        write(ring_buffer, std::as_bytes(std::span(built.rings)));
        write(normal_buffer, std::as_bytes(std::span(built.normals)));
    }
    return {};
}

void Renderer::Impl::bind(const vk::Pipeline& pipeline) const {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.get());
}

void Renderer::Impl::draw_screen(const vk::Pipeline& pipeline) const {
    bind(pipeline);
    vkCmdDraw(commands, 3, 1, 0, 0);
}

void Renderer::Impl::draw_still(const vk::Pipeline& pipeline) const {
    bind(pipeline);
    still.draw(commands, pipelines.layout.get(), false);
}

void Renderer::Impl::draw_lathe() const {
    if (built.lathe_indices == 0) return;
    bind(pipelines.lathe);
    vkCmdBindIndexBuffer(commands, index_buffer.handle(), 0, VK_INDEX_TYPE_UINT16);
    vkCmdPushConstants(commands, pipelines.layout.get(),
                       VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof built.lathe,
                       &built.lathe);
    vkCmdDrawIndexed(commands, built.lathe_indices, 1, 0, 0, 0);
}

void Renderer::Impl::draw_spheres(const Scene& scene) const {
    const std::size_t count = std::min<std::size_t>(scene.spheres.size(), kMaxSpheres);
    if (count == 0) return;
    bind(pipelines.mover);
    for (std::size_t i = 0; i < count; ++i) {
        const Sphere& ball = scene.spheres[i];
        sphere.draw_as(commands, pipelines.layout.get(),
                       mesh_draw(ball.material, ball.centre_mm, ball.radius_mm));
    }
}

void Renderer::Impl::record_normals() const {
    if (built.lathe_indices == 0) return;
    vk::barrier(commands, images.normals, vk::state::kDiscard, vk::state::kCopyTarget);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {shaders::kProfileTexels, 1, 1};
    vkCmdCopyBufferToImage(commands, normal_buffer.handle(), images.normals.handle(),
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    vk::barrier(commands, images.normals, vk::state::kCopyTarget, vk::state::kSampled);
}

void Renderer::Impl::record_key_map() const {
    vk::barrier(commands, images.key_map, vk::state::kDiscard, vk::state::kDepth);
    begin_pass(commands, images.key_map.extent(), {},
               {.view = images.key_map.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    bind(pipelines.key_map);
    still.draw(commands, pipelines.layout.get(), true);
    vkCmdEndRendering(commands);
    vk::barrier(commands, images.key_map, vk::state::kDepth, vk::state::kSampled);
}

void Renderer::Impl::record_layers() const {
    for (const vk::Image* image : {&images.still_key, &images.still_ambient, &images.still_coords})
        vk::barrier(commands, *image, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.still_depth, vk::state::kDiscard, vk::state::kDepth);
    begin_pass(commands, extent,
               {{.view = images.still_key.view()},
                {.view = images.still_ambient.view()},
                {.view = images.still_coords.view()}},
               {.view = images.still_depth.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    draw_still(pipelines.still);
    draw_screen(pipelines.backdrop);
    vkCmdEndRendering(commands);
    for (const vk::Image* image : {&images.still_key, &images.still_ambient, &images.still_coords})
        vk::barrier(commands, *image, vk::state::kColour, vk::state::kSampled);
    vk::barrier(commands, images.still_depth, vk::state::kDepth, vk::state::kCopySource);
}

void Renderer::Impl::record_mask() const {
    vk::barrier(commands, images.mask, vk::state::kDiscard, vk::state::kColour);
    begin_pass(commands, images.mask.extent(), {{.view = images.mask.view()}}, {});
    draw_screen(pipelines.mask);
    vkCmdEndRendering(commands);
    vk::barrier(commands, images.mask, vk::state::kColour, vk::state::kSampled);
}

void Renderer::Impl::record_cached(const Scene& scene, const vk::TargetImage& target) const {
    constexpr VkImageAspectFlags kColourAspect = VK_IMAGE_ASPECT_COLOR_BIT;
    // What stands still: the picture whole, its depth only where something moves in front of it.
    vk::barrier(commands, target.image, kColourAspect, vk::state::kDiscard, vk::state::kCopyTarget);
    vk::barrier(commands, images.still_key, vk::state::kSampled, vk::state::kCopySource);
    vk::copy(commands, images.still_key.handle(), target.image, kColourAspect, {{0, 0}, extent});
    vk::barrier(commands, images.still_key, vk::state::kCopySource, vk::state::kSampled);
    vk::barrier(commands, target.image, kColourAspect, vk::state::kCopyTarget, vk::state::kColour);
    const PixelRect& moving = built.moving;
    const bool something_moves = moving.width > 0 && moving.height > 0;
    if (something_moves) {
        vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kCopyTarget);
        vk::copy(commands, images.still_depth.handle(), images.depth.handle(), VK_IMAGE_ASPECT_DEPTH_BIT,
                 {{moving.x, moving.y},
                  {static_cast<std::uint32_t>(moving.width), static_cast<std::uint32_t>(moving.height)}});
        vk::barrier(commands, images.depth, vk::state::kCopyTarget, vk::state::kDepth);
    } else {
        vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    }
    begin_pass(commands, extent, {{.view = target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD}},
               {.view = images.depth.view(), .load = VK_ATTACHMENT_LOAD_OP_LOAD});
    if (built.shade_vertices > 0) {
        bind(pipelines.shade);
        push(built.shade);
        vkCmdDraw(commands, built.shade_vertices, 1, 0, 0);
    }
    if (something_moves) {
        set_scissor(commands, moving);
        draw_lathe();
        draw_spheres(scene);
    }
    vkCmdEndRendering(commands);
}

void Renderer::Impl::record_direct(const Scene& scene, const vk::TargetImage& target) const {
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    PassColour colour{.view = target.view};
    if (desc.samples > 1) {
        vk::barrier(commands, images.multisampled, vk::state::kDiscard, vk::state::kColour);
        colour = {.view = images.multisampled.view(), .resolve = target.view};
    }
    begin_pass(commands, extent, {colour}, {.view = images.depth.view()});
    // Front to back, so that what is hidden is not shaded.
    draw_lathe();
    draw_spheres(scene);
    draw_still(pipelines.still);
    draw_screen(pipelines.backdrop);
    vkCmdEndRendering(commands);
}

Result<void> Renderer::Impl::record(const Scene& scene, const vk::TargetImage& target) {
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    ONGGI_VK_TRY(vkBeginCommandBuffer(commands, &begin));
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout.get(), 0, 1,
                            &pipelines.set.set, 0, nullptr);
    record_normals();
    if (stats.still_life_drawn) {
        record_key_map();
        if (desc.cached) record_layers();
        has_layers = true;
    }
    if (stats.shadow_drawn) {
        record_mask();
        has_mask = true;
    }
    if (desc.cached) {
        record_cached(scene, target);
    } else {
        record_direct(scene, target);
    }
    const vk::ImageState done{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                              target.final_layout};
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kColour, done);
    ONGGI_VK_TRY(vkEndCommandBuffer(commands));
    return {};
}

Result<bool> Renderer::draw(const Scene& scene, vk::FrameTarget& target) {
    auto begun = target.begin();
    if (!begun) return begun.error();
    if (!*begun) return false;
    const vk::TargetImage& image = **begun;
    if (auto fitted = impl_->fit_to(scene, image.extent); !fitted) return fitted.error();
    if (auto uploaded = impl_->upload(scene); !uploaded) return uploaded.error();
    if (auto recorded = impl_->record(scene, image); !recorded) return recorded.error();
    if (auto ended = target.end(impl_->commands); !ended) return ended.error();
    return true;
}

}  // namespace onggi::render
