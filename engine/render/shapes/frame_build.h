// Builds what one frame uploads from a scene. Pure functions, so most of the renderer can be tested without
// pixels. Any thread. mm, pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_mesh.h"
#include "engine/render/shapes/tiles.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The cut faces of an open wall: the area between outside and inside in the cutting plane, on both sides of
// the axis. mm.

constexpr std::size_t kMaxSectionVertices = 4096;

// Appends triangles, three vertices each, to a cut lathe's `vertices`: place.xyz in the world; lean.x
// distance from the axis, negative on the left; lean.y load; lean.z 0 on the outer face to 1 on the inner
// one. Returns the number of vertices.
std::size_t add_section(const LatheMeshInput& input, int sectors, std::vector<shaders::VertexData>& vertices);

// The angles of the vertices in a lathe's rows. rad from +X towards +Z, px.

// Evenly spaced, around the turn or from one side of a cut to the other: sectors + 1 angles, the last a whole
// turn (or half a turn) after the first.
[[nodiscard]] std::vector<float> even_sectors(const Lathe& lathe, int sectors);

struct SectorBudget {
    float error_px = 0.35F;  // wanted maximum distance of an edge of the pot from its circle
    int max_sectors = 48;    // hard cap
};

// Angles for the eye's position: dense where the wall turns away, because its silhouette is visible there;
// sparse in front and behind, where only the rim's edge shows corners. The number of sectors is even, and
// both sides of the line of sight have the same number.
struct LatheSeen {
    float widest_px = 0.0F;  // largest radius of the pot
    float rim_px = 0.0F;
    float azimuth_rad = 0.0F;  // direction of the eye
    float pitch_rad = 0.0F;    // angle by which the eye looks down
};
[[nodiscard]] std::vector<float> seen_sectors(const LatheSeen& seen, const SectorBudget& budget);

// The faces of a lathe's grid that are drawn: those that face the eye. They are in two groups, because
// testing the moving spheres' shadows doubles the cost of a pixel. mm.

// Two triangles per face, counter-clockwise from outside, as indices of the grid's vertices.
struct LatheFaces {
    std::vector<std::uint16_t> indices;
    std::uint32_t plain = 0;  // number of indices, at the front, whose faces no sphere's shadow reaches

    void clear() {
        indices.clear();
        plain = 0;
    }
};

// `vertices` is a grid as for add_grid_edges(). `frame` contains the spheres and the light's direction. Faces
// that are edge-on or undecidable are kept; the rasteriser culls them exactly.
void choose_faces(std::span<const shaders::VertexData> vertices, int sectors, const shaders::FrameData& frame,
                  const EdgeView& view, LatheFaces& faces);

// Takes all faces, in the second group.
void take_all_faces(std::size_t rows, int sectors, LatheFaces& faces);

// The environment's diffuse light, as nine spherical-harmonic coefficients. Any thread; a pure function, run
// when the environment changes. R. Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance
// Environment Maps", 2001.

// Returns the radiance from a direction (unit length); the same formula as in shaders/sky.glsl.
[[nodiscard]] vec3 sky_radiance(const Environment& environment, vec3 direction);

// Returns irradiance / pi for a white surface, folded so that the shader evaluates c0 + c1 y + c2 z + c3 x +
// c4 xy + c5 yz + c6 (3 z^2 - 1) + c7 xz + c8 (x^2 - y^2) at the normal.
[[nodiscard]] std::array<vec3, 9> sky_irradiance(const Environment& environment);

struct BuiltFrame {
    shaders::FrameData frame{};
    shaders::LatheDraw lathe{};
    LatheProfile profile;
    LatheSamples samples;
    LatheRows choice;
    std::vector<shaders::RowData> rows;
    int sectors = 0;  // a row has one vertex more
    std::vector<shaders::VertexData> vertices;
    std::vector<OutlinePiece> edges;  // silhouettes of moving things, if they are smoothed
    NormalTexels normals{};
    shaders::LatheDraw section{};
    std::uint32_t section_first = 0;  // first vertex of the cut faces
    std::uint32_t section_count = 0;
    bool shows_load = false;
    const LatheMarks* marks = nullptr;  // the scene's; null: no marks are shown
    LatheFaces faces;                   // empty: no lathe
    PixelRect moving;                   // where moving things can be seen
    // For the CPU backend, one entry per tile: 1 where something moves, and 1 where hands and tools are.
    std::vector<std::uint8_t> moving_tiles;
    std::vector<std::uint8_t> prop_tiles;
    float ring_error_px = 0.0F;
};

// The data of the still life that a frame needs: the depth of its ground and the extent of its shadow
// casters.
struct StillBounds {
    float lowest_mm = 0.0F;
    vec3 centre_mm{0.0F};
    float radius_mm = 1.0F;  // of a sphere about all parts that cast shadows
};
[[nodiscard]] StillBounds bounds_of(const StillLife& still_life);

// Reuses the memory of `built`. The moving tiles are found later, when all outlines are known, see
// moving_tiles.h.
void build_frame(const Scene& scene, const StillBounds& still, const RendererDesc& desc, int width_px,
                 int height_px, BuiltFrame& built);

// Returns the uniforms for the still life alone, with all lights full, regardless of the scene's levels.
[[nodiscard]] shaders::FrameData still_frame(const Scene& scene, const StillBounds& still, int width_px,
                                             int height_px);

[[nodiscard]] shaders::MeshDraw mesh_draw(const Material& material, vec3 position_mm);

// Hashes of everything that the still life's layers depend on (not the light levels), and of everything that
// the shadow mask depends on.
[[nodiscard]] std::uint64_t still_hash(const Scene& scene, int width_px, int height_px);
[[nodiscard]] std::uint64_t shadow_hash(const Scene& scene);

// Roughness of the saturated body.
[[nodiscard]] float wet_roughness(const LatheMaterial& material);

// Gloss roughness of what covers the body: a thin film of water, which is smoother than the body, or a thick
// glaze.
[[nodiscard]] float film_roughness(const LatheMaterial& material);

// The shadow mask's region of the world, and the pixels where moving things can be seen. Any thread; pure
// functions. mm, pixels.

// The mask covers a rectangle of y = 0. It begins behind the axis, as seen from the light, and extends along
// the light to the end of the tallest caster's shadow.
struct MaskPlacement {
    vec4 u;  // dot(xyz, p) + w: mask coordinate of p projected along the light onto y = 0
    vec4 v;
    vec2 origin;  // xz of u = v = 0
    vec2 axis_u;  // xz
    vec2 axis_v;
};
[[nodiscard]] MaskPlacement place_mask(const ShadowRegion& region, const DirectionalLight& light);

// The pixels in which the boxes can be seen, with a margin of one pixel.
[[nodiscard]] PixelRect pixels_of(std::span<const Box> boxes, const Camera& camera, int width_px,
                                  int height_px);

// Bounding boxes of moving things: the lathe; a sphere; all spheres and props.
[[nodiscard]] Box lathe_box(const Lathe& lathe);
[[nodiscard]] Box sphere_box(const Sphere& sphere);
[[nodiscard]] std::vector<Box> boxes_beside_lathe(const Scene& scene);

}  // namespace onggi::render
