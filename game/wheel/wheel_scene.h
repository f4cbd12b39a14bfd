// The potter's-wheel scene: its entities and the frame built from them. Wheel, clay, tool, camera, lights and
// the still life are entities of one registry, and the drawn scene comes only from this registry. Main
// thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/ecs/registry.h"
#include "engine/ecs/schedule.h"
#include "engine/render/scene.h"
#include "game/wheel/room_model.h"
#include "game/wheel/systems.h"
#include "game/wheel/wheel_view.h"

namespace onggi::wheel {

class WheelScene {
  public:
    // With a workshop: the room of its backgrounds once they are added; until then, and without a workshop,
    // the small still life of workshop.h. With a model of the room: the model, from the workshop's cameras
    // and in its light.
    explicit WheelScene(std::shared_ptr<const Workshop> workshop = nullptr, RoomModel model = {});

    // Cameras of a picture of this aspect ratio whose backgrounds are not loaded.
    [[nodiscard]] std::vector<const BackgroundCamera*> missing_backgrounds(int width_px, int height_px);
    void add_background(const std::string& camera_name, std::shared_ptr<const render::Background> background);
    // Drops the backgrounds that a picture of this aspect ratio does not show, if there are others to show.
    void drop_backgrounds_of_other_shapes(int width_px, int height_px);
    [[nodiscard]] bool has_backgrounds();
    [[nodiscard]] std::shared_ptr<const Workshop> workshop();  // null without one
    // Requests another view. The camera cuts to it once a frame reports it as ready (see render::FrameStats),
    // and fades it in.
    void look_at(View view);
    void set_framing(const Framing& framing);
    void next_view_is_ready();
    void move_less(bool less);  // cuts without fades
    void jump();                // cuts to the wanted view in the next frame, while the scene is covered
    void sway(bool sways);      // slowly from side to side, while the wheel is idle
    void set_evening(double evening);  // 0 day to 1 evening, in about a second

    // Runs every system for a picture of this size, dt_s after the previous one (0: a still, without
    // animation). The returned scene is valid until the next call.
    const render::Scene& apply(const WheelView& shown, int width_px, int height_px, double dt_s = 0.0);

    // Sets the models of hands and tools; null: balls.
    void set_tools(std::shared_ptr<const render::PropLibrary> library);
    void forget_hands();             // the next picture poses them as in a first frame
    [[nodiscard]] bool has_tools();  // otherwise balls are drawn instead

    // The tool's place for a pointer at this pixel, mm; see LiveView::tool_target_mm.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px, int width_px, int height_px);

    // The pixel of a place in the view's camera with that framing; empty without a photographed room, or
    // behind the eye.
    [[nodiscard]] std::optional<dvec2> project_framed(View view, const Framing& framing, int width_px,
                                                      int height_px, const dvec3& place_mm);
    // The camera of a picture of this size.
    [[nodiscard]] const render::Camera& camera_now(int width_px, int height_px);

    [[nodiscard]] ecs::Registry& registry() { return registry_; }
    [[nodiscard]] ecs::Entity clay() const { return clay_; }
    [[nodiscard]] ecs::Entity tool() const { return tool_; }
    [[nodiscard]] ecs::Entity camera() const { return camera_; }

  private:
    ecs::Registry registry_;
    ecs::Schedule<FrameContext> schedule_ = wheel_schedule();
    FrameContext context_;
    ecs::Entity clay_;
    ecs::Entity tool_;
    ecs::Entity second_tool_;
    ecs::Entity shelf_;
    ecs::Entity camera_;
};

// A wheel scene with the workshop and the installed tools, ready for its first picture. Main thread; blocks
// while it reads.
struct OpenedScene {
    std::unique_ptr<WheelScene> scene;  // never null
    std::string lack = {};  // why it shows another room, or balls for tools; empty without a fault
    std::string note = {};  // what of the room's model is not drawn; empty: all is
};

// `folder`: of a photographed room, or of a room that has only a model (room.glb), or a GLB file itself,
// which is shown in our light and from our cameras; empty: the installed one. An error never prevents
// throwing: the scene then shows the installed room, or if that is faulty the small still life, and reports
// why.
[[nodiscard]] OpenedScene open_scene(const std::filesystem::path& folder, int width_px, int height_px);

}  // namespace onggi::wheel
