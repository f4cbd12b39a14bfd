#include "tests/support/paper_reference.h"

#include <cmath>

namespace onggi::clay {

PaperReference::PaperReference(const PaperLump& lump) {
    const double height_mm = lump.height_mm / lump.element_count;
    for (int i = 0; i < lump.element_count; ++i) {
        elements_.push_back({.centre_mm = {0.0, (i + 0.5) * height_mm, 0.0},
                             .radius_mm = lump.radius_mm,
                             .height_mm = height_mm,
                             .top_normal = {0.0, 1.0, 0.0}});
    }
}

void PaperReference::set_radius_mm(int first, int count, double radius_mm) {
    for (int i = first; i < first + count; ++i)
        elements_[static_cast<std::size_t>(i)].radius_mm = radius_mm;
}

ContactForces PaperReference::tick(const ToolInput& tool, const PaperParameters& parameters) {
    const dvec3 p2 = tool.position_mm;
    const double r1 = tool.radius_mm;
    const double h1 = p2.y;
    const double r3 = std::sqrt(p2.x * p2.x + p2.z * p2.z);
    if (r3 > 0.0) radial_unit_ = dvec3(p2.x, 0.0, p2.z) / r3;
    const dvec3 v1 = first_tick_ ? dvec3(0.0) : (p2 - previous_position_mm_) * parameters.rate_hz;
    previous_position_mm_ = p2;
    first_tick_ = false;

    const double c1 = parameters.softness_c1_per_mm;
    if (c1 != fraction_c1_ || r1 != fraction_r1_ || parameters.rate_hz != fraction_rate_hz_) {
        fraction_c1_ = c1;
        fraction_r1_ = r1;
        fraction_rate_hz_ = parameters.rate_hz;
        fraction_ = 1.0 - std::pow(1.0 - 1.0 / (c1 * r1), 1000.0 / parameters.rate_hz);
    }
    const double k =
        tool.wheel_turning ? parameters.stiffness_turning_n_per_mm : parameters.stiffness_standing_n_per_mm;

    int contacts = 0;
    int first_touched = -1;
    int last_touched = -1;
    dvec3 sum_of_forces(0.0);
    const int count = static_cast<int>(elements_.size());
    for (int i = 0; i < count; ++i) {
        PaperElement& element = elements_[static_cast<std::size_t>(i)];
        const double h2 = element.centre_mm.y;
        if (std::fabs(h2 - h1) > r1) continue;
        const double r1_cos_theta = std::sqrt(r1 * r1 - (h2 - h1) * (h2 - h1));
        double proximity = -(r1_cos_theta + element.radius_mm) + r3;  // Eq. (1)
        if (proximity >= 0.0) continue;
        ++contacts;
        if (tool.wheel_turning) {
            const double before = element.radius_mm;
            element.radius_mm -= std::fabs(proximity) * fraction_;  // Eq. (2)
            if (element.radius_mm < parameters.minimum_radius_mm) {
                element.radius_mm = parameters.minimum_radius_mm;
            }
            if (element.radius_mm != before) {
                if (first_touched < 0) first_touched = i;
                last_touched = i;
            }
            proximity = -(r1_cos_theta + element.radius_mm) + r3;
        }
        const double d1 = std::fabs(proximity);
        const dvec3 p1 = p2 - r1_cos_theta * radial_unit_ - (h1 - h2) * element.top_normal;
        sum_of_forces += k * d1 * (p2 - p1) / glm::length(p2 - p1);  // Eq. (4)
    }

    ContactForces forces;
    if (contacts == 0) return forces;
    forces.contacts = contacts;
    if (first_touched >= 0) {
        forces.first_touched = first_touched;
        forces.touched_count = last_touched - first_touched + 1;
    }
    forces.stiffness_n = sum_of_forces / static_cast<double>(contacts);  // Eq. (5)
    forces.viscosity_n = -parameters.viscosity_c2_n_s_per_mm * v1;       // Eq. (6)
    if (tool.wheel_turning && r3 > 0.0) {
        const dvec3 p3(0.0, p2.y, 0.0);
        forces.friction_n = parameters.friction_c3_n_s_per_mm * parameters.wheel_speed_rad_s * r3 *
                            glm::cross((p3 - p2) / glm::length(p3 - p2), dvec3(0.0, 1.0, 0.0));  // Eq. (7)
    }
    return forces;
}

}  // namespace onggi::clay
