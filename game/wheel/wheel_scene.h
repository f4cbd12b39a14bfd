// The potter's-wheel scene: its entities, and the frame that comes of them. Wheel, clay, tool, camera, lights
// and everything that stands about are entities of one registry, and what is drawn comes out of the registry
// and from nowhere else. Main thread.
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
    // With a workshop: the room as its backgrounds show it, as soon as there are some; until then, and
    // without, the small still life of workshop.h. With a model of the room besides, that is drawn, from the
    // workshop's cameras and in its light.
    explicit WheelScene(std::shared_ptr<const Workshop> workshop = nullptr, RoomModel model = {});

    // Cameras whose backgrounds a picture of this shape wants to show and has not got.
    [[nodiscard]] std::vector<const BackgroundCamera*> missing_backgrounds(int width_px, int height_px);
    void add_background(const std::string& camera_name, std::shared_ptr<const render::Background> background);
    // Forgets those that a picture of this shape does not show, as far as it has others to show instead.
    void drop_backgrounds_of_other_shapes(int width_px, int height_px);
    [[nodiscard]] bool has_backgrounds();
    [[nodiscard]] std::shared_ptr<const Workshop> workshop();  // null: there is none
    // The camera is cut to another view when a frame has said that it is ready (see render::FrameStats), and
    // that fades in.
    void look_at(View view);
    void set_framing(const Framing& framing);
    void next_view_is_ready();
    void move_less(bool less);  // nothing fades
    void jump();                // with the next frame the camera is where it is wanted: nobody sees it now
    void sway(bool sways);      // slowly from side to side, while nobody throws
    void set_evening(double evening);  // 0 day to 1 evening, in about a second

    // Runs every system for a picture of this size, dt_s after the one before (0: a still, in which nothing
    // is on its way). The scene it gives is good until the next call.
    const render::Scene& apply(const WheelView& shown, int width_px, int height_px, double dt_s = 0.0);

    // What hands and tools look like from now on; null: balls.
    void set_tools(std::shared_ptr<const render::PropLibrary> library);
    void forget_hands();             // the next picture shows them as if it were the first
    [[nodiscard]] bool has_tools();  // else balls stand in for them

    // Where a pointer at this pixel puts the tool, mm; see LiveView::tool_target_mm.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px, int width_px, int height_px);

    // Where the camera of a view would show a place if the picture were framed so, pixels; nothing without a
    // photographed room, or behind the eye.
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

// A wheel scene with the workshop and the tools that the program brings, ready for its first picture. Main
// thread; blocks while it reads.
struct OpenedScene {
    std::unique_ptr<WheelScene> scene;  // never null
    std::string lack;  // why it shows another room, or balls for tools, instead; empty: it does not
};

// `folder`: of a photographed room, or of one that has only been modelled (room.glb), or a GLB file itself,
// which is then seen in the light and from the cameras of ours; empty: the one that comes with the program.
// Whatever is wrong with it, a pot can still be thrown: the scene then shows the program's own room, or where
// that is what is wrong, the small still life, and says why.
[[nodiscard]] OpenedScene open_scene(const std::filesystem::path& folder, int width_px, int height_px);

}  // namespace onggi::wheel
