// The three contact kernels behind find_contacts(); for contact_kernel.cpp only.
//
// Each runs the same operations in the same order on every lane, so their results have the same bits:
//
//   dy    = (i - nearest) element_height + nearest_offset       y_i - h1
//   rc    = sqrt(max((r1 - dy)(r1 + dy), 0))                    r1 cos(theta)
//   sag   = dy^2 / (r1 + rc)                                    r1 - rc, without the cancellation
//   depth = ((R - reach) + (carry - reach_rest)) - sag          -proximity of Eq. (1)
//   in contact where depth > 0 and first <= i < end
//
//   step  = carry - share depth                                 Eq. (2)
//   R'    = R + step
//   carry'= step - (R' - R)                                     what rounding R' left over, exactly
//   where R' <= min(R, R_min): R' = min(R, R_min), carry' = 0
//
//   d1    = |((R' - reach) + (carry' - reach_rest)) - sag|      |proximity| after the deformation, for Eq.
//   (4) sums of d1 rc and d1 dy over the lanes in contact           Eq. (5), both before its common factors
//
// Eq. (1) written as r3 - (rc + R) would lose five digits: three numbers near 60 to tell a depth of 0.01.
#pragma once

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

// The first element of the block of eight that element i lies in. Precondition: i >= 0.
constexpr int block_start(int i) {
    return i - i % kLanes;
}

}  // namespace onggi::clay
