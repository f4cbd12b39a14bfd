// Which contact kernel runs: asked of the processor once, never inside the tick.
#include "game/clay/contact_kernel.h"

#include <cstddef>

#include "game/clay/contact_kernel_variants.h"

namespace onggi::clay {

bool is_supported(KernelVariant variant) {
#if ONGGI_X86_KERNELS
    // The compiler's CPUID query, which also asks whether the system saves the wide registers.
    switch (variant) {
        case KernelVariant::kPlain:
            return true;
        case KernelVariant::kSse:
            return __builtin_cpu_supports("sse4.1") != 0;
        case KernelVariant::kAvx2:
            return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("popcnt") != 0;
    }
    return false;
#else
    return variant == KernelVariant::kPlain;
#endif
}

KernelVariant best_kernel() {
    if (is_supported(KernelVariant::kAvx2)) return KernelVariant::kAvx2;
    if (is_supported(KernelVariant::kSse)) return KernelVariant::kSse;
    return KernelVariant::kPlain;
}

const char* name(KernelVariant variant) {
    switch (variant) {
        case KernelVariant::kPlain:
            return "plain";
        case KernelVariant::kSse:
            return "sse4.1";
        case KernelVariant::kAvx2:
            return "avx2";
    }
    return "unknown";
}

void stop_at_floor(FloorBlock& block, float minimum_radius_mm, unsigned lanes) noexcept {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const bool in_contact = (lanes >> lane & 1U) != 0;
        if (!in_contact || block.new_radius_mm[lane] > minimum_radius_mm) continue;
        const Deformed deformed = stopped_at_floor(block.radius_mm[lane], block.carry_mm[lane],
                                                   block.depth_mm[lane], minimum_radius_mm);
        block.new_radius_mm[lane] = deformed.radius_mm;
        block.new_carry_mm[lane] = deformed.carry_mm;
        block.new_depth_mm[lane] = deformed.depth_mm;
    }
}

void find_contacts(KernelVariant variant, const ContactQuery& query, ContactSums& sums) noexcept {
#if ONGGI_X86_KERNELS
    switch (variant) {
        case KernelVariant::kAvx2:
            return find_contacts_avx2(query, sums);
        case KernelVariant::kSse:
            return find_contacts_sse(query, sums);
        case KernelVariant::kPlain:
            break;
    }
#else
    static_cast<void>(variant);
#endif
    find_contacts_plain(query, sums);
}

}  // namespace onggi::clay
