// The order of a frame; what each pass does is in its own file.
#include "engine/render/renderer.h"

#include "engine/render/edge_pass.h"
#include "engine/render/host_frame.h"
#include "engine/render/host_glide.h"
#include "engine/render/host_moving.h"
#include "engine/render/host_shade.h"
#include "engine/render/lathe_pass.h"
#include "engine/render/mover_pass.h"
#include "engine/render/moving_tiles.h"
#include "engine/render/overlay_pass.h"
#include "engine/render/painted_overlay.h"
#include "engine/render/resting_scene.h"
#include "engine/render/shadow_pass.h"
#include "engine/render/still_pass.h"
#include "engine/vk/check.h"

namespace onggi::render {

// What an overlay lies on; or covers, drawn because it will be seen when the overlay has begun to fade, or
// because much of it is another than before: what takes several frames' time is done before anybody waits for
// it.
enum class Under { kScene, kCoveredScene, kRestingScene, kNothing };

bool draws_scene(Under under) {
    return under == Under::kScene || under == Under::kCoveredScene;
}

struct Renderer::Impl {
    Impl(vk::Device& owner, const RendererDesc& wanted) : frame{.device = owner, .desc = wanted} {}

    Result<void> create();
    Result<void> fit_to(const Scene& scene, VkExtent2D extent);
    Under look_under(const Scene& scene, const Overlay* wanted);
    bool is_prepared(const Scene& scene) const;
    Result<void> fit_overlay(const Overlay* wanted);
    Result<void> lay_out_unwritten();
    Result<void> upload(const Scene& scene);
    Result<void> shade(const Scene& scene);
    Result<void> record_painted(const vk::TargetImage& target, Under under);
    Result<void> record(const Scene& scene, const vk::TargetImage& target, Under under);
    Result<void> record_scene(const Scene& scene, const vk::TargetImage& target);
    Result<void> record_cached(const Scene& scene, const vk::TargetImage& target);
    void record_moving(const Scene& scene, const vk::TargetImage& target, bool is_kept);
    void draw_moving(const Scene& scene);
    Result<void> record_direct(const Scene& scene, const vk::TargetImage& target);

    Result<void> note_rest(const vk::TargetImage& target, const HostShade* shaded);

    // Whether the processor bends the photographs; and otherwise shades the layers.
    [[nodiscard]] bool is_bent(const Scene& scene) const {
        return frame.desc.cached && scene.glide && scene.plate;
    }
    [[nodiscard]] bool is_cached(const Scene& scene) const { return frame.desc.cached && !is_bent(scene); }
    void enter(const char* part) { clock.enter(frame.device, frame.commands, part); }

    FrameContext frame;
    PassClock clock;
    vk::Buffer frame_buffer;
    StillPass still;
    ShadowPass shadow;
    HostShade host_shade;  // in its place, where layers are cached
    LathePass lathe;
    MoverPass movers;
    HostMoving host_moving;  // in their place, where the processor draws
    EdgePass edges;
    OverlayPass overlay;
    PaintedOverlay painted;  // in its place, where the processor shades
    HostFrame host_frame;
    HostGlide host_glide;
    RestingScene resting;
    bool will_rest = false;  // this frame's overlay says that the scene may
    Under drawn_under = Under::kNothing;
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
    if (desc.cached && (desc.samples != 1 || desc.transfer != Transfer::kSquareRoot)) {
        return failed(
            "renderer: expected one sample a pixel and square roots with cached layers, found others");
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
    frame_buffer = std::move(*buffer);

    const VkDescriptorSet set = frame.set();
    vk::write_buffer(device, set, shaders::kBindFrame, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                     frame_buffer.handle());
    vk::write_image(device, set, shaders::kBindMask, frame.images.mask.view(), frame.pipelines.clamped.get());
    vk::write_image(device, set, shaders::kBindKeyMap, frame.images.key_map.view(),
                    frame.pipelines.compared.get());
    auto made_clock = PassClock::create(device, frame.desc);
    if (!made_clock) return made_clock.error();
    clock = std::move(*made_clock);
    if (auto laid_out = lay_out_unwritten(); !laid_out) return laid_out;
    PlatePass::bind_placeholders(frame);
    if (auto created = movers.create(frame); !created) return created;
    if (auto created = edges.create(frame); !created) return created;
    if (auto created = lathe.create(frame); !created) return created;
    return frame.desc.cached ? painted.create(frame) : overlay.create(frame);
}

// What is bound must be laid out, though not every scene has it drawn or read.
Result<void> Renderer::Impl::lay_out_unwritten() {
    return frame.device.run_once([&](VkCommandBuffer once) {
        vk::barrier(once, frame.images.mask, vk::state::kUndefined, vk::state::kSampled);
        vk::barrier(once, frame.images.key_map, vk::state::kUndefined, vk::state::kSampled);
    });
}

// Whatever the size and the contents of the picture ask for. The device is idle.
Result<void> Renderer::Impl::fit_to(const Scene& scene, VkExtent2D wanted) {
    if (wanted.width != frame.extent.width || wanted.height != frame.extent.height) {
        if (auto made = create_sized_images(frame.device, frame.desc, wanted, frame.images); !made)
            return made;
        frame.extent = wanted;
        resting.forget();
        edges.resized(frame);
    }
    if (auto made = fit_pipelines(frame.device, frame.desc, scene, frame.pipelines); !made) return made;
    if (auto fitted = still.fit(frame, scene); !fitted) return fitted;
    return movers.fit(frame, scene);
}

// Whether the next frame of it takes no longer than any other.
bool Renderer::Impl::is_prepared(const Scene& scene) const {
    return !is_cached(scene) || still.shows(frame, scene);
}

Under Renderer::Impl::look_under(const Scene& scene, const Overlay* wanted) {
    const bool covers = wanted != nullptr && wanted->covers;
    will_rest = frame.desc.cached && wanted != nullptr && wanted->scene_rests;
    if (!will_rest) {
        resting.forget();
        if (!covers) return Under::kScene;
        return is_prepared(scene) ? Under::kNothing : Under::kCoveredScene;
    }
    const bool is_here = resting.take(host_shade);
    if (covers) return is_here ? Under::kNothing : Under::kCoveredScene;
    return is_here ? Under::kRestingScene : Under::kScene;
}

Result<void> Renderer::Impl::fit_overlay(const Overlay* wanted) {
    return frame.desc.cached ? painted.fit(frame, wanted) : overlay.fit(frame, wanted);
}

Result<void> Renderer::Impl::upload(const Scene& scene) {
    BuiltFrame& built = frame.built;
    const EdgeView view{scene.camera, static_cast<int>(frame.extent.width),
                        static_cast<int>(frame.extent.height)};
    clock.enter_host("shapes");
    build_frame(scene, still.bounds(), frame.desc, view.width_px, view.height_px, built);
    frame.stats = {.rings = static_cast<int>(built.rows.size()), .ring_error_px = built.ring_error_px};
    if (auto chosen = movers.upload(frame, scene); !chosen) return chosen;
    built.mover_tiles.clear();
    if (frame.desc.cached) {
        host_moving.place(frame, scene, movers, lathe);
        find_moving_tiles(scene, view, built);
    }
    clock.enter_host("room");
    still.update(frame, scene);
    if (is_bent(scene)) {
        host_shade.let_go();
        still.let_go_layers();
        if (auto bent = host_glide.bend(frame, scene, still.plates()); !bent) return bent;
        clock.enter_host("hands and clay");
        host_moving.draw(frame, host_glide.canvas(frame));
    } else if (frame.desc.cached) {
        host_glide.rest();
        if (auto shaded = shade(scene); !shaded) return shaded;
    } else {
        shadow.update(frame, scene);
    }
    clock.end_host();
    frame.write(frame_buffer, std::as_bytes(std::span(&built.frame, 1)));
    if (built.is_drawn_by_host) return {};
    lathe.upload(frame);
    edges.upload(frame);
    return {};
}

// The still life as it is under the moving things' shade, by the processor.
Result<void> Renderer::Impl::shade(const Scene& scene) {
    if (auto fitted = host_shade.fit(frame); !fitted) return fitted;
    if (auto drawn = still.draw_layers(frame, scene, frame_buffer); !drawn) return drawn;
    if (frame.stats.still_life_drawn) host_shade.forget();
    host_shade.shade(frame, scene, still.layers().layers());
    clock.enter_host("hands and clay");
    return host_moving.draw_over(frame, host_shade.shaded().as<const std::uint32_t>(),
                                 still.layers().depth().as<const float>());
}

// The room as the processor made it, kept or bent anew, with what it drew over that.
Result<void> Renderer::Impl::record_cached(const Scene& scene, const vk::TargetImage& target) {
    enter("still life");
    const bool is_kept = !is_bent(scene);
    HostPicture room =
        is_kept ? HostPicture{host_shade.shaded(), host_shade.tiles().numbers(), frame.built.moving_tiles}
                : host_glide.picture(frame);
    if (is_kept) {
        room.instead = &host_moving.picture();
        room.instead_on = host_moving.tiles(frame);
    }
    room.is_whole = frame.built.is_drawn_by_host;
    if (will_rest && room.is_whole) {
        if (auto kept = resting.keep(frame, room); !kept) return kept;
    }
    if (auto brought = host_frame.record(frame, target, room, painted); !brought) return brought;
    if (room.is_whole) return {};
    record_moving(scene, target, is_kept);
    return note_rest(target, is_kept ? &host_shade : nullptr);
}

// What the device draws over the room, and the depth it needs for that.
void Renderer::Impl::record_moving(const Scene& scene, const vk::TargetImage& target, bool is_kept) {
    const vk::Image& depth = frame.images.depth;
    vk::barrier(frame.commands, depth, vk::state::kDiscard, vk::state::kCopyTarget);
    if (is_kept) {
        still.record_depth(frame);
        host_moving.record_depth(frame);
    } else {
        host_glide.record_depth(frame);
    }
    vk::barrier(frame.commands, depth, vk::state::kCopyTarget, vk::state::kDepth);
    begin_pass(
        frame.commands, frame.extent, {{.view = target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD}},
        {.view = depth.view(), .load = VK_ATTACHMENT_LOAD_OP_LOAD, .store = VK_ATTACHMENT_STORE_OP_STORE});
    draw_moving(scene);
    vkCmdEndRendering(frame.commands);
    enter("outlines");
    edges.record(frame, target);
}

// Inside a pass.
void Renderer::Impl::draw_moving(const Scene& scene) {
    const PixelRect& moving = frame.built.moving;
    if (moving.width <= 0 || moving.height <= 0) return;
    set_scissor(frame.commands, moving);
    // A pixel of clay takes several times as long as one of a hand: what a hand hides is not shaded.
    enter("hands and tools");
    movers.draw(frame, scene);
    enter("clay");
    lathe.draw(frame);
}

Result<void> Renderer::Impl::record_direct(const Scene& scene, const vk::TargetImage& target) {
    const VkCommandBuffer commands = frame.commands;
    const FrameImages& images = frame.images;
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    PassColour colour{.view = target.view};
    if (frame.desc.samples > 1) {
        vk::barrier(commands, images.multisampled, vk::state::kDiscard, vk::state::kColour);
        colour = {.view = images.multisampled.view(), .resolve = target.view};
    }
    begin_pass(commands, frame.extent, {colour},
               {.view = images.depth.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    // Front to back, so that what is hidden is not shaded.
    enter("clay");
    lathe.draw(frame);
    enter("hands and tools");
    movers.draw(frame, scene);
    enter("still life");
    if (scene.glide) {
        still.draw_gliding(frame, *scene.glide);
    } else {
        still.draw(frame);
    }
    vkCmdEndRendering(commands);
    return {};
}

// Everything but the overlay is drawn.
Result<void> Renderer::Impl::note_rest(const vk::TargetImage& target, const HostShade* shaded) {
    if (!will_rest) return {};
    enter("resting scene");
    return resting.record_reading(frame, target, shaded);
}

Result<void> Renderer::Impl::record_scene(const Scene& scene, const vk::TargetImage& target) {
    frame.bind_set();
    if (frame.desc.cached) return record_cached(scene, target);
    enter("shadow maps");
    still.record(frame);
    shadow.record(frame);
    return record_direct(scene, target);
}

// The device is the processor: most of the overlay is in the target already, with what lies under it.
Result<void> Renderer::Impl::record_painted(const vk::TargetImage& target, Under under) {
    if (under == Under::kNothing || under == Under::kCoveredScene) {
        host_frame.record_covered(frame, target, painted, under == Under::kCoveredScene);
        return {};
    }
    if (under == Under::kRestingScene) return host_frame.record(frame, target, resting.picture(), painted);
    return painted.record(frame, target, host_frame.drawn_over());
}

Result<void> Renderer::Impl::record(const Scene& scene, const vk::TargetImage& target, Under under) {
    const VkCommandBuffer commands = frame.commands;
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    ONGGI_VK_TRY(vkBeginCommandBuffer(commands, &begin));
    clock.begin(frame.device, commands);
    if (!frame.desc.cached) {
        enter("overlay's pictures");
        overlay.record_uploads(frame);
    }
    if (draws_scene(under)) {
        if (auto recorded = record_scene(scene, target); !recorded) return recorded;
    }
    enter("overlay");
    if (frame.desc.cached) {
        if (auto recorded = record_painted(target, under); !recorded) return recorded;
    } else {
        overlay.record(frame, target, under == Under::kScene);
    }
    clock.end(frame.device, commands);
    const vk::ImageState done{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                              target.final_layout};
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kColour, done);
    ONGGI_VK_TRY(vkEndCommandBuffer(commands));
    return {};
}

void Renderer::measure_parts(bool measures) {
    impl_->clock.measure_parts(measures);
}

Result<bool> Renderer::draw(const Scene& scene, vk::FrameTarget& target, const Overlay* overlay) {
    auto begun = target.begin();
    if (!begun) return begun.error();
    if (!*begun) return false;
    const vk::TargetImage& image = **begun;
    std::vector<PassTime> parts = std::move(impl_->frame.stats.parts);
    const double device_ms = impl_->clock.read(impl_->frame.device, parts);  // the target has waited for it
    const bool drew_scene = impl_->drawn_under == Under::kScene;
    if (auto fitted = impl_->fit_to(scene, image.extent); !fitted) return fitted.error();
    const Under under = impl_->look_under(scene, overlay);
    impl_->drawn_under = under;
    if (draws_scene(under)) {
        if (auto uploaded = impl_->upload(scene); !uploaded) return uploaded.error();
    } else {
        impl_->frame.stats.still_life_drawn = impl_->frame.stats.shadow_drawn = false;
    }
    impl_->frame.stats.device_ms = device_ms;
    impl_->frame.stats.device_drew_scene = drew_scene;
    impl_->frame.stats.parts = std::move(parts);
    if (auto fitted = impl_->fit_overlay(overlay); !fitted) return fitted.error();
    if (auto recorded = impl_->record(scene, image, under); !recorded) return recorded.error();
    if (auto ended = target.end(impl_->frame.commands); !ended) return ended.error();
    return true;
}

}  // namespace onggi::render
