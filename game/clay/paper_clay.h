// The paper's clay: a stack of thin cylinders whose radii a spherical tool reduces while the wheel turns. Any
// one thread at a time; the tick allocates nothing, calls nothing outside this room and cannot fail. Units:
// mm, N, s, rad. Frame: +Y up along the wheel axis, origin at the centre of the wheel head.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/math/math.h"
#include "game/clay/contact_kernel.h"

namespace onggi::clay {

constexpr int kMinElements = 100;
constexpr int kMaxElements = 200000;

// No valid tool or clay lies beyond this: larger values mean damage or a broken device.
constexpr double kFarthestMm = 1e6;
// The least height of a lump. It lets every element be numbered exactly as a float, up to kMaxElements.
constexpr double kLeastHeightMm = 1.0;

// A fresh lump.
struct PaperLump {
    int element_count = 2000;  // N, kMinElements to kMaxElements
    double height_mm = 200.0;  // H
    double radius_mm = 60.0;   // R_0
};

// Constants of the equations, with the paper's values where it has them. Set them only after check().
struct PaperParameters {
    double rate_hz = 1000.0;                        // f, the tick rate
    double softness_c1_per_mm = 10.0;               // c1 of Eq. (2); c1 r1 > 1 is enforced
    double viscosity_c2_n_s_per_mm = 0.002;         // c2 of Eq. (6)
    double friction_c3_n_s_per_mm = 0.0001;         // c3 of Eq. (7)
    double stiffness_turning_n_per_mm = 0.1;        // K of Eq. (4) while the wheel turns
    double stiffness_standing_n_per_mm = 0.5;       // K of Eq. (4) while it stands
    double wheel_speed_rad_s = 12.566370614359172;  // v2 of Eq. (7): 120 rev/min = 4 pi rad/s
    double minimum_radius_mm = 2.0;                 // R_min, the floor of Eq. (2)
};

// Refuses parameters that the equations cannot use: a number that is not finite, a rate outside 100 to 10000
// Hz, a c1 with which the smallest tool would have c1 r1 <= 1. The message names the parameter.
Result<void> check(const PaperParameters& parameters);

// The hand in one tick. A position that is not finite, or farther than kFarthestMm, counts as no contact and
// is not remembered.
struct ToolInput {
    dvec3 position_mm{0.0};      // p2, centre of the tool's sphere (the haptic interface point)
    double radius_mm = 10.0;     // r1
    bool wheel_turning = false;  // the paper's stylus button
};

// The clay's action on the tool in one tick.
struct ContactForces {
    int contacts = 0;        // n of Eq. (5): elements in contact
    dvec3 stiffness_n{0.0};  // F_s, Eq. (5)
    dvec3 viscosity_n{0.0};  // F_v, Eq. (6)
    dvec3 friction_n{0.0};   // F_f, Eq. (7)
    int first_touched = 0;   // the elements that Eq. (2) changed lie in
    int touched_count = 0;   // [first_touched, first_touched + touched_count); count 0: no change
    double local_stiffness_n_per_mm = 0.0;  // upper bound of dF_s/d(depth); for devices
    double contact_low_mm = 0.0;            // heights between which all elements in contact lie; for pictures
    double contact_high_mm = 0.0;

    [[nodiscard]] dvec3 total_n() const;  // F, Eq. (3)
};

// The cylindrical element method of G. Han, J. Kim and S. Choi, "Virtual Pottery Modeling with Force Feedback
// Using Cylindrical Element Method": sections IV (elements, collision, deformation) and V (forces).
//
// A tick follows the paper's order, section III.B: position, collision Eq. (1), deformation Eq. (2),
// stiffness Eq. (4) and (5), viscosity Eq. (6), friction Eq. (7), their sum Eq. (3).
//
//   symbol        here                       meaning
//   r1            radius_mm                  radius of the tool's sphere
//   r2, radius_t  radii_mm()[i], R_i         radius of element i, before and after the tick
//   r3            distance of p2 from the wheel axis
//   h1, h2        position_mm.y, y_i         height of the tool; of the element, (i + 0.5) H/N
//   theta         rc_i = r1 cos(theta)       half width of the sphere at the element's height
//   p1            nearest to the axis of the sphere's surface at the element's height
//   p2, p3        position_mm and its projection on the axis
//   d1            depth, |proximity| after the deformation
//   v1, v2        velocity of the tool; angular velocity of the wheel
//   c1, c2, c3, K fields of PaperParameters
//   n             contacts, and in Eq. (7) the axis +Y
//
// Differs: Eq. (2) as printed removes the fraction 1/(c1 r1) of the depth a tick, so a faster rate would make
//   softer clay. The fraction here is 1 - (1 - 1/(c1 r1))^(1000 Hz / f): the paper's at its 1 kHz, and the
//   same clay at every other rate.
// Differs: Eq. (2) stops at R_min, so that no element vanishes.
// Differs: p1 of Eq. (4) lies on the tool, not on the element. Both agree at first touch; on the element the
//   direction divides by zero at r3 = R_i and pulls inward beyond it.
// Differs: a device gets Eq. (6) and Eq. (7) in a form fit for a hand (game/haptic/device_force.h): v1 comes
//   from a window of ticks, and friction is scaled in with the normal force, because as printed it kicks at
//   the first touch. This class returns the forces as printed, and recordings hold them as printed.
// Differs: the tick does not loop over every element. Index arithmetic leaves out those that the sphere
//   cannot reach; the result is the same as if they had been tested.
// Differs: on the axis, where e_r has no direction, the last direction is kept; +X before the first one.
class PaperClay {
  public:
    // Precondition: element count within its limits; height kLeastHeightMm to kFarthestMm; radius above zero,
    // up to kFarthestMm.
    explicit PaperClay(const PaperLump& lump = {});

    [[nodiscard]] int element_count() const { return element_count_; }
    [[nodiscard]] double height_mm() const { return height_mm_; }
    [[nodiscard]] double element_height_mm() const { return height_mm_ / element_count_; }
    // R_i, bottom first; element_count() values.
    [[nodiscard]] std::span<const float> radii_mm() const;
    // For a snapshot. Precondition: out.size() == element_count().
    void copy_radii_mm(std::span<float> out) const;
    // Sets the radii of the elements first, first + 1, ... Precondition: they exist; all finite and above
    // zero.
    void set_radii_mm(std::span<const float> radii_mm, int first = 0);

    // sum of pi R_i^2 H/N, mm^3, in double.
    [[nodiscard]] double volume_mm3() const;

    // One step of 1/f. Precondition: check(parameters) holds.
    ContactForces tick(const ToolInput& tool, const PaperParameters& parameters) noexcept;

    // Hash of everything a later tick depends on, for replay checks. No allocation.
    [[nodiscard]] std::uint64_t state_hash() const;
    // The same state as little-endian bytes, with which a recording starts, and its reader. The reader
    // refuses a wrong size, a count out of its limits and a number that is not finite. kMaxStartStateBytes
    // bounds a reader's buffer.
    [[nodiscard]] std::vector<std::byte> start_state() const;
    static Result<PaperClay> from_start_state(std::span<const std::byte> bytes);

    // For tests. All kernels compute the same bits; the constructor chooses the fastest that this processor
    // supports.
    void use_kernel(KernelVariant variant);
    [[nodiscard]] KernelVariant kernel() const { return kernel_; }

  private:
    double deformation_fraction(double tool_radius_mm, const PaperParameters& parameters) noexcept;
    void update_largest_radius();
    // Visits every number of the state except the clay's size, in a fixed order.
    template <typename Self, typename Visitor>
    static void visit_state(Self& self, Visitor& visitor);

    int element_count_ = 0;
    double height_mm_ = 0.0;
    AlignedFloats radii_mm_;  // R_i rounded to float; padded to whole blocks of eight
    AlignedFloats carry_mm_;  // rounding errors of R_i, so that steps below half an ulp add up
    dvec3 previous_position_mm_{0.0};
    bool has_previous_ = false;         // false before the first tick, which has v1 = 0
    dvec3 radial_unit_{1.0, 0.0, 0.0};  // e_r
    float largest_radius_mm_ = 0.0F;    // upper bound of all radii: they only shrink
    KernelVariant kernel_;
    // Cache of the last fraction of Eq. (2) and its inputs. Not state: never hashed.
    double fraction_of_c1_r1_ = 0.0;
    double fraction_of_rate_hz_ = 0.0;
    double fraction_ = 0.0;
};

}  // namespace onggi::clay
