#include "game/wheel/wheel_scene.h"

#include "game/wheel/components.h"
#include "game/wheel/workshop.h"

namespace onggi::wheel {

WheelScene::WheelScene() {
    clay_ = registry_.create();
    registry_.add(clay_, Clay{.material = thrown_clay(), .edge_rounding_mm = 2.5F});
    registry_.add(clay_, Wheel{});
    tool_ = registry_.create();
    registry_.add(tool_, Tool{.material = polished_wood()});
    registry_.add(tool_, Transform{});
    camera_ = registry_.create();
    registry_.add(camera_, throwing_camera());
    furnish(registry_);
}

const render::Scene& WheelScene::apply(const PotView& pot, int width_px, int height_px) {
    context_.pot = &pot;
    context_.width_px = width_px;
    context_.height_px = height_px;
    schedule_.run(registry_, context_);
    context_.pot = nullptr;
    return context_.scene;
}

std::optional<dvec3> WheelScene::tool_target_mm(double x_px, double y_px, int width_px, int height_px) {
    const render::Camera camera = camera_of(registry_.get<CameraRig>(camera_), width_px, height_px);
    return render::meet_axis_plane(render::ray_through(camera, width_px, height_px, {x_px, y_px}), camera);
}

}  // namespace onggi::wheel
