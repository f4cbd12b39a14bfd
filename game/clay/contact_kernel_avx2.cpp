// The contact kernel with AVX2: one register holds the eight lanes. The target is set on the function alone,
// so that nothing else of the program needs such a processor.
#include "game/clay/contact_kernel_variants.h"

#if ONGGI_X86_KERNELS
#include <immintrin.h>

namespace onggi::clay {

__attribute__((target("avx2"))) void find_contacts_avx2(const ContactQuery& query,
                                                        ContactSums& sums) noexcept {
    float* const radii = query.radii_mm;
    float* const carries = query.carry_mm;
    const bool deform = query.deform;
    const __m256 pitch = _mm256_set1_ps(query.element_height_mm);
    const __m256 offset = _mm256_set1_ps(query.nearest_offset_mm);
    const __m256 r1 = _mm256_set1_ps(query.tool_radius_mm);
    const __m256 reach = _mm256_set1_ps(query.reach_mm);
    const __m256 reach_rest = _mm256_set1_ps(query.reach_rest_mm);
    const __m256 share = _mm256_set1_ps(query.share);
    const __m256 minimum = _mm256_set1_ps(query.minimum_radius_mm);

    // Elements are numbered from the nearest one: small numbers, exact as floats.
    const __m256i before_first = _mm256_set1_epi32(query.first - query.nearest - 1);
    const __m256i end = _mm256_set1_epi32(query.end - query.nearest);
    const __m256i next_block = _mm256_set1_epi32(kLanes);
    __m256i k = _mm256_add_epi32(_mm256_set1_epi32(block_start(query.first) - query.nearest),
                                 _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));

    __m256 widths = _mm256_setzero_ps();
    __m256 heights = _mm256_setzero_ps();
    __m256i contacts = _mm256_setzero_si256();
    ChangedRange changed_range;

    for (int block = block_start(query.first); block < query.end;
         block += kLanes, k = _mm256_add_epi32(k, next_block)) {
        const __m256 radius = _mm256_load_ps(radii + block);
        const __m256 carry = _mm256_load_ps(carries + block);
        const __m256 dy = _mm256_add_ps(_mm256_mul_ps(_mm256_cvtepi32_ps(k), pitch), offset);
        const __m256 rc = _mm256_sqrt_ps(_mm256_mul_ps(_mm256_sub_ps(r1, dy), _mm256_add_ps(r1, dy)));
        const __m256 sag = _mm256_div_ps(_mm256_mul_ps(dy, dy), _mm256_add_ps(r1, rc));
        // Eq. (1), the proximity with its sign turned.
        __m256 depth =
            _mm256_sub_ps(_mm256_add_ps(_mm256_sub_ps(radius, reach), _mm256_sub_ps(carry, reach_rest)), sag);
        const __m256i inside =
            _mm256_and_si256(_mm256_cmpgt_epi32(k, before_first), _mm256_cmpgt_epi32(end, k));
        const __m256 touching =
            _mm256_and_ps(_mm256_cmp_ps(depth, _mm256_setzero_ps(), _CMP_GT_OQ), _mm256_castsi256_ps(inside));
        if (_mm256_movemask_ps(touching) == 0) continue;

        if (deform) {
            // Eq. (2), with the rounding error carried on to the next tick.
            const __m256 taken = _mm256_mul_ps(share, depth);
            const __m256 step = _mm256_sub_ps(carry, taken);
            __m256 moved = _mm256_add_ps(radius, step);
            __m256 rest = _mm256_sub_ps(step, _mm256_sub_ps(moved, radius));
            __m256 left = _mm256_sub_ps(depth, taken);
            const __m256 stopped = _mm256_and_ps(_mm256_cmp_ps(moved, minimum, _CMP_LE_OQ), touching);
            if (const int lanes = _mm256_movemask_ps(stopped); lanes != 0) [[unlikely]] {
                FloorBlock at_floor{};
                _mm256_store_ps(at_floor.radius_mm.data(), radius);
                _mm256_store_ps(at_floor.carry_mm.data(), carry);
                _mm256_store_ps(at_floor.depth_mm.data(), depth);
                _mm256_store_ps(at_floor.new_radius_mm.data(), moved);
                _mm256_store_ps(at_floor.new_carry_mm.data(), rest);
                _mm256_store_ps(at_floor.new_depth_mm.data(), left);
                stop_at_floor(at_floor, query.minimum_radius_mm, static_cast<unsigned>(lanes));
                moved = _mm256_load_ps(at_floor.new_radius_mm.data());
                rest = _mm256_load_ps(at_floor.new_carry_mm.data());
                left = _mm256_load_ps(at_floor.new_depth_mm.data());
            }
            depth = left;

            const __m256 deformed = _mm256_blendv_ps(radius, moved, touching);
            _mm256_store_ps(radii + block, deformed);
            _mm256_store_ps(carries + block, _mm256_blendv_ps(carry, rest, touching));
            const __m256i same =
                _mm256_cmpeq_epi32(_mm256_castps_si256(deformed), _mm256_castps_si256(radius));
            changed_range.add(block,
                              ~static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(same))) & 0xFFU);
        }

        // Eq. (4) and the sum of Eq. (5).
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
    changed_range.store(sums);
}

}  // namespace onggi::clay
#endif
