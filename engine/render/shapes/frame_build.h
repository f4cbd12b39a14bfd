// From a scene to what one frame uploads: pure functions, so that most of the renderer is tested without a
// pixel. Any thread. mm, pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_profile.h"
#include "engine/render/shapes/lathe_rows.h"
#include "engine/render/shapes/lathe_vertices.h"
#include "engine/render/shapes/shadow_region.h"
#include "engine/render/shapes/tiles.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The faces of a wall that has been cut open: what lies between outside and inside where the cut goes
// through it, on both sides of the axis. mm.

constexpr std::size_t kMaxSectionVertices = 4096;

// Appends triangles, three vertices each, to a cut lathe's `vertices`: place.xyz in the world; lean.x how far
// from the axis, left negative; lean.y load; lean.z 0 on the outer face to 1 on the inner one. Says how many.
std::size_t add_section(const LatheMeshInput& input, int sectors, std::vector<shaders::VertexData>& vertices);

// At which angles a lathe's rows have their vertices. rad from +X towards +Z,
// px.

// Evenly round, or from one side of a cut to the other: sectors + 1 angles, the last a whole turn (or half a
// turn) after the first.
[[nodiscard]] std::vector<float> even_sectors(const Lathe& lathe, int sectors);

struct SectorBudget {
    float error_px = 0.35F;  // wanted: how far an edge of the pot may lie from its circle
    int max_sectors = 48;    // hard
};

// As seen by the eye: close to each other where the wall turns away and its edge is seen against what lies
// behind, further apart in front and behind, where only the rim's edge shows a corner. An even number of
// sectors, the same on both sides of the line of sight.
struct LatheSeen {
    float widest_px = 0.0F;  // radii
    float rim_px = 0.0F;
    float azimuth_rad = 0.0F;  // of the eye
    float pitch_rad = 0.0F;    // how far it looks down
};
[[nodiscard]] std::vector<float> seen_sectors(const LatheSeen& seen, const SectorBudget& budget);

// Which faces of a lathe's grid are drawn: those that look at the eye, in two heaps, because a pixel that
// must ask the moving spheres for their shadow costs twice one that need not.
// mm.

// Two triangles a face, counter-clockwise from outside, as indices of the grid's vertices.
struct LatheFaces {
    std::vector<std::uint16_t> indices;
    std::uint32_t plain = 0;  // how many of them, at the front, no sphere's shadow reaches

    void clear() {
        indices.clear();
        plain = 0;
    }
};

// The grid as add_grid_edges() has it. `frame` says where the spheres are and where the light comes from. A
// face that is seen edge on, or of which it cannot be said, is drawn: the device looks once more.
void choose_faces(std::span<const shaders::VertexData> vertices, int sectors, const shaders::FrameData& frame,
                  const EdgeView& view, LatheFaces& faces);

// All of them, in the second heap.
void take_all_faces(std::size_t rows, int sectors, LatheFaces& faces);

// The environment's diffuse light, as nine spherical-harmonic coefficients. Any thread; a pure function, run
// when the environment changes. R. Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance
// Environment Maps", 2001.

// Radiance from a direction (unit length), the same formula as in shaders/sky.glsl.
[[nodiscard]] vec3 sky_radiance(const Environment& environment, vec3 direction);

// Irradiance / pi for a white surface, folded so that the shader evaluates
// c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3 z^2 - 1) + c7 xz + c8 (x^2 - y^2) at the normal.
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
    std::vector<OutlinePiece> edges;  // outlines of what moves, where they are smoothed
    NormalTexels normals{};
    shaders::LatheDraw section{};
    std::uint32_t section_first = 0;  // of the vertices, the faces of a cut
    std::uint32_t section_count = 0;
    bool shows_load = false;
    const LatheMarks* marks = nullptr;  // of the scene; null: none are shown
    LatheFaces faces;                   // none: no lathe
    PixelRect moving;                   // where anything that moves can be seen
    // For the processor: which tiles that is in (kMoves and its like), and which of them hands and tools are
    // in; one entry a tile.
    std::vector<std::uint8_t> moving_tiles;
    std::vector<std::uint8_t> prop_tiles;
    float ring_error_px = 0.0F;
};

// What of the still life the frame needs to know: its ground's depth and the size of what casts shadows.
struct StillBounds {
    float lowest_mm = 0.0F;
    vec3 centre_mm{0.0F};
    float radius_mm = 1.0F;  // of a sphere about all parts that cast shadows
};
[[nodiscard]] StillBounds bounds_of(const StillLife& still_life);

// Into `built`, whose memory is used again. The tiles in which something moves are found when all outlines
// are there, see moving_tiles.h.
void build_frame(const Scene& scene, const StillBounds& still, const RendererDesc& desc, int width_px,
                 int height_px, BuiltFrame& built);

// The frame's uniforms for what stands still alone, with all lights full, whatever the scene's levels.
[[nodiscard]] shaders::FrameData still_frame(const Scene& scene, const StillBounds& still, int width_px,
                                             int height_px);

[[nodiscard]] shaders::MeshDraw mesh_draw(const Material& material, vec3 position_mm);

// Of everything the layers of what stands still depend on (the levels of the light do not count), and of
// everything the shadow mask does.
[[nodiscard]] std::uint64_t still_hash(const Scene& scene, int width_px, int height_px);
[[nodiscard]] std::uint64_t shadow_hash(const Scene& scene);

// Of the body full of it.
[[nodiscard]] float wet_roughness(const LatheMaterial& material);

// Of the film of water or glaze on a turned body, to gloss: water lies thinner and smoother on it than it is
// itself; a glaze is thick.
[[nodiscard]] float film_roughness(const LatheMaterial& material);

}  // namespace onggi::render
