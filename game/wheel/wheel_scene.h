// The potter's-wheel scene: its entities and the frame built from them. Hands, tools on the bench, pots
// beside the haptic loop's clay, camera, lights and the still life are entities of one registry; the drawn
// scene comes only from this registry and the loop's snapshot. Main thread.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/ecs/registry.h"
#include "engine/render/scene.h"
#include "game/haptic/messages.h"
#include "game/wheel/components.h"
#include "game/wheel/workshop.h"

namespace onggi::wheel {

// The pot on the wheel in a frame.
struct SeenPot {
    const pot::Pot* pot = nullptr;
    const render::LatheMaterial* material = nullptr;  // as in PotApart
    const render::LatheMarks* marks = nullptr;
    dvec2 direction{1.0, 0.0};  // (cos, sin) of the angle turned, counter-clockwise from above
    bool is_apart = false;      // true: a pot other than the haptic loop's clay, or with one over it
    // The colour of its clay that sticks to hands and tools.
    vec3 smear{0.3F};
    float wetness = 0.0F;
};

// Input and output of a frame.
struct FrameContext {
    const haptic::Snapshot* snapshot = nullptr;  // with its pot
    int width_px = 0;
    int height_px = 0;
    double dt_s = 0.0;    // since the previous frame; 0: everything is at its goal, as in a still
    render::Scene scene;  // its spans point into the seen pot and the Clay component
    SeenPot seen;
    std::array<DrawnHand, 2> hands;  // of the snapshot
    pot::Pot stacked;                // the clay with the pot that is held over it
};

// The light levels at an evening of 0 to 1: the sun goes, the window dims, a warm lamp stays on the wheel.
[[nodiscard]] render::LightLevels light_levels(double evening);

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
    // and fades it in within a quarter of a second. Needs the photographed room.
    void look_at(View view);
    void set_framing(const Framing& framing);
    void next_view_is_ready();
    void move_less(bool less);  // for visitors who prefer less motion: cuts without fades
    void jump();                // cuts to the wanted view in the next frame, while the scene is covered
    void sway(bool sways);      // slowly from side to side, while the wheel is idle
    void set_evening(double evening);  // 0 day to 1 evening, in about a second; in any room

    // Runs every system for a picture of this size, dt_s after the previous one (0: a still, without
    // animation). The snapshot must have its pot. The returned scene is valid until the next call, and as
    // long as the pot that is seen.
    const render::Scene& apply(const haptic::Snapshot& snapshot, int width_px, int height_px,
                               double dt_s = 0.0);

    // The pot that apply() found on the wheel.
    [[nodiscard]] const SeenPot& seen() const { return context_.seen; }

    // The program's part of the scene besides the haptic loop; each setting stays until it is changed.
    void show_hands(bool shown);
    // The program moves both hands itself; empty: the haptic loop does.
    void lead_hands(const std::optional<std::array<DrawnHand, 2>>& hands);
    // Tilts the first hand as a pen is tilted; see DrawnHand::tilt_rad.
    void tilt_hand(const dvec2& tilt_rad);
    // Holds the wire ready to cut at this height; see Wire.
    void hold_wire(const std::optional<double>& height_mm);
    // The volume cut off since the trimmer was picked up, and the place of the cut; 0 removes the shavings.
    void shave(double shaved_mm3, const dvec3& from_mm);
    // Whether the tool lies at its place on the bench.
    void lay_on_bench(tool::Tool tool, bool lies_there);
    // Puts another pot on the wheel (if the entity is not alive), or replaces that entity's pot.
    // registry().destroy() takes it down again.
    void put_on_wheel(ecs::Entity& entity, const PotApart& pot, const OnWheel& on_wheel = {});

    // Sets the models of hands and tools; null: balls.
    void set_tools(std::shared_ptr<const render::PropLibrary> library);
    void forget_hands();             // the next picture poses them without a transition
    [[nodiscard]] bool has_tools();  // otherwise balls are drawn instead

    // The tool's place for a pointer at this pixel, mm; see LiveView::tool_target_mm.
    [[nodiscard]] std::optional<dvec3> tool_target_mm(double x_px, double y_px, int width_px, int height_px);

    // The pixel of a place in the view's camera with that framing; empty behind the eye or without a
    // photographed room.
    [[nodiscard]] std::optional<dvec2> project_framed(View view, const Framing& framing, int width_px,
                                                      int height_px, const dvec3& place_mm);
    // The camera of a picture of this size.
    [[nodiscard]] const render::Camera& camera_now(int width_px, int height_px);

    [[nodiscard]] ecs::Registry& registry() { return registry_; }
    [[nodiscard]] ecs::Entity clay() const { return clay_; }
    [[nodiscard]] ecs::Entity hand() const { return hands_[0]; }

  private:
    ecs::Registry registry_;
    FrameContext context_;
    ecs::Entity clay_;
    std::array<ecs::Entity, 2> hands_;
    ecs::Entity wire_;
    ecs::Entity shavings_;
    ecs::Entity shelf_;
};

// A wheel scene with the workshop and the installed tools, ready for its first picture. Main thread; blocks
// while it reads.
struct OpenedScene {
    std::unique_ptr<WheelScene> scene;  // never null
    std::string lack = {};  // why it shows another room, or balls for tools; empty if there is no fault
    std::string note = {};  // parts of the room's model that are not drawn; empty if all are
};

// `folder`: a photographed room, a room with only a model (room.glb), or a GLB file, which is shown in the
// workshop's light and from its cameras; empty: the installed room. An error never prevents throwing: the
// scene then shows the installed room, or if that is faulty the small still life, and reports the reason.
[[nodiscard]] OpenedScene open_scene(const std::filesystem::path& folder, int width_px, int height_px);

}  // namespace onggi::wheel
