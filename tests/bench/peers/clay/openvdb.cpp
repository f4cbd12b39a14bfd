// Sculpting with OpenVDB: the clay is a level set with a voxel per row, and each tick cuts the ball out of it
// where the turning wheel has brought it. It has no force of its own.
#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/MeshToVolume.h>

#include <vector>

#include "model.h"

namespace onggi::peers {
namespace {

constexpr double kTurnATick = 4.0 * kPi / 1000.0;  // 120 rev/min at 1 kHz

class Sculpting : public Model {
  public:
    explicit Sculpting(int rows) : voxel_mm_(kHeightMm / rows) {
        openvdb::initialize();
        constexpr int kCorners = 512;
        std::vector<openvdb::Vec3s> points;
        std::vector<openvdb::Vec4I> quads;
        std::vector<openvdb::Vec3I> triangles;
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2.0 * kPi * i / kCorners;
            for (const double y_mm : {0.0, kHeightMm})
                points.emplace_back(kWallMm * std::cos(angle), y_mm, kWallMm * std::sin(angle));
            const auto at = static_cast<unsigned>(2 * i);
            const auto next = static_cast<unsigned>(2 * ((i + 1) % kCorners));
            quads.emplace_back(at, at + 1, next + 1, next);
            triangles.emplace_back(2 * kCorners, at, next);
            triangles.emplace_back(2 * kCorners + 1, next + 1, at + 1);
        }
        points.emplace_back(0, 0, 0);
        points.emplace_back(0, kHeightMm, 0);
        clay_ = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
            *openvdb::math::Transform::createLinearTransform(voxel_mm_), points, triangles, quads);
    }
    double tick(double depth_mm) override {
        const double reach_mm = kWallMm + kToolMm - depth_mm;
        const openvdb::Vec3f centre(static_cast<float>(reach_mm * std::cos(angle_)),
                                    static_cast<float>(kToolHeightMm),
                                    static_cast<float>(reach_mm * std::sin(angle_)));
        angle_ += kTurnATick;
        const auto ball = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
            static_cast<float>(kToolMm), centre, static_cast<float>(voxel_mm_), 3.0F, false);
        openvdb::tools::csgDifference(*clay_, *ball);
        return 0.0;
    }
    double wall_mm(double y_mm) override {
        const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> distance(*clay_);
        double inside_mm = kWallMm - 2.0;
        double outside_mm = kWallMm + 0.5;
        while (outside_mm - inside_mm > 1e-4) {
            const double middle_mm = 0.5 * (inside_mm + outside_mm);
            (distance.wsSample({middle_mm, y_mm, 0.0}) < 0.0F ? inside_mm : outside_mm) = middle_mm;
        }
        return inside_mm;
    }

  private:
    double voxel_mm_;
    double angle_ = 0.0;
    openvdb::FloatGrid::Ptr clay_;
};

}  // namespace

std::unique_ptr<Model> openvdb_sculpting(int rows) {
    return std::make_unique<Sculpting>(rows);
}

}  // namespace onggi::peers
