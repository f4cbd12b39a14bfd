// The contact kernel with AVX2: one register holds the eight lanes. The target is set on the function alone,
// so that nothing else of the program needs such a processor.
#include "game/clay/contact_kernel_variants.h"

#if ONGGI_X86_KERNELS
#include <immintrin.h>

#include <bit>

namespace onggi::clay {

__attribute__((target("avx2"))) void find_contacts_avx2(const ContactQuery& query,
                                                        ContactSums& sums) noexcept {
    const __m256 height = _mm256_set1_ps(query.element_height_mm);
    const __m256 offset = _mm256_set1_ps(query.nearest_offset_mm);
    const __m256 r1 = _mm256_set1_ps(query.tool_radius_mm);
    const __m256 reach = _mm256_set1_ps(query.reach_mm);
    const __m256 reach_rest = _mm256_set1_ps(query.reach_rest_mm);
    const __m256 share = _mm256_set1_ps(query.share);
    const __m256 minimum = _mm256_set1_ps(query.minimum_radius_mm);
    const __m256 zero = _mm256_setzero_ps();
    const __m256 sign = _mm256_set1_ps(-0.0F);
    // Element numbers counted from the nearest one: small, and exact as floats.
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256 first = _mm256_set1_ps(static_cast<float>(query.first - query.nearest));
    const __m256 end = _mm256_set1_ps(static_cast<float>(query.end - query.nearest));

    __m256 widths = _mm256_loadu_ps(sums.depth_times_half_width.data());
    __m256 heights = _mm256_loadu_ps(sums.depth_times_height.data());
    __m256i contacts = _mm256_setzero_si256();

    for (int block = block_start(query.first); block < query.end; block += kLanes) {
        const __m256 radius = _mm256_load_ps(query.radii_mm + block);
        const __m256 carry = _mm256_load_ps(query.carry_mm + block);
        const __m256 k = _mm256_cvtepi32_ps(_mm256_add_epi32(_mm256_set1_epi32(block - query.nearest), lane));
        const __m256 dy = _mm256_add_ps(_mm256_mul_ps(k, height), offset);
        const __m256 square = _mm256_mul_ps(_mm256_sub_ps(r1, dy), _mm256_add_ps(r1, dy));
        const __m256 rc = _mm256_sqrt_ps(_mm256_max_ps(square, zero));
        const __m256 sag = _mm256_div_ps(_mm256_mul_ps(dy, dy), _mm256_add_ps(r1, rc));
        __m256 depth =
            _mm256_sub_ps(_mm256_add_ps(_mm256_sub_ps(radius, reach), _mm256_sub_ps(carry, reach_rest)), sag);
        const __m256 inside =
            _mm256_and_ps(_mm256_cmp_ps(k, first, _CMP_GE_OQ), _mm256_cmp_ps(k, end, _CMP_LT_OQ));
        const __m256 touching = _mm256_and_ps(_mm256_cmp_ps(depth, zero, _CMP_GT_OQ), inside);
        if (_mm256_movemask_ps(touching) == 0) continue;

        if (query.deform) {
            const __m256 step = _mm256_sub_ps(carry, _mm256_mul_ps(share, depth));
            const __m256 moved = _mm256_add_ps(radius, step);
            const __m256 rest = _mm256_sub_ps(step, _mm256_sub_ps(moved, radius));
            const __m256 floor = _mm256_min_ps(radius, minimum);
            const __m256 stopped = _mm256_cmp_ps(moved, floor, _CMP_LE_OQ);
            const __m256 deformed =
                _mm256_blendv_ps(radius, _mm256_blendv_ps(moved, floor, stopped), touching);
            const __m256 left = _mm256_blendv_ps(carry, _mm256_andnot_ps(stopped, rest), touching);
            _mm256_store_ps(query.radii_mm + block, deformed);
            _mm256_store_ps(query.carry_mm + block, left);

            const auto changed =
                static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(deformed, radius, _CMP_NEQ_OQ)));
            if (changed != 0) {
                if (sums.first_changed < 0) sums.first_changed = block + std::countr_zero(changed);
                sums.last_changed = block + 31 - std::countl_zero(changed);
            }
            depth = _mm256_andnot_ps(sign, _mm256_sub_ps(_mm256_add_ps(_mm256_sub_ps(deformed, reach),
                                                                       _mm256_sub_ps(left, reach_rest)),
                                                         sag));
        }

        widths = _mm256_add_ps(widths, _mm256_and_ps(touching, _mm256_mul_ps(depth, rc)));
        heights = _mm256_add_ps(heights, _mm256_and_ps(touching, _mm256_mul_ps(depth, dy)));
        contacts = _mm256_sub_epi32(contacts, _mm256_castps_si256(touching));  // a true lane is -1
    }

    _mm256_storeu_ps(sums.depth_times_half_width.data(), widths);
    _mm256_storeu_ps(sums.depth_times_height.data(), heights);
    std::array<int, kLanes> counts{};
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(counts.data()), contacts);
    for (const int count : counts)
        sums.contacts += count;
}

}  // namespace onggi::clay
#endif
