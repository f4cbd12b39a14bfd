#include "game/clay/paper_clay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string_view>

#include "game/clay/bounds.h"
#include "game/clay/exact_math.h"
#include "game/clay/state_numbers.h"
#include "game/tool/tool_state.h"

namespace onggi::clay {
namespace {

constexpr double kPaperRateHz = 1000.0;

// Nearer to the axis than this, x^2 + z^2 is subnormal and e_r has no direction.
constexpr double kOnAxisMm = 1e-150;

// Elements this far beyond the largest radius still go to the kernel. Far more than the sum of the kernel's
// rounding errors, and far less than an element's width.
constexpr double kReachSlackMm = 1e-4;

std::size_t padded(int element_count) {
    const int blocks = (element_count + kLanes - 1) / kLanes;
    return static_cast<std::size_t>(blocks) * kLanes;
}

// The elements [first, end); empty if both are equal.
struct Elements {
    int first = 0;
    int end = 0;
};

struct Stack {
    int count;
    double element_height_mm;

    [[nodiscard]] double centre_mm(int i) const { return (i + 0.5) * element_height_mm; }
    [[nodiscard]] int clamped(int i) const { return std::clamp(i, 0, count); }
};

// The elements that the sphere may touch, computed without a loop over them. Applies the height test |y_i -
// h1| <= r1 of section IV.A. Where the tool's centre is outside all clay, also bounds the part of the sphere
// that is inside it.
Elements reachable(const Stack& stack, double h1, double r1, double r3, double largest_radius_mm) {
    const double pitch = stack.element_height_mm;
    const double margin = r1 + 2.0 * pitch;
    if (h1 < -margin || h1 > stack.count * pitch + margin) return {};  // makes the casts below safe

    // Contact needs rc_i > r3 - R_i, and R_i is at most the largest radius.
    const double needed_half_width = r3 - (largest_radius_mm + kReachSlackMm);
    if (needed_half_width >= r1) return {};
    if (needed_half_width > 0.0) {
        const double half_height = std::sqrt(r1 * r1 - needed_half_width * needed_half_width);
        const int first = static_cast<int>((h1 - half_height) / pitch - 0.5) - 1;
        const int end = static_cast<int>((h1 + half_height) / pitch - 0.5) + 3;
        return {stack.clamped(first), stack.clamped(end)};
    }

    // The tool's centre may be inside the clay. There the height test decides contact, so it must be exact.
    int first = stack.clamped(static_cast<int>((h1 - r1) / pitch - 0.5) - 1);
    int end = stack.clamped(static_cast<int>((h1 + r1) / pitch - 0.5) + 3);
    while (first < end && h1 - stack.centre_mm(first) > r1)
        ++first;
    while (end > first && stack.centre_mm(end - 1) - h1 > r1)
        --end;
    return {first, end};
}

// Sums the eight lanes in pairs, in the same order in every build.
double sum_of(const std::array<float, kLanes>& lanes) {
    const auto lane = [&](std::size_t i) { return static_cast<double>(lanes[i]); };
    return ((lane(0) + lane(4)) + (lane(2) + lane(6))) + ((lane(1) + lane(5)) + (lane(3) + lane(7)));
}

bool is_somewhere(const dvec3& position_mm) {
    const auto near = [](double coordinate_mm) { return std::fabs(coordinate_mm) <= kFarthestMm; };
    return near(position_mm.x) && near(position_mm.y) && near(position_mm.z);
}

// Start state: this header, then N radii, then N carries, each a 32-bit float.
constexpr std::uint32_t kStateTag = 0x314c4350;  // "PCL1"
constexpr std::size_t kHeadBytes = 4 + 4 + 8 + 3 * 8 + 2 * 8 + 4;

}  // namespace

dvec3 ContactForces::total_n() const {
    return stiffness_n + viscosity_n + friction_n;  // Eq. (3)
}

PaperClay::PaperClay(const PaperLump& lump)
    : element_count_(lump.element_count),
      height_mm_(lump.height_mm),
      radii_mm_(padded(lump.element_count), static_cast<float>(lump.radius_mm)),
      carry_mm_(padded(lump.element_count), 0.0F),
      kernel_(best_kernel()) {
    assert(lump.element_count >= kMinElements && lump.element_count <= kMaxElements);
    assert(lump.height_mm >= kLeastHeightMm && lump.height_mm <= kFarthestMm);
    assert(lump.radius_mm > 0.0 && lump.radius_mm <= kFarthestMm);
    update_largest_radius();
}

std::span<const float> PaperClay::radii_mm() const {
    return {radii_mm_.data(), static_cast<std::size_t>(element_count_)};
}

void PaperClay::copy_radii_mm(std::span<float> out) const {
    const std::span<const float> radii = radii_mm();
    assert(out.size() == radii.size());
    std::copy(radii.begin(), radii.end(), out.begin());
}

void PaperClay::set_radii_mm(std::span<const float> radii_mm, int first) {
    assert(first >= 0 && radii_mm.size() <= static_cast<std::size_t>(element_count_ - first));
    std::copy(radii_mm.begin(), radii_mm.end(), radii_mm_.begin() + first);
    std::fill_n(carry_mm_.begin() + first, radii_mm.size(), 0.0F);
    if (radii_mm.size() == static_cast<std::size_t>(element_count_)) {
        update_largest_radius();
    } else {
        for (const float radius : radii_mm)
            largest_radius_mm_ = std::max(largest_radius_mm_, radius);
    }
}

void PaperClay::update_largest_radius() {
    const std::span<const float> radii = radii_mm();
    largest_radius_mm_ = *std::max_element(radii.begin(), radii.end());
}

double PaperClay::volume_mm3() const {
    double squares_mm2 = 0.0;
    for (const float radius : radii_mm()) {
        squares_mm2 += static_cast<double>(radius) * static_cast<double>(radius);
    }
    return kPi * squares_mm2 * element_height_mm();
}

void PaperClay::use_kernel(KernelVariant variant) {
    assert(is_supported(variant));
    kernel_ = variant;
}

// Eq. (2)'s 1/(c1 r1) at the rate f. Tool and rate seldom change, so the last result is cached.
double PaperClay::deformation_fraction(double tool_radius_mm, const PaperParameters& parameters) noexcept {
    const double c1_r1 = parameters.softness_c1_per_mm * tool_radius_mm;
    if (c1_r1 != fraction_of_c1_r1_ || parameters.rate_hz != fraction_of_rate_hz_) {
        fraction_of_c1_r1_ = c1_r1;
        fraction_of_rate_hz_ = parameters.rate_hz;
        const double paper_fraction = 1.0 / c1_r1;
        fraction_ = parameters.rate_hz == kPaperRateHz
                        ? paper_fraction
                        : 1.0 - power(1.0 - paper_fraction, kPaperRateHz / parameters.rate_hz);
    }
    return fraction_;
}

ContactForces PaperClay::tick(const ToolInput& tool, const PaperParameters& parameters) noexcept {
    ContactForces forces;
    if (!is_somewhere(tool.position_mm) || !std::isfinite(tool.radius_mm)) return forces;

    // Position.
    const dvec3 p2 = tool.position_mm;
    const double r1 = std::clamp(tool.radius_mm, tool::kMinToolRadiusMm, tool::kMaxToolRadiusMm);
    const dvec3 v1 = has_previous_ ? (p2 - previous_position_mm_) * parameters.rate_hz : dvec3(0.0);
    previous_position_mm_ = p2;
    has_previous_ = true;
    const double h1 = p2.y;
    const double r3 = std::sqrt(p2.x * p2.x + p2.z * p2.z);
    if (r3 > kOnAxisMm) radial_unit_ = {p2.x / r3, 0.0, p2.z / r3};

    // Collision Eq. (1), deformation Eq. (2) and the sums of Eq. (4) and (5), element by element.
    const Stack stack{element_count_, element_height_mm()};
    const Elements elements = reachable(stack, h1, r1, r3, static_cast<double>(largest_radius_mm_));
    if (elements.first >= elements.end) return forces;
    const int nearest = static_cast<int>(h1 / stack.element_height_mm);
    const double reach_mm = r3 - r1;
    const auto reach_rounded_mm = static_cast<float>(reach_mm);
    const ContactQuery query{
        .radii_mm = radii_mm_.data(),
        .carry_mm = carry_mm_.data(),
        .first = elements.first,
        .end = elements.end,
        .nearest = nearest,
        .nearest_offset_mm = static_cast<float>(stack.centre_mm(nearest) - h1),
        .element_height_mm = static_cast<float>(stack.element_height_mm),
        .tool_radius_mm = static_cast<float>(r1),
        .reach_mm = reach_rounded_mm,
        .reach_rest_mm = static_cast<float>(reach_mm - static_cast<double>(reach_rounded_mm)),
        .fraction = tool.wheel_turning ? static_cast<float>(deformation_fraction(r1, parameters)) : 0.0F,
        .minimum_radius_mm = static_cast<float>(parameters.minimum_radius_mm),
        .deform = tool.wheel_turning,
    };
    ContactSums sums;
    find_contacts(kernel_, query, sums);
    if (sums.contacts == 0) return forces;

    forces.contacts = sums.contacts;
    forces.contact_low_mm = sums.first_contact * stack.element_height_mm;
    forces.contact_high_mm = (sums.last_contact + 1) * stack.element_height_mm;
    if (tool.wheel_turning) {
        forces.first_touched = sums.first_contact;
        forces.touched_count = sums.last_contact - sums.first_contact + 1;
    }

    // Eq. (4): K d1_i times (p2 - p1_i)/|p2 - p1_i| = (rc_i/r1) e_r + ((h1 - y_i)/r1) e_Y; Eq. (5): their
    // mean.
    const double stiffness_n_per_mm =
        tool.wheel_turning ? parameters.stiffness_turning_n_per_mm : parameters.stiffness_standing_n_per_mm;
    forces.local_stiffness_n_per_mm = stiffness_n_per_mm;
    const double scale = stiffness_n_per_mm / (r1 * sums.contacts);
    forces.stiffness_n = radial_unit_ * (scale * sum_of(sums.depth_times_half_width));
    forces.stiffness_n.y = -scale * sum_of(sums.depth_times_height);

    // Eq. (6). Subtracted from zero, so that a tool at rest feels 0 and not -0.
    forces.viscosity_n = dvec3(0.0) - v1 * parameters.viscosity_c2_n_s_per_mm;

    // Eq. (7): (p3 - p2)/|p3 - p2| is -e_r, and -e_r x e_Y points the way the surface turns. The printed
    // equation does not depend on how hard the tool presses: the full friction acts at the first touch. A
    // device spares the hand this kick (game/haptic/device_force.h).
    if (tool.wheel_turning) {
        const double size_n = parameters.friction_c3_n_s_per_mm * parameters.wheel_speed_rad_s * r3;
        forces.friction_n = {size_n * radial_unit_.z, 0.0, 0.0 - size_n * radial_unit_.x};
    }
    return forces;
}

Result<void> check(const PaperParameters& parameters) {
    const std::array bounds = {
        Bound{"rate, Hz", parameters.rate_hz, 100.0, 10000.0},
        Bound{"viscosity c2, N s/mm", parameters.viscosity_c2_n_s_per_mm, 0.0, 1.0},
        Bound{"friction c3, N s/mm", parameters.friction_c3_n_s_per_mm, 0.0, 1.0},
        Bound{"stiffness K while turning, N/mm", parameters.stiffness_turning_n_per_mm, 0.0, 100.0},
        Bound{"stiffness K while standing, N/mm", parameters.stiffness_standing_n_per_mm, 0.0, 100.0},
        Bound{"wheel speed v2, rad/s", parameters.wheel_speed_rad_s, 0.0, 100.0},
        Bound{"minimum radius, mm", parameters.minimum_radius_mm, 0.1, 1000.0},
    };
    if (auto checked = check_bounds("clay parameter", bounds); !checked) return checked;
    const double c1 = parameters.softness_c1_per_mm;
    if (!(c1 * tool::kMinToolRadiusMm > 1.0 && c1 <= 1e6)) {
        return bad_input(
            fmt::format("clay parameter softness c1, 1/mm: expected more than {} (so that c1 r1 > 1 for the "
                        "smallest tool, "
                        "{} mm) and at most 1e6, found {}",
                        1.0 / tool::kMinToolRadiusMm, tool::kMinToolRadiusMm, c1));
    }
    return {};
}

template <typename Self, typename Visitor>
void PaperClay::visit_state(Self& self, Visitor& visitor) {
    visit(visitor, self.previous_position_mm_, self.radial_unit_.x, self.radial_unit_.z, self.has_previous_);
    for (auto* column : {&self.radii_mm_, &self.carry_mm_})
        visitor.numbers(std::span(column->data(), static_cast<std::size_t>(self.element_count_)));
}

std::uint64_t PaperClay::state_hash() const {
    StateHasher hash;
    visit(hash, element_count_, height_mm_);
    visit_state(*this, hash);
    return hash.value();
}

std::vector<std::byte> PaperClay::start_state() const {
    StateWriter out;
    visit(out, kStateTag, element_count_, height_mm_);
    visit_state(*this, out);
    return out.take();
}

Result<PaperClay> PaperClay::from_start_state(std::span<const std::byte> bytes) {
    const auto damaged = [](std::string_view place, std::string_view expected, const auto& found) {
        return bad_input(fmt::format("clay start state, {}: expected {}, found {}", place, expected, found));
    };
    if (bytes.size() < kHeadBytes) {
        return damaged("size", fmt::format("at least {} bytes", kHeadBytes), bytes.size());
    }
    StateReader in(bytes);
    std::uint32_t tag = 0;
    std::uint32_t count = 0;
    double height_mm = 0.0;
    visit(in, tag, count, height_mm);
    if (tag != kStateTag)
        return damaged("tag", fmt::format("{:#010x}", kStateTag), fmt::format("{:#010x}", tag));
    if (count < kMinElements || count > kMaxElements)
        return damaged("element count", fmt::format("{} to {}", kMinElements, kMaxElements), count);
    const std::size_t size = kHeadBytes + std::size_t{count} * 2 * sizeof(float);
    if (bytes.size() != size)
        return damaged("size", fmt::format("{} bytes for {} elements", size, count), bytes.size());
    if (!(height_mm >= kLeastHeightMm && height_mm <= kFarthestMm))
        return damaged("height", fmt::format("{} to {} mm", kLeastHeightMm, kFarthestMm), height_mm);

    PaperClay clay({.element_count = static_cast<int>(count), .height_mm = height_mm});
    visit_state(clay, in);
    for (const double coordinate :
         {clay.previous_position_mm_.x, clay.previous_position_mm_.y, clay.previous_position_mm_.z}) {
        if (!(std::fabs(coordinate) <= kFarthestMm))
            return damaged("previous position", fmt::format("at most {} mm", kFarthestMm), coordinate);
    }
    const dvec3& radial = clay.radial_unit_;
    const double length2 = radial.x * radial.x + radial.z * radial.z;
    if (!(std::fabs(length2 - 1.0) < 1e-9))
        return damaged("radial direction", "a unit vector", fmt::format("squared length {}", length2));
    if (const auto flag = in.strange()) return damaged("first tick flag", "0 or 1", *flag);
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = clay.radii_mm_[i];
        if (!(radius > 0.0F && radius <= static_cast<float>(kFarthestMm))) {
            return damaged(fmt::format("radius of element {}", i),
                           fmt::format("above 0 and at most {} mm", kFarthestMm), radius);
        }
        // A rounding error is at most half an ulp, 2^-24 of the radius.
        if (const float carry = clay.carry_mm_[i]; !(std::fabs(carry) <= radius * 0x1p-23F))
            return damaged(fmt::format("carry of element {}", i), "a rounding error of the radius", carry);
    }
    clay.update_largest_radius();
    return clay;
}

}  // namespace onggi::clay
