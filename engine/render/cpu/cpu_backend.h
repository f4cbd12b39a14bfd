// The backend for a software device. The device draws the still life once into layers; the processor shades
// those, draws the moving things over them, and paints the overlay. Per frame the device only copies, and
// only the tiles that a target does not show yet. Another view is made in parts while the current one is
// shown, then faded in. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/cpu/host_frame.h"
#include "engine/render/cpu/kept_view.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/edge_pixels.h"
#include "engine/render/pixels/lathe_pixels.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/pixels/prop_pixels.h"
#include "engine/render/pixels/section_pixels.h"
#include "engine/render/shapes/prop_models.h"
#include "engine/render/shapes/tiles.h"
#include "engine/vk/buffer.h"

namespace onggi::render {

// Cross-fade from the last picture of a view to the pictures of the next. It works in the memory of the view
// that was left.
class CrossFade {
  public:
    // Begins a fade from `last`, which is copied to lent.first (tiles may be there already). That memory must
    // stay in place until end().
    void begin(const FrameContext& frame, const HostPicture& last, const KeptView::Lent& lent);
    void end() { before_ = mixed_ = nullptr; }
    [[nodiscard]] bool is_on() const { return mixed_ != nullptr; }

    // Mixes `now` over the old picture with weight `fraction`, 0 to 1. Precondition: is_on(). The device is
    // idle.
    void mix(const FrameContext& frame, const HostPicture& now, float fraction, TileNumbers& numbers);
    // The mixed picture.
    [[nodiscard]] HostPicture picture() const { return {*mixed_, numbers_}; }

  private:
    TileGrid grid_;
    const vk::Buffer* before_ = nullptr;
    const vk::Buffer* mixed_ = nullptr;
    std::vector<std::uint64_t> numbers_;  // of the mixed picture's tiles; all change in every frame
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

// A scene that rests while a covering screen fades in or out: drawn once, kept, and then shown in each frame
// with the overlay over it.
class RestingScene {
  public:
    void forget() { is_here_ = false; }
    // Keeps a copy of `scene`, which has no overlay on it yet, unless a copy exists.
    Result<void> keep(const FrameContext& frame, const HostPicture& scene, TileNumbers& numbers);
    [[nodiscard]] bool is_here() const { return is_here_; }
    [[nodiscard]] HostPicture picture() const { return {picture_, numbers_}; }

  private:
    Result<void> fit(const FrameContext& frame);

    bool is_here_ = false;
    TileGrid grid_;
    vk::Buffer picture_;
    std::vector<std::uint64_t> numbers_;
};

// A colour buffer that the processor draws and the device reads, with a depth buffer for the processor alone.
// Pixels.
class Framebuffer {
  public:
    // Resizes to the frame's size; a resize loses the contents. `name` is the buffer's debug name. The device
    // is idle. Errors: no memory.
    Result<void> fit(const FrameContext& frame, std::string_view name);
    [[nodiscard]] PictureCanvas canvas();
    [[nodiscard]] const vk::Buffer& picture() const { return picture_; }

  private:
    vk::Buffer picture_;
    // Not a vector, which would write to all of it: most pages are never used.
    std::unique_ptr<float[]> depth_;
    PictureSize size_;
};

// Draws the moving things on the processor: hands, tools and the lathe, with smoothed outlines.
class HostMoving {
  public:
    // `desc`: the renderer's settings.
    void create(const RendererDesc& desc);
    // Projects and lights everything that moves, and fills in the frame's prop_tiles. `frame.built` must be
    // this frame's, with the faces that the models chose; those must stay until draw_over().
    void place(FrameContext& frame, const Scene& scene, const PropModels& models);

    // Draws over a copy of the kept picture and its depth, in the tiles where something moves; both are as
    // large as the frame. The device is idle. Errors: no memory.
    Result<void> draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                           std::span<const float> depth);
    // The copy. Only the tiles in which something moves are valid.
    [[nodiscard]] const vk::Buffer& picture() const { return canvas_.picture(); }

  private:
    // Triangles in the order in which they are drawn.
    struct Triangles {
        std::span<const std::uint32_t> props;
        std::span<const std::uint16_t> lathe;
        std::size_t plain = 0;  // see draw_lathe()
    };
    // The triangles that a band touches.
    struct Band {
        std::vector<std::uint32_t> props;
        std::vector<std::uint16_t> lathe;
        std::size_t plain = 0;
    };
    void draw(const FrameContext& frame, const Triangles& triangles, const PictureCanvas& canvas) const;
    void sort_into_bands(const FrameContext& frame);

    std::vector<PropCorner> corners_;
    std::vector<std::uint32_t> indices_;  // of the corners of all props
    std::vector<Band> bands_;
    std::vector<std::uint32_t> streaks_;  // see LatheLook
    StreakSize streak_size_;
    std::vector<LatheCorner> lathe_corners_;
    std::vector<SectionCorner> section_corners_;
    EdgePixels edges_;
    Framebuffer canvas_;
    std::vector<PixelRect> rects_;
};

class CpuBackend : public RenderBackend {
  public:
    CpuBackend(vk::Device& device, const RendererDesc& desc) : frame_{.device = device, .desc = desc} {}

    Result<void> create() override;
    Result<void> fit(const Scene& scene, VkExtent2D target) override;
    Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) override;
    [[nodiscard]] FrameContext& frame() override { return frame_; }

  private:
    // The content under the overlay. kCoveredScene is drawn but not shown, because the overlay is about to
    // fade or because much of the scene has changed. Work that takes several frames is thus done before a
    // visitor waits for it.
    enum class Under { kScene, kCoveredScene, kRestingScene, kNothing };

    void fit_size(VkExtent2D target);
    Under look_under(const Scene& scene, const Overlay* overlay);
    Result<HostPicture> make(const Scene& scene);
    void change_view(const Scene& scene);
    Result<void> make_next_view(const Scene& scene);
    [[nodiscard]] HostPicture picture_of(const KeptView& view) const;
    [[nodiscard]] HostPicture picture() const;

    FrameContext frame_;
    PropModels models_;
    KeptRoom room_;
    TileNumbers numbers_;
    KeptView shown_;
    KeptView next_;
    bool has_picture_ = false;  // picture() is valid for a frame of this size, until the next is built
    CrossFade fade_;
    HostMoving moving_;
    PaintedOverlay overlay_;
    RestingScene resting_;
    HostFrame bringing_;
    bool will_rest_ = false;  // this frame's overlay lets the scene rest
};

}  // namespace onggi::render
