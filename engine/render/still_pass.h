// The background: what stands still. With cached layers it is drawn once, with the key light and without, and
// copied each frame; without, it is drawn into every frame. Main thread.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/core/result.h"
#include "engine/render/frame_context.h"
#include "engine/render/plate_pass.h"
#include "engine/render/still_meshes.h"

namespace onggi::render {

class StillPass {
  public:
    // Binds something to every slot that a shader might read before the first layers exist.
    static void bind_placeholders(const FrameContext& frame);

    // The still life of the scene and its plate onto the device, if they are others. The device is idle.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // After the images of the picture's size have been made again.
    void resized(const FrameContext& frame);
    // Decides whether the layers have to be drawn again, and notes it in the stats.
    void update(FrameContext& frame, const Scene& scene);

    // Cached: whether the layers show this scene.
    [[nodiscard]] bool shows(const FrameContext& frame, const Scene& scene) const;

    // The still life's shadow map, and the layers when cached, if update() asked for them.
    void record(const FrameContext& frame);
    // Cached: the picture whole into the target; its depth where something moves.
    void record_copy(const FrameContext& frame, VkImage target) const;
    void record_depth_copy(const FrameContext& frame) const;
    // Direct: meshes and backdrop inside the caller's pass; front to back, so after what stands before them.
    void draw(const FrameContext& frame) const;
    // The same while the camera moves between plates.
    void draw_gliding(const FrameContext& frame, const Glide& glide) const;

    [[nodiscard]] PlatePass& plates() { return plate_; }
    [[nodiscard]] const StillBounds& bounds() const { return still_.bounds(); }

  private:
    void record_key_map(const FrameContext& frame) const;
    void record_layers(const FrameContext& frame) const;

    PlatePass plate_;
    bool has_plate_ = false;
    bool is_gliding_ = false;
    std::size_t glide_need_ = kGlideAlone;
    StillMeshes still_;
    std::shared_ptr<const StillLife> uploaded_;  // held, so that its revision is compared with itself
    std::uint64_t uploaded_revision_ = 0;
    std::uint64_t drawn_ = 0;  // hash of what the layers show
    bool has_layers_ = false;
};

}  // namespace onggi::render
