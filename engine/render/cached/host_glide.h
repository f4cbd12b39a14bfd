// The photographed room while the camera moves, bent by the processor where that is the device: the relief,
// the meshes that stand for parts of the room, and the shade on both, as one picture and its depth. What
// moves is drawn over it (HostMoving). Main thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/cached/host_canvas.h"
#include "engine/render/cached/host_frame.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/plate_pass.h"
#include "engine/render/pixels/bent_points.h"
#include "engine/render/pixels/mover_pixels.h"

namespace onggi::render {

class HostGlide {
  public:
    // The scene has a glide and its plates are on the device; `frame.built` is this frame's. The device is
    // idle. Errors: no memory for the picture.
    Result<void> bend(const FrameContext& frame, const Scene& scene, const PlatePass& plates);

    // The camera stands: gives back the picture's memory. The device is idle.
    void rest();

    // What bend() made.
    [[nodiscard]] HostPicture picture() const { return {canvas_.picture(), numbers_}; }
    // The same, for what moves to be drawn into.
    [[nodiscard]] PictureCanvas canvas() { return canvas_.canvas(); }

  private:
    void fit_mesh(const Scene& scene);
    void fill_dimmed(const LightLevels& levels, ByteOrder order);
    void draw(std::span<const Quad> cells, BentPicture& picture);
    void note_speed(const FrameContext& frame, const BendablePlate& plate, float scale);

    HostCanvas canvas_;
    // At half the size, while the camera goes fast.
    std::vector<std::uint32_t> half_picture_;
    std::vector<float> half_depth_;
    bool is_fast_ = false;
    std::vector<vec2> places_px_;               // of some of the relief's corners, in the frame before
    const BendablePlate* places_of_ = nullptr;  // compared only
    std::vector<std::uint64_t> numbers_;        // of its tiles; all of them are others in every frame
    std::uint64_t last_number_ = 0;
    std::unique_ptr<ShadowMask> mask_ = std::make_unique<ShadowMask>();
    std::array<std::array<std::uint8_t, 256>, 3> dimmed_{};
    std::vector<ReliefCorner> relief_;
    ReliefOrder order_;
    BendableMesh mesh_;
    std::vector<SurfaceCorner> surface_;
    std::shared_ptr<const StillLife> mesh_of_;  // held, so that its revision is compared with itself
    std::uint64_t mesh_revision_ = 0;
};

}  // namespace onggi::render
