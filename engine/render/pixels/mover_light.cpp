#include "engine/render/pixels/mover_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "engine/render/pixels/light_lanes.h"
#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

using lanes::Corners3;
using lanes::kLanes;
using lanes::Lanes;
using lanes::Lanes3;
using lanes::mixed;

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

[[gnu::always_inline]] inline void load(std::span<const MoverMesh::Vertex> vertices,
                                        std::span<const std::uint32_t> numbers, const mat4& place,
                                        Block& block) {
    constexpr float kOneOver255 = 1.0F / 255.0F;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const MoverMesh::Vertex& vertex = vertices[numbers[std::min(i, numbers.size() - 1)]];
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
    lanes::mirror_sky(view.frame, mirrored, answer.roughness, answer.sky);
    for (int channel = 0; channel < 3; ++channel)
        lanes::light_softly(view.frame, block.normal, channel,
                            answer.soft[static_cast<std::size_t>(channel)]);
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

[[gnu::always_inline]] inline void light_all(const MoverMesh& mesh, std::span<const std::uint32_t> numbers,
                                             const Mover& mover, const MoverView& view, MoverCorner* into) {
    const bool is_red_first = view.order == ByteOrder::kRedFirst;
    Block block;
    Answer answer;
    Corners3 corners;
    std::array<Lanes, 3> shown;
    for (std::size_t first = 0; first < numbers.size(); first += kLanes) {
        const auto own = numbers.subspan(first, std::min(kLanes, numbers.size() - first));
        load(mesh.vertices, own, mover.place, block);
        answer_light(mesh, mover, view, block, answer);
        for (int channel = 0; channel < 3; ++channel) {
            const int at = is_red_first ? channel : 2 - channel;
            colour(mesh, mover, view, block, answer, channel, shown[static_cast<std::size_t>(at)]);
        }
        lanes::project(view.frame, block.place, corners);
        for (std::size_t i = 0; i < own.size(); ++i) {
            into[own[i]] = {.at_px = {corners.at.x[i], corners.at.y[i]},
                            .away_mm = corners.away_mm[i],
                            .depth = corners.at.z[i],
                            .values = {shown[0][i], shown[1][i], shown[2][i]}};
        }
    }
}

void light_plain(const MoverMesh& mesh, std::span<const std::uint32_t> numbers, const Mover& mover,
                 const MoverView& view, MoverCorner* into) {
    light_all(mesh, numbers, mover, view, into);
}

ONGGI_WIDE_VECTORS void light_wide(const MoverMesh& mesh, std::span<const std::uint32_t> numbers,
                                   const Mover& mover, const MoverView& view, MoverCorner* into) {
    light_all(mesh, numbers, mover, view, into);
}

}  // namespace

void light_corners(const MoverMesh& mesh, std::span<const std::uint32_t> indices, const Mover& mover,
                   const MoverView& view, std::vector<MoverCorner>& corners) {
    static auto* const best = best_of(light_plain, light_wide);
    const std::size_t first = corners.size();
    corners.resize(first + mesh.vertices.size());
    best(mesh, lanes::vertices_of(indices, mesh.vertices.size()), mover, view, corners.data() + first);
}

}  // namespace onggi::render
