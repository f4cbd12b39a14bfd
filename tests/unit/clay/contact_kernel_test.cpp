#include "game/clay/contact_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "game/clay/paper_clay.h"
#include "tests/support/paper_gestures.h"

namespace onggi::clay {
namespace {

constexpr KernelVariant kVariants[] = {KernelVariant::kPlain, KernelVariant::kWide};

TEST(ContactKernel, IsTheWidestThisProcessorHas) {
#if defined(__x86_64__)
    // Queried again here through the compiler's run time, to detect a silent fallback.
    const char* expected = __builtin_cpu_supports("avx2") != 0 ? "wide" : "plain";
#else
    const char* expected = "plain";
#endif
    EXPECT_STREQ(name(best_kernel()), expected);
    EXPECT_STREQ(name(PaperClay().kernel()), expected);
    RecordProperty("kernel", name(best_kernel()));
}

TEST(ContactKernel, AlwaysHasThePlainVariant) {
    EXPECT_TRUE(is_supported(KernelVariant::kPlain));
    PaperClay clay;
    clay.use_kernel(KernelVariant::kPlain);
    EXPECT_EQ(clay.kernel(), KernelVariant::kPlain);
    EXPECT_EQ(clay.tick(tool_in_wall(1.0, true), {}).contacts, 88);
}

struct Wall {
    AlignedFloats radii;
    AlignedFloats carry;

    explicit Wall(std::size_t count) : radii(count, 60.0F), carry(count, 0.0F) {
        for (std::size_t i = 0; i < count; ++i) {
            radii[i] += static_cast<float>(i * 7 % 13) * 0.05F;
            carry[i] = static_cast<float>(i * 5 % 11) * 1e-7F - 5e-7F;
        }
    }

    ContactQuery query(int first, int end, bool deform, float reach_mm, float minimum_radius_mm) {
        return {.radii_mm = radii.data(),
                .carry_mm = carry.data(),
                .first = first,
                .end = end,
                .nearest = 101,
                .nearest_offset_mm = 0.013F,
                .element_height_mm = 0.1F,
                .tool_radius_mm = 10.0F,
                .reach_mm = reach_mm,
                .reach_rest_mm = 1.3e-6F,
                .fraction = 0.01F,
                .minimum_radius_mm = minimum_radius_mm,
                .deform = deform};
    }
};

bool same_bits(const AlignedFloats& a, const AlignedFloats& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

// The same operations element by element, in the same order, to the bit.
ContactSums one_by_one(const ContactQuery& query) {
    ContactSums sums;
    const float r1 = query.tool_radius_mm;
    for (int i = query.first; i < query.end; ++i) {
        float& radius = query.radii_mm[i];
        float& carry = query.carry_mm[i];
        const float dy =
            static_cast<float>(i - query.nearest) * query.element_height_mm + query.nearest_offset_mm;
        const float rc = std::sqrt((r1 - dy) * (r1 + dy));
        float depth =
            ((radius - query.reach_mm) + (carry - query.reach_rest_mm)) - dy * dy / (r1 + rc);  // Eq. (1)
        if (!(depth > 0.0F)) continue;
        if (sums.contacts++ == 0) sums.first_contact = i;
        sums.last_contact = i;
        if (query.deform) {  // Eq. (2)
            const float taken = query.fraction * depth;
            const float step = carry - taken;
            const float moved = radius + step;
            const float floor = std::min(radius, query.minimum_radius_mm);
            const bool is_at_floor = moved <= query.minimum_radius_mm;
            depth -= is_at_floor ? (radius - floor) + carry : taken;
            carry = is_at_floor ? 0.0F : step - (moved - radius);
            radius = is_at_floor ? floor : moved;
        }
        sums.depth_times_half_width[static_cast<std::size_t>(i % kLanes)] += depth * rc;  // Eq. (4), (5)
        sums.depth_times_height[static_cast<std::size_t>(i % kLanes)] += depth * dy;
    }
    return sums;
}

// Every first and end within the blocks, far from and at the floor, turning and standing.
TEST(ContactKernel, HasTheBitsOfOneElementAtATimeForEveryRange) {
    for (const bool deform : {false, true}) {
        for (const float minimum_radius_mm : {2.0F, 59.9995F, 60.2F}) {
            for (int first = 64; first < 82; ++first) {
                for (const int length : {0, 1, 3, 8, 9, 64, 101, 118}) {
                    Wall expected_wall(200);
                    const ContactSums expected = one_by_one(
                        expected_wall.query(first, first + length, deform, 59.4F, minimum_radius_mm));
                    for (const KernelVariant variant : kVariants) {
                        if (!is_supported(variant)) continue;
                        Wall wall(200);
                        ContactSums sums;
                        find_contacts(variant,
                                      wall.query(first, first + length, deform, 59.4F, minimum_radius_mm),
                                      sums);
                        ASSERT_EQ(sums.contacts, expected.contacts) << name(variant);
                        ASSERT_EQ(sums.first_contact, expected.first_contact) << name(variant);
                        ASSERT_EQ(sums.last_contact, expected.last_contact) << name(variant);
                        ASSERT_EQ(sums.depth_times_half_width, expected.depth_times_half_width)
                            << name(variant);
                        ASSERT_EQ(sums.depth_times_height, expected.depth_times_height) << name(variant);
                        ASSERT_TRUE(same_bits(wall.radii, expected_wall.radii)) << name(variant);
                        ASSERT_TRUE(same_bits(wall.carry, expected_wall.carry)) << name(variant);
                    }
                }
            }
        }
    }
}

TEST(ContactKernel, TouchesNothingOutsideItsRange) {
    for (const KernelVariant variant : kVariants) {
        if (!is_supported(variant)) continue;
        Wall wall(200);
        const Wall before = wall;
        ContactSums sums;
        find_contacts(variant, wall.query(90, 110, true, 55.0F, 2.0F), sums);
        EXPECT_EQ(sums.contacts, 20);
        for (std::size_t i = 0; i < 200; ++i) {
            if (i < 90 || i >= 110) {
                ASSERT_EQ(wall.radii[i], before.radii[i]) << i;
                ASSERT_EQ(wall.carry[i], before.carry[i]) << i;
            } else {
                ASSERT_LT(wall.radii[i], before.radii[i]) << i;
            }
        }
    }
}

}  // namespace
}  // namespace onggi::clay
