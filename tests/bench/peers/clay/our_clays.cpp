// The clays of this repository: the paper's (game/clay/paper_clay.h) and the studio's
// (game/clay/studio/studio_clay.h).
#include <vector>

#include "game/clay/paper_clay.h"
#include "game/clay/studio/studio_clay.h"
#include "model.h"

namespace onggi::peers {
namespace {

class Paper : public Model {
  public:
    explicit Paper(int rows)
        : clay_({.element_count = rows, .height_mm = kHeightMm, .radius_mm = kWallMm}),
          straight_(clay_.radii_mm().begin(), clay_.radii_mm().end()) {}
    void restore() override { clay_.set_radii_mm(straight_); }
    double tick(double depth_mm) override {
        return clay_
            .tick({.position_mm = {kWallMm + kToolMm - depth_mm, kToolHeightMm, 0.0},
                   .radius_mm = kToolMm,
                   .wheel_turning = true},
                  parameters_)
            .stiffness_n.x;
    }
    double wall_mm(double y_mm) override {
        return static_cast<double>(
            clay_.radii_mm()[static_cast<std::size_t>(y_mm / clay_.element_height_mm())]);
    }

  private:
    clay::PaperParameters parameters_;
    clay::PaperClay clay_;
    std::vector<float> straight_;
};

class Studio : public Model {
  public:
    explicit Studio(int rows)
        : rows_(rows),
          straight_({.mass_g = 5000.0, .rings = rows, .off_centre_mm = 0.0}),
          clay_(straight_) {
        straight_.set_wall(kWallMm, kWallMm - 1.0, kHeightMm, kHeightMm, rows_);
        straight_.set_wheel_speed(4.0 * kPi);
        restore();
    }
    void restore() override { clay_.restart_from(straight_); }
    double tick(double depth_mm) override {
        tool::ToolState tool;
        tool.position_mm = {kWallMm + kToolMm - depth_mm, kToolHeightMm, 0.0};
        tool.radius_mm = kToolMm;
        tool.wheel_button = true;
        return clay_.tick(tool, {}).hand.stiffness_n.x;
    }
    double wall_mm(double y_mm) override {
        std::vector<double> heights_mm;
        for (int i = 0; i < clay_.ring_count(); ++i)
            heights_mm.push_back(clay_.centre_height_mm(i));
        return interpolated(heights_mm, {clay_.outer_mm().begin(), clay_.outer_mm().end()}, y_mm);
    }

  private:
    int rows_;
    clay::StudioClay straight_;
    clay::StudioClay clay_;
};

}  // namespace

std::unique_ptr<Model> paper_clay(int rows) {
    return std::make_unique<Paper>(rows);
}

std::unique_ptr<Model> studio_clay(int rows) {
    return std::make_unique<Studio>(rows);
}

}  // namespace onggi::peers
