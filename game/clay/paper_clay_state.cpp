// The paper clay outside its tick: which parameters it takes, its state as bytes and as a hash.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "game/clay/bounds.h"
#include "game/clay/paper_clay.h"
#include "game/clay/state_numbers.h"

namespace onggi::clay {
namespace {

// The start state: this head, then N radii, then N carries, each a 32-bit float.
constexpr std::uint32_t kStateTag = 0x314c4350;  // "PCL1"
constexpr std::size_t kHeadBytes = 4 + 4 + 8 + 3 * 8 + 2 * 8 + 4;

}  // namespace

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
    if (!(c1 * kSmallestToolMm > 1.0 && c1 <= 1e6)) {
        return bad_input(
            fmt::format("clay parameter softness c1, 1/mm: expected more than {} (so that c1 r1 > 1 for the "
                        "smallest tool, "
                        "{} mm) and at most 1e6, found {}",
                        1.0 / kSmallestToolMm, kSmallestToolMm, c1));
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
