// Where a hand or tool is shown: its model's place from where the tool is and which way the clay faces, eased
// in time, so that neither a jump of the device nor a change of side is seen as one. Pure but for its own
// memory; any thread. mm, s, rad. The wheel's frame: +Y up, the visitor at +Z.
#pragma once

#include <vector>

#include "engine/math/math.h"
#include "engine/render/scene.h"
#include "game/clay/studio/hand.h"
#include "game/wheel/tool_models.h"

namespace onggi::wheel {

// What the loop says of one hand, and the clay about it.
struct ToolSight {
    dvec3 centre_mm{0.0, 260.0, 0.0};  // of the ball that touches
    double radius_mm = 10.0;
    clay::StudioTool kind = clay::StudioTool::kHand;
    clay::studio::Side side = clay::studio::Side::kFree;
    bool shown = true;
    bool touching = false;
    double wall_lean = 0.0;        // of the face it touches: how much wider a mm higher up is, mm
    double mouth_radius_mm = 0.0;  // of the pot's opening; 0: none
    bool is_assistant = false;     // the second hand
    double below_rim_mm = 0.0;     // how deep it touches
    bool guided = false;           // see HandView
    bool digs = false;
};

// A tool as it is to be drawn, and the balls that cast its shadow.
struct ShownTool {
    ToolModel model = ToolModel::kHandOuter;
    bool left = false;
    mat4 place{1.0F};
};
struct ToolPicture {
    std::vector<ShownTool> tools;  // a hand and what it holds
    std::vector<render::Sphere> shadows;
};

class ToolPose {
  public:
    // One frame later by dt_s (0: at once, as for a still).
    void follow(const ToolSight& sight, double dt_s);
    [[nodiscard]] ToolPicture picture() const;

    // How far a hand that comes or goes is away from the clay, mm; 0: it is there.
    [[nodiscard]] double away_mm() const { return away_mm_; }

  private:
    void settle(const ToolSight& sight);
    // Where that hand touches is so far from here that there may be clay between.
    [[nodiscard]] bool leaps_to(const ToolSight& sight) const;

    bool is_known_ = false;
    clay::StudioTool kind_ = clay::StudioTool::kHand;
    clay::studio::Side side_ = clay::studio::Side::kFree;  // the last that was not free
    bool left_ = false;                                    // which way the hand comes from
    bool narrow_ = false;                                  // inside where no hand fits
    dvec3 touch_mm_{0.0};
    double yaw_rad_ = 0.0;    // of the model's +X about +Y
    double pitch_rad_ = 0.0;  // and its lean about the model's +Z
    double away_mm_ = 0.0;
};

// A model's +X turned by yaw about +Y (counter-clockwise from above), leaned by pitch about its own +Z.
[[nodiscard]] mat4 placed(const dvec3& at_mm, double yaw_rad, double pitch_rad);

}  // namespace onggi::wheel
