// The picture where the device is the processor: what stands still is drawn once by the device and kept where
// the processor shades it; what moves the processor draws over that, and the overlay too. The device is left
// with copies, and of those only what a target does not show already. Another view is made in parts while the
// one before is shown, and then fades in. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/cpu/host_frame.h"
#include "engine/render/cpu/kept_view.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/render_backend.h"
#include "engine/render/pixels/edge_pixels.h"
#include "engine/render/pixels/lathe_pixels.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/pixels/prop_pixels.h"
#include "engine/render/pixels/section_pixels.h"
#include "engine/render/shapes/prop_models.h"
#include "engine/render/shapes/tiles.h"
#include "engine/vk/buffer.h"

namespace onggi::render {

// From the last picture of a view to those of the next, one mixed into the other; in the memory of the view
// that is left.
class CrossFade {
  public:
    // `last` is what is left; it may lie in the first of what is lent, which stays where it is until end().
    void begin(const TileGrid& grid, const HostPicture& last, const KeptView::Lent& lent);
    void end() { before_ = mixed_ = nullptr; }
    [[nodiscard]] bool is_on() const { return mixed_ != nullptr; }

    // As much of `now` as the fraction says, 0 to 1, over what was left; it is on. The device is idle.
    void mix(const HostPicture& now, float fraction, TileNumbers& numbers);
    // What came of it.
    [[nodiscard]] HostPicture picture() const { return {*mixed_, numbers_}; }

  private:
    TileGrid grid_;
    const vk::Buffer* before_ = nullptr;
    const vk::Buffer* mixed_ = nullptr;
    std::vector<std::uint64_t> numbers_;  // of its tiles, all of which are others in every frame
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

// A scene that stands still while a screen that covers it comes or goes: made once more, and from then on
// brought into the frames with the overlay on it.
class RestingScene {
  public:
    void forget() { is_here_ = false; }
    // No overlay lies on the scene yet: keeps a copy, unless one is here.
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

// A picture that the processor draws into, in memory that the device reads, and its depth, which it does
// not. Pixels.
class Framebuffer {
  public:
    // As large as the frame; what was in it is lost where that has changed. `name` is for tools that show
    // the device's objects. The device is idle. Errors: no memory.
    Result<void> fit(const FrameContext& frame, std::string_view name);
    [[nodiscard]] PictureCanvas canvas();
    [[nodiscard]] const vk::Buffer& picture() const { return picture_; }

  private:
    vk::Buffer picture_;
    std::vector<float> depth_;
    PictureSize size_;
};

// What moves, by the processor where that is the device: hands, tools and the lathe, and their outlines
// smoothed, drawn into a picture that the processor makes.
class HostMoving {
  public:
    // Of a renderer that is described so.
    void create(const RendererDesc& desc);
    // Finds where all of it comes to lie and in which light, and fills the frame's prop_tiles. `frame.built`
    // must be this frame's, with the models' choice of faces, which must stay until they are drawn.
    void place(FrameContext& frame, const Scene& scene, const PropModels& models);

    // Over a copy of a picture that is kept and its depth, where something moves; both as large as the frame.
    // The device is idle. Errors: no memory for it.
    Result<void> draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                           std::span<const float> depth);
    // That copy; only the tiles are good in which something moves.
    [[nodiscard]] const vk::Buffer& picture() const { return canvas_.picture(); }

  private:
    void draw(const FrameContext& frame, const PictureCanvas& canvas);
    void copy_under(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                    std::span<const float> depth, const PictureCanvas& canvas);

    struct Part {
        std::size_t first_corner = 0;
        std::size_t corner_count = 0;
        std::span<const std::uint32_t> indices;  // the models'
    };
    [[nodiscard]] std::span<const PropCorner> corners_of(const Part& part) const {
        return std::span(corners_).subspan(part.first_corner, part.corner_count);
    }

    std::vector<PropCorner> corners_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> streaks_;  // see LatheLook
    StreakSize streak_size_;
    std::vector<LatheCorner> lathe_corners_;
    std::vector<SectionCorner> section_corners_;
    EdgePixels edges_;
    Framebuffer canvas_;
    std::vector<std::uint8_t> wanted_;
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
    // What an overlay lies on; or covers, made because it will be seen when the overlay has begun to fade, or
    // because much of it is another than before: what takes several frames' time is done before anybody waits
    // for it.
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
    bool has_picture_ = false;  // of a frame as large as this one: picture(), until the next is built
    CrossFade fade_;
    HostMoving moving_;
    PaintedOverlay overlay_;
    RestingScene resting_;
    HostFrame bringing_;
    bool will_rest_ = false;  // this frame's overlay says that the scene may
};

}  // namespace onggi::render
