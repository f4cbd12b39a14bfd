// The photographs of the room, on the device: those that are shown, and those that may be next. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/bend_pixels.h"
#include "engine/render/frame_context.h"

namespace onggi::render {

// Where in the frame's set a plate is bound.
struct PlateSlots {
    int key;
    int ambient;
    int depth;
};

// A plate where the processor is the device, and bends it itself.
struct BendablePlate {
    std::optional<HostPlate> photographs{};  // as long as the camera moves
    std::optional<HostPlate> halved{};       // where it goes fast
    std::vector<vec3> relief_mm;             // corners
    std::vector<Quad> cells;                 // of them
};

class PlatePass {
  public:
    // Binds something to every slot that a shader might read before there is a plate.
    static void bind_placeholders(const FrameContext& frame);

    // The scene's plates onto the device, where they are not there yet; true if another one is shown now. The
    // device is idle.
    Result<bool> fit(const FrameContext& frame, const Scene& scene);

    // The relief of the plate that is nearer to the gliding camera, inside the caller's pass.
    void draw_relief(const FrameContext& frame, const Glide& glide) const;
    // Where the host shades: a plate of the scene, with its photographs, which are read back from the device
    // when they are not here. The device is idle. Errors: it is none, or the device's.
    Result<const BendablePlate*> bendable(const FrameContext& frame,
                                          const std::shared_ptr<const Plate>& plate);
    // The same photographs at half their width and height. Errors: as bendable().
    Result<const HostPlate*> halved(const FrameContext& frame, const std::shared_ptr<const Plate>& plate);
    // The camera stands: lets them go.
    void rest();

  private:
    struct Resident {
        std::shared_ptr<const Plate> plate;  // held, so that no other can have its address
        vk::Image key;
        vk::Image ambient;
        vk::Image depth;  // of the relief's corners, mm
        vk::Buffer relief_positions{};
        vk::Buffer relief_indices{};
        std::uint32_t relief_index_count = 0;
        BendablePlate bendable{};  // instead of these three
    };
    Result<BendablePlate*> with_photographs(const FrameContext& frame,
                                            const std::shared_ptr<const Plate>& plate);
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
