// The contact kernel in plain C++: the one to read first, and the one for processors without SSE4.1.
#include <cmath>
#include <cstddef>

#include "game/clay/contact_kernel_variants.h"

namespace onggi::clay {

void find_contacts_plain(const ContactQuery& query, ContactSums& sums) noexcept {
    const float r1 = query.tool_radius_mm;
    ContactRange range;
    for (int i = query.first; i < query.end; ++i) {
        float& radius = query.radii_mm[i];
        float& carry = query.carry_mm[i];

        const float dy =
            static_cast<float>(i - query.nearest) * query.element_height_mm + query.nearest_offset_mm;
        const float rc = std::sqrt((r1 - dy) * (r1 + dy));
        const float sag = dy * dy / (r1 + rc);
        // Eq. (1), the proximity with its sign turned.
        float depth = ((radius - query.reach_mm) + (carry - query.reach_rest_mm)) - sag;
        if (!(depth > 0.0F)) continue;
        range.add(i, 1U);

        if (query.deform) {
            // Eq. (2), with the rounding error carried on to the next tick.
            const float taken = query.fraction * depth;
            const float step = carry - taken;
            Deformed deformed{.radius_mm = radius + step, .carry_mm = 0.0F, .depth_mm = depth - taken};
            deformed.carry_mm = step - (deformed.radius_mm - radius);
            if (deformed.radius_mm <= query.minimum_radius_mm) {
                deformed = stopped_at_floor(radius, carry, depth, query.minimum_radius_mm);
            }
            radius = deformed.radius_mm;
            carry = deformed.carry_mm;
            depth = deformed.depth_mm;
        }

        // Eq. (4) and the sum of Eq. (5).
        const auto lane = static_cast<std::size_t>(i % kLanes);
        sums.depth_times_half_width[lane] += depth * rc;
        sums.depth_times_height[lane] += depth * dy;
        ++sums.contacts;
    }
    range.store(sums);
}

}  // namespace onggi::clay
