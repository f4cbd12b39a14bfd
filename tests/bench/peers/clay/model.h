// What every model of this comparison does: a straight solid cylinder on a wheel head, and a tool that
// presses its side. The tool is a ball of kToolMm. The wheel turns under it, so that in the mean it presses
// as a ring of that cross section does; models without a wheel are pressed by that ring. Units: mm, N, MPa,
// s.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace onggi::peers {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWallMm = 60.0;         // the cylinder's radius
constexpr double kHeightMm = 200.0;      // and height, the paper's lump
constexpr double kToolMm = 10.0;         // r1
constexpr double kToolHeightMm = 100.0;  // of the tool's centre
constexpr double kYoungMpa = 0.1;        // chosen; forces are proportional to it
constexpr double kPoisson = 0.45;
constexpr int kSectors = 64;  // round the axis, for models that are not axisymmetric

// How deep the tool, at its deepest depth_mm in the straight wall, stands in the wall at a height; negative
// outside it.
inline double overlap_mm(double y_mm, double depth_mm) {
    const double away_mm = y_mm - kToolHeightMm;
    if (std::abs(away_mm) >= kToolMm) return -kToolMm;
    return depth_mm - kToolMm + std::sqrt(kToolMm * kToolMm - away_mm * away_mm);
}

// The value at a height, between rows at increasing heights.
inline double interpolated(const std::vector<double>& heights_mm, const std::vector<double>& values,
                           double y_mm) {
    std::size_t above = 1;
    while (above + 1 < heights_mm.size() && heights_mm[above] < y_mm)
        ++above;
    const double part = (y_mm - heights_mm[above - 1]) / (heights_mm[above] - heights_mm[above - 1]);
    return values[above - 1] + part * (values[above] - values[above - 1]);
}

class Model {
  public:
    virtual ~Model() = default;
    // Puts the clay back to the straight wall where a tick would leave less work for the next.
    virtual void restore() {}
    // One tick with the tool at that depth. The force that pushes it out, N.
    virtual double tick(double depth_mm) = 0;
    // The radius of the wall at a height.
    virtual double wall_mm(double y_mm) = 0;
};

struct Peer {
    const char* name;
    std::function<std::unique_ptr<Model>(int rows)> make;  // rows: along the profile
    int most_rows;                                         // more take too long to build, or too much memory
    enum class Force { kOfModulus, kOwnConstants, kNone } force = Force::kOfModulus;
    int ticks_to_force = 1;  // on a fresh wall, until the force counts
    int ticks_to_rest = 1;   // until the shape rests
};

std::unique_ptr<Model> paper_clay(int rows);
std::unique_ptr<Model> studio_clay(int rows);
std::unique_ptr<Model> bullet_soft_body(int rows);
std::unique_ptr<Model> openvdb_sculpting(int rows);
std::unique_ptr<Model> linear_finite_elements(int rows);
std::unique_ptr<Model> corotational_finite_elements(int rows);
std::unique_ptr<Model>
fine_finite_elements();  // the yardstick: squares of degree two, 0.05 mm wide under the tool
std::unique_ptr<Model> long_elements(int rows);
std::unique_ptr<Model> boundary_elements(int rows);

}  // namespace onggi::peers
