// The contact kernel with SSE4.1: two registers of four make the eight lanes. The target is set on the
// function alone, so that nothing else of the program needs such a processor.
#include "game/clay/contact_kernel_variants.h"

#if ONGGI_X86_KERNELS
#include <smmintrin.h>

#include <bit>
#include <cstddef>

namespace onggi::clay {
namespace {

constexpr int kHalf = kLanes / 2;

}  // namespace

__attribute__((target("sse4.1"))) void find_contacts_sse(const ContactQuery& query,
                                                         ContactSums& sums) noexcept {
    const __m128 height = _mm_set1_ps(query.element_height_mm);
    const __m128 offset = _mm_set1_ps(query.nearest_offset_mm);
    const __m128 r1 = _mm_set1_ps(query.tool_radius_mm);
    const __m128 reach = _mm_set1_ps(query.reach_mm);
    const __m128 reach_rest = _mm_set1_ps(query.reach_rest_mm);
    const __m128 share = _mm_set1_ps(query.share);
    const __m128 minimum = _mm_set1_ps(query.minimum_radius_mm);
    const __m128 zero = _mm_setzero_ps();
    const __m128 sign = _mm_set1_ps(-0.0F);
    const __m128i lane = _mm_setr_epi32(0, 1, 2, 3);
    const __m128 first = _mm_set1_ps(static_cast<float>(query.first - query.nearest));
    const __m128 end = _mm_set1_ps(static_cast<float>(query.end - query.nearest));

    // [0] are lanes 0 to 3, [1] lanes 4 to 7.
    __m128 widths[2] = {_mm_loadu_ps(sums.depth_times_half_width.data()),
                        _mm_loadu_ps(sums.depth_times_half_width.data() + kHalf)};
    __m128 heights[2] = {_mm_loadu_ps(sums.depth_times_height.data()),
                         _mm_loadu_ps(sums.depth_times_height.data() + kHalf)};
    __m128i contacts = _mm_setzero_si128();

    for (int block = block_start(query.first); block < query.end; block += kLanes) {
        for (int half = 0; half < 2; ++half) {
            const int start = block + half * kHalf;
            const __m128 radius = _mm_load_ps(query.radii_mm + start);
            const __m128 carry = _mm_load_ps(query.carry_mm + start);
            const __m128 k = _mm_cvtepi32_ps(_mm_add_epi32(_mm_set1_epi32(start - query.nearest), lane));
            const __m128 dy = _mm_add_ps(_mm_mul_ps(k, height), offset);
            const __m128 square = _mm_mul_ps(_mm_sub_ps(r1, dy), _mm_add_ps(r1, dy));
            const __m128 rc = _mm_sqrt_ps(_mm_max_ps(square, zero));
            const __m128 sag = _mm_div_ps(_mm_mul_ps(dy, dy), _mm_add_ps(r1, rc));
            __m128 depth =
                _mm_sub_ps(_mm_add_ps(_mm_sub_ps(radius, reach), _mm_sub_ps(carry, reach_rest)), sag);
            const __m128 inside = _mm_and_ps(_mm_cmpge_ps(k, first), _mm_cmplt_ps(k, end));
            const __m128 touching = _mm_and_ps(_mm_cmpgt_ps(depth, zero), inside);
            if (_mm_movemask_ps(touching) == 0) continue;

            if (query.deform) {
                const __m128 step = _mm_sub_ps(carry, _mm_mul_ps(share, depth));
                const __m128 moved = _mm_add_ps(radius, step);
                const __m128 rest = _mm_sub_ps(step, _mm_sub_ps(moved, radius));
                const __m128 floor = _mm_min_ps(radius, minimum);
                const __m128 stopped = _mm_cmple_ps(moved, floor);
                const __m128 deformed = _mm_blendv_ps(radius, _mm_blendv_ps(moved, floor, stopped), touching);
                const __m128 left = _mm_blendv_ps(carry, _mm_andnot_ps(stopped, rest), touching);
                _mm_store_ps(query.radii_mm + start, deformed);
                _mm_store_ps(query.carry_mm + start, left);

                const auto changed = static_cast<unsigned>(_mm_movemask_ps(_mm_cmpneq_ps(deformed, radius)));
                if (changed != 0) {
                    if (sums.first_changed < 0) sums.first_changed = start + std::countr_zero(changed);
                    sums.last_changed = start + 31 - std::countl_zero(changed);
                }
                depth = _mm_andnot_ps(
                    sign,
                    _mm_sub_ps(_mm_add_ps(_mm_sub_ps(deformed, reach), _mm_sub_ps(left, reach_rest)), sag));
            }

            widths[half] = _mm_add_ps(widths[half], _mm_and_ps(touching, _mm_mul_ps(depth, rc)));
            heights[half] = _mm_add_ps(heights[half], _mm_and_ps(touching, _mm_mul_ps(depth, dy)));
            contacts = _mm_sub_epi32(contacts, _mm_castps_si128(touching));  // a true lane is -1
        }
    }

    for (int half = 0; half < 2; ++half) {
        _mm_storeu_ps(sums.depth_times_half_width.data() + half * kHalf, widths[half]);
        _mm_storeu_ps(sums.depth_times_height.data() + half * kHalf, heights[half]);
    }
    std::array<int, kHalf> counts{};
    _mm_storeu_si128(reinterpret_cast<__m128i*>(counts.data()), contacts);
    for (const int count : counts)
        sums.contacts += count;
}

}  // namespace onggi::clay
#endif
