// The contact kernel with SSE4.1: two registers of four make the eight lanes. The target is set on the
// function alone, so that nothing else of the program needs such a processor.
#include "game/clay/contact_kernel_variants.h"

#if ONGGI_X86_KERNELS
#include <smmintrin.h>

namespace onggi::clay {
namespace {

constexpr int kHalf = kLanes / 2;

}  // namespace

__attribute__((target("sse4.1"))) void find_contacts_sse(const ContactQuery& query,
                                                         ContactSums& sums) noexcept {
    float* const radii = query.radii_mm;
    float* const carries = query.carry_mm;
    const bool deform = query.deform;
    const bool floor_in_reach = is_floor_in_reach(query);
    const __m128 pitch = _mm_set1_ps(query.element_height_mm);
    const __m128 offset = _mm_set1_ps(query.nearest_offset_mm);
    const __m128 r1 = _mm_set1_ps(query.tool_radius_mm);
    const __m128 reach = _mm_set1_ps(query.reach_mm);
    const __m128 reach_rest = _mm_set1_ps(query.reach_rest_mm);
    const __m128 fraction = _mm_set1_ps(query.fraction);

    // Elements are numbered from the nearest one: small numbers, exact as floats.
    const __m128i before_first = _mm_set1_epi32(query.first - query.nearest - 1);
    const __m128i end = _mm_set1_epi32(query.end - query.nearest);
    const __m128i next_half = _mm_set1_epi32(kHalf);
    __m128i k =
        _mm_add_epi32(_mm_set1_epi32(block_start(query.first) - query.nearest), _mm_setr_epi32(0, 1, 2, 3));

    // [0] are lanes 0 to 3, [1] lanes 4 to 7.
    __m128 widths[2] = {_mm_setzero_ps(), _mm_setzero_ps()};   // NOLINT: std::array drops their alignment
    __m128 heights[2] = {_mm_setzero_ps(), _mm_setzero_ps()};  // NOLINT
    __m128i contacts = _mm_setzero_si128();
    ContactRange range;

    for (int block = block_start(query.first); block < query.end; block += kLanes) {
        for (int half = 0; half < 2; ++half, k = _mm_add_epi32(k, next_half)) {
            const int start = block + half * kHalf;
            const __m128 radius = _mm_load_ps(radii + start);
            const __m128 carry = _mm_load_ps(carries + start);
            const __m128 dy = _mm_add_ps(_mm_mul_ps(_mm_cvtepi32_ps(k), pitch), offset);
            const __m128 rc = _mm_sqrt_ps(_mm_mul_ps(_mm_sub_ps(r1, dy), _mm_add_ps(r1, dy)));
            const __m128 sag = _mm_div_ps(_mm_mul_ps(dy, dy), _mm_add_ps(r1, rc));
            // Eq. (1), the proximity with its sign turned.
            __m128 depth =
                _mm_sub_ps(_mm_add_ps(_mm_sub_ps(radius, reach), _mm_sub_ps(carry, reach_rest)), sag);
            const __m128i inside = _mm_and_si128(_mm_cmpgt_epi32(k, before_first), _mm_cmpgt_epi32(end, k));
            const __m128 touching =
                _mm_and_ps(_mm_cmpgt_ps(depth, _mm_setzero_ps()), _mm_castsi128_ps(inside));
            const auto lanes = static_cast<unsigned>(_mm_movemask_ps(touching));
            if (lanes == 0) continue;
            range.add(start, lanes);

            if (deform) {
                // Eq. (2), with the rounding error carried on to the next tick.
                const __m128 taken = _mm_mul_ps(fraction, depth);
                const __m128 step = _mm_sub_ps(carry, taken);
                __m128 moved = _mm_add_ps(radius, step);
                __m128 rest = _mm_sub_ps(step, _mm_sub_ps(moved, radius));
                __m128 left = _mm_sub_ps(depth, taken);
                if (floor_in_reach) [[unlikely]] {
                    FloorBlock at_floor{};
                    _mm_store_ps(at_floor.radius_mm.data(), radius);
                    _mm_store_ps(at_floor.carry_mm.data(), carry);
                    _mm_store_ps(at_floor.depth_mm.data(), depth);
                    _mm_store_ps(at_floor.new_radius_mm.data(), moved);
                    _mm_store_ps(at_floor.new_carry_mm.data(), rest);
                    _mm_store_ps(at_floor.new_depth_mm.data(), left);
                    stop_at_floor(at_floor, query.minimum_radius_mm, lanes);
                    moved = _mm_load_ps(at_floor.new_radius_mm.data());
                    rest = _mm_load_ps(at_floor.new_carry_mm.data());
                    left = _mm_load_ps(at_floor.new_depth_mm.data());
                }
                depth = left;

                const __m128 deformed = _mm_blendv_ps(radius, moved, touching);
                _mm_store_ps(radii + start, deformed);
                _mm_store_ps(carries + start, _mm_blendv_ps(carry, rest, touching));
            }

            // Eq. (4) and the sum of Eq. (5).
            widths[half] = _mm_add_ps(widths[half], _mm_and_ps(touching, _mm_mul_ps(depth, rc)));
            heights[half] = _mm_add_ps(heights[half], _mm_and_ps(touching, _mm_mul_ps(depth, dy)));
            contacts = _mm_sub_epi32(contacts, _mm_castps_si128(touching));  // a true lane is -1
        }
    }

    _mm_storeu_ps(sums.depth_times_half_width.data(), widths[0]);
    _mm_storeu_ps(sums.depth_times_half_width.data() + kHalf, widths[1]);
    _mm_storeu_ps(sums.depth_times_height.data(), heights[0]);
    _mm_storeu_ps(sums.depth_times_height.data() + kHalf, heights[1]);
    std::array<int, kHalf> counts{};
    _mm_storeu_si128(reinterpret_cast<__m128i*>(counts.data()), contacts);
    for (const int count : counts)
        sums.contacts += count;
    range.store(sums);
}

}  // namespace onggi::clay
#endif
