// From a scene to what one frame uploads: pure functions, so that most of the renderer is tested without a
// pixel. Any thread. mm, pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/renderer_desc.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_edges.h"
#include "engine/render/shapes/lathe_faces.h"
#include "engine/render/shapes/lathe_profile.h"
#include "engine/render/shapes/lathe_rows.h"
#include "engine/render/shapes/shadow_region.h"
#include "engine/render/shapes/tiles.h"
#include "shaders/frame_data.h"

namespace onggi::render {

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

// A wet body is darker and more saturated: light that the water throws back into it is filtered once more.
// J. Lekner, M. Dorf, "Why some things are darker when wet", 1988: A' = A (1 - p) / (1 - p A), where p is the
// fraction of diffuse light that water reflects back inside; 0.66 of a body full of it.
[[nodiscard]] vec3 wet_albedo(vec3 albedo, float wetness);
// Of the body full of it.
[[nodiscard]] float wet_roughness(const LatheMaterial& material);

// Of the film of water or glaze on a turned body, to gloss: water lies thinner and smoother on it than it is
// itself; a glaze is thick.
[[nodiscard]] float film_roughness(const LatheMaterial& material);

}  // namespace onggi::render
