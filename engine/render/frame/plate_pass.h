// The photographs of the room, those that are shown and those that may be next: on the device, or where the
// processor is the device with it, which lays and bends them itself. Main thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/bend_pixels.h"

namespace onggi::render {

// Where in the frame's set a plate is bound.
struct PlateSlots {
    int key;
    int ambient;
    int depth;
};

// A plate where the processor is the device.
struct BendablePlate {
    HostPlate photographs;
    HostPlate halved;             // of half the width and height, where a glide may be soft
    std::vector<vec3> relief_mm;  // corners
    std::vector<Quad> cells;      // of them
};

class PlatePass {
  public:
    // Not when cached: binds something to every slot that a shader might read before there is a plate.
    static void bind_placeholders(const FrameContext& frame);

    // The scene's plates to where they are used, unless they are there; true if another one is shown now. The
    // device is idle.
    Result<bool> fit(const FrameContext& frame, const Scene& scene);

    // The relief of the plate that is nearer to the gliding camera, inside the caller's pass.
    void draw_relief(const FrameContext& frame, const Glide& glide) const;
    // Where the host shades: a plate of the scene. Errors: it is none.
    [[nodiscard]] Result<const BendablePlate*> bendable(const std::shared_ptr<const Plate>& plate) const;

  private:
    struct Resident {
        std::shared_ptr<const Plate> plate;  // held, so that no other can have its address
        vk::Image key{};
        vk::Image ambient{};
        vk::Image depth{};  // of the relief's corners, mm
        vk::Buffer relief_positions{};
        vk::Buffer relief_indices{};
        std::uint32_t relief_index_count = 0;
        BendablePlate bendable{};  // instead of all these
    };
    static Result<Resident> upload(const FrameContext& frame, std::shared_ptr<const Plate> plate);
    Result<const Resident*> resident(const FrameContext& frame, const std::shared_ptr<const Plate>& plate);
    void let_go(const FrameContext& frame, const PlateSlots& slots,
                std::shared_ptr<const Plate>& bound) const;
    [[nodiscard]] const Resident* find(const std::shared_ptr<const Plate>& plate) const;

    std::vector<std::unique_ptr<Resident>> residents_;
    std::shared_ptr<const Plate> from_;  // as bound
    std::shared_ptr<const Plate> to_;
};

}  // namespace onggi::render
