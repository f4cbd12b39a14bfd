// The three contact kernels behind find_contacts(); for contact_kernel.cpp only.
//
// Each runs the same operations in the same order on every lane, so their results have the same bits:
//
//   dy    = (i - nearest) element_height + nearest_offset       y_i - h1
//   rc    = sqrt((r1 - dy)(r1 + dy))                            r1 cos(theta); not a number off the sphere
//   sag   = dy^2 / (r1 + rc)                                    r1 - rc, without the cancellation
//   depth = ((R - reach) + (carry - reach_rest)) - sag          -proximity of Eq. (1)
//   in contact where depth > 0 and first <= i < end
//
//   taken = fraction depth                                         Eq. (2)
//   step  = carry - taken
//   R'    = R + step
//   carry'= step - (R' - R)                                     what rounding R' left over, exactly
//   d1    = depth - taken                                       |proximity| with R', for Eq. (4)
//   where R' <= R_min: R' = min(R, R_min), carry' = 0, d1 = depth - ((R - R') + carry)
//
//   sums of d1 rc and d1 dy over the elements in contact        Eq. (5), both before its common factors
//
// Eq. (1) written as r3 - (rc + R) would lose five digits: three numbers near 60 to tell a depth of 0.01.
#pragma once

#include <bit>

#include "game/clay/contact_kernel.h"

#if defined(__x86_64__)
#define ONGGI_X86_KERNELS 1
#else
#define ONGGI_X86_KERNELS 0
#endif

namespace onggi::clay {

void find_contacts_plain(const ContactQuery& query, ContactSums& sums) noexcept;
#if ONGGI_X86_KERNELS
void find_contacts_sse(const ContactQuery& query, ContactSums& sums) noexcept;
void find_contacts_avx2(const ContactQuery& query, ContactSums& sums) noexcept;
#endif

// What Eq. (2) makes of one element: R', carry' and d1.
struct Deformed {
    float radius_mm;
    float carry_mm;
    float depth_mm;
};

// Eq. (2) for an element that has come down to R_min. Given its R, carry and depth before.
inline Deformed stopped_at_floor(float radius_mm, float carry_mm, float depth_mm, float minimum_radius_mm) {
    const float floor = radius_mm < minimum_radius_mm ? radius_mm : minimum_radius_mm;
    const float room = (radius_mm - floor) + carry_mm;
    return {.radius_mm = floor, .carry_mm = 0.0F, .depth_mm = depth_mm - room};
}

// Whether any element may come down to R_min in this tick. One in contact is left with R' >= R - depth =
// r3 - rc >= r3 - r1, so a tool further out than that needs no look at the floor.
inline bool is_floor_in_reach(const ContactQuery& query) {
    constexpr float kSlackMm = 1e-3F;  // far more than all rounding
    return query.reach_mm < query.minimum_radius_mm + kSlackMm;
}

// The floor for a block, where it is in reach. That is seldom, so the wide variants keep it out of their
// registers: they hand over memory. In: R, carry, depth before and R', carry', d1 as they would be without a
// floor; out: the last three.
struct FloorBlock {
    alignas(32) std::array<float, kLanes> radius_mm;
    alignas(32) std::array<float, kLanes> carry_mm;
    alignas(32) std::array<float, kLanes> depth_mm;
    alignas(32) std::array<float, kLanes> new_radius_mm;
    alignas(32) std::array<float, kLanes> new_carry_mm;
    alignas(32) std::array<float, kLanes> new_depth_mm;
};
// Bit b of lanes: lane b is in contact.
void stop_at_floor(FloorBlock& block, float minimum_radius_mm, unsigned lanes) noexcept;

// The first and the last element in contact.
class ContactRange {
  public:
    // Bit b of lanes: element start + b is; at least one. Elements come in rising order.
    void add(int start, unsigned lanes) {
        if (first_start_ < 0) {
            first_start_ = start;
            first_bits_ = lanes;
        }
        last_start_ = start;
        last_bits_ = lanes;
    }
    void store(ContactSums& sums) const {
        if (first_start_ < 0) return;
        sums.first_contact = first_start_ + std::countr_zero(first_bits_);
        sums.last_contact = last_start_ + static_cast<int>(std::bit_width(last_bits_)) - 1;
    }

  private:
    int first_start_ = -1;
    int last_start_ = -1;
    unsigned first_bits_ = 0;
    unsigned last_bits_ = 0;
};

// The first element of the block of eight that element i lies in. Precondition: i >= 0.
constexpr int block_start(int i) {
    return i - i % kLanes;
}

}  // namespace onggi::clay
