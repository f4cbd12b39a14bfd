// The paper clay outside its tick: which parameters it takes, its state as bytes and as a hash.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "engine/core/hash.h"
#include "engine/core/little_endian.h"
#include "game/clay/paper_clay.h"

namespace onggi::clay {
namespace {

// The start state: this head, then N radii, then N carries, each a 32-bit float.
constexpr std::uint32_t kStateTag = 0x314c4350;  // "PCL1"
constexpr std::size_t kHeadBytes = 4 + 4 + 8 + 3 * 8 + 2 * 8 + 4;

// Walks bytes number by number. Precondition of each call: as many bytes are left.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::uint32_t u32() { return little_endian::get<std::uint32_t>(pass(sizeof(std::uint32_t))); }
    float f32() { return little_endian::get_float(pass(sizeof(float))); }
    double f64() { return little_endian::get_double(pass(sizeof(double))); }

  private:
    const std::byte* pass(std::size_t size) {
        at_ += size;
        return bytes_.data() + at_ - size;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

struct Bound {
    std::string_view name;
    double value;
    double least;
    double most;
};

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
    for (const Bound& bound : bounds) {
        if (!(bound.value >= bound.least && bound.value <= bound.most)) {
            return bad_input(fmt::format("clay parameter {}: expected {} to {}, found {}", bound.name,
                                         bound.least, bound.most, bound.value));
        }
    }
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

std::uint64_t PaperClay::state_hash() const {
    StateHash hash;
    hash.add_word(static_cast<std::uint64_t>(element_count_));
    hash.add(height_mm_);
    for (const double coordinate :
         {previous_position_mm_.x, previous_position_mm_.y, previous_position_mm_.z}) {
        hash.add(coordinate);
    }
    hash.add(radial_unit_.x);
    hash.add(radial_unit_.z);
    hash.add_word(has_previous_ ? 1 : 0);
    hash.add(radii_mm());
    hash.add(std::span<const float>(carry_mm_.data(), radii_mm().size()));
    return hash.value();
}

std::vector<std::byte> PaperClay::start_state() const {
    const auto count = static_cast<std::size_t>(element_count_);
    std::vector<std::byte> bytes;
    bytes.reserve(kHeadBytes + count * 2 * sizeof(float));
    using little_endian::put;
    put(bytes, kStateTag);
    put(bytes, static_cast<std::uint32_t>(element_count_));
    put(bytes, height_mm_);
    put(bytes, previous_position_mm_.x);
    put(bytes, previous_position_mm_.y);
    put(bytes, previous_position_mm_.z);
    put(bytes, radial_unit_.x);
    put(bytes, radial_unit_.z);
    put(bytes, std::uint32_t{has_previous_ ? 1U : 0U});
    for (std::size_t i = 0; i < count; ++i)
        put(bytes, radii_mm_[i]);
    for (std::size_t i = 0; i < count; ++i)
        put(bytes, carry_mm_[i]);
    return bytes;
}

Result<PaperClay> PaperClay::from_start_state(std::span<const std::byte> bytes) {
    const auto damaged = [](std::string_view place, std::string_view expected, const auto& found) {
        return bad_input(fmt::format("clay start state, {}: expected {}, found {}", place, expected, found));
    };
    if (bytes.size() < kHeadBytes) {
        return damaged("size", fmt::format("at least {} bytes", kHeadBytes), bytes.size());
    }
    Reader in(bytes);
    if (const std::uint32_t tag = in.u32(); tag != kStateTag) {
        return damaged("tag", fmt::format("{:#010x}", kStateTag), fmt::format("{:#010x}", tag));
    }
    const std::uint32_t count = in.u32();
    if (count < kMinElements || count > kMaxElements) {
        return damaged("element count", fmt::format("{} to {}", kMinElements, kMaxElements), count);
    }
    const std::size_t size = kHeadBytes + std::size_t{count} * 2 * sizeof(float);
    if (bytes.size() != size) {
        return damaged("size", fmt::format("{} bytes for {} elements", size, count), bytes.size());
    }
    const double height_mm = in.f64();
    if (!(height_mm >= kLeastHeightMm && height_mm <= kFarthestMm)) {
        return damaged("height", fmt::format("{} to {} mm", kLeastHeightMm, kFarthestMm), height_mm);
    }

    PaperClay clay({.element_count = static_cast<int>(count), .height_mm = height_mm});
    for (double* coordinate :
         {&clay.previous_position_mm_.x, &clay.previous_position_mm_.y, &clay.previous_position_mm_.z}) {
        *coordinate = in.f64();
        if (!(std::fabs(*coordinate) <= kFarthestMm)) {
            return damaged("previous position", fmt::format("at most {} mm", kFarthestMm), *coordinate);
        }
    }
    clay.radial_unit_ = {in.f64(), 0.0, 0.0};
    clay.radial_unit_.z = in.f64();
    const double length2 =
        clay.radial_unit_.x * clay.radial_unit_.x + clay.radial_unit_.z * clay.radial_unit_.z;
    if (!(std::fabs(length2 - 1.0) < 1e-9)) {
        return damaged("radial direction", "a unit vector", fmt::format("squared length {}", length2));
    }
    const std::uint32_t has_previous = in.u32();
    if (has_previous > 1) return damaged("first tick flag", "0 or 1", has_previous);
    clay.has_previous_ = has_previous == 1;
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = in.f32();
        if (!(radius > 0.0F && radius <= static_cast<float>(kFarthestMm))) {
            return damaged(fmt::format("radius of element {}", i),
                           fmt::format("above 0 and at most {} mm", kFarthestMm), radius);
        }
        clay.radii_mm_[i] = radius;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const float carry = in.f32();
        // A rounding error is at most half an ulp, 2^-24 of the radius.
        if (!(std::fabs(carry) <= clay.radii_mm_[i] * 0x1p-23F)) {
            return damaged(fmt::format("carry of element {}", i), "a rounding error of the radius", carry);
        }
        clay.carry_mm_[i] = carry;
    }
    clay.update_largest_radius();
    return clay;
}

}  // namespace onggi::clay
