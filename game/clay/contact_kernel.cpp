// The kernel is one template, compiled for four elements at a time (any processor) and for eight (AVX2).
//
// It makes two passes over a few blocks at a time. The first pass is one long dependency chain through a
// square root and a division. The processor overlaps these chains across blocks only while nothing else fills
// its queues. Measured against one pass: a tenth less time with 2000 elements, a quarter less with 200000.
#include "game/clay/contact_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "engine/math/wide_vectors.h"

namespace onggi::clay {
namespace {

template <std::size_t kWide>
struct Register {
    using Reals [[gnu::vector_size(kWide * sizeof(float))]] = float;
    using Ints [[gnu::vector_size(kWide * sizeof(int))]] = int;  // mask of a comparison: all bits set or none

    // The tool's sphere at the height of these elements.
    struct Sphere {
        Reals dy;   // y_i - h1
        Reals rc;   // r1 cos(theta); NaN beyond the sphere
        Reals sag;  // r1 - rc, computed without cancellation
    };
    // An element's values: found by Eq. (1), changed by Eq. (2).
    struct Elements {
        Reals radius;  // R
        Reals carry;   // exact rounding error of R
        Reals depth;   // d1
    };
};

template <typename Reals>
[[gnu::always_inline]] inline void load(const float* from, Reals& numbers) {
    std::memcpy(&numbers, from, sizeof numbers);
}
template <typename Reals>
[[gnu::always_inline]] inline void store(float* into, const Reals& numbers) {
    std::memcpy(into, &numbers, sizeof numbers);
}

// k numbers the elements from the nearest one: the numbers are small, so they are exact as floats.
template <typename Ints, typename Sphere>
[[gnu::always_inline]] inline void find_sphere(const ContactQuery& query, const Ints& k, Sphere& found) {
    const float r1 = query.tool_radius_mm;
    found.dy =
        __builtin_convertvector(k, decltype(found.dy)) * query.element_height_mm + query.nearest_offset_mm;
    found.rc = (r1 - found.dy) * (r1 + found.dy);
    for (std::size_t i = 0; i < sizeof found.rc / sizeof(float); ++i)
        found.rc[i] = std::sqrt(found.rc[i]);
    found.sag = found.dy * found.dy / (r1 + found.rc);
}

// Eq. (1), the proximity with its sign turned. The paper's form, r3 - (rc + R), would lose five digits: it
// subtracts numbers near 60 to find a depth of 0.01.
template <typename Reals, typename Elements>
[[gnu::always_inline]] inline void find_depth(const ContactQuery& query, const Reals& sag, Elements& found) {
    found.depth = ((found.radius - query.reach_mm) + (found.carry - query.reach_rest_mm)) - sag;
}

// Eq. (2). The rounding error is carried over to the next tick. An element that reaches R_min stays there.
template <bool kFloorInReach, typename Elements>
[[gnu::always_inline]] inline void deform(const ContactQuery& query, const Elements& before,
                                          Elements& after) {
    const auto taken = query.fraction * before.depth;
    const auto step = before.carry - taken;
    after.radius = before.radius + step;
    after.carry = step - (after.radius - before.radius);
    after.depth = before.depth - taken;
    if constexpr (kFloorInReach) {
        const auto r_min = decltype(before.radius){} + query.minimum_radius_mm;
        const auto is_at_floor = after.radius <= r_min;
        const auto floor = before.radius < r_min ? before.radius : r_min;
        const auto room = (before.radius - floor) + before.carry;
        after.radius = is_at_floor ? floor : after.radius;
        after.carry = is_at_floor ? decltype(room){} : after.carry;
        after.depth = is_at_floor ? before.depth - room : after.depth;
    }
}

// Whether any element may reach R_min in this tick. An element in contact keeps R' >= R - depth = r3 - rc >=
// r3 - r1, so a tool farther out than R_min + r1 needs no check against the floor.
bool is_floor_in_reach(const ContactQuery& query) {
    constexpr float kSlackMm = 1e-3F;  // far more than the sum of all rounding errors
    return query.reach_mm < query.minimum_radius_mm + kSlackMm;
}

template <std::size_t kWide, bool kFloorInReach>
[[gnu::always_inline]] inline void visit_elements(const ContactQuery& asked, ContactSums& sums) {
    using Reals = typename Register<kWide>::Reals;
    using Ints = typename Register<kWide>::Ints;
    using Sphere = typename Register<kWide>::Sphere;
    using Elements = typename Register<kWide>::Elements;
    constexpr std::size_t kParts = kLanes / kWide;  // registers that make up a block of all lanes
    static_assert(kLanes % kWide == 0);
    constexpr int kStep = kWide;
    constexpr int kChunk = 16 * kLanes;
    const ContactQuery query = asked;  // a copy that no store into the clay can alias
    Ints own{};
    for (int i = 0; i < kStep; ++i)
        own[i] = i;

    std::array<Sphere, 16 * kParts> spheres;  // results of the first pass for the second
    Reals widths[kParts]{};                   // NOLINT: std::array drops their alignment
    Reals heights[kParts]{};                  // NOLINT
    Ints contacts{};
    Ints first = Ints{} + query.end;
    Ints last = Ints{} - 1;
    const int start = query.first - query.first % kLanes;  // of the block that contains `first`
    Ints element = own + start;
    Ints from_nearest = element - query.nearest;
    for (int chunk = start; chunk < query.end; chunk += kChunk) {
        const int end = std::min(chunk + kChunk, query.end);
        Sphere* sphere = spheres.data();
        for (int block = chunk; block < end; block += kLanes) {
            for (std::size_t part = 0; part < kParts; ++part, from_nearest += kStep)
                find_sphere(query, from_nearest, *sphere++);
        }

        sphere = spheres.data();
        for (int block = chunk; block < end; block += kLanes) {
            for (std::size_t part = 0; part < kParts; ++part, element += kStep, ++sphere) {
                float* const radii_mm = query.radii_mm + block + part * kWide;
                float* const carry_mm = query.carry_mm + block + part * kWide;
                Elements found;
                load(radii_mm, found.radius);
                load(carry_mm, found.carry);
                find_depth(query, sphere->sag, found);
                const Ints touching =
                    (found.depth > 0.0F) & (element > query.first - 1) & (element < query.end);
                contacts -= touching;  // a lane in contact is -1
                const Ints here = touching ? element : Ints{} + query.end;
                first = here < first ? here : first;
                last = touching ? element : last;  // element indices only rise

                if (query.deform) {
                    Elements left;
                    deform<kFloorInReach>(query, found, left);
                    store(radii_mm, touching ? left.radius : found.radius);
                    store(carry_mm, touching ? left.carry : found.carry);
                    found.depth = left.depth;
                }

                // Eq. (4) and the sum of Eq. (5), both before their common factors.
                widths[part] += touching ? found.depth * sphere->rc : Reals{};
                heights[part] += touching ? found.depth * sphere->dy : Reals{};
            }
        }
    }
    for (std::size_t part = 0; part < kParts; ++part) {
        store(sums.depth_times_half_width.data() + part * kWide, widths[part]);
        store(sums.depth_times_height.data() + part * kWide, heights[part]);
    }
    int lowest = query.end;
    for (int i = 0; i < kStep; ++i) {
        sums.contacts += contacts[i];
        lowest = std::min(lowest, first[i]);
        sums.last_contact = std::max(sums.last_contact, last[i]);
    }
    if (sums.contacts > 0) sums.first_contact = lowest;
}

void find_contacts_plain(const ContactQuery& query, ContactSums& sums) {
    is_floor_in_reach(query) ? visit_elements<4, true>(query, sums) : visit_elements<4, false>(query, sums);
}
ONGGI_WIDE_VECTORS void find_contacts_wide(const ContactQuery& query, ContactSums& sums) {
    is_floor_in_reach(query) ? visit_elements<8, true>(query, sums) : visit_elements<8, false>(query, sums);
}

}  // namespace

bool is_supported(KernelVariant variant) {
    return variant == KernelVariant::kPlain || has_wide_vectors();
}

KernelVariant best_kernel() {
    return has_wide_vectors() ? KernelVariant::kWide : KernelVariant::kPlain;
}

const char* name(KernelVariant variant) {
    return variant == KernelVariant::kWide ? "wide" : "plain";
}

void find_contacts(KernelVariant variant, const ContactQuery& query, ContactSums& sums) noexcept {
    variant == KernelVariant::kWide ? find_contacts_wide(query, sums) : find_contacts_plain(query, sums);
}

}  // namespace onggi::clay
