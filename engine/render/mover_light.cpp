#include "engine/render/mover_light.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

namespace onggi::render {
namespace {

// Vertices that are lit side by side; every loop over them is one the compiler makes vectors of.
constexpr std::size_t kLanes = 64;
using Lanes = std::array<float, kLanes>;
struct Lanes3 {
    Lanes x;
    Lanes y;
    Lanes z;
};

struct Block {
    Lanes3 place;  // mm
    Lanes3 normal;
    Lanes tone;  // these three 0 to 1
    Lanes smear;
    Lanes open;
};

// What of the light gets there, and what of it goes to the eye before colours come in.
struct Answer {
    Lanes roughness;
    Lanes metalness;
    Lanes grazing;              // Schlick's share of what is mirrored
    Lanes key;                  // key light that gets here, 0 to 1
    Lanes lit;                  // of it what a white body throws back
    Lanes glint;                // and what a white mirror does
    std::array<Lanes, 3> sky;   // mirrored
    std::array<Lanes, 3> soft;  // diffuse
};

[[gnu::always_inline]] inline float mixed(float a, float b, float share) {
    return a + (b - a) * share;
}

// e to a number that is not above 0: powers of two are put together from their bits, and what is left is a
// series of seven terms, wrong by less than 2e-5.
[[gnu::always_inline]] inline float exp_below_0(float number) {
    constexpr float kLeast = -87.0F;
    const float clamped = number > kLeast ? number : kLeast;
    const int twos = static_cast<int>(clamped * std::numbers::log2e_v<float>);
    const float t = clamped - static_cast<float>(twos) * std::numbers::ln2_v<float>;
    const float series =
        1.0F +
        t * (1.0F + t / 2.0F * (1.0F + t / 3.0F * (1.0F + t / 4.0F * (1.0F + t / 5.0F * (1.0F + t / 6.0F)))));
    return series * std::bit_cast<float>((twos + 127) << 23);
}

[[gnu::always_inline]] inline void load(std::span<const MoverMesh::Vertex> vertices, const mat4& place,
                                        Block& block) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const MoverMesh::Vertex& vertex = vertices[std::min(i, vertices.size() - 1)];
        block.place.x[i] = vertex.position_mm.x;
        block.place.y[i] = vertex.position_mm.y;
        block.place.z[i] = vertex.position_mm.z;
        block.normal.x[i] = vertex.normal.x;
        block.normal.y[i] = vertex.normal.y;
        block.normal.z[i] = vertex.normal.z;
        block.tone[i] = static_cast<float>(vertex.tone) * kOneOver255;
        block.smear[i] = static_cast<float>(vertex.smear) * kOneOver255;
        block.open[i] = static_cast<float>(vertex.open_sky) * kOneOver255;
    }
    const auto turn = [&](Lanes3 & lanes, float w) __attribute__((always_inline)) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float x = lanes.x[i];
            const float y = lanes.y[i];
            const float z = lanes.z[i];
            lanes.x[i] = place[0][0] * x + place[1][0] * y + place[2][0] * z + place[3][0] * w;
            lanes.y[i] = place[0][1] * x + place[1][1] * y + place[2][1] * z + place[3][1] * w;
            lanes.z[i] = place[0][2] * x + place[1][2] * y + place[2][2] * z + place[3][2] * w;
        }
    };
    turn(block.place, 1.0F);
    turn(block.normal, 0.0F);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = block.normal.x[i];
        const float y = block.normal.y[i];
        const float z = block.normal.z[i];
        const float share = 1.0F / std::sqrt(x * x + y * y + z * z);
        block.normal.x[i] = x * share;
        block.normal.y[i] = y * share;
        block.normal.z[i] = z * share;
    }
}

// past_lathe_to_light() of the shader, from a little before the skin.
[[gnu::always_inline]] inline void shade_by_lathe(const MoverView& view, const Block& block, Lanes& seen) {
    const float height = view.frame.lathe.x;
    if (height <= 0.0F) {
        seen.fill(1.0F);
        return;
    }
    constexpr int kSteps = 16;
    constexpr float kBeforeMm = 2.0F;
    const vec3 light(view.frame.key_direction);
    const float rise = std::max(light.y, 0.05F);
    const float per_mm = view.frame.lathe.y;
    const vec2 foot(view.frame.lathe_foot);
    const float* const outline = view.samples.outer_mm.data();
    Lanes from;
    Lanes step;
    Lanes least;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float y = block.place.y[i] + kBeforeMm * block.normal.y[i];
        const float below = -y / rise;
        from[i] = below > 0.0F ? below : 0.0F;
        step[i] = ((height - y) / rise - from[i]) / static_cast<float>(kSteps);
    }
    least.fill(1e3F);
    for (int number = 0; number < kSteps; ++number) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float t = from[i] + step[i] * (static_cast<float>(number) + 0.5F);
            const float x = block.place.x[i] + kBeforeMm * block.normal.x[i] + light.x * t - foot.x;
            const float y = block.place.y[i] + kBeforeMm * block.normal.y[i] + light.y * t;
            const float z = block.place.z[i] + kBeforeMm * block.normal.z[i] + light.z * t - foot.y;
            const float sample = std::min(std::max(y * per_mm, 0.0F), LatheSamples::kCount - 1.0F);
            const float gap = std::sqrt(x * x + z * z) - outline[static_cast<int>(sample)];
            const float angle = gap / std::max(t, 4.0F);
            least[i] = angle < least[i] ? angle : least[i];
        }
    }
    const float width = std::max(view.frame.key_direction.w, 0.02F);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float share = std::min(std::max((least[i] + width) / (2.0F * width), 0.0F), 1.0F);
        seen[i] = step[i] > 0.0F ? share * share * (3.0F - 2.0F * share) : 1.0F;
    }
}

// sky_diffuse() of shaders/sky.glsl.
[[gnu::always_inline]] inline void light_softly(const shaders::FrameData& frame, const Lanes3& n, int channel,
                                                Lanes& into) {
    const auto term = [&](std::size_t number) { return frame.irradiance[number][channel]; };
    const std::array<float, 9> of{term(0), term(1), term(2), term(3), term(4),
                                  term(5), term(6), term(7), term(8)};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = n.x[i];
        const float y = n.y[i];
        const float z = n.z[i];
        const float light = of[0] + of[1] * y + of[2] * z + of[3] * x + of[4] * (x * y) + of[5] * (y * z) +
                            of[6] * (3.0F * z * z - 1.0F) + of[7] * (x * z) + of[8] * (x * x - y * y);
        into[i] = std::max(light, 0.0F);
    }
}

// sky_radiance() of shaders/sky.glsl.
[[gnu::always_inline]] inline void mirror_sky(const shaders::FrameData& frame, const Lanes3& towards,
                                              const Lanes& roughness, std::array<Lanes, 3>& into) {
    for (int channel = 0; channel < 3; ++channel) {
        const float horizon = frame.sky_horizon[channel];
        const float zenith = frame.sky_zenith[channel];
        const float nadir = frame.sky_nadir[channel];
        Lanes& light = into[static_cast<std::size_t>(channel)];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float height = std::min(std::abs(towards.y[i]), 1.0F);
            const float share = height * height * (3.0F - 2.0F * height);
            light[i] = mixed(horizon, towards.y[i] > 0.0F ? zenith : nadir, share);
        }
    }
    for (int panel = 0; panel < shaders::kPanels; ++panel) {
        const vec4 direction = frame.panel_direction[panel];
        const vec4 radiance = frame.panel_radiance[panel];
        const float sharpness = direction.w;
        Lanes weight;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float alpha = roughness[i] * roughness[i];
            const float blur = 2.0F / std::max(alpha * alpha, 1e-4F);
            const float soft = sharpness * blur / (sharpness + blur);
            const float cosine =
                direction.x * towards.x[i] + direction.y * towards.y[i] + direction.z * towards.z[i];
            weight[i] = soft / sharpness * exp_below_0(soft * (std::min(cosine, 1.0F) - 1.0F));
        }
        for (int channel = 0; channel < 3; ++channel) {
            const float of = radiance[channel];
            Lanes& light = into[static_cast<std::size_t>(channel)];
            for (std::size_t i = 0; i < kLanes; ++i)
                light[i] += of * weight[i];
        }
    }
}

// soft_cosine() and ggx() of shaders/surface.glsl, as mover_light() of shaders/mover.glsl has them.
[[gnu::always_inline]] inline void answer_key(const vec3& light, const Block& block, const Lanes3& v,
                                              Answer& answer) {
    constexpr float kSoft = 0.30F;
    constexpr float kPi = std::numbers::pi_v<float>;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float n_l =
            block.normal.x[i] * light.x + block.normal.y[i] * light.y + block.normal.z[i] * light.z;
        const float v_l = v.x[i] * light.x + v.y[i] * light.y + v.z[i] * light.z;
        const float own_n_v =
            block.normal.x[i] * v.x[i] + block.normal.y[i] * v.y[i] + block.normal.z[i] * v.z[i];
        const float n_v = std::max(own_n_v, 0.05F);
        const float eased = std::max(n_l / kSoft + 1.0F, 0.0F);
        answer.lit[i] = n_l > kSoft ? n_l : kSoft * 0.25F * eased * eased;

        const float n_h = std::max((n_v + n_l) / std::sqrt(std::max(2.0F + 2.0F * v_l, 1e-4F)), 0.0F);
        const float to_light = std::max(n_l, 0.0F);
        const float alpha = answer.roughness[i] * answer.roughness[i];
        const float a2 = alpha * alpha;
        const float k = alpha * 0.5F;
        const float d = n_h * n_h * (a2 - 1.0F) + 1.0F;
        const float visible = (n_v * (1.0F - k) + k) * (to_light * (1.0F - k) + k);
        answer.glint[i] = kPi * a2 * to_light / (kPi * 4.0F * d * d * visible);

        const float past = 1.0F - std::max(own_n_v, 0.0F);
        answer.grazing[i] = past * past * past * past * past;
        answer.key[i] *= mixed(0.55F, 1.0F, block.open[i]);
    }
}

[[gnu::always_inline]] inline void answer_light(const MoverMesh& mesh, const Mover& mover,
                                                const MoverView& view, const Block& block, Answer& answer) {
    const float of_clay = 0.72F - 0.22F * mover.wetness;
    for (std::size_t i = 0; i < kLanes; ++i) {
        answer.metalness[i] = mesh.metalness * (1.0F - block.smear[i]);
        answer.roughness[i] = mixed(mesh.roughness, of_clay, block.smear[i]);
    }
    const vec3 eye(view.frame.eye);
    Lanes3 v;
    Lanes3 mirrored;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = eye.x - block.place.x[i];
        const float y = eye.y - block.place.y[i];
        const float z = eye.z - block.place.z[i];
        const float share = 1.0F / std::sqrt(x * x + y * y + z * z);
        v.x[i] = x * share;
        v.y[i] = y * share;
        v.z[i] = z * share;
        const float twice =
            2.0F * (block.normal.x[i] * v.x[i] + block.normal.y[i] * v.y[i] + block.normal.z[i] * v.z[i]);
        mirrored.x[i] = twice * block.normal.x[i] - v.x[i];
        mirrored.y[i] = twice * block.normal.y[i] - v.y[i];
        mirrored.z[i] = twice * block.normal.z[i] - v.z[i];
    }
    mirror_sky(view.frame, mirrored, answer.roughness, answer.sky);
    for (int channel = 0; channel < 3; ++channel)
        light_softly(view.frame, block.normal, channel, answer.soft[static_cast<std::size_t>(channel)]);
    shade_by_lathe(view, block, answer.key);
    answer_key(vec3(view.frame.key_direction), block, v, answer);
}

// One channel of what goes to the eye, as encode() of shaders/tone.glsl shows it, 0 to 255.
[[gnu::always_inline]] inline void colour(const MoverMesh& mesh, const Mover& mover, const MoverView& view,
                                          const Block& block, const Answer& answer, int channel,
                                          Lanes& shown) {
    constexpr float kPlainMirror = 0.04F;
    const float own = mesh.albedo[channel];
    const float clay = mover.clay[channel];
    const float key_light = view.frame.key_radiance[channel];
    const Lanes& sky = answer.sky[static_cast<std::size_t>(channel)];
    const Lanes& soft = answer.soft[static_cast<std::size_t>(channel)];
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float open = block.open[i];
        const float metalness = answer.metalness[i];
        const float albedo = mixed(own * (0.5F + block.tone[i]), clay, block.smear[i]);
        const float f0 = mixed(kPlainMirror, albedo, metalness);
        const float mirror = mixed(f0, std::max(1.0F - answer.roughness[i], f0), answer.grazing[i]);
        const float body = albedo * (1.0F - metalness);
        const float ambient =
            body * soft[i] * (open * (1.0F + albedo * (1.0F - open) * 1.6F)) + mirror * sky[i] * open;
        const float straight_on = mixed(kPlainMirror, own, metalness);
        const float key = key_light * answer.key[i] * (body * answer.lit[i] + straight_on * answer.glint[i]);
        const float light = std::max(ambient + key, 0.0F);
        shown[i] = 255.0F * std::sqrt(std::min(light / (light * 0.8F + 0.35F), 1.0F));
    }
}

// In the steps that a device has between two pixels, so that a shape covers the same ones as if it drew it.
[[gnu::always_inline]] inline float in_steps(float px) {
    constexpr float kSteps = 256.0F;
    constexpr float kFarPx = 16384.0F;  // beyond any picture; twice as much in steps is a whole number yet
    const float from_far = std::min(std::max(px + kFarPx, 0.0F), 2.0F * kFarPx);
    return static_cast<float>(static_cast<int>(from_far * kSteps + 0.5F)) / kSteps - kFarPx;
}

struct Corners3 {
    Lanes3 at;  // px, and depth
    Lanes away_mm;
};

[[gnu::always_inline]] inline void project(const shaders::FrameData& frame, const Lanes3& place,
                                           Corners3& corners) {
    const mat4& matrix = frame.view_projection;
    const vec2 half = 0.5F * vec2(frame.picture);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float px = place.x[i];
        const float py = place.y[i];
        const float pz = place.z[i];
        const float x = matrix[0][0] * px + matrix[1][0] * py + matrix[2][0] * pz + matrix[3][0];
        const float y = matrix[0][1] * px + matrix[1][1] * py + matrix[2][1] * pz + matrix[3][1];
        const float z = matrix[0][2] * px + matrix[1][2] * py + matrix[2][2] * pz + matrix[3][2];
        const float w = matrix[0][3] * px + matrix[1][3] * py + matrix[2][3] * pz + matrix[3][3];
        const bool is_before = w > 0.0F && z >= 0.0F;  // the nearest plane
        const float share = 1.0F / (is_before ? w : 1.0F);
        corners.at.x[i] = in_steps(half.x * (x * share + 1.0F));
        corners.at.y[i] = in_steps(half.y * (y * share + 1.0F));
        corners.at.z[i] = z * share;
        corners.away_mm[i] = is_before ? w : 0.0F;
    }
}

[[gnu::always_inline]] inline void light_all(const MoverMesh& mesh, const Mover& mover, const MoverView& view,
                                             MoverCorner* into) {
    const bool is_red_first = view.order == ByteOrder::kRedFirst;
    const std::span<const MoverMesh::Vertex> vertices(mesh.vertices);
    Block block;
    Answer answer;
    Corners3 corners;
    std::array<Lanes, 3> shown;
    for (std::size_t first = 0; first < vertices.size(); first += kLanes) {
        load(vertices.subspan(first), mover.place, block);
        answer_light(mesh, mover, view, block, answer);
        for (int channel = 0; channel < 3; ++channel) {
            const int at = is_red_first ? channel : 2 - channel;
            colour(mesh, mover, view, block, answer, channel, shown[static_cast<std::size_t>(at)]);
        }
        project(view.frame, block.place, corners);
        const std::size_t count = std::min(kLanes, vertices.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            into[first + i] = {.at_px = {corners.at.x[i], corners.at.y[i]},
                               .away_mm = corners.away_mm[i],
                               .depth = corners.at.z[i],
                               .values = {shown[0][i], shown[1][i], shown[2][i]}};
        }
    }
}

using LightAll = void (*)(const MoverMesh&, const Mover&, const MoverView&, MoverCorner*);

void light_plain(const MoverMesh& mesh, const Mover& mover, const MoverView& view, MoverCorner* into) {
    light_all(mesh, mover, view, into);
}

#if defined(__x86_64__)
// The same lines, eight lanes at a time; without fused multiply-add, so the same bits.
[[gnu::target("avx2")]] void light_avx2(const MoverMesh& mesh, const Mover& mover, const MoverView& view,
                                        MoverCorner* into) {
    light_all(mesh, mover, view, into);
}

LightAll best_for_this_processor() {
    return __builtin_cpu_supports("avx2") != 0 ? light_avx2 : light_plain;
}
#else
LightAll best_for_this_processor() {
    return light_plain;
}
#endif

}  // namespace

void light_corners(const MoverMesh& mesh, const Mover& mover, const MoverView& view,
                   std::vector<MoverCorner>& corners) {
    static const LightAll best = best_for_this_processor();
    const std::size_t first = corners.size();
    corners.resize(first + mesh.vertices.size());
    if (!mesh.vertices.empty()) best(mesh, mover, view, corners.data() + first);
}

}  // namespace onggi::render
