#include "engine/render/pixels/lathe_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engine/math/wide_vectors.h"
#include "engine/render/pixels/corners8.h"
#include "engine/render/pixels/encode8.h"
#include "engine/render/shapes/detail_texture.h"
#include "shaders/lathe.h"
#include "shaders/load.h"

namespace onggi::render {
namespace {

// Eight vertices.
struct Vertices8 {
    Float8x3 place;  // mm
    Float8x3 normal;
    Float8 outward_x;
    Float8 outward_z;
    Float8 lean;
    Float8 turned;  // fraction of a turn
    Float8 seen;
    Float8 height_mm;
    Float8 outline;
    Float8 along_mm;
    Float8 open;
    Float8 inside;
    Float8 water;
    Float8 film;
    Float8 load;
};

// Fewer than eight vertices are padded with the last one.
[[gnu::always_inline]] inline void load(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                        Vertices8& into) {
    const auto in_row = static_cast<std::size_t>(grid.draw.turn.y);
    for (int i = 0; i < kFloat8; ++i) {
        const std::size_t number = numbers[std::min(static_cast<std::size_t>(i), numbers.size() - 1)];
        const shaders::VertexData& vertex = grid.vertices[number];
        const shaders::RowData& row = grid.rows[number / in_row];
        into.place.x[i] = vertex.place.x;
        into.place.y[i] = vertex.place.y;
        into.place.z[i] = vertex.place.z;
        into.seen[i] = vertex.place.w;
        into.outward_x[i] = vertex.lean.x;
        into.outward_z[i] = vertex.lean.z;
        into.lean[i] = vertex.lean.y;
        into.turned[i] = vertex.lean.w;
        into.normal.x[i] = row.light.x;
        into.normal.y[i] = row.light.y;
        into.open[i] = row.light.z;
        into.inside[i] = row.light.w;
        into.height_mm[i] = row.place.y;
        into.outline[i] = row.place.z;
        into.along_mm[i] = row.place.w;
        into.water[i] = row.water.x;
        into.film[i] = row.water.y;
        into.load[i] = row.water.z;
    }
}

struct Answer8 {
    Float8x3 to_eye;   // unit
    Float8 half;       // see lathe_value
    Colour8 ambient;   // of the body's own colour
    Colour8 mirrored;  // of the sky
};

[[gnu::always_inline]] inline void answer_light(const LatheGrid& grid, Vertices8& own, Answer8& answer) {
    const shaders::FrameData& frame = grid.frame;
    // From the row's normal in its half plane to the vertex's normal.
    const Float8 across = own.normal.x;
    own.normal =
        normalised({across * own.outward_x, own.normal.y - across * own.lean, across * own.outward_z});
    const Float8x3& n = own.normal;
    Float8 open = shaders::lathe_open(own.open, own.height_mm, n.y, own.inside);
    for (const vec4& sphere : frame.spheres)
        open *= shaders::sky_past_sphere(sphere, own.place, n);
    const Float8 from_mouth = shaders::lathe_from_mouth(own.inside, open);
    const Float8x3 from =
        normalised({n.x - n.x * from_mouth, float8::mix(n.y, 1.0F, from_mouth), n.z - n.z * from_mouth});
    answer.to_eye = towards(vec3(frame.eye), own.place);
    answer.half = shaders::half_of(dot(answer.to_eye, vec3(frame.key_direction)));
    find_sky_radiance(frame, mirrored(n, answer.to_eye), shaders::lathe_sky_roughness(grid.draw.gloss.w),
                      answer.mirrored);
    find_sky_diffuse(frame, from, answer.ambient);
    for (int channel = 0; channel < 3; ++channel) {
        const Float8 albedo = float8::mix(grid.draw.dry[channel], grid.draw.wet[channel], own.water);
        const auto number = static_cast<std::size_t>(channel);
        answer.ambient[number] *= albedo * shaders::open_sky_colour(open, albedo);
        answer.mirrored[number] *= open;
    }
}

[[gnu::always_inline]] inline void store(const LatheGrid& grid, const Vertices8& own, const Answer8& answer,
                                         const Placed8& at, std::span<const std::uint32_t> numbers,
                                         LatheCorner* into) {
    static_assert(lathe_value::kLoad == lathe_value::kHalf);
    const Float8& half = grid.shows_load ? own.load : answer.half;
    const auto texels_across = static_cast<float>(grid.streaks.across);
    const auto texels_up = static_cast<float>(grid.streaks.up);
    const Int8 is_before = at.away_mm > 0.0F;
    const Float8 near = float8::select(is_before, 1.0F / float8::select(is_before, at.away_mm, 1.0F), 0.0F);
    const Float8 streaks_across =
        near * texels_across * (2.0F * own.turned + grid.draw.turn.x + kStreakWidthsMore);
    const Float8 streaks_up = near * texels_up * (own.along_mm / shaders::kStreakMm);
    const Float8 outline = own.outline * static_cast<float>(shaders::kProfileTexels);
    const std::array<const Float8*, lathe_value::kCount> values{&answer.to_eye.x,
                                                                &answer.to_eye.y,
                                                                &answer.to_eye.z,
                                                                &own.outward_x,
                                                                &own.outward_z,
                                                                &streaks_across,
                                                                &streaks_up,
                                                                &outline,
                                                                &own.seen,
                                                                &own.water,
                                                                &own.film,
                                                                &own.lean,
                                                                &half,
                                                                &answer.ambient[0],
                                                                &answer.ambient[1],
                                                                &answer.ambient[2],
                                                                &answer.mirrored[0],
                                                                &answer.mirrored[1],
                                                                &answer.mirrored[2],
                                                                &near,
                                                                &own.place.x,
                                                                &own.place.y,
                                                                &own.place.z,
                                                                &at.at.z};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto lane = static_cast<int>(i);
        LatheCorner& corner = into[numbers[i]];
        corner.at_px = {at.at.x[lane], at.at.y[lane]};
        corner.away_mm = at.away_mm[lane];
        corner.depth = at.at.z[lane];
        for (std::size_t value = 0; value < values.size(); ++value)
            corner.values[value] = (*values[value])[lane];
    }
}

ONGGI_WIDE_VECTORS void light_all(const LatheGrid& grid, std::span<const std::uint32_t> numbers,
                                  LatheCorner* into) {
    Vertices8 vertices{};
    Answer8 answer;
    for (std::size_t first = 0; first < numbers.size(); first += kFloat8) {
        const auto own = numbers.subspan(first, std::min(std::size_t{kFloat8}, numbers.size() - first));
        load(grid, own, vertices);
        answer_light(grid, vertices, answer);
        store(grid, vertices, answer, project(grid.frame, vertices.place), own, into);
    }
}

}  // namespace

void light_corners(const LatheGrid& grid, std::span<const std::uint16_t> indices,
                   std::vector<LatheCorner>& corners) {
    corners.resize(grid.vertices.size());
    light_all(grid, vertices_of(indices, corners.size()), corners.data());
}

// Shades queued pixels, eight at a time, with the formulas of shaders/lathe.h.
namespace shading {

namespace value = lathe_value;
using float8::floats;
using float8::ints;
using float8::looked_up;
using float8::max;

// Variants of the shading; a draw uses one.
enum class Pot { kPlain, kNearSpheres, kWithLoad, kMarked };

// Additional values of pixels that show the load: the screen-space derivatives of the load and of the
// position along the hatch in mm.
constexpr std::size_t kLoadWidth = value::kDepth;
constexpr std::size_t kHatchWidth = kLoadWidth + 1;

// Pixels waiting to be shaded, from any number of triangles: most rows of a triangle are narrower than a
// block.
struct Queue {
    static constexpr std::size_t kMost = 128;
    std::size_t count = 0;
    alignas(32) std::array<std::array<float, kMost>, kHatchWidth + 1> values;
    std::array<std::int32_t, kMost>
        at;  // index in the picture, with the streaks' level in the upper bits; negative: occluded

    [[nodiscard]] bool is_full() const { return count + kFloat8 > kMost; }
};

// The streaks' level is stored above the pixel's index.
constexpr int kLevelShift = 28;
static_assert(kStreakLevels <= 1 << (31 - kLevelShift));

// Eight queued pixels.
struct Pixels {
    const Queue& queue;
    std::size_t first;

    [[gnu::always_inline]] [[nodiscard]] Float8 operator[](std::size_t number) const {
        Float8 values;
        std::memcpy(&values, queue.values[number].data() + first, sizeof values);
        return values;
    }
    [[gnu::always_inline]] [[nodiscard]] Int8 streak_level() const {
        Int8 places;
        std::memcpy(&places, queue.at.data() + first, sizeof places);
        return (places >> kLevelShift) & (kStreakLevels - 1);
    }
    [[gnu::always_inline]] [[nodiscard]] Float8x3 three(std::size_t number) const {
        return {(*this)[number], (*this)[number + 1], (*this)[number + 2]};
    }
};

// The streaks' texture at a pixel, 0 to 1.
struct Streaks {
    Float8 tone;
    Float8 lean_round;
    Float8 lean_up;
    Float8 film;
};
[[gnu::always_inline]] inline Streaks streaks_at(const LatheLook& look, const Pixels& own) {
    const Float8 away = 1.0F / own[value::kNear];
    const Int8 across = ints(own[value::kStreak] * away) & (look.streak_size.across - 1);
    const Int8 up = ints(own[value::kStreak + 1] * away) & (look.streak_size.up - 1);
    const Int8 row = own.streak_level() * look.streak_size.up + up;
    const Int8 texel = looked_up(look.streaks.data(), row * look.streak_size.across + across);
    constexpr float kOneOver255 = 1.0F / 255.0F;
    const auto byte = [&](int shift) __attribute__((always_inline)) {
        return floats((texel >> shift) & 255) * kOneOver255;
    };
    return {byte(0), byte(8), byte(16), byte(24)};
}

// The marks at a pixel.
struct Painted {
    Float8x3 roots;  // square roots of light
    Float8 cover;
    Float8 lean_round;  // counter-clockwise from above
    Float8 lean_up;
};
// Bilinear; there are no marks beyond the end of the outside.
[[gnu::always_inline]] inline Painted painted_at(const LatheLook& look, const Pixels& own) {
    const vec4& marks = look.draw.marks;
    const Float8 away = 1.0F / own[value::kNear];
    // Streak coordinates run clockwise from above, two texture widths per turn, plus a positive offset.
    const float columns_a_texel =
        -0.5F * static_cast<float>(kMarkColumns) / static_cast<float>(look.streak_size.across);
    constexpr float kNotBelow0 = kMarkColumns * 8.0F;
    const Float8 across = own[value::kStreak] * away * columns_a_texel + (kNotBelow0 - 0.5F);
    const Float8 up = float8::clamp(own[value::kPlace + 1] * marks.x - 0.5F, 0.0F, kMarkRows - 1.0F);
    const Int8 left = ints(across);
    const Int8 low = ints(up);
    const Float8 to_right = across - floats(left);
    const Float8 to_high = up - floats(low);
    const auto* const words = reinterpret_cast<const std::uint32_t*>(look.marks.data());
    constexpr float kOneOver255 = 1.0F / 255.0F;
    const auto byte = [&](const Int8& word, int shift) __attribute__((always_inline)) {
        return floats((word >> shift) & 255) * kOneOver255;
    };
    Painted found{};
    const auto add = [&](int step_across, int step_up, const Float8& weight) __attribute__((always_inline)) {
        const Int8 column = (left + step_across) & (kMarkColumns - 1);
        const Int8 next = low + step_up;
        const Int8 row = next - ((next >= kMarkRows) & 1);
        const Int8 at = (row * kMarkColumns + column) * 2;
        const Int8 colour = looked_up(words, at);
        const Int8 lean = looked_up(words, at + 1);
        const Float8 cover = byte(colour, 24) * weight;
        found.roots.x += byte(colour, 0) * cover;
        found.roots.y += byte(colour, 8) * cover;
        found.roots.z += byte(colour, 16) * cover;
        found.cover += cover;
        found.lean_round += byte(lean, 0) * weight;
        found.lean_up += byte(lean, 8) * weight;
    };
    add(0, 0, (1.0F - to_right) * (1.0F - to_high));
    add(1, 0, to_right * (1.0F - to_high));
    add(0, 1, (1.0F - to_right) * to_high);
    add(1, 1, to_right * to_high);
    const Float8 one_over = 1.0F / max(found.cover, 1e-4F);
    const float along_a_texel = shaders::kStreakMm / static_cast<float>(look.streak_size.up);
    const Float8 along = own[value::kStreak + 1] * away * along_a_texel;
    const Float8 is_outside = float8::select(along > marks.y, 0.0F, 1.0F);
    return {.roots = {found.roots.x * one_over, found.roots.y * one_over, found.roots.z * one_over},
            .cover = found.cover * is_outside,
            .lean_round = shaders::lathe_mark_lean(found.lean_round, marks.w) * is_outside,
            .lean_up = shaders::lathe_mark_lean(found.lean_up, marks.w) * is_outside};
}

// The wall's normal, not normalised: the outline's normal, tilted by dents, streaks and marks.
template <Pot kPot>
[[gnu::always_inline]] inline Float8x3 normal_at(const LatheLook& look, const Pixels& own,
                                                 const Streaks& streaks, const Painted& painted) {
    const Int8 place = ints(float8::clamp(own[value::kNormal], 0.0F, shaders::kProfileTexels - 1.0F));
    const Int8 word = looked_up(look.normals.data(), place);
    constexpr float kTwice = 2.0F / 65535.0F;
    const Float8 across = floats(word & 0xFFFF) * kTwice - 1.0F;
    const Float8 upward = floats((word >> 16) & 0xFFFF) * kTwice - 1.0F;
    Float8 round = shaders::lathe_lean(look.draw.dry.w, streaks.lean_round);
    Float8 up = shaders::lathe_lean(look.draw.dry.w, streaks.lean_up);
    if constexpr (kPot == Pot::kMarked) {
        round -= painted.lean_round;
        up += painted.lean_up;
    }
    const Float8 out_x = own[value::kOutward];
    const Float8 out_z = own[value::kOutward + 1];
    return {across * out_x - round * out_z, upward - across * own[value::kLean] + up,
            across * out_z + round * out_x};
}

template <Pot kPot>
[[gnu::always_inline]] inline Float8 key_seen(const LatheLook& look, const Pixels& own) {
    Float8 seen = own[value::kSeen];
    if constexpr (kPot == Pot::kPlain) return seen;
    const Float8x3 place = own.three(value::kPlace);
    for (const vec4& sphere : look.frame.spheres)
        seen *= shaders::past_sphere(sphere, look.frame.key_direction, look.frame.key_direction.w, place);
    return seen;
}

// Weights of the light that goes to the eye: key light reflected diffusely, key light reflected specularly,
// sky light reflected specularly; and the brightness of the body.
struct Fractions {
    Float8 body;
    Float8 gloss;
    Float8 mirror;
    Float8 tone;
};

template <Pot kPot>
[[gnu::always_inline]] inline Fractions fractions_at(const LatheLook& look, const Pixels& own,
                                                     const Painted& painted) {
    const shaders::LatheDraw& draw = look.draw;
    const Streaks streaks = streaks_at(look, own);
    const Float8x3 n = normal_at<kPot>(look, own, streaks, painted);
    const Float8 one_over_n = float8::inversesqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    const Float8x3 v = own.three(value::kToEye);
    const vec3 key(look.frame.key_direction);
    const Float8 n_l = (n.x * key.x + n.y * key.y + n.z * key.z) * one_over_n;
    const Float8 n_v = max((n.x * v.x + n.y * v.y + n.z * v.z) * one_over_n, 0.05F);
    const Float8 l_v = v.x * key.x + v.y * key.y + v.z * key.z;
    const Float8 seen = key_seen<kPot>(look, own);

    const Float8 s = shaders::fujii_s(l_v, n_l, n_v);
    const Float8 t = shaders::fujii_t(s, n_l, n_v);
    const Float8 half = kPot == Pot::kWithLoad ? shaders::half_of(l_v) : own[value::kHalf];
    const Float8 n_h = max((n_v + n_l) * half, 0.0F);
    const Float8 light_l = max(n_l, 0.0F);
    const Float8 water = own[value::kWater];
    const Float8 film = shaders::lathe_film(own[value::kFilm], streaks.film, draw.gloss.w);
    const Float8 roughness = shaders::lathe_roughness(draw.gloss.x, draw.gloss.y, water);
    const Float8 body_under = shaders::ggx_under(n_h, n_v, light_l, roughness);
    const Float8 sheen_under = shaders::ggx_under(n_h, n_v, light_l, draw.gloss.z);
    const Float8 body_sheen = body_under * sheen_under;
    const Float8 fraction = 1.0F / (body_sheen * t);
    const Float8 rough = shaders::lathe_rough(water);
    const Float8 lit = shaders::lathe_lit(shaders::soft_cosine(n_l, draw.wet.w, draw.turn.w), rough, s,
                                          body_sheen, fraction, shaders::lathe_left(rough));
    const float mirrors = draw.turn.z;  // reflectance at normal incidence
    const Float8 gloss = shaders::lathe_gloss(shaders::ggx_over(light_l, roughness), body_under,
                                              shaders::ggx_over(light_l, draw.gloss.z), sheen_under, mirrors,
                                              film, fraction * t);
    return {.body = lit * seen,
            .gloss = gloss * seen,
            .mirror = shaders::lathe_mirror(mirrors, n_v, film),
            .tone = shaders::lathe_tone(draw.dry.w, streaks.tone)};
}

// The load display, blended over the lathe's own colour.
struct LoadLayers {
    Float8 red;
    Float8 dark;
    Float8 pale;

    [[gnu::always_inline]] [[nodiscard]] Float8 over(const Float8& own, int channel) const {
        return shaders::with_load(own, red, dark, pale, shaders::kLoadRed[channel],
                                  shaders::kLoadDark[channel], shaders::kLoadPale[channel]);
    }
};

// The light of one channel. `load` and `painted` replace the body's colour; null: no change.
[[gnu::always_inline]] inline Float8 light_of(const LatheLook& look, const Pixels& own,
                                              const Fractions& fractions, const LoadLayers* load,
                                              const Painted* painted, int channel) {
    const auto number = static_cast<std::size_t>(channel);
    const float key = look.frame.key_radiance[channel];
    const float dry = key * look.draw.dry[channel];
    const float wet = key * look.draw.wet[channel];
    Float8 body = fractions.tone *
                  (own[value::kAmbient + number] + (dry + (wet - dry) * own[value::kWater]) * fractions.body);
    if (load != nullptr || painted != nullptr) {
        const float own_dry = look.draw.dry[channel];
        const Float8 colour =
            max(fractions.tone * (own_dry + (look.draw.wet[channel] - own_dry) * own[value::kWater]), 1e-4F);
        if (load != nullptr) {
            body *= load->over(colour, channel) / colour;
        } else {
            const Float8& root = channel == 0   ? painted->roots.x
                                 : channel == 1 ? painted->roots.y
                                                : painted->roots.z;
            body *= shaders::lathe_marked(colour, root, painted->cover) / colour;
        }
    }
    return max(body + key * fractions.gloss + own[value::kMirrored + number] * fractions.mirror, 0.0F);
}

// mm along the hatch per texel of the streaks' texture, around the pot and up.
struct HatchPerTexel {
    float round_mm;
    float up_mm;

    [[gnu::always_inline]] explicit HatchPerTexel(const StreakSize& size)
        : round_mm(shaders::kStreakRoundMm / static_cast<float>(size.across)),
          up_mm(shaders::kStreakMm / static_cast<float>(size.up)) {}
};
[[gnu::always_inline]] inline Float8 hatch_at(const LatheLook& look, const Pixels& own) {
    const HatchPerTexel hatch(look.streak_size);
    const Float8 away = 1.0F / own[value::kNear];
    // The hatch stands still on the lathe, whereas the streaks' texture turns.
    const float turned_mm =
        (look.draw.turn.x + kStreakWidthsMore) * static_cast<float>(look.streak_size.across) * hatch.round_mm;
    return (own[value::kStreak] * hatch.round_mm + own[value::kStreak + 1] * hatch.up_mm) * away - turned_mm;
}

template <Pot kPot>
[[gnu::always_inline]] inline void shade(Queue& queue, const LatheLook& look, const PictureCanvas& canvas) {
    for (std::size_t first = 0; first < queue.count; first += kFloat8) {
        const Pixels own{queue, first};
        Painted painted;
        if constexpr (kPot == Pot::kMarked) painted = painted_at(look, own);
        const Fractions fractions = fractions_at<kPot>(look, own, painted);
        LoadLayers load;
        if constexpr (kPot == Pot::kWithLoad) {
            const Float8 shown = own[value::kLoad];
            load = {.red = shaders::load_red(shown),
                    .dark = shaders::load_dark(shown, hatch_at(look, own), own[kHatchWidth]),
                    .pale = shaders::load_pale(shown, own[kLoadWidth])};
        }
        const auto light = [&](int channel) __attribute__((always_inline)) {
            return light_of(look, own, fractions, kPot == Pot::kWithLoad ? &load : nullptr,
                            kPot == Pot::kMarked ? &painted : nullptr, channel);
        };
        const Int8 pixels = encoded({light(0), light(1), light(2)}, look.order);
        const std::size_t end = std::min(queue.count - first, std::size_t{kFloat8});
        for (std::size_t i = 0; i < end; ++i) {
            const std::int32_t at = queue.at[first + i];
            constexpr std::int32_t kPlace = (1 << kLevelShift) - 1;
            if (at >= 0)
                canvas.pixels[static_cast<std::size_t>(at & kPlace)] = static_cast<std::uint32_t>(pixels[i]);
        }
    }
    queue.count = 0;
}

}  // namespace shading

namespace {

using float8::any;
using float8::floats;
using shading::Pot;
using shading::Queue;
using shading::shade;

namespace value = lathe_value;
using shapes::Reach;
using shapes::Shape;

// Values that are interpolated linearly over a triangle, packed into vectors.
constexpr std::size_t kValueVectors = value::kCount / kFloat8;
using Values = std::array<Float8, kValueVectors>;

[[gnu::always_inline]] inline Values values_of(const LatheCorner& corner) {
    Values values;
    static_assert(sizeof values == sizeof corner.values);
    std::memcpy(&values, corner.values.data(), sizeof values);
    return values;
}

// Selects the level of the streaks: the one with one to two texels per pixel.
[[gnu::always_inline]] inline int streak_level(const Shape<value::kCount>& shape, float area) {
    const LatheCorner& first = *shape.corners[0];
    const auto texels_up = [](const LatheCorner& corner) {
        return corner.values[value::kStreak + 1] * corner.away_mm;
    };
    const vec2 to_1 = shape.corners[1]->at_px - first.at_px;
    const vec2 to_2 = shape.corners[2]->at_px - first.at_px;
    const float grown_1 = texels_up(*shape.corners[1]) - texels_up(first);
    const float grown_2 = texels_up(*shape.corners[2]) - texels_up(first);
    const float a_pixel =
        std::abs(grown_1 * to_2.y - grown_2 * to_1.y) + std::abs(grown_2 * to_1.x - grown_1 * to_2.x);
    const float least = 1.5F * std::abs(area);
    return (a_pixel > least ? 1 : 0) + (a_pixel > 2.0F * least ? 1 : 0) + (a_pixel > 4.0F * least ? 1 : 0);
}

// The gradients of a triangle's values, packed and for each value.
struct Growth {
    vec2 from;    // its first corner
    int level;    // level of the streaks, shifted to its position in Queue::at
    Values base;  // values at `from`
    Values across;
    Values down;
    alignas(32) std::array<Float8, value::kCount> along;  // offsets of eight pixels in a row

    [[gnu::always_inline]] Growth(const Shape<value::kCount>& shape, float area)
        : from(shape.corners[0]->at_px),
          level(streak_level(shape, area) << shading::kLevelShift),
          base(values_of(*shape.corners[0])) {
        const vec2 to_1 = (shape.corners[1]->at_px - from) / area;
        const vec2 to_2 = (shape.corners[2]->at_px - from) / area;
        const Values of_1 = values_of(*shape.corners[1]);
        const Values of_2 = values_of(*shape.corners[2]);
        for (std::size_t i = 0; i < kValueVectors; ++i) {
            const Float8 grown_1 = of_1[i] - base[i];
            const Float8 grown_2 = of_2[i] - base[i];
            across[i] = grown_1 * to_2.y - grown_2 * to_1.y;
            down[i] = grown_2 * to_1.x - grown_1 * to_2.x;
        }
        for (std::size_t i = 0; i < value::kCount; ++i)
            along[i] = across[i / kFloat8][i % kFloat8] * floats(kFirst8);
    }
    // Computes the values at a pixel.
    [[gnu::always_inline]] void find(int x, int y, std::array<float, value::kCount>& found) const {
        const float right_by = static_cast<float>(x) + 0.5F - from.x;
        const float down_by = static_cast<float>(y) + 0.5F - from.y;
        for (std::size_t i = 0; i < kValueVectors; ++i) {
            const Float8 values = base[i] + across[i] * right_by + down[i] * down_by;
            std::memcpy(found.data() + i * kFloat8, &values, sizeof values);
        }
    }
};

// Screen-space derivatives of the load and of the hatch position for a block, like fwidth() in a shader.
[[gnu::always_inline]] inline void add_widths(const Growth& growth,
                                              const std::array<float, value::kCount>& first,
                                              const LatheLook& look, Queue& queue, std::size_t at) {
    const shading::HatchPerTexel hatch(look.streak_size);
    const auto of = [](const Values& grown, std::size_t number) {
        return grown[number / kFloat8][number % kFloat8];
    };
    const auto along = [&](const Values& grown) {
        return of(grown, value::kStreak) * hatch.round_mm + of(grown, value::kStreak + 1) * hatch.up_mm;
    };
    const Float8 near = first[value::kNear] + growth.along[value::kNear];
    const Float8 place = ((first[value::kStreak] + growth.along[value::kStreak]) * hatch.round_mm +
                          (first[value::kStreak + 1] + growth.along[value::kStreak + 1]) * hatch.up_mm) /
                         near;
    const Float8 width = (float8::abs(along(growth.across) - place * of(growth.across, value::kNear)) +
                          float8::abs(along(growth.down) - place * of(growth.down, value::kNear))) /
                         near;
    std::memcpy(queue.values[shading::kHatchWidth].data() + at, &width, sizeof width);
    const Float8 load_width =
        Float8{} + (std::abs(of(growth.across, value::kLoad)) + std::abs(of(growth.down, value::kLoad)));
    std::memcpy(queue.values[shading::kLoadWidth].data() + at, &load_width, sizeof load_width);
}

// Queues one block: the pixels of a row from `x` on that fit in it. `end`: one after the row's last pixel.
template <Pot kPot>
[[gnu::always_inline]] inline void add(const Growth& growth, int x, int end, int y, const LatheLook& look,
                                       const PictureCanvas& canvas, Queue& queue) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * canvas.size.width + x;
    const int count = std::min(end - x, kFloat8);
    alignas(32) std::array<float, value::kCount> first;
    growth.find(x, y, first);
    const Float8 here = first[value::kDepth] + growth.along[value::kDepth];
    // A block that would reach beyond the canvas's rows has only its own pixels' depth.
    float* const depths = canvas.depth.data() + at;
    const bool is_whole = at + kFloat8 <= canvas.end();
    const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(float);
    Float8 depth{};
    if (is_whole) [[likely]]
        std::memcpy(&depth, depths, sizeof depth);
    else
        std::memcpy(&depth, depths, bytes);
    const Int8 is_drawn = (here <= depth) & (kFirst8 < count);
    if (!any(is_drawn)) return;
    depth = is_drawn ? here : depth;
    if (is_whole) [[likely]]
        std::memcpy(depths, &depth, sizeof depth);
    else
        std::memcpy(depths, &depth, bytes);
    const std::size_t before = queue.count;
    const Int8 places = is_drawn ? kFirst8 + (static_cast<int>(at) | growth.level) : Int8{} - 1;
    std::memcpy(queue.at.data() + before, &places, sizeof places);
    constexpr std::size_t kValues = kPot == Pot::kPlain ? value::kPlain : value::kDepth;
#pragma GCC unroll 24
    for (std::size_t i = 0; i < kValues; ++i) {
        const Float8 values = first[i] + growth.along[i];
        std::memcpy(queue.values[i].data() + before, &values, sizeof values);
    }
    if constexpr (kPot == Pot::kWithLoad) add_widths(growth, first, look, queue, before);
    queue.count = before + static_cast<std::size_t>(count);
}

// `area`: twice the signed area in the picture; negative, because the corners are counter-clockwise.
template <Pot kPot>
[[gnu::always_inline]] inline void draw_triangle(const Shape<value::kCount>& shape, float area,
                                                 const LatheLook& look, Reach& reach,
                                                 const PictureCanvas& canvas, Queue& queue) {
    shapes::find_reach(shape, false, reach);
    const Growth growth(shape, area);
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left(y);
        const int end = reach.right(y);
        if (end <= left) continue;
        shapes::fetch_ahead(canvas, left, y);
        for (int x = left; x < end; x += kFloat8) {
            add<kPot>(growth, x, end, y, look, canvas, queue);
            if (queue.is_full()) shade<kPot>(queue, look, canvas);
        }
    }
}

template <Pot kPot>
[[gnu::always_inline]] inline void draw_some(std::span<const LatheCorner> corners,
                                             std::span<const std::uint16_t> indices, const LatheLook& look,
                                             Reach& reach, const PictureCanvas& canvas) {
    Queue queue{};  // zeroed: the last block of eight may be partial
    Shape<value::kCount> shape;
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const LatheCorner& a = corners[indices[first]];
        const LatheCorner& b = corners[indices[first + 1]];
        const LatheCorner& c = corners[indices[first + 2]];
        if (std::min({a.away_mm, b.away_mm, c.away_mm}) <= 0.0F) continue;
        const float area = shapes::area_of(a.at_px, b.at_px, c.at_px);
        if (area > -shapes::kNoArea) continue;  // faces away
        shape.corners = {&a, &b, &c, nullptr};
        draw_triangle<kPot>(shape, area, look, reach, canvas, queue);
    }
    shade<kPot>(queue, look, canvas);
}

ONGGI_WIDE_VECTORS void draw_all(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
                                 std::size_t plain, const LatheLook& look, const PictureCanvas& canvas) {
    if (canvas.pixels.size() < kFloat8) return;
    Reach reach(canvas);
    if (look.shows_load) {
        draw_some<Pot::kWithLoad>(corners, indices, look, reach, canvas);
        return;
    }
    if (!look.marks.empty()) {
        draw_some<Pot::kMarked>(corners, indices, look, reach, canvas);
        return;
    }
    draw_some<Pot::kPlain>(corners, indices.first(plain), look, reach, canvas);
    draw_some<Pot::kNearSpheres>(corners, indices.subspan(plain), look, reach, canvas);
}

}  // namespace

void draw_lathe(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
                std::size_t plain, const LatheLook& look, const PictureCanvas& canvas) {
    draw_all(corners, indices, plain, look, canvas);
}

}  // namespace onggi::render
