#include "engine/render/shapes/lathe_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>

namespace onggi::render {
namespace {

// The radii of both faces of a ring, and its heights.
struct Ring {
    float outer_mm;
    float inner_mm;
    float bottom_mm;
    float top_mm;
    [[nodiscard]] float middle_mm() const { return 0.5F * (bottom_mm + top_mm); }
};

Ring ring_of(const Lathe& lathe, std::size_t i) {
    const bool stacked = lathe.top_mm.size() == lathe.radii_mm.size();
    const auto number = static_cast<float>(i);
    return {.outer_mm = lathe.radii_mm[i],
            .inner_mm = lathe.inner_mm.size() == lathe.radii_mm.size() ? lathe.inner_mm[i] : 0.0F,
            .bottom_mm = stacked ? (i == 0 ? 0.0F : lathe.top_mm[i - 1]) : number * lathe.element_height_mm,
            .top_mm = stacked ? lathe.top_mm[i] : (number + 1.0F) * lathe.element_height_mm};
}

// Interpolates a face's radius between the middles of two rings; above the last middle it is constant.
ProfilePoint face_at(const Lathe& lathe, std::size_t below, float y_mm, bool inner) {
    const std::size_t above = std::min(below + 1, lathe.radii_mm.size() - 1);
    const Ring low = ring_of(lathe, below);
    const Ring high = ring_of(lathe, above);
    const float run = high.middle_mm() - low.middle_mm();
    const float fraction = run > 0.0F ? std::clamp((y_mm - low.middle_mm()) / run, 0.0F, 1.0F) : 0.0F;
    const float from = inner ? low.inner_mm : low.outer_mm;
    const float to = inner ? high.inner_mm : high.outer_mm;
    return {.radius_mm = from + fraction * (to - from),
            .y_mm = y_mm,
            .along_mm = 0.0F,
            .ring = static_cast<float>(below) + fraction};
}

void add_edge(LatheProfile& profile, const ProfilePoint& outer, const ProfilePoint& inner, float wall_mm) {
    const float across = std::min(profile.rounding_mm, 0.5F * wall_mm);
    const auto add = [&](float radius, float y) {
        profile.points.push_back({.radius_mm = radius, .y_mm = y, .along_mm = 0.0F, .ring = outer.ring});
    };
    for (int step = 1; step <= kQuarterSteps; ++step) {
        const float angle = 0.5F * kPiF * static_cast<float>(step) / kQuarterSteps;
        add(outer.radius_mm - across * (1.0F - std::cos(angle)),
            outer.y_mm + profile.rounding_mm * std::sin(angle));
    }
    if (!profile.hollow) return;
    const bool is_round = wall_mm <= 2.0F * profile.rounding_mm * 1.0001F;
    for (int step = is_round ? kQuarterSteps - 1 : kQuarterSteps; step > 0; --step) {
        const float angle = 0.5F * kPiF * static_cast<float>(step) / kQuarterSteps;
        add(inner.radius_mm + across * (1.0F - std::cos(angle)),
            inner.y_mm + profile.rounding_mm * std::sin(angle));
    }
}

// Samples the outline at increasing positions.
class Walk {
  public:
    explicit Walk(const LatheProfile& profile) : points_(profile.points) {}
    vec2 at(float along_mm) {
        while (next_ + 1 < points_.size() && points_[next_].along_mm < along_mm)
            ++next_;
        const ProfilePoint& from = points_[next_ - 1];
        const ProfilePoint& to = points_[next_];
        const float run = to.along_mm - from.along_mm;
        const float fraction = run > 0.0F ? std::clamp((along_mm - from.along_mm) / run, 0.0F, 1.0F) : 0.0F;
        return {from.radius_mm + fraction * (to.radius_mm - from.radius_mm),
                from.y_mm + fraction * (to.y_mm - from.y_mm)};
    }
    void start_near(float along_mm) {
        const auto found =
            std::lower_bound(points_.begin() + 1, points_.end() - 1, along_mm,
                             [](const ProfilePoint& point, float place) { return point.along_mm < place; });
        next_ = static_cast<std::size_t>(found - points_.begin());
    }

  private:
    const std::vector<ProfilePoint>& points_;
    std::size_t next_ = 1;
};

std::uint32_t packed_normal(vec2 normal) {
    const auto sixteen_bits = [](float value) {
        return static_cast<std::uint32_t>(static_cast<int>((0.5F + 0.5F * value) * 65535.0F + 0.5F));
    };
    return sixteen_bits(normal.x) | sixteen_bits(normal.y) << 16U;
}

// The outward normal of a chord; the solid is on the chord's left.
vec2 outward_of(vec2 chord) {
    const float length = glm::length(chord);
    return length > 1e-6F ? vec2(chord.y, -chord.x) / length : vec2(0.0F, 1.0F);
}

}  // namespace

void build_profile(const Lathe& lathe, LatheProfile& profile) {
    profile.points.clear();
    profile.edge = profile.inside = profile.floor = 0;
    profile.hollow = false;
    profile.height_mm = profile.floor_mm = profile.rounding_mm = 0.0F;
    const std::size_t count = lathe.radii_mm.size();
    if (count == 0) return;
    const Ring top = ring_of(lathe, count - 1);
    profile.height_mm = top.top_mm;
    // The hollow ends above the highest solid ring.
    std::size_t first_hollow = count;
    while (first_hollow > 0 && ring_of(lathe, first_hollow - 1).inner_mm > 0.0F)
        --first_hollow;
    profile.hollow = first_hollow < count && top.outer_mm > top.inner_mm;
    profile.floor_mm = profile.hollow ? ring_of(lathe, first_hollow).bottom_mm : profile.height_mm;
    const float room_mm =
        profile.hollow ? 0.5F * (profile.height_mm - profile.floor_mm) : 0.25F * profile.height_mm;
    const float wall_mm = profile.hollow ? top.outer_mm - top.inner_mm : top.outer_mm;
    profile.rounding_mm = std::clamp(lathe.edge_rounding_mm, 0.0F, std::min(0.5F * wall_mm, room_mm));
    const float wall_top_mm = profile.height_mm - profile.rounding_mm;

    // Up the outside. Rings whose height does not increase are skipped.
    profile.points.push_back({.radius_mm = lathe.radii_mm[0], .y_mm = 0.0F});
    std::size_t last_below = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Ring ring = ring_of(lathe, i);
        const float y_mm = ring.middle_mm();
        if (!(y_mm < wall_top_mm)) break;
        if (!(y_mm > profile.points.back().y_mm) || !std::isfinite(ring.outer_mm)) continue;
        profile.points.push_back({.radius_mm = ring.outer_mm, .y_mm = y_mm, .ring = static_cast<float>(i)});
        last_below = i;
    }
    const ProfilePoint outer_top = face_at(lathe, last_below, wall_top_mm, false);
    profile.points.push_back(outer_top);
    profile.edge = profile.points.size();

    const ProfilePoint inner_top = face_at(lathe, last_below, wall_top_mm, true);
    add_edge(profile, outer_top, inner_top,
             profile.hollow ? outer_top.radius_mm - inner_top.radius_mm : 2.0F * outer_top.radius_mm);
    profile.inside = profile.points.size();
    if (profile.hollow) {
        profile.points.push_back(inner_top);
        for (std::size_t i = last_below + 1; i-- > first_hollow;) {
            const Ring ring = ring_of(lathe, i);
            const float y_mm = ring.middle_mm();
            if (!(y_mm < profile.points.back().y_mm) || !std::isfinite(ring.inner_mm)) continue;
            profile.points.push_back(
                {.radius_mm = ring.inner_mm, .y_mm = y_mm, .ring = static_cast<float>(i)});
        }
        profile.points.push_back({.radius_mm = lathe.inner_mm[first_hollow],
                                  .y_mm = profile.floor_mm,
                                  .ring = static_cast<float>(first_hollow)});
    }
    profile.floor = profile.points.size();
    const ProfilePoint rim = profile.points.back();
    constexpr int kFloorSteps = 4;
    for (int step = 1; step <= kFloorSteps; ++step) {
        const float fraction = static_cast<float>(step) / kFloorSteps;
        profile.points.push_back(
            {.radius_mm = rim.radius_mm * (1.0F - fraction), .y_mm = rim.y_mm, .ring = rim.ring});
    }
    for (std::size_t i = 1; i < profile.points.size(); ++i) {
        const ProfilePoint& before = profile.points[i - 1];
        ProfilePoint& point = profile.points[i];
        point.along_mm =
            before.along_mm + std::hypot(point.radius_mm - before.radius_mm, point.y_mm - before.y_mm);
    }
}

void sample_profile(const LatheProfile& profile, LatheSamples& samples) {
    samples.height_mm = profile.height_mm;
    samples.floor_mm = profile.floor_mm;
    samples.per_mm = profile.height_mm > 0.0F ? LatheSamples::kCount / profile.height_mm : 0.0F;
    samples.inner_mm.fill(0.0F);
    if (profile.empty()) return;
    const auto fill = [&](std::array<float, LatheSamples::kCount>& into, auto first, auto last,
                          float from_mm) {
        // Points in ascending order of height; above the last point the radius is constant.
        auto point = first;
        for (int i = 0; i < LatheSamples::kCount; ++i) {
            const float y_mm = (static_cast<float>(i) + 0.5F) / samples.per_mm;
            if (y_mm < from_mm) continue;
            while (point + 1 != last && (point + 1)->y_mm < y_mm)
                ++point;
            float radius = point->radius_mm;
            if (point + 1 != last) {
                const float run = (point + 1)->y_mm - point->y_mm;
                const float fraction = run > 0.0F ? std::clamp((y_mm - point->y_mm) / run, 0.0F, 1.0F) : 0.0F;
                radius += fraction * ((point + 1)->radius_mm - point->radius_mm);
            }
            into[static_cast<std::size_t>(i)] = radius;
        }
    };
    const auto begin = profile.points.begin();
    const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    // The rounded edge belongs to both faces, divided at its highest point.
    const auto summit =
        std::max_element(begin + at(profile.edge), begin + at(profile.inside),
                         [](const ProfilePoint& a, const ProfilePoint& b) { return a.y_mm < b.y_mm; });
    fill(samples.outer_mm, begin, summit == begin + at(profile.inside) ? summit : summit + 1, 0.0F);
    if (!profile.hollow) return;
    const auto from = std::make_reverse_iterator(begin + at(profile.floor));
    const auto to = std::make_reverse_iterator(summit);
    fill(samples.inner_mm, from, to, profile.floor_mm);
}

float texture_place(const LatheProfile& profile, float along_mm) {
    const float fraction = profile.length_mm() > 0.0F ? along_mm / profile.length_mm() : 0.0F;
    return (0.5F + fraction * (shaders::kProfileTexels - 1)) / shaders::kProfileTexels;
}

void profile_normals(const LatheProfile& profile, float footprint_mm, NormalTexels& texels) {
    texels.fill(packed_normal({0.0F, 1.0F}));
    if (profile.points.size() < 2) return;
    const float texel_mm = profile.length_mm() / (shaders::kProfileTexels - 1);
    // At least two rings, or the steps between them would show.
    const float ring_mm = profile.height_mm / std::max(1.0F, profile.points[profile.edge - 1].ring + 1.0F);
    const float half_mm = 0.5F * std::max({footprint_mm, texel_mm, 2.0F * ring_mm});
    Walk behind(profile);
    Walk ahead(profile);
    // One array per axis, so that the compiler vectorises the last loop.
    constexpr std::size_t kCount = shaders::kProfileTexels;
    struct Axes {
        std::array<float, kCount> r;
        std::array<float, kCount> y;
    };
    const auto normals = std::make_unique<Axes>();
    for (std::size_t i = 0; i < kCount; ++i) {
        const float along_mm = static_cast<float>(i) * texel_mm;
        const vec2 from = behind.at(along_mm - half_mm);
        const vec2 normal = outward_of(ahead.at(along_mm + half_mm) - from);
        normals->r[i] = normal.x;
        normals->y[i] = normal.y;
    }
    // A chord is a box filter, which passes part of a groove of its own length; a second box filter of the
    // same length removes nearly all that remains.
    const auto reach = static_cast<std::size_t>(std::max(0.5F * footprint_mm / texel_mm, 0.0F));
    const auto sums = std::make_unique<Axes>();
    vec2 sum(0.0F);
    for (std::size_t i = 0; i < std::min(reach, kCount); ++i)
        sum += vec2(normals->r[i], normals->y[i]);
    for (std::size_t i = 0; i < kCount; ++i) {
        if (i + reach < kCount) sum += vec2(normals->r[i + reach], normals->y[i + reach]);
        if (i > reach) sum -= vec2(normals->r[i - reach - 1], normals->y[i - reach - 1]);
        sums->r[i] = sum.x;
        sums->y[i] = sum.y;
    }
    for (std::size_t i = 0; i < kCount; ++i) {
        const float length = std::sqrt(sums->r[i] * sums->r[i] + sums->y[i] * sums->y[i]);
        const bool is_known = length > 1e-4F;
        const float fraction = 1.0F / (is_known ? length : 1.0F);
        const vec2 normal(is_known ? sums->r[i] * fraction : normals->r[i],
                          is_known ? sums->y[i] * fraction : normals->y[i]);
        texels[i] = packed_normal(normal);
    }
}

vec2 profile_normal(const LatheProfile& profile, float along_mm, float span_mm) {
    if (profile.points.size() < 2) return {0.0F, 1.0F};
    Walk walk(profile);
    walk.start_near(along_mm - 0.5F * span_mm);
    const vec2 from = walk.at(along_mm - 0.5F * span_mm);
    return outward_of(walk.at(along_mm + 0.5F * span_mm) - from);
}

namespace {

constexpr int kSkyRays = 40;
constexpr int kSkySteps = 14;

// Cosine-distributed directions about +Y on a golden-angle spiral: deterministic, and no two of them are
// coplanar with the axis.
const std::array<vec3, kSkyRays>& sky_rays() {
    static const std::array<vec3, kSkyRays> rays = [] {
        std::array<vec3, kSkyRays> made{};
        for (int i = 0; i < kSkyRays; ++i) {
            const float fraction = (static_cast<float>(i) + 0.5F) / kSkyRays;
            const float flat = std::sqrt(fraction);
            const float angle = 2.39996323F * static_cast<float>(i);
            made[static_cast<std::size_t>(i)] = {flat * std::cos(angle), std::sqrt(1.0F - fraction),
                                                 flat * std::sin(angle)};
        }
        return made;
    }();
    return rays;
}

float smooth_step(float from, float to, float value) {
    const float fraction = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
    return fraction * fraction * (3.0F - 2.0F * fraction);
}

// The cosine of each column's azimuth from the light.
const KeyColumns& column_cosines() {
    static const KeyColumns cosines = [] {
        KeyColumns made{};
        for (int i = 0; i < kKeyColumns; ++i)
            made[static_cast<std::size_t>(i)] = std::cos(kPiF * static_cast<float>(i) / (kKeyColumns - 1));
        return made;
    }();
    return cosines;
}

}  // namespace

float open_outside(const LatheSamples& samples, float radius_mm, float y_mm) {
    constexpr int kStride = 8;    // the horizon is formed by the belly, not by a groove
    float steepest_above = 0.0F;  // tangent of the upper horizon's outward angle from vertical
    float steepest_below = 0.0F;
    const float step_mm = samples.per_mm > 0.0F ? 1.0F / samples.per_mm : 0.0F;
    for (int i = kStride / 2; i < LatheSamples::kCount; i += kStride) {
        const float rise = (static_cast<float>(i) + 0.5F) * step_mm - y_mm;
        const float out = samples.outer_mm[static_cast<std::size_t>(i)] - radius_mm;
        // A nearer horizon is the wall's own slope, which the normal accounts for.
        if (rise > 2.0F * kStride * step_mm) steepest_above = std::max(steepest_above, out / rise);
        if (rise < -2.0F * kStride * step_mm) steepest_below = std::max(steepest_below, out / -rise);
    }
    const auto sine_of_view = [](float tangent) { return 1.0F / std::sqrt(1.0F + tangent * tangent); };
    return 0.5F * (sine_of_view(steepest_above) + sine_of_view(steepest_below));
}

float open_inside(const LatheSamples& samples, float radius_mm, float y_mm, vec2 normal) {
    // The point is (radius, y, 0); its frame: the normal, the tangent around, and their perpendicular.
    const vec2 across(normal.y, -normal.x);
    const float widest = *std::max_element(samples.inner_mm.begin(), samples.inner_mm.end());
    const float reach = 2.0F * widest + (samples.height_mm - y_mm);
    float open = 0.0F;
    for (const vec3& ray : sky_rays()) {
        const vec3 direction(normal.x * ray.y + across.x * ray.x, normal.y * ray.y + across.y * ray.x, ray.z);
        bool seen = direction.y > 0.0F;
        for (int step = 1; seen && step <= kSkySteps; ++step) {
            // Short steps first: the occluder is mostly the adjacent wall.
            const float fraction = static_cast<float>(step) / kSkySteps;
            const float t = reach * fraction * fraction;
            const float y = y_mm + direction.y * t;
            if (y >= samples.height_mm) break;
            const float x = radius_mm + direction.x * t;
            const float z = direction.z * t;
            const float limit = samples.inner_mm[samples.at(y)] + 0.3F;
            seen = x * x + z * z < limit * limit;
        }
        if (seen) open += 1.0F;
    }
    return open / kSkyRays;
}

namespace {

// Samples along a ray towards the light, the same for all azimuths.
struct KeySteps {
    static constexpr std::size_t kCount = 16;
    std::array<float, kCount> t{};
    std::array<float, kCount> one_over_t{};
    std::array<float, kCount> wall_mm{};  // radius of the wall at that height
};
KeySteps key_steps(const LatheSamples& samples, LatheFace face, float y_mm, const KeyRay& key) {
    KeySteps steps;
    const float reach = std::max(samples.height_mm - y_mm, 0.1F) / std::max(key.towards_light.y, 0.05F);
    const auto& wall_mm = face == LatheFace::kOuter ? samples.outer_mm : samples.inner_mm;
    for (std::size_t i = 0; i < KeySteps::kCount; ++i) {
        steps.t[i] = reach * static_cast<float>(i + 1) / KeySteps::kCount;
        steps.one_over_t[i] = 1.0F / steps.t[i];
        steps.wall_mm[i] = wall_mm[samples.at(y_mm + key.towards_light.y * steps.t[i])];
    }
    return steps;
}

// flat: horizontal distance for each unit along the ray; cosine: of the azimuth from the light.
float past_lathe(const KeySteps& steps, LatheFace face, float radius_mm, float cosine, float flat,
                 const KeyRay& key) {
    const float x = radius_mm * cosine;
    const float z2 = radius_mm * radius_mm - x * x;
    const float outwards = face == LatheFace::kOuter ? 1.0F : -1.0F;
    float least = 1e3F;
    for (std::size_t i = 0; i < KeySteps::kCount; ++i) {
        const float ahead = x + flat * steps.t[i];
        const float gap = outwards * (std::sqrt(ahead * ahead + z2) - steps.wall_mm[i]);
        least = std::min(least, gap * steps.one_over_t[i]);
    }
    // Along a convex wall the gap opens slowly where the light grazes. The cosine term already shades that,
    // so only points clearly inside the wall count as hidden.
    if (face == LatheFace::kOuter) return smooth_step(-2.0F * key.tangent, 0.25F * key.tangent, least);
    return smooth_step(-key.tangent, key.tangent, least);
}

}  // namespace

void key_columns(const LatheSamples& samples, LatheFace face, vec2 place, vec2 normal, const KeyRay& key,
                 KeyColumns& columns) {
    const float flat = std::hypot(key.towards_light.x, key.towards_light.z);
    const KeyColumns& cosines = column_cosines();
    // Start a little off the wall to avoid self-shadowing.
    const vec2 from = place + 0.5F * normal;
    const KeySteps steps = key_steps(samples, face, from.y, key);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const float cosine = normal.x * flat * cosines[i] + normal.y * key.towards_light.y;
        // Back faces are dark without a shadow test; the light's soft edge must still fade in.
        const bool may_be_lit = cosine > -0.35F;
        columns[i] = may_be_lit ? past_lathe(steps, face, from.x, cosines[i], flat, key)
                                : (face == LatheFace::kOuter ? 1.0F : 0.0F);
    }
}

namespace {

// Returns the furthest element that a chord from `from` can end at within the tolerance. Each element on the
// way narrows the interval of valid slopes; an end is valid if its own slope is inside.
std::size_t end_of_chord(const LodFace& face, std::size_t from, float tolerance, std::size_t last,
                         float max_span) {
    float lowest = -std::numeric_limits<float>::infinity();
    float highest = std::numeric_limits<float>::infinity();
    std::size_t end = from + 1;
    for (std::size_t to = from + 1; to <= last; ++to) {
        const float run = face.places_mm.empty() ? static_cast<float>(to - from)
                                                 : face.places_mm[to] - face.places_mm[from];
        if (run > max_span && to > from + 1) break;
        const float fraction = 1.0F / std::max(run, 1e-6F);
        const float rise = face.radii_mm[to] - face.radii_mm[from];
        const float slope = rise * fraction;
        if (slope >= lowest && slope <= highest) end = to;
        lowest = std::max(lowest, (rise - tolerance) * fraction);
        highest = std::min(highest, (rise + tolerance) * fraction);
        if (lowest > highest) break;
    }
    return end;
}

// Returns false as soon as more than `room` rings are needed; subtracts the rings it uses from `room`.
bool try_face(const LodFace& face, float tolerance, std::size_t max_step, float max_span, std::size_t& room,
              std::vector<std::uint32_t>& elements) {
    elements.clear();
    if (face.radii_mm.empty()) return true;
    const std::size_t top = face.radii_mm.size() - 1;
    for (std::size_t at = 0;;) {
        if (room == 0) return false;
        --room;
        elements.push_back(static_cast<std::uint32_t>(at));
        if (at >= top) return true;
        at = end_of_chord(face, at, tolerance, std::min(at + max_step, top), max_span);
    }
}

}  // namespace

std::vector<RingChoice> choose_face_rings(std::span<const LodFace> faces, const RingBudget& budget) {
    std::vector<RingChoice> choices(faces.size());
    std::size_t elements = 0;
    float span_mm = 0.0F;
    for (const LodFace& face : faces) {
        elements += face.radii_mm.size();
        if (!face.places_mm.empty()) span_mm += face.places_mm.back() - face.places_mm.front();
    }
    const auto cap = std::max(static_cast<std::size_t>(std::max(budget.max_rings, 0)),
                              2 * std::max<std::size_t>(faces.size(), 1));
    // max_step must not require more rings than the cap.
    const std::size_t shared = std::max<std::size_t>(cap - faces.size(), 1);
    const std::size_t least_step = elements == 0 ? 1 : (elements - 1) / shared + 1;
    const std::size_t max_step = std::max(static_cast<std::size_t>(std::max(budget.max_step, 1)), least_step);
    const float max_span = std::max(budget.max_span_mm, 2.0F * span_mm / static_cast<float>(shared));

    std::vector<std::vector<std::uint32_t>> tried(faces.size());
    const auto try_all = [&](float tolerance) {
        std::size_t room = cap;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            if (!try_face(faces[face], tolerance, max_step, max_span, room, tried[face])) return false;
        }
        for (std::size_t face = 0; face < faces.size(); ++face)
            choices[face] = {.elements = tried[face], .tolerance_mm = tolerance};
        return true;
    };
    float too_fine = 0.0F;
    float tolerance = budget.tolerance_mm;
    while (!try_all(tolerance)) {
        too_fine = tolerance;
        tolerance = std::max(tolerance * 2.0F, 1e-4F);
        if (!std::isfinite(tolerance)) return choices;  // NaN or infinite radii are not drawn
    }
    if (too_fine > 0.0F) {
        // Bisect between the last tolerance that failed and the first that passed; four steps come within 6 %
        // of the smallest.
        for (int halving = 0; halving < 4; ++halving) {
            const float middle = 0.5F * (too_fine + tolerance);
            (try_all(middle) ? tolerance : too_fine) = middle;
        }
    }
    return choices;
}

namespace {

// Interpolates an optional column at a fractional ring; `without` if the column is empty.
float column_at(std::span<const float> column, float ring, float without) {
    if (column.empty()) return without;
    const float last = static_cast<float>(column.size() - 1);
    const float place = std::clamp(ring, 0.0F, last);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, column.size() - 1);
    return column[below] + (place - static_cast<float>(below)) * (column[above] - column[below]);
}

// Visibility test for inside points, across the axis from the eye (x < 0) or on its near side: in the
// vertical plane through eye and axis, no ring above the point may block the line of sight.
class Sight {
  public:
    Sight(const LatheProfile& profile, vec3 eye_mm, float slack_mm)
        : eye_(std::hypot(eye_mm.x, eye_mm.z), eye_mm.y) {
        const std::size_t count = profile.floor - profile.inside;
        const std::size_t stride = std::max<std::size_t>(count / kLevels, 1);
        // From the highest ring of the edge, where the wall is thinnest, downwards.
        for (std::size_t i = profile.inside; i < profile.floor; i += stride)
            rings_.emplace_back(profile.points[i].radius_mm + slack_mm, profile.points[i].y_mm);
        rim_mm_ = profile.height_mm;
    }
    [[nodiscard]] bool reaches(vec2 point) const {
        if (eye_.y <= rim_mm_) return false;
        for (const vec2& ring : rings_) {
            if (ring.y <= point.y) break;
            const float fraction = (ring.y - point.y) / (eye_.y - point.y);
            if (std::abs(point.x + fraction * (eye_.x - point.x)) > ring.x) return false;
        }
        return true;
    }

  private:
    static constexpr std::size_t kLevels = 40;
    vec2 eye_;
    std::vector<vec2> rings_;  // (r, y), from the top
    float rim_mm_ = 0.0F;
};

}  // namespace

std::size_t points_seen(const LatheProfile& profile, vec3 eye_mm, float slack_mm) {
    if (!profile.hollow) return profile.points.size();
    const Sight sight(profile, eye_mm, slack_mm);
    const ProfilePoint& corner = profile.points[profile.floor - 1];
    for (const float fraction : {-0.98F, -0.6F, -0.2F, 0.2F, 0.6F, 0.98F}) {
        if (sight.reaches({fraction * corner.radius_mm, corner.y_mm})) return profile.points.size();
    }
    // From the floor up to the deepest visible point of the far wall.
    std::size_t end = profile.floor;
    while (end > profile.inside) {
        const ProfilePoint& point = profile.points[end - 1];
        if (sight.reaches({-point.radius_mm, point.y_mm})) break;
        --end;
    }
    // A margin, because only forty levels of occluders were tested.
    const float lower_mm = end > profile.inside ? profile.points[end - 1].y_mm - 3.0F - slack_mm : 0.0F;
    while (end > profile.inside && end < profile.floor && profile.points[end].y_mm > lower_mm)
        ++end;
    return std::max(end, profile.inside);
}

LatheRows choose_rows(const LatheProfile& profile, std::size_t seen, const RowBudget& budget) {
    LatheRows chosen;
    if (profile.empty()) return chosen;
    std::vector<std::uint32_t> edge;
    const auto stride = static_cast<std::size_t>(std::max(budget.edge_stride, 1));
    for (std::size_t i = profile.edge + stride - 1; i < profile.inside; i += stride)
        edge.push_back(static_cast<std::uint32_t>(i));
    const std::size_t floor = seen > profile.floor ? profile.points.size() - profile.floor : 0;
    const std::size_t inner_end = std::min(seen, profile.floor);

    // Both walls in ascending order of height.
    std::array<std::vector<float>, 2> radii;
    std::array<std::vector<float>, 2> places;
    for (std::size_t i = 0; i < profile.edge; ++i) {
        radii[0].push_back(profile.points[i].radius_mm);
        places[0].push_back(profile.points[i].y_mm);
    }
    for (std::size_t i = inner_end; i-- > profile.inside;) {
        radii[1].push_back(profile.points[i].radius_mm);
        places[1].push_back(profile.points[i].y_mm);
    }
    const std::array faces{LodFace{radii[0], places[0]}, LodFace{radii[1], places[1]}};
    const int room = budget.max_rows - static_cast<int>(edge.size() + floor);
    const std::vector<RingChoice> walls =
        choose_face_rings(std::span(faces).first(radii[1].empty() ? 1 : 2),
                          {.tolerance_mm = budget.tolerance_mm,
                           .max_rings = room,
                           .max_step = static_cast<int>(profile.points.size()),
                           .max_span_mm = budget.max_span_mm});
    chosen.tolerance_mm = walls.front().tolerance_mm;
    chosen.points = walls.front().elements;
    chosen.points.insert(chosen.points.end(), edge.begin(), edge.end());
    chosen.inside = chosen.points.size();
    if (walls.size() > 1) {
        const std::vector<std::uint32_t>& elements = walls[1].elements;
        for (auto element = elements.rbegin(); element != elements.rend(); ++element)
            chosen.points.push_back(static_cast<std::uint32_t>(inner_end) - 1 - *element);
    }
    for (std::size_t i = 0; i < floor; ++i)
        chosen.points.push_back(static_cast<std::uint32_t>(profile.floor + i));
    return chosen;
}

void fill_rows(const Lathe& lathe, const LatheProfile& profile, const LatheSamples& samples,
               const LatheRows& chosen, std::vector<shaders::RowData>& rows) {
    // Smoothing span of the normal that lights a whole row: wider than a groove.
    constexpr float kNormalSpanMm = 3.0F;
    // Spacing of the ray-marched rows; rows between them are interpolated.
    constexpr float kOpenEveryMm = 9.0F;
    rows.clear();
    float open = 1.0F;
    float open_at_mm = -1e9F;
    std::size_t open_row = 0;
    const auto spread_open = [&](std::size_t row, float value) {
        // Linear between the last ray-marched row and this one.
        const float from = rows[open_row].place.w;
        const float run = rows[row].place.w - from;
        for (std::size_t i = open_row + 1; i < row; ++i)
            rows[i].light.z = open + (value - open) * (run > 0.0F ? (rows[i].place.w - from) / run : 1.0F);
        rows[row].light.z = value;
        open = value;
        open_row = row;
        open_at_mm = rows[row].place.w;
    };
    for (std::size_t row = 0; row < chosen.points.size(); ++row) {
        const ProfilePoint& point = profile.points[chosen.points[row]];
        const bool is_edge = chosen.points[row] >= profile.edge && chosen.points[row] < profile.inside;
        const bool is_inside = profile.hollow && row >= chosen.inside;
        const vec2 normal = profile_normal(profile, point.along_mm, is_edge ? 0.6F : kNormalSpanMm);
        rows.push_back({.place = vec4(point.radius_mm, point.y_mm, texture_place(profile, point.along_mm),
                                      point.along_mm),
                        .light = vec4(normal.x, normal.y, 1.0F, is_inside ? 1.0F : 0.0F),
                        .water = vec4(column_at(lathe.wetness, point.ring, lathe.material.wetness),
                                      column_at(lathe.film, point.ring, lathe.material.film),
                                      column_at(lathe.load, point.ring, 0.0F), 0.0F)});
        const bool is_last = row + 1 == chosen.points.size();
        if (is_edge || (!profile.hollow && row >= chosen.inside)) {
            spread_open(row, 1.0F);
        } else if (is_inside) {
            if (lathe.cut)
                spread_open(row, 0.7F);
            else if (is_last || point.along_mm - open_at_mm >= kOpenEveryMm || row == chosen.inside)
                spread_open(row, open_inside(samples, point.radius_mm - 0.4F, point.y_mm + 0.1F, normal));
        } else {
            spread_open(row, open_outside(samples, point.radius_mm, point.y_mm));
        }
    }
}

namespace {

// Values of a sector's edge that are the same in every row.
struct SectorEdge {
    vec2 outward;         // (x, z)
    std::size_t dent;     // index of the dents' sector below it
    float dent_fraction;  // weight of the next sector
    std::size_t column;   // likewise, of the key light's columns
    float column_fraction;
    float fraction;  // of a turn from +X, or of the way from one side of a cut to the other
    float
        // An inscribed polygon looks thinner than its circle: half of the sag lies outside, half inside.
        straddle;
};

std::vector<SectorEdge> sector_edges(const Lathe& lathe, const DirectionalLight& key,
                                     std::span<const float> angles_rad) {
    const float turned = std::atan2(lathe.turn.y, lathe.turn.x);
    const float light = std::atan2(key.towards_light.z, key.towards_light.x);
    std::vector<SectorEdge> edges;
    edges.reserve(angles_rad.size());
    const std::size_t last = angles_rad.size() - 1;
    const float sweep = angles_rad[last] - angles_rad[0];
    for (std::size_t i = 0; i <= last; ++i) {
        SectorEdge edge{};
        // The last edge of a whole turn equals the first bit by bit.
        const float shown = angles_rad[!lathe.cut && i == last ? 0 : i];
        // The streaks' coordinate is fixed to the lathe, independent of the eye.
        edge.fraction = lathe.cut ? (angles_rad[i] - angles_rad[0]) / sweep : angles_rad[i] / kTurnF;
        const std::size_t from = i > 0 ? i - 1 : 0;
        const float chord = (angles_rad[std::min(i + 1, last)] - angles_rad[from]) /
                            static_cast<float>(std::min(i + 1, last) - from);
        edge.straddle = 1.0F + 0.5F * (1.0F - std::cos(0.5F * chord));
        edge.outward = {std::cos(shown), std::sin(shown)};
        float own = (-shown - turned) / kTurnF;
        // A sector's value applies at its middle.
        own = (own - std::floor(own)) * kDentSectors + kDentSectors - 0.5F;
        edge.dent = static_cast<std::size_t>(own) % kDentSectors;
        edge.dent_fraction = own - std::floor(own);
        float away = std::abs(shown - light);
        away = std::fmod(away, kTurnF);
        if (away > kPiF) away = kTurnF - away;
        const float column = away / kPiF * (kKeyColumns - 1);
        edge.column = std::min(static_cast<std::size_t>(column), static_cast<std::size_t>(kKeyColumns - 2));
        edge.column_fraction = column - static_cast<float>(edge.column);
        edges.push_back(edge);
    }
    return edges;
}

// Dents at one height, and their derivatives.
struct DentRow {
    std::array<float, kDentSectors> off_mm{};
    std::array<float, kDentSectors> rise{};   // per mm of height
    std::array<float, kDentSectors> round{};  // per sector
};

bool dents_at(const Lathe& lathe, float y_mm, float height_mm, DentRow& row) {
    const std::size_t count = lathe.dents_mm.size() / kDentSectors;
    if (count == 0 || height_mm <= 0.0F) return false;
    const float step_mm = height_mm / static_cast<float>(count);
    const float place = std::clamp(y_mm / step_mm - 0.5F, 0.0F, static_cast<float>(count - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, count - 1);
    const float fraction = place - static_cast<float>(below);
    const std::span<const float> low = lathe.dents_mm.subspan(below * kDentSectors, kDentSectors);
    const std::span<const float> high = lathe.dents_mm.subspan(above * kDentSectors, kDentSectors);
    for (std::size_t s = 0; s < kDentSectors; ++s) {
        row.off_mm[s] = low[s] + fraction * (high[s] - low[s]);
        row.rise[s] = above > below ? (high[s] - low[s]) / step_mm : 0.0F;
    }
    // Slopes at the sectors' middles, so that they vary linearly between them and no facet shows.
    for (std::size_t s = 0; s < kDentSectors; ++s)
        row.round[s] =
            0.5F * (row.off_mm[(s + 1) % kDentSectors] - row.off_mm[(s + kDentSectors - 1) % kDentSectors]);
    return true;
}

vec2 centre_at(std::span<const vec2> centres, float ring) {
    const float place = std::clamp(ring, 0.0F, static_cast<float>(centres.size() - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, centres.size() - 1);
    return centres[below] + (place - static_cast<float>(below)) * (centres[above] - centres[below]);
}

}  // namespace

float largest_offset_mm(const Lathe& lathe) {
    float largest = 0.0F;
    for (const float dent : lathe.dents_mm)
        largest = std::max(largest, std::abs(dent));
    float furthest = 0.0F;
    for (const vec2& centre : lathe.centre_mm)
        furthest = std::max(furthest, glm::length(centre));
    return largest + furthest;
}

void fill_vertices(const LatheMeshInput& input, const DirectionalLight& key,
                   std::span<const float> angles_rad, std::vector<shaders::VertexData>& vertices) {
    const Lathe& lathe = input.lathe;
    const std::vector<SectorEdge> edges = sector_edges(lathe, key, angles_rad);
    const KeyRay ray{.towards_light = key.towards_light, .tangent = std::tan(key.angular_radius_rad)};
    const bool off_centre = lathe.centre_mm.size() == lathe.radii_mm.size();
    vertices.clear();
    vertices.reserve(input.rows.size() * edges.size());
    DentRow dents;
    KeyColumns seen{};
    vec2 centre_before(0.0F);
    for (std::size_t row = 0; row < input.rows.size(); ++row) {
        const vec4& place = input.rows[row].place;
        const vec4& light = input.rows[row].light;
        const std::size_t point = input.chosen.points[row];
        const bool is_inside = input.profile.hollow && row >= input.chosen.inside;
        const bool is_edge = point >= input.profile.edge && point < input.profile.inside;
        // Nothing shades the rounded edge or a solid's top. The inside of a cut pot is lit from the front.
        if (is_edge || (row >= input.chosen.inside && (!input.profile.hollow || lathe.cut))) {
            seen.fill(1.0F);
        } else {
            key_columns(input.samples, is_inside ? LatheFace::kInner : LatheFace::kOuter,
                        vec2(place.x, place.y), vec2(light.x, light.y), ray, seen);
        }
        const bool dented = dents_at(lathe, place.y, input.profile.height_mm, dents);
        vec2 centre(0.0F);
        vec2 drift(0.0F);  // of the centre, per mm of height
        if (off_centre) {
            const vec2 own = centre_at(lathe.centre_mm, input.profile.points[point].ring);
            centre = {own.x * lathe.turn.x + own.y * lathe.turn.y,
                      own.y * lathe.turn.x - own.x * lathe.turn.y};
            const float rise = row > 0 ? place.y - input.rows[row - 1].place.y : 0.0F;
            if (std::abs(rise) > 0.2F) drift = (centre - centre_before) / rise;
            centre_before = centre;
        }
        for (const SectorEdge& edge : edges) {
            const float radius = place.x * edge.straddle;
            float off_mm = 0.0F;
            float lean = glm::dot(drift, edge.outward);
            vec2 outward = edge.outward;
            if (dented && place.x > 0.0F) {
                const std::size_t next = (edge.dent + 1) % kDentSectors;
                off_mm = dents.off_mm[edge.dent] +
                         edge.dent_fraction * (dents.off_mm[next] - dents.off_mm[edge.dent]);
                // At the corner the floor moves with the wall, at the axis not at all.
                if (point >= input.profile.floor)
                    off_mm *= place.x / input.profile.points[input.profile.floor - 1].radius_mm;
                lean +=
                    dents.rise[edge.dent] + edge.dent_fraction * (dents.rise[next] - dents.rise[edge.dent]);
                // Sectors run against the angle, so their slope changes sign.
                const float round = dents.round[edge.dent] +
                                    edge.dent_fraction * (dents.round[next] - dents.round[edge.dent]);
                const float slope = -round * kDentSectors / (kTurnF * std::max(radius + off_mm, 1.0F));
                outward -= slope * vec2(-edge.outward.y, edge.outward.x);
                outward /= glm::length(outward);
            }
            const float r = std::max(radius + off_mm, 0.0F);
            vertices.push_back(
                {.place = vec4(
                     centre.x + r * edge.outward.x, place.y, centre.y + r * edge.outward.y,
                     seen[edge.column] + edge.column_fraction * (seen[edge.column + 1] - seen[edge.column])),
                 .lean = vec4(outward.x, lean, outward.y, edge.fraction)});
        }
    }
}

}  // namespace onggi::render
