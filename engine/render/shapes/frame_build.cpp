#include "engine/render/shapes/frame_build.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/hash.h"
#include "engine/math/light.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_mesh.h"
#include "shaders/sky.h"

namespace onggi::render {

std::size_t add_section(const LatheMeshInput& input, int sectors,
                        std::vector<shaders::VertexData>& vertices) {
    const std::size_t rows = input.rows.size();
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    if (rows < 2 || vertices.size() < rows * in_row) return 0;
    const std::size_t before = vertices.size();
    std::size_t summit = 0;
    for (std::size_t row = 1; row < rows; ++row) {
        if (input.rows[row].place.y > input.rows[summit].place.y) summit = row;
    }
    for (const std::size_t edge : {std::size_t{0}, in_row - 1}) {
        const float side = edge == 0 ? -1.0F : 1.0F;
        const auto corner = [&](std::size_t row, float across) {
            const vec4& place = vertices[row * in_row + edge].place;
            return shaders::VertexData{
                .place = vec4(vec3(place), 1.0F),
                .lean = vec4(side * input.rows[row].place.x, input.rows[row].water.z, across, 0.0F)};
        };
        // Two chains from the base to the top of the rim: up the outside, and from the axis over the floor up
        // the inside. The chain with the lower next vertex advances, so that the triangles stay level.
        std::vector<shaders::VertexData> outer;
        std::vector<shaders::VertexData> inner;
        for (std::size_t row = 0; row <= summit; ++row)
            outer.push_back(corner(row, 0.0F));
        inner.push_back({.place = vec4(0.0F, 0.0F, 0.0F, 1.0F), .lean = vec4(0.0F, 0.0F, 0.5F, 0.0F)});
        for (std::size_t row = rows; row-- > summit;)
            inner.push_back(corner(row, 1.0F));
        std::size_t o = 0;
        std::size_t i = 0;
        while (o + 1 < outer.size() || i + 1 < inner.size()) {
            const bool outer_next = i + 1 >= inner.size() ||
                                    (o + 1 < outer.size() && outer[o + 1].place.y <= inner[i + 1].place.y);
            const shaders::VertexData& next = outer_next ? outer[o + 1] : inner[i + 1];
            if (vertices.size() - before + 3 > kMaxSectionVertices) return vertices.size() - before;
            const shaders::VertexData a = outer[o];
            const shaders::VertexData b = inner[i];
            vertices.push_back(a);
            vertices.push_back(b);
            vertices.push_back(next);
            (outer_next ? o : i) += 1;
        }
    }
    return vertices.size() - before;
}

namespace {

// A chord deviates from its circle by r (1 - cos(half its angle)).
float angle_of_chord(float radius_px, float error_px) {
    // Light is interpolated between the vertices too and allows no wider chord.
    constexpr float kWidest = 18.0F * kPiF / 180.0F;
    const float cosine = 1.0F - error_px / std::max(radius_px, 1e-3F);
    return cosine > 0.0F ? std::min(2.0F * std::acos(cosine), kWidest) : kWidest;
}

// Sectors per radian at this angle from the line of sight.
float density(const LatheSeen& seen, float from_sight_rad, float error_px) {
    const float across = std::abs(std::sin(from_sight_rad));
    const float down = std::cos(from_sight_rad) * std::sin(seen.pitch_rad);
    // Leaning walls turn away from the eye up to about forty degrees before or behind a right angle.
    constexpr float kAtAll = 0.64F;  // sines
    constexpr float kWhole = 0.80F;
    const float fraction = std::clamp((across - kAtAll) / (kWhole - kAtAll), 0.0F, 1.0F);
    const float rim_px = seen.rim_px * std::hypot(across, down);
    return 1.0F / angle_of_chord(std::max(seen.widest_px * fraction, rim_px), error_px);
}

}  // namespace

std::vector<float> even_sectors(const Lathe& lathe, int sectors) {
    // The lathe's own sectors run counter-clockwise, these angles clockwise.
    const float start = lathe.cut ? kPiF - lathe.cut->towards_rad : 0.0F;
    const float sweep = lathe.cut ? kPiF : kTurnF;
    std::vector<float> angles;
    angles.reserve(static_cast<std::size_t>(sectors) + 1);
    for (int i = 0; i <= sectors; ++i)
        angles.push_back(start + sweep * static_cast<float>(i) / static_cast<float>(sectors));
    return angles;
}

std::vector<float> seen_sectors(const LatheSeen& seen, const SectorBudget& budget) {
    // The integral of the density from 0 to each angle, over half a turn.
    constexpr std::size_t kSteps = 180;
    constexpr float kStep = kPiF / static_cast<float>(kSteps);
    std::array<float, kSteps + 1> sum{};
    for (std::size_t i = 0; i < kSteps; ++i)
        sum[i + 1] = sum[i] + kStep * density(seen, (static_cast<float>(i) + 0.5F) * kStep, budget.error_px);
    // An even number, so that a pot that widens slightly is not divided differently in every frame.
    constexpr int kFewest = 8;
    const int wanted = (static_cast<int>(std::ceil(sum[kSteps])) + 1) / 2 * 2;
    const int half = std::clamp(wanted, kFewest, std::max(budget.max_sectors / 2, kFewest));
    std::vector<float> to_side;
    to_side.reserve(static_cast<std::size_t>(half) + 1);
    std::size_t at = 0;
    for (int i = 0; i <= half; ++i) {
        const float fraction = sum[kSteps] * static_cast<float>(i) / static_cast<float>(half);
        while (at + 1 < kSteps && sum[at + 1] < fraction)
            ++at;
        const float within = (fraction - sum[at]) / (sum[at + 1] - sum[at]);
        to_side.push_back((static_cast<float>(at) + std::clamp(within, 0.0F, 1.0F)) * kStep);
    }
    std::vector<float> angles;
    angles.reserve(2 * static_cast<std::size_t>(half) + 1);
    for (const float angle : to_side)
        angles.push_back(seen.azimuth_rad + angle);
    for (int i = half; i-- > 0;)
        angles.push_back(seen.azimuth_rad + kTurnF - to_side[static_cast<std::size_t>(i)]);
    return angles;
}

namespace {

// The corners of a face: below, next below, above, next above.
using Corners = std::array<const shaders::VertexData*, 4>;

// Whether a sphere's shadow may fall within margin_mm of a point; the formula of past_sphere() in
// shaders/surface.h.
bool may_be_in_shadow(const shaders::FrameData& frame, vec3 point, float margin_mm) {
    const vec3 light(frame.key_direction);
    return std::any_of(std::begin(frame.spheres), std::end(frame.spheres), [&](const vec4& sphere) {
        const vec3 to = vec3(sphere) - point;
        const float along = glm::dot(to, light);
        if (along < -margin_mm) return false;
        const float reach =
            sphere.w + std::max((along + margin_mm) * frame.key_direction.w, 0.5F) + margin_mm;
        return glm::dot(to, to) - along * along < reach * reach;
    });
}

bool may_be_in_shadow(const shaders::FrameData& frame, const Corners& corners) {
    const auto in_the_dark = [](const shaders::VertexData* corner) { return corner->place.w == 0.0F; };
    if (std::all_of(corners.begin(), corners.end(), in_the_dark)) return false;
    vec3 middle(0.0F);
    for (const shaders::VertexData* corner : corners)
        middle += 0.25F * vec3(corner->place);
    float reach_2_mm2 = 0.0F;
    for (const shaders::VertexData* corner : corners) {
        const vec3 to = vec3(corner->place) - middle;
        reach_2_mm2 = std::max(reach_2_mm2, glm::dot(to, to));
    }
    return may_be_in_shadow(frame, middle, std::sqrt(reach_2_mm2));
}

void add_face(std::size_t below, std::size_t in_row, std::vector<std::uint16_t>& indices) {
    const std::size_t above = below + in_row;
    for (const std::size_t index : {below, above, below + 1, below + 1, above, above + 1})
        indices.push_back(static_cast<std::uint16_t>(index));
}

// Twice the signed area of a triangle in the picture (y down); negative: counter-clockwise.
float turn_of(const vec4& a, const vec4& b, const vec4& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

void choose_faces(std::span<const shaders::VertexData> vertices, int sectors, const shaders::FrameData& frame,
                  const EdgeView& view, LatheFaces& faces) {
    faces.clear();
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    const std::size_t rows = vertices.size() / in_row;
    if (rows < 2) return;
    const Projector project(view);
    std::vector<vec4> pixels;
    pixels.reserve(vertices.size());
    for (const shaders::VertexData& vertex : vertices)
        pixels.push_back(project(vec3(vertex.place)));
    std::vector<std::uint16_t> near_spheres;
    constexpr float kEdgeOn = 0.05F;  // square pixels; larger than an error from rounded coordinates
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t s = 0; s + 1 < in_row; ++s) {
            const std::size_t below = row * in_row + s;
            const std::size_t above = below + in_row;
            const vec4& corner = pixels[below + 1];
            const bool is_known =
                std::min(std::min(pixels[below].w, corner.w),
                         std::min(pixels[above].w, pixels[above + 1].w)) > view.camera.near_mm;
            const bool looks_away = turn_of(pixels[below], pixels[above], corner) > kEdgeOn &&
                                    turn_of(corner, pixels[above], pixels[above + 1]) > kEdgeOn;
            if (is_known && looks_away) continue;
            const bool is_near = may_be_in_shadow(
                frame, {&vertices[below], &vertices[below + 1], &vertices[above], &vertices[above + 1]});
            add_face(below, in_row, is_near ? near_spheres : faces.indices);
        }
    }
    faces.plain = static_cast<std::uint32_t>(faces.indices.size());
    faces.indices.insert(faces.indices.end(), near_spheres.begin(), near_spheres.end());
}

void take_all_faces(std::size_t rows, int sectors, LatheFaces& faces) {
    faces.clear();
    const auto in_row = static_cast<std::size_t>(sectors) + 1;
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t s = 0; s + 1 < in_row; ++s)
            add_face(row * in_row + s, in_row, faces.indices);
    }
}

vec3 sky_radiance(const Environment& environment, vec3 direction) {
    vec3 radiance = glm::mix(environment.horizon, direction.y > 0.0F ? environment.zenith : environment.nadir,
                             shaders::sky_height(direction.y));
    for (const Environment::Panel& panel : environment.panels)
        radiance +=
            panel.radiance * std::exp(panel.sharpness * (glm::dot(panel.direction, direction) - 1.0F));
    return radiance;
}

std::array<vec3, 9> sky_irradiance(const Environment& environment) {
    // Midpoint rule over the sphere; the sky is smooth, so a coarse grid is accurate enough.
    constexpr int kRows = 32;
    constexpr int kColumns = 64;
    std::array<vec3, 9> coefficients{};
    for (int row = 0; row < kRows; ++row) {
        const float y = 1.0F - (static_cast<float>(row) + 0.5F) * 2.0F / kRows;
        const float across = std::sqrt(1.0F - y * y);
        for (int column = 0; column < kColumns; ++column) {
            const float angle = (static_cast<float>(column) + 0.5F) * kTurnF / kColumns;
            const vec3 d(across * std::cos(angle), y, across * std::sin(angle));
            const std::array<float, 9> basis{0.282095F,
                                             0.488603F * d.y,
                                             0.488603F * d.z,
                                             0.488603F * d.x,
                                             1.092548F * d.x * d.y,
                                             1.092548F * d.y * d.z,
                                             0.315392F * (3.0F * d.z * d.z - 1.0F),
                                             1.092548F * d.x * d.z,
                                             0.546274F * (d.x * d.x - d.y * d.y)};
            const vec3 radiance = sky_radiance(environment, d);
            for (std::size_t i = 0; i < basis.size(); ++i)
                coefficients[i] += radiance * basis[i];
        }
    }
    // Solid angle of a cell; the cosine lobe's factors over pi (1, 2/3, 1/4); the constants of the basis.
    constexpr float kCell = 4.0F * kPiF / (kRows * kColumns);
    constexpr std::array<float, 9> kFold{0.282095F,         0.488603F * 2 / 3, 0.488603F * 2 / 3,
                                         0.488603F * 2 / 3, 1.092548F / 4,     1.092548F / 4,
                                         0.315392F / 4,     1.092548F / 4,     0.546274F / 4};
    for (std::size_t i = 0; i < kFold.size(); ++i)
        coefficients[i] *= kCell * kFold[i];
    return coefficients;
}

namespace {

mat4 key_projection(const DirectionalLight& light, const StillBounds& still) {
    const vec3 up = std::abs(light.towards_light.y) > 0.99F ? vec3(1.0F, 0.0F, 0.0F) : vec3(0.0F, 1.0F, 0.0F);
    const float r = still.radius_mm;
    const mat4 view = glm::lookAt(still.centre_mm + light.towards_light * (2.0F * r), still.centre_mm, up);
    return glm::ortho(-r, r, -r, r, 0.5F * r, 3.5F * r) * view;
}

void build_lights(const Scene& scene, const StillBounds& still, shaders::FrameData& frame) {
    frame.key_view_projection = key_projection(scene.key, still);
    frame.key_direction = vec4(scene.key.towards_light, std::tan(scene.key.angular_radius_rad));
    const vec3 ambient = scene.levels.ambient;
    frame.levels = vec4(ambient, scene.levels.key);
    frame.key_radiance = vec4(scene.key.radiance * scene.levels.key, 0.0F);
    frame.sky_zenith = vec4(scene.environment.zenith * ambient, 0.0F);
    frame.sky_horizon = vec4(scene.environment.horizon * ambient, 0.0F);
    frame.sky_nadir = vec4(scene.environment.nadir * ambient, 0.0F);
    for (std::size_t i = 0; i < scene.environment.panels.size(); ++i) {
        const Environment::Panel& panel = scene.environment.panels[i];
        frame.panel_direction[i] = vec4(panel.direction, panel.sharpness);
        frame.panel_radiance[i] = vec4(panel.radiance * ambient, 0.0F);
    }
    const std::array<vec3, 9> irradiance =
        scene.irradiance ? *scene.irradiance : sky_irradiance(scene.environment);
    for (std::size_t i = 0; i < irradiance.size(); ++i)
        frame.irradiance[i] = vec4(irradiance[i] * ambient, 0.0F);

    const MaskPlacement mask = place_mask(scene.shadow_region, scene.key);
    frame.mask_u = mask.u;
    frame.mask_v = mask.v;
    frame.mask_origin = vec4(mask.origin.x, mask.origin.y, 0.0F, 0.0F);
    frame.mask_axes = vec4(mask.axis_u.x, mask.axis_u.y, mask.axis_v.x, mask.axis_v.y);
}

void build_backdrop(const Scene& scene, int width_px, int height_px, shaders::FrameData& frame) {
    const Backdrop& backdrop = scene.backdrop;
    const vec3 ambient = scene.levels.ambient;
    const auto width = static_cast<float>(width_px);
    const auto height = static_cast<float>(height_px);
    const float shorter = std::min(width, height);
    frame.backdrop_low = vec4(backdrop.low * ambient, 0.0F);
    frame.backdrop_high = vec4(backdrop.high * ambient, 0.0F);
    frame.backdrop_glow = vec4(backdrop.glow * ambient, backdrop.glow_radius);
    frame.backdrop_shape =
        vec4(backdrop.glow_centre.x, backdrop.glow_centre.y, width / shorter, height / shorter);
    frame.picture = vec4(width, height, 1.0F / width, 1.0F / height);
    frame.fade = vec4(1.0F - scene.fade_in.value_or(1.0F), 0.0F, 0.0F, 0.0F);
    if (!scene.background) return;
    frame.background_window =
        background_window(scene.background->camera, scene.background->width_px, scene.background->height_px,
                          scene.camera, width_px, height_px);
}

// Fills in everything except the moving things.
void build_scene(const Scene& scene, const StillBounds& still, int width_px, int height_px,
                 shaders::FrameData& frame) {
    frame.view_projection = view_projection(scene.camera, width_px, height_px);
    frame.eye = vec4(scene.camera.eye_mm, 0.0F);
    build_lights(scene, still, frame);
    build_backdrop(scene, width_px, height_px, frame);
}

// How far the streaks' texture has turned, in texture widths; two widths make a turn.
float streak_turn(vec2 turn) {
    const float angle = std::atan2(turn.y, turn.x);
    return angle / kPiF;
}

std::vector<float> sectors_of(const Scene& scene, const RendererDesc& desc, float px_per_mm,
                              const LatheProfile& profile) {
    const Lathe& lathe = *scene.lathe;
    if (lathe.cut || desc.sector_error_px <= 0.0F) return even_sectors(lathe, desc.sectors);
    const auto at_edge = std::min(profile.edge, profile.points.size() - 1);
    float widest_mm = 0.0F;
    for (const ProfilePoint& point : profile.points)
        widest_mm = std::max(widest_mm, point.radius_mm);
    const vec3& eye = scene.camera.eye_mm;
    const vec3 down = eye - scene.camera.target_mm;
    return seen_sectors({.widest_px = widest_mm * px_per_mm,
                         .rim_px = profile.points[at_edge].radius_mm * px_per_mm,
                         .azimuth_rad = std::atan2(eye.z, eye.x),
                         .pitch_rad = std::atan2(down.y, std::hypot(down.x, down.z))},
                        {.error_px = desc.sector_error_px, .max_sectors = desc.sectors});
}

void build_lathe(const Scene& scene, const RendererDesc& desc, const EdgeView& view, BuiltFrame& built) {
    const Lathe& lathe = *scene.lathe;
    const auto px_per_mm = static_cast<float>(pixels_per_mm(scene.camera, view.height_px));
    build_profile(lathe, built.profile);
    if (built.profile.empty()) return;
    sample_profile(built.profile, built.samples);
    const std::size_t seen = lathe.cut
                                 ? built.profile.points.size()
                                 : points_seen(built.profile, scene.camera.eye_mm, largest_offset_mm(lathe));
    built.choice = choose_rows(built.profile, seen,
                               {.tolerance_mm = desc.ring_error_px / px_per_mm,
                                .max_rows = std::clamp(desc.max_rings, 32, kMaxRings),
                                .edge_stride = desc.samples > 1 ? 1 : 3,
                                .max_span_mm = desc.samples > 1 ? 4.0F : 9.0F});
    built.ring_error_px = built.choice.tolerance_mm * px_per_mm;
    fill_rows(lathe, built.profile, built.samples, built.choice, built.rows);
    const std::vector<float> angles = sectors_of(scene, desc, px_per_mm, built.profile);
    built.sectors = static_cast<int>(angles.size()) - 1;
    fill_vertices({.lathe = lathe,
                   .profile = built.profile,
                   .samples = built.samples,
                   .chosen = built.choice,
                   .rows = built.rows},
                  scene.key, angles, built.vertices);
    built.shows_load = lathe.shows_load;
    built.marks = lathe.shows_load ? nullptr : lathe.marks;
    built.section_first = static_cast<std::uint32_t>(built.vertices.size());
    if (lathe.cut) {
        const std::size_t added = add_section({.lathe = lathe,
                                               .profile = built.profile,
                                               .samples = built.samples,
                                               .chosen = built.choice,
                                               .rows = built.rows},
                                              built.sectors, built.vertices);
        built.section_count = static_cast<std::uint32_t>(added);
        built.section.dry = vec4(lathe.cut->section, 0.0F);
        built.section.wet = vec4(vec3(0.0F), lathe.shows_load ? 1.0F : 0.0F);
    }
    constexpr float kFootprintPx =
        1.2F;  // one normal per pixel, so grooves of two pixels must have begun to fade
    profile_normals(built.profile, kFootprintPx / px_per_mm, built.normals);
    if (desc.smooths_outlines)
        add_grid_edges(std::span(built.vertices).first(built.section_first), built.sectors,
                       lathe.cut.has_value(), view, built.edges);

    const vec4& foot = built.vertices.front().place;
    const vec4& across = built.vertices[static_cast<std::size_t>(built.sectors) / 2].place;
    built.frame.lathe =
        vec4(built.profile.height_mm, built.samples.per_mm, LatheSamples::kCount, built.profile.foot_mm());
    if (!lathe.cut)
        built.frame.lathe_foot = vec4(0.5F * (foot.x + across.x), 0.5F * (foot.z + across.z), 0.0F, 0.0F);
    const LatheMaterial& material = lathe.material;
    built.lathe.dry = vec4(material.albedo, material.streaks);
    built.lathe.wet = vec4(wet_albedo(material.albedo), material.soft_edge);
    // A highlight is as wide as its light: the light's half width is added to the lobe's.
    const float film = film_roughness(material);
    const float width = 0.5F * std::tan(scene.key.angular_radius_rad);
    const float film_lobe = std::sqrt(std::sqrt(film * film * film * film + width * width));
    built.lathe.gloss = vec4(material.roughness, wet_roughness(material), film_lobe, material.coat);
    built.lathe.turn = vec4(streak_turn(lathe.turn), static_cast<float>(built.sectors + 1),
                            0.02F + 0.02F * material.coat, 1.0F / std::max(material.soft_edge, 1e-4F));
    const std::size_t edge = std::min(built.profile.edge, built.profile.points.size() - 1);
    built.lathe.marks = vec4(kMarkRows / std::max(built.profile.height_mm, 1e-3F),
                             built.profile.points[edge].along_mm, kMarkColumns, kMarkLean);
}

// Points on rays from the ground towards the light, at evenly spaced heights of the outline.
void build_shadow_steps(const DirectionalLight& key, BuiltFrame& built) {
    shaders::FrameData& frame = built.frame;
    const float rise = std::max(key.towards_light.y, 0.05F);
    const float tangent = frame.key_direction.w;
    constexpr int kIntervals = 28;     // the remaining steps repeat the last
    constexpr float kFinestMm = 2.0F;  // close to the foot, a mask texel cannot resolve a narrower penumbra
    for (int i = 0; i < shaders::kShadowSteps; ++i) {
        const float fraction = static_cast<float>(std::min(i, kIntervals)) / kIntervals;
        const float y_mm = built.profile.height_mm * fraction;
        const float t = y_mm / rise;
        frame.shadow_steps[i] =
            vec4(key.towards_light.x * t - frame.lathe_foot.x, key.towards_light.z * t - frame.lathe_foot.y,
                 built.samples.outer_mm[built.samples.at(y_mm)], 1.0F / std::max(t * tangent, kFinestMm));
    }
}

}  // namespace

float wet_roughness(const LatheMaterial& material) {
    constexpr float kWetSmoothing = 0.72F;
    return material.roughness * kWetSmoothing;
}

float film_roughness(const LatheMaterial& material) {
    constexpr float kFilmRoughness = 0.20F;
    return kFilmRoughness + material.coat * (material.coat_roughness - kFilmRoughness);
}

StillBounds bounds_of(const StillLife& still_life) {
    StillBounds bounds;
    Box casters{vec3(std::numeric_limits<float>::max()), vec3(std::numeric_limits<float>::lowest())};
    for (const StillLife::Part& part : still_life.parts) {
        for (const Mesh::Vertex& vertex : part.mesh->vertices) {
            const vec3 point = part.position_mm + vertex.position_mm;
            bounds.lowest_mm = std::min(bounds.lowest_mm, point.y);
            if (!part.casts_shadow) continue;
            casters.low = glm::min(casters.low, point);
            casters.high = glm::max(casters.high, point);
        }
    }
    if (casters.low.x > casters.high.x) return bounds;
    bounds.centre_mm = 0.5F * (casters.low + casters.high);
    bounds.radius_mm = std::max(0.5F * glm::length(casters.high - casters.low), 1.0F);
    return bounds;
}

void build_frame(const Scene& scene, const StillBounds& still, const RendererDesc& desc, int width_px,
                 int height_px, BuiltFrame& built) {
    shaders::FrameData& frame = built.frame;
    frame = {};
    built.faces.clear();
    built.section_first = built.section_count = 0;
    built.shows_load = false;
    built.marks = nullptr;
    built.rows.clear();
    built.vertices.clear();
    built.edges.clear();
    built.ring_error_px = 0.0F;
    build_scene(scene, still, width_px, height_px, frame);
    const EdgeView view{scene.camera, width_px, height_px};
    if (scene.lathe) build_lathe(scene, desc, view, built);
    const std::size_t sphere_count = std::min<std::size_t>(scene.spheres.size(), kMaxSpheres);
    for (std::size_t i = 0; i < sphere_count; ++i)
        frame.spheres[i] = vec4(scene.spheres[i].centre_mm, scene.spheres[i].radius_mm);
    for (std::size_t i = sphere_count; i < kMaxSpheres; ++i)
        frame.spheres[i] = vec4(0.0F, -1e6F, 0.0F, 1e-3F);
    if (!built.rows.empty()) {
        const auto grid = std::span<const shaders::VertexData>(built.vertices).first(built.section_first);
        if (desc.inside_out) {
            take_all_faces(built.rows.size(), built.sectors, built.faces);
        } else {
            choose_faces(grid, built.sectors, frame, view, built.faces);
        }
        build_shadow_steps(scene.key, built);
    }
    std::vector<Box> moving = boxes_beside_lathe(scene);
    if (scene.lathe) moving.push_back(lathe_box(*scene.lathe));
    built.moving = pixels_of(moving, scene.camera, width_px, height_px);
}

shaders::FrameData still_frame(const Scene& scene, const StillBounds& still, int width_px, int height_px) {
    Scene lit = scene;
    lit.levels = {};
    shaders::FrameData frame{};
    build_scene(lit, still, width_px, height_px, frame);
    return frame;
}

shaders::MeshDraw mesh_draw(const Material& material, vec3 position_mm) {
    return {
        .place = vec4(position_mm, 0.0F),
        .albedo = vec4(material.albedo, material.roughness),
        .surface = vec4(material.metalness, material.groove_pitch_mm, material.groove_tilt, material.grain),
        .pattern = vec4(material.grain_stretch, 0.0F, 0.0F, 0.0F)};
}

std::uint64_t still_hash(const Scene& scene, int width_px, int height_px) {
    StateHash hash;
    hash.add(width_px);
    hash.add(height_px);
    hash.add(scene.still_life ? scene.still_life->revision : 0);
    // Structs of floats without padding.
    const auto add = [&](const auto& floats) {
        static_assert(sizeof(floats) % sizeof(float) == 0);
        hash.add_bytes(std::as_bytes(std::span(&floats, 1)));
    };
    add(scene.camera);
    add(scene.key);
    add(scene.environment);
    if (scene.irradiance) add(*scene.irradiance);
    add(scene.backdrop);
    add(scene.shadow_region);
    return hash.value();
}

std::uint64_t shadow_hash(const Scene& scene) {
    StateHash hash;
    const auto add = [&](float value) { hash.add(std::span<const float>(&value, 1)); };
    if (scene.lathe) {
        const Lathe& lathe = *scene.lathe;
        hash.add(lathe.radii_mm);
        hash.add(lathe.top_mm);
        add(lathe.element_height_mm);
        if (!lathe.centre_mm.empty()) {
            // An off-centre pot's shadow turns with it.
            for (const float value : {lathe.centre_mm[0].x, lathe.centre_mm[0].y, lathe.turn.x, lathe.turn.y})
                add(value);
        }
    }
    for (const Sphere& sphere : scene.spheres) {
        for (int axis = 0; axis < 3; ++axis)
            add(sphere.centre_mm[axis]);
        add(sphere.radius_mm);
    }
    for (int axis = 0; axis < 3; ++axis)
        add(scene.key.towards_light[axis]);
    add(scene.key.angular_radius_rad);
    add(scene.shadow_region.half_width_mm);
    add(scene.shadow_region.height_mm);
    return hash.value();
}

namespace {

// Horizontal direction of the shadow; arbitrary when the light is vertical.
vec2 shadow_direction(vec3 towards_light) {
    const vec2 flat(-towards_light.x, -towards_light.z);
    const float length = glm::length(flat);
    return length > 1e-4F ? flat / length : vec2(1.0F, 0.0F);
}

// Length of the shadow of a thing one mm high.
float shadow_length(vec3 towards_light) {
    return glm::length(vec2(towards_light.x, towards_light.z)) / std::max(towards_light.y, 0.05F);
}

float widest_radius(const Lathe& lathe) {
    if (lathe.radii_mm.empty()) return 0.0F;
    return *std::max_element(lathe.radii_mm.begin(), lathe.radii_mm.end()) + largest_offset_mm(lathe);
}

// Bottom of a ring. The index after the last ring returns the top.
float bottom_of(const Lathe& lathe, std::size_t ring) {
    const bool stacked = lathe.top_mm.size() == lathe.radii_mm.size();
    if (ring == 0 || lathe.radii_mm.empty()) return 0.0F;
    return stacked ? lathe.top_mm[ring - 1] : static_cast<float>(ring) * lathe.element_height_mm;
}

float height_of(const Lathe& lathe) {
    return bottom_of(lathe, lathe.radii_mm.size());
}

}  // namespace

MaskPlacement place_mask(const ShadowRegion& region, const DirectionalLight& light) {
    const vec2 along = shadow_direction(light.towards_light);
    const vec2 across(-along.y, along.x);
    const float back = region.half_width_mm;
    const float length = back + region.half_width_mm + region.height_mm * shadow_length(light.towards_light);
    const float width = 2.0F * region.half_width_mm;

    MaskPlacement placement;
    placement.axis_u = along * length;
    placement.axis_v = across * width;
    placement.origin = -along * back - across * region.half_width_mm;
    // q = p - L p.y / L.y, so each coordinate of q is linear in p, and so is its fraction of the rectangle.
    const vec3 light_direction = light.towards_light;
    const auto row = [&](vec2 axis, float size) {
        const vec2 unit = axis / size;
        const float lean =
            -(unit.x * light_direction.x + unit.y * light_direction.z) / std::max(light_direction.y, 0.05F);
        return vec4(unit.x, lean, unit.y, -glm::dot(unit, placement.origin)) / size;
    };
    placement.u = row(placement.axis_u, length);
    placement.v = row(placement.axis_v, width);
    return placement;
}

PixelRect pixels_of(std::span<const Box> boxes, const Camera& camera, int width_px, int height_px) {
    dvec2 low(width_px, height_px);
    dvec2 high(0.0);
    for (const Box& box : boxes) {
        for (int corner = 0; corner < 8; ++corner) {
            const dvec3 point((corner & 1) != 0 ? box.high.x : box.low.x,
                              (corner & 2) != 0 ? box.high.y : box.low.y,
                              (corner & 4) != 0 ? box.high.z : box.low.z);
            const auto projected = project(camera, width_px, height_px, point);
            if (!projected) return {0, 0, width_px, height_px};  // reaches behind the eye: it may be anywhere
            low = glm::min(low, projected->pixel);
            high = glm::max(high, projected->pixel);
        }
    }
    const auto x0 = static_cast<int>(std::clamp(std::floor(low.x) - 1.0, 0.0, static_cast<double>(width_px)));
    const auto y0 =
        static_cast<int>(std::clamp(std::floor(low.y) - 1.0, 0.0, static_cast<double>(height_px)));
    const auto x1 = static_cast<int>(std::clamp(std::ceil(high.x) + 1.0, 0.0, static_cast<double>(width_px)));
    const auto y1 =
        static_cast<int>(std::clamp(std::ceil(high.y) + 1.0, 0.0, static_cast<double>(height_px)));
    if (x1 <= x0 || y1 <= y0) return {};
    return {x0, y0, x1 - x0, y1 - y0};
}

Box lathe_box(const Lathe& lathe) {
    const float r = widest_radius(lathe) * 1.01F;  // the polygon straddles the circle
    return {{-r, 0.0F, -r}, {r, height_of(lathe), r}};
}

Box sphere_box(const Sphere& sphere) {
    return {sphere.centre_mm - sphere.radius_mm, sphere.centre_mm + sphere.radius_mm};
}

std::vector<Box> boxes_beside_lathe(const Scene& scene) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.spheres.size(), kMaxSpheres); ++i)
        boxes.push_back(sphere_box(scene.spheres[i]));
    for (const Prop& prop : scene.props) {
        if (!scene.prop_library || prop.model >= scene.prop_library->size()) continue;
        for (const Box& box : (*scene.prop_library)[prop.model].boxes_mm)
            boxes.push_back(placed(box, prop.place));
    }
    return boxes;
}

}  // namespace onggi::render
