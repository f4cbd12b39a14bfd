// How a loop over rings is compiled twice, once for any processor and once for AVX2, from one body: each
// operation is on one ring, so the bits are the same whichever runs. Any thread.
#pragma once

#include "game/clay/contact_kernel.h"
#include "game/clay/contact_kernel_variants.h"  // ONGGI_X86_KERNELS

// The body goes into each variant whole, and takes that variant's instructions.
#define ONGGI_LANES inline __attribute__((always_inline))

namespace onggi::clay::studio {

// Whether this processor runs the AVX2 variants.
inline bool has_wide_lanes() {
    return best_kernel() == KernelVariant::kAvx2;
}

}  // namespace onggi::clay::studio
