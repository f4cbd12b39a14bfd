// The contact kernel in plain C++: the one to read first, and the one for processors without SSE4.1.
#include <cmath>
#include <cstddef>

#include "game/clay/contact_kernel_variants.h"

namespace onggi::clay {

void find_contacts_plain(const ContactQuery& query, ContactSums& sums) noexcept {
    const float r1 = query.tool_radius_mm;
    for (int block = block_start(query.first); block < query.end; block += kLanes) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const int i = block + lane;
            float& radius = query.radii_mm[i];
            float& carry = query.carry_mm[i];

            const float dy =
                static_cast<float>(i - query.nearest) * query.element_height_mm + query.nearest_offset_mm;
            const float square = (r1 - dy) * (r1 + dy);
            const float rc = std::sqrt(square > 0.0F ? square : 0.0F);
            const float sag = dy * dy / (r1 + rc);
            // Eq. (1), the proximity with its sign turned.
            float depth = ((radius - query.reach_mm) + (carry - query.reach_rest_mm)) - sag;
            if (!(depth > 0.0F) || i < query.first || i >= query.end) continue;

            if (query.deform) {
                // Eq. (2), with the rounding error carried on to the next tick.
                const float step = carry - query.share * depth;
                float deformed = radius + step;
                float rest = step - (deformed - radius);
                const float floor = radius < query.minimum_radius_mm ? radius : query.minimum_radius_mm;
                if (deformed <= floor) {
                    deformed = floor;
                    rest = 0.0F;
                }
                if (deformed != radius) {
                    if (sums.first_changed < 0) sums.first_changed = i;
                    sums.last_changed = i;
                }
                radius = deformed;
                carry = rest;
                depth = std::fabs(((radius - query.reach_mm) + (carry - query.reach_rest_mm)) - sag);
            }

            // Eq. (4) and the sum of Eq. (5).
            sums.depth_times_half_width[static_cast<std::size_t>(lane)] += depth * rc;
            sums.depth_times_height[static_cast<std::size_t>(lane)] += depth * dy;
            ++sums.contacts;
        }
    }
}

}  // namespace onggi::clay
