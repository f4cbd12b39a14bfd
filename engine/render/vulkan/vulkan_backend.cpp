#include "engine/render/vulkan/vulkan_backend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/render/frame/pipelines.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/detail_texture.h"
#include "engine/render/shapes/frame_build.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

constexpr VkFormat kBackgroundFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr std::size_t kTexelBytes = 4;
// Upload per frame for a photograph that is not needed yet; uploading it all at once would delay the frame.
constexpr std::size_t kStripBytes = std::size_t{2} << 20;

void bind_background(const VulkanFrame& frame, const vk::Image& key, const vk::Image& ambient) {
    const auto bind = [&](std::uint32_t binding, const vk::Image& image) {
        vk::write_image(frame.device, frame.set(), binding, image.view(), frame.pipelines.clamped.get());
    };
    bind(shaders::kBindBackgroundKey, key);
    bind(shaders::kBindBackgroundAmbient, ambient);
}

Result<vk::Image> create_picture(const VulkanFrame& frame, const asset::Image& picture, const char* name) {
    return vk::Image::create(
        frame.device,
        {.name = name,
         .format = kBackgroundFormat,
         .extent = {static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height)},
         .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
}

// Copies rows of a picture. The image stays in the copy layout from its first rows to its last.
void copy_rows(VkCommandBuffer commands, const vk::Buffer& strip, const vk::Image& image, int first,
               int rows) {
    const auto height = static_cast<int>(image.extent().height);
    if (first == 0) vk::barrier(commands, image, vk::state::kUndefined, vk::state::kCopyTarget);
    const VkBufferImageCopy region{
        .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
        .imageOffset = {0, first, 0},
        .imageExtent = {image.extent().width, static_cast<std::uint32_t>(rows), 1}};
    vkCmdCopyBufferToImage(commands, strip.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
    if (first + rows == height) vk::barrier(commands, image, vk::state::kCopyTarget, vk::state::kSampled);
}

bool names(const Scene& scene, const std::shared_ptr<const Background>& background) {
    const auto& at_hand = scene.backgrounds_at_hand;
    return background == scene.background || (scene.next_view && background == scene.next_view->background) ||
           std::find(at_hand.begin(), at_hand.end(), background) != at_hand.end();
}

}  // namespace

void BackgroundPass::bind_placeholders(const VulkanFrame& frame) {
    bind_background(frame, frame.images.mask, frame.images.mask);
}

Result<void> BackgroundPass::upload_strip(const VulkanFrame& frame, Resident& resident) {
    const Background& background = *resident.background;
    const auto pair = whole_pair(background);
    if (!pair) return pair.error();
    const bool is_key = resident.rows < background.height_px;
    const asset::Image& picture = is_key ? (*pair)->key : (*pair)->ambient;
    vk::Image& image = is_key ? resident.key : resident.ambient;
    const int first = is_key ? resident.rows : resident.rows - background.height_px;
    if (first == 0) {
        auto made = create_picture(
            frame, picture, is_key ? "background with the key light" : "background without the key light");
        if (!made) return made.error();
        image = std::move(*made);
    }
    const std::size_t row_bytes = kTexelBytes * static_cast<std::size_t>(picture.width);
    const std::size_t strip_bytes = std::max(kStripBytes, row_bytes);
    if (strip_.size() < strip_bytes) {
        auto made = vk::Buffer::create(
            frame.device,
            {.name = "background upload", .size = strip_bytes, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
        if (!made) return made.error();
        strip_ = std::move(*made);
    }
    const int rows = std::min(static_cast<int>(strip_bytes / row_bytes), picture.height - first);
    strip_.write(std::as_bytes(std::span(picture.rgba))
                     .subspan(static_cast<std::size_t>(first) * row_bytes,
                              static_cast<std::size_t>(rows) * row_bytes));
    auto copied =
        frame.device.run_once([&](VkCommandBuffer once) { copy_rows(once, strip_, image, first, rows); });
    if (!copied) return copied;
    resident.rows += rows;
    if (resident.is_whole()) background.photographs->let_go();
    return {};
}

BackgroundPass::Resident& BackgroundPass::begin(std::shared_ptr<const Background> background) {
    for (const auto& resident : residents_) {
        if (resident->background == background) return *resident;
    }
    residents_.push_back(std::make_unique<Resident>());
    residents_.back()->background = std::move(background);
    return *residents_.back();
}

bool BackgroundPass::has(const Background* background) const {
    return std::any_of(residents_.begin(), residents_.end(), [&](const std::unique_ptr<Resident>& resident) {
        return resident->background.get() == background && resident->is_whole();
    });
}

void BackgroundPass::let_go_of_others(const VulkanFrame& frame, const Scene& scene) {
    if (bound_ && !names(scene, bound_)) {
        bind_placeholders(frame);
        bound_ = nullptr;
    }
    std::erase_if(residents_, [&](const std::unique_ptr<Resident>& resident) {
        return !names(scene, resident->background);
    });
}

Result<void> BackgroundPass::fit(const VulkanFrame& frame, const Scene& scene) {
    let_go_of_others(frame, scene);
    std::vector<std::shared_ptr<const Background>> soon = scene.backgrounds_at_hand;
    if (scene.next_view && scene.next_view->background) soon.push_back(scene.next_view->background);
    for (const auto& background : soon) {
        if (has(background.get())) continue;
        if (auto sent = upload_strip(frame, begin(background)); !sent) return sent;
        break;
    }
    if (scene.background == nullptr || scene.background == bound_) return {};
    Resident& shown = begin(scene.background);
    while (!shown.is_whole()) {
        if (auto sent = upload_strip(frame, shown); !sent) return sent;
    }
    bind_background(frame, shown.key, shown.ambient);
    bound_ = scene.background;
    return {};
}

Result<void> RoomPass::fit(const VulkanFrame& frame, const Scene& scene) {
    if (auto fitted = background_.fit(frame, scene); !fitted) return fitted;
    const auto is_other = still_.fit(frame.device, scene.still_life);
    if (!is_other) return is_other.error();
    if (*is_other) mapped_.reset();
    return {};
}

void RoomPass::record(const VulkanFrame& frame, const Scene& scene) {
    still_.look_from(vec3(frame.built.frame.eye));
    const mat4& light = frame.built.frame.key_view_projection;
    if (scene.background || mapped_ == light) return;
    record_shadow_map(frame, still_);
    mapped_ = light;
}

void RoomPass::draw(const VulkanFrame& frame, const Scene& scene) const {
    frame.bind(scene.background ? frame.pipelines.background_surface : frame.pipelines.still);
    still_.draw(frame, StillMeshes::Which::kAll);
    frame.draw_screen(scene.background ? frame.pipelines.background : frame.pipelines.backdrop);
}

void ShadowPass::update(VulkanFrame& frame, const Scene& scene) {
    const std::uint64_t now = shadow_hash(scene);
    frame.stats.shadow_drawn = !has_mask_ || now != drawn_;
    drawn_ = now;
}

void ShadowPass::record(const VulkanFrame& frame) {
    if (!frame.stats.shadow_drawn) return;
    const vk::Image& mask = frame.images.mask;
    vk::barrier(frame.commands, mask, vk::state::kDiscard, vk::state::kColour);
    begin_pass(frame.commands, mask.extent(), {{.view = mask.view()}}, {});
    frame.draw_screen(frame.pipelines.mask);
    vkCmdEndRendering(frame.commands);
    vk::barrier(frame.commands, mask, vk::state::kColour, vk::state::kSampled);
    has_mask_ = true;
}

// Every device has a maxTexelBufferElements of at least 65536.
static_assert(shaders::kProfileTexels <= 65536);

Result<void> LathePass::create(const VulkanFrame& frame) {
    const std::size_t most_indices =
        std::size_t{6} * (kMaxRings - 1) * static_cast<std::size_t>(frame.desc.sectors);
    struct BufferRequest {
        vk::Buffer& into;
        vk::BufferDesc desc;
    };
    for (const BufferRequest& request :
         {BufferRequest{rows_.buffer,
                        {.name = "lathe rows",
                        .size = sizeof(shaders::RowData) * kMaxRings,
                        .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}},
          BufferRequest{vertices_.buffer,
                        {.name = "lathe vertices",
                        .size = sizeof(shaders::VertexData) * kMaxRings *
                                    static_cast<std::size_t>(frame.desc.sectors + 1) +
                                sizeof(shaders::VertexData) * kMaxSectionVertices,
                        .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}},
          BufferRequest{outline_.buffer,
                        {.name = "lathe outline",
                        .size = sizeof(float) * shaders::kOutlineSamples,
                        .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}},
          BufferRequest{normals_.buffer,
                        {.name = "outline normals",
                        .size = sizeof(NormalTexels),
                        .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT}},
          BufferRequest{indices_.buffer,
                        {.name = "lathe indices",
                        .size = most_indices * sizeof(std::uint16_t),
                        .usage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT}}}) {
        auto buffer = vk::Buffer::create(frame.device, request.desc);
        if (!buffer) return buffer.error();
        request.into = std::move(*buffer);
    }

    const VulkanPipelines& pipelines = frame.pipelines;
    const VulkanImages& images = frame.images;
    struct Place {
        int binding;
        const vk::Buffer& buffer;
    };
    for (const Place& place :
         {Place{shaders::kBindOutline, outline_.buffer}, Place{shaders::kBindRows, rows_.buffer},
          Place{shaders::kBindVertices, vertices_.buffer}}) {
        vk::write_buffer(frame.device, frame.set(), static_cast<std::uint32_t>(place.binding),
                         VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, place.buffer.handle());
    }
    // Until there are marks, another buffer fills the slot: a bound slot needs a buffer, even if no shader
    // reads it.
    vk::write_buffer(frame.device, frame.set(), shaders::kBindMarks, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                     rows_.buffer.handle());
    auto normals =
        vk::create_texels(frame.device, normals_.buffer.handle(), VK_FORMAT_R32_UINT, "outline normals");
    if (!normals) return normals.error();
    normal_texels_ = std::move(*normals);
    vk::write_texels(frame.device, frame.set(), shaders::kBindNormals, normal_texels_.get());
    vk::write_image(frame.device, frame.set(), shaders::kBindDetail, images.detail.view(),
                    pipelines.repeated.get());
    return upload_streaks(frame);
}

Result<void> LathePass::upload_streaks(const VulkanFrame& frame) {
    const vk::Image& detail = frame.images.detail;
    const int across = frame.desc.streaks_across;
    const int up = frame.desc.streaks_up;
    const std::vector<std::uint8_t> texels = coarser_detail(detail_texture(), across, up);
    auto staging = vk::Buffer::create(
        frame.device,
        {.name = "streaks upload", .size = texels.size(), .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    if (!staging) return staging.error();
    staging->write(std::as_bytes(std::span(texels)));
    return frame.device.run_once([&](VkCommandBuffer once) {
        vk::barrier(once, detail, vk::state::kUndefined, vk::state::kCopyTarget);
        const VkBufferImageCopy region{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                       .imageExtent = {detail.extent().width, detail.extent().height, 1}};
        vkCmdCopyBufferToImage(once, staging->handle(), detail.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               1, &region);
        vk::barrier(once, detail, vk::state::kCopyTarget, vk::state::kSampled);
    });
}

// Most pots have no marks, so the buffer is allocated on first use. No frame is in flight here.
Result<void> LathePass::upload_marks(const VulkanFrame& frame) {
    const LatheMarks* const marks = frame.built.marks;
    if (marks == nullptr || marks->revision == marks_revision_) return {};
    const auto texels = std::as_bytes(std::span(marks->texels));
    if (marks_.size() < texels.size()) {
        auto buffer = vk::Buffer::create(
            frame.device,
            {.name = "lathe marks", .size = texels.size(), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
        if (!buffer) return buffer.error();
        marks_ = std::move(*buffer);
        vk::write_buffer(frame.device, frame.set(), shaders::kBindMarks, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                         marks_.handle());
    }
    marks_.write(texels);
    frame.work.uploaded_bytes += texels.size();
    marks_revision_ = marks->revision;
    return {};
}

void LathePass::Kept::write(const VulkanFrame& frame, std::span<const std::byte> bytes) {
    if (std::ranges::equal(bytes, there)) return;
    there.assign(bytes.begin(), bytes.end());
    buffer.write(bytes);
    frame.work.uploaded_bytes += bytes.size();
}

Result<void> LathePass::upload(const VulkanFrame& frame) {
    const BuiltFrame& built = frame.built;
    if (built.faces.indices.empty()) return {};
    outline_.write(frame, std::as_bytes(std::span(built.samples.outer_mm)));
    rows_.write(frame, std::as_bytes(std::span(built.rows)));
    vertices_.write(frame, std::as_bytes(std::span(built.vertices)));
    normals_.write(frame, std::as_bytes(std::span(built.normals)));
    indices_.write(frame, std::as_bytes(std::span(built.faces.indices)));
    return upload_marks(frame);
}

void LathePass::draw(const VulkanFrame& frame) const {
    if (frame.built.faces.indices.empty()) return;
    const LatheFaces& faces = frame.built.faces;
    const auto all = static_cast<std::uint32_t>(faces.indices.size());
    const auto draw_faces = [&](const vk::Pipeline& pipeline, std::uint32_t first, std::uint32_t count) {
        if (count == 0) return;
        frame.bind(pipeline);
        vkCmdDrawIndexed(frame.commands, count, 1, first, 0, 0);
        frame.count_draw(count);
    };
    vkCmdBindIndexBuffer(frame.commands, indices_.buffer.handle(), 0, VK_INDEX_TYPE_UINT16);
    frame.push(frame.built.lathe);
    if (frame.built.shows_load) {
        draw_faces(frame.pipelines.lathe_load, 0, all);
    } else if (frame.built.marks != nullptr) {
        draw_faces(frame.pipelines.lathe_marks, 0, all);
    } else {
        draw_faces(frame.pipelines.lathe, 0, faces.plain);
        draw_faces(frame.pipelines.lathe_near_spheres, faces.plain, all - faces.plain);
    }
    if (frame.built.section_count == 0) return;
    frame.bind(frame.pipelines.lathe_section);
    frame.push(frame.built.section);
    vkCmdDraw(frame.commands, frame.built.section_count, 1, frame.built.section_first, 0);
    frame.count_draw(frame.built.section_count);
}

namespace {

constexpr std::array kAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT,
                                      offsetof(PropMesh::Vertex, position_mm)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(PropMesh::Vertex, normal)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(PropMesh::Vertex, tone)}};

shaders::PropDraw prop_draw(const Prop& prop, const PropMesh& mesh) {
    const mat4 rows = glm::transpose(prop.place);  // a column of the transposed matrix is a row
    return {.row_x = rows[0],
            .row_y = rows[1],
            .row_z = rows[2],
            .albedo = vec4(mesh.albedo, mesh.roughness),
            .smear = vec4(prop.smear, prop.wetness),
            .surface = vec4(mesh.metalness, 0.0F, 0.0F, 0.0F)};
}

}  // namespace

Result<void> PropPass::create(const VulkanFrame& frame) {
    const std::array formats{frame.desc.colour_format};
    auto pipeline =
        vk::create_pipeline(frame.device, {.name = "hands and tools",
                                           .vertex_spirv = shaders::kPropVert,
                                           .fragment_spirv = shaders::kPropFrag,
                                           .layout = frame.layout.get(),
                                           .attributes = kAttributes,
                                           .vertex_stride = sizeof(PropMesh::Vertex),
                                           .colour_formats = formats,
                                           .depth_format = kDepthFormat,
                                           .samples = static_cast<VkSampleCountFlagBits>(frame.desc.samples),
                                           .depth_test = true,
                                           .depth_write = true});
    if (!pipeline) return pipeline.error();
    pipeline_ = std::move(*pipeline);
    return {};
}

Result<void> PropPass::fit(const VulkanFrame& frame, const Scene& scene) {
    if (scene.prop_library == uploaded_) return {};
    uploaded_.reset();
    ranges_.clear();
    std::vector<PropMesh::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const PropModel& model : scene.prop_library ? *scene.prop_library : PropLibrary()) {
        std::vector<Range>& ranges = ranges_.emplace_back();
        for (const PropMesh& mesh : model.meshes) {
            ranges.push_back({.first_index = static_cast<std::uint32_t>(indices.size()),
                              .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                              .first_vertex = static_cast<std::int32_t>(vertices.size())});
            vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
            indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        }
    }
    auto sent = buffers_.upload(frame.device, "hands and tools", std::as_bytes(std::span(vertices)), indices);
    if (!sent) return sent;
    uploaded_ = scene.prop_library;
    return {};
}

void PropPass::draw(const VulkanFrame& frame, const Scene& scene) const {
    if (scene.props.empty() || !uploaded_) return;
    frame.bind(pipeline_);
    buffers_.bind(frame.commands);
    for (const Prop& prop : scene.props) {
        if (prop.model >= ranges_.size()) continue;
        const std::vector<Range>& ranges = ranges_[prop.model];
        for (std::size_t mesh = 0; mesh < ranges.size(); ++mesh) {
            const Range& range = ranges[mesh];
            frame.push(prop_draw(prop, (*uploaded_)[prop.model].meshes[mesh]));
            vkCmdDrawIndexed(frame.commands, range.index_count, 1, range.first_index, range.first_vertex, 0);
            frame.count_draw(range.index_count);
        }
    }
}

void ViewFade::bind_placeholder(const VulkanFrame& frame) {
    vk::write_image(frame.device, frame.set(), shaders::kBindViewBefore, frame.images.mask.view(),
                    frame.pipelines.clamped.get());
}

Result<void> ViewFade::fit(const VulkanFrame& frame, const Scene& scene) {
    const VkExtent2D have = kept_.extent();
    const bool fits = have.width == frame.extent.width && have.height == frame.extent.height;
    shows_ = scene.fade_in.has_value() && has_ && fits;
    // The kept image is not overwritten while it is read: the next view waits until the fade has ended.
    keeps_ = scene.next_view.has_value() && !scene.fade_in;
    has_ = shows_;
    if (!keeps_ || fits) return {};
    auto made = vk::Image::create(frame.device,
                                  {.name = "last picture of a view",
                                   .format = frame.desc.colour_format,
                                   .extent = frame.extent,
                                   .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                            VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    if (!made) return made.error();
    kept_ = std::move(*made);
    vk::write_image(frame.device, frame.set(), shaders::kBindViewBefore, kept_.view(),
                    frame.pipelines.clamped.get());
    return {};
}

void ViewFade::keep(VkCommandBuffer commands, const vk::ImageState& used) {
    vk::barrier(commands, kept_, used, vk::state::kSampled);
    has_ = true;
}

void ViewFade::draw(const VulkanFrame& frame) const {
    if (shows_) frame.draw_screen(frame.pipelines.view_fade);
}

namespace {

VkExtent2D scaled(VkExtent2D extent, float scale) {
    const auto side = [&](std::uint32_t px) {
        return std::max(static_cast<std::uint32_t>(std::lround(static_cast<float>(px) * scale)), 1U);
    };
    return {side(extent.width), side(extent.height)};
}

constexpr vk::ImageState kStretched{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

VkOffset3D far_corner(VkExtent2D extent) {
    return {static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height), 1};
}

}  // namespace

Result<void> VulkanBackend::create() {
    if (auto created = frame_.create(shaders::kBindings); !created) return created;
    if (auto made = create_pipelines(frame_, frame_.pipelines); !made) return made;
    if (auto made = create_fixed_images(frame_.device, frame_.desc, frame_.images); !made) return made;
    const vk::Image& mask = frame_.images.mask;
    vk::write_image(frame_.device, frame_.set(), shaders::kBindMask, mask.view(),
                    frame_.pipelines.clamped.get());
    // A bound image must have a layout, even if the scene neither draws nor reads it.
    auto laid_out = frame_.device.run_once(
        [&](VkCommandBuffer once) { vk::barrier(once, mask, vk::state::kUndefined, vk::state::kSampled); });
    if (!laid_out) return laid_out;
    RoomPass::create(frame_);
    ViewFade::bind_placeholder(frame_);
    if (auto created = props_.create(frame_); !created) return created;
    if (auto created = lathe_.create(frame_); !created) return created;
    return overlay_.create(frame_);
}

Result<void> VulkanBackend::fit_size(VkExtent2D target) {
    const VkExtent2D have = frame_.target_extent;
    if (target.width == have.width && target.height == have.height) return {};
    const VkExtent2D extent = scaled(target, frame_.desc.scale);
    if (auto made = create_sized_images(frame_.device, frame_.desc, extent, frame_.images); !made)
        return made;
    frame_.extent = extent;
    frame_.target_extent = target;
    return {};
}

Result<void> VulkanBackend::fit(const Scene& scene, VkExtent2D target) {
    if (auto fitted = fit_size(target); !fitted) return fitted;
    if (!scene.background) {
        if (auto fitted = fit_shadow_map(frame_); !fitted) return fitted;
    }
    if (auto made = fit_pipelines(frame_, scene, frame_.pipelines); !made) return made;
    if (auto fitted = fade_.fit(frame_, scene); !fitted) return fitted;
    return room_.fit(frame_, scene);
}

Result<void> VulkanBackend::upload(const Scene& scene) {
    frame_.clock.enter_host("shapes");
    frame_.build(scene, room_.bounds());
    frame_.stats.still_life_drawn = true;
    if (auto fitted = props_.fit(frame_, scene); !fitted) return fitted;
    shadow_.update(frame_, scene);
    frame_.clock.end_host();
    frame_.upload_uniforms(frame_.built.frame);
    return lathe_.upload(frame_);
}

Result<bool> VulkanBackend::draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) {
    const bool shows_scene = overlay == nullptr || !overlay->covers;
    if (shows_scene) {
        if (auto sent = upload(scene); !sent) return sent.error();
    }
    if (auto fitted = overlay_.fit(frame_, overlay); !fitted) return fitted.error();
    if (auto begun = frame_.begin(); !begun) return begun.error();
    frame_.enter("overlay's pictures");
    overlay_.record_uploads(frame_);
    if (shows_scene) record(scene, target);
    frame_.enter("overlay");
    overlay_.record(frame_, target, shows_scene);
    frame_.changed.push_back({.extent = target.extent});
    if (auto ended = frame_.end(target); !ended) return ended.error();
    frame_.stats.next_view_ready =
        shows_scene && fade_.keeps() != nullptr && room_.has(scene.next_view->background.get());
    return shows_scene;
}

void VulkanBackend::record(const Scene& scene, const vk::TargetImage& target) {
    const VkCommandBuffer commands = frame_.commands;
    const VulkanImages& images = frame_.images;
    frame_.bind_set();
    frame_.enter("shadow maps");
    room_.record(frame_, scene);
    shadow_.record(frame_);
    const vk::Image* apart = picture_apart();
    const VkImage picture = apart != nullptr ? apart->handle() : target.image;
    const VkImageView view = apart != nullptr ? apart->view() : target.view;
    vk::barrier(commands, picture, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, vk::state::kColour);
    vk::barrier(commands, images.depth, vk::state::kDiscard, vk::state::kDepth);
    PassColour colour{.view = view};
    if (frame_.desc.samples > 1) {
        vk::barrier(commands, images.multisampled, vk::state::kDiscard, vk::state::kColour);
        colour = {.view = images.multisampled.view(), .resolve = view};
    }
    begin_pass(commands, frame_.extent, {colour}, {.view = images.depth.view()});
    // Front to back, to reduce overdraw.
    frame_.enter("lathe");
    lathe_.draw(frame_);
    frame_.enter("hands and tools");
    props_.draw(frame_, scene);
    frame_.enter("still life");
    room_.draw(frame_, scene);
    fade_.draw(frame_);
    vkCmdEndRendering(commands);
    if (apart != nullptr) stretch(*apart, target);
    if (fade_.keeps() != nullptr) fade_.keep(commands, kStretched);
}

const vk::Image* VulkanBackend::picture_apart() const {
    if (fade_.keeps() != nullptr) return fade_.keeps();
    return frame_.desc.scale < 1.0F ? &frame_.images.smaller : nullptr;
}

void VulkanBackend::stretch(const vk::Image& picture, const vk::TargetImage& target) const {
    constexpr vk::ImageState kWritten{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    const VkCommandBuffer commands = frame_.commands;
    vk::barrier(commands, picture, vk::state::kColour, kStretched);
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, vk::state::kDiscard, kWritten);
    VkImageBlit region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = far_corner(picture.extent());
    region.dstOffsets[1] = far_corner(target.extent);
    vkCmdBlitImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_LINEAR);
    vk::barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, kWritten, vk::state::kColour);
}

}  // namespace onggi::render
