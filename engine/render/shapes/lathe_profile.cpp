#include "engine/render/shapes/lathe_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
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
    // same length removes nearly all of it.
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

}  // namespace onggi::render
