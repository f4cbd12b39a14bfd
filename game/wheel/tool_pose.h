// Pose of a hand or tool in the picture: its model's place, from the tool's position and the side of the
// clay, eased in time, so that jumps of the device and changes of side are hidden. Pure but for its own
// memory; any thread. mm, s, rad. The wheel's frame: +Y up, the visitor at +Z.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/clay/studio/hand.h"
#include "game/wheel/tool_models.h"

namespace onggi::wheel {

// One hand with its tool in the picture, and the pot around it.
struct DrawnHand {
    dvec3 position_mm{0.0, 260.0, 0.0};  // centre of the contact ball
    double radius_mm = 10.0;
    tool::Tool tool = tool::Tool::kHand;
    tool::Side side = tool::Side::kFree;
    bool shown = true;
    bool touching = false;
    // Properties of the visible pot; see meet().
    double wall_lean = 0.0;        // slope dR/dy of the touched face
    double mouth_radius_mm = 0.0;  // of the pot's opening; 0 without one
    double below_rim_mm = 0.0;     // depth of the touch below the rim
    bool is_second = false;        // the hand assists the first one
    // The hand follows a finger on a screen, which may jump: the hand then leaves and comes back, and moves
    // more slowly while it hovers.
    bool guided = false;
    bool digs = false;  // the thumbs point straight down; `side` is the top
    // Tilt of a pen that guides the hand, of its upper end from upright: to the right, and towards the
    // visitor. The forearm follows; an upright pen, or none, leaves it as it is.
    dvec2 tilt_rad{0.0};
};

// A tool to draw.
struct ShownTool {
    ToolModel model = ToolModel::kHandOuter;
    bool left = false;
    mat4 place{1.0F};
};
struct ToolPicture {
    std::vector<ShownTool> tools;  // a hand and its tool
    std::vector<render::Sphere> shadows;
};

class ToolPose {
  public:
    // Advances by dt_s (0: takes the final pose at once, as for a still).
    void follow(const DrawnHand& hand, double dt_s);
    [[nodiscard]] ToolPicture picture() const;

    // The distance of a coming or leaving hand from the clay, mm; 0 at the clay.
    [[nodiscard]] double away_mm() const { return away_mm_; }

  private:
    void settle(const DrawnHand& hand);
    // Whether the hand's new place is so far away that clay may be in between.
    [[nodiscard]] bool leaps_to(const DrawnHand& hand) const;

    bool is_known_ = false;
    tool::Tool tool_ = tool::Tool::kHand;
    tool::Side side_ = tool::Side::kFree;  // the last side other than kFree
    bool left_ = false;                    // a left hand
    bool narrow_ = false;                  // inside an opening too narrow for a hand
    dvec3 touch_mm_{0.0};
    double yaw_rad_ = 0.0;    // of the model's +X about +Y
    double pitch_rad_ = 0.0;  // lean about the model's +Z
    double away_mm_ = 0.0;
};

// Transform: turns a model's +X by yaw about +Y (counter-clockwise from above), then leans it by pitch about
// its own +Z.
[[nodiscard]] mat4 placed(const dvec3& at_mm, double yaw_rad, double pitch_rad);

}  // namespace onggi::wheel
