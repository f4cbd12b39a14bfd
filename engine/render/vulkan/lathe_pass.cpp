#include "engine/render/vulkan/lathe_pass.h"

#include <algorithm>
#include <vector>

#include "engine/render/shapes/detail_texture.h"
#include "engine/render/shapes/lathe_section.h"

namespace onggi::render {

// maxTexelBufferElements is at least so many on every device.
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
    // Until there are marks: what is bound must be there, though nothing reads it.
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

// A room of their own as soon as there are some: most pots have none. No frame is in flight here.
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

}  // namespace onggi::render
