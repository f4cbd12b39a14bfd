// A frame's contents as plain data. The owner of the world (game/wheel) fills it in; the renderer reads it.
// It knows only lathes, spheres and meshes. Any thread; one writer. Lengths are mm, angles rad, colours
// linear light (1 is about a white sheet facing the key light). Frame: right-handed, +Y up.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "engine/math/dents.h"
#include "engine/math/math.h"
#include "engine/render/camera.h"
#include "engine/render/prop.h"

namespace onggi::render {

// Two photographs of a room, with and without the key light, of the same size.
struct PhotographPair {
    asset::Image key;
    asset::Image ambient;
};

// Photographs of a background on their way to the renderer. The renderer keeps its own copy, so this one is
// released after the upload: 7 MB a background of 1280x720. Created on any thread, then used on the main
// thread only.
class Photographs {
  public:
    using Read = std::function<Result<PhotographPair>()>;

    // `read` reads the same pair again when a lost device needs it. Without `read` the pair is never
    // released.
    explicit Photographs(PhotographPair pair, Read read = {})
        : pair_(std::move(pair)),
          read_(std::move(read)) {}

    // Returns the pair, and reads it again if it was released (some tens of ms). Valid until the next call or
    // let_go(). Errors: those of `read`.
    [[nodiscard]] Result<const PhotographPair*> pair();
    // Releases the pair; the renderer has its copy.
    void let_go();
    [[nodiscard]] bool are_here() const { return pair_.has_value(); }

  private:
    std::optional<PhotographPair> pair_;
    Read read_;
};

// How a surface reflects light.
struct Material {
    vec3 albedo{0.5F};             // metal: reflectance at normal incidence
    float roughness = 0.6F;        // GGX, 0.05 to 1; alpha is its square
    float metalness = 0.0F;        // 0 or 1
    float groove_pitch_mm = 0.0F;  // rings left by a lathe tool around +Y; 0: smooth
    float groove_tilt = 0.0F;      // slope by which those rings tilt the normal
    float grain = 0.0F;            // unevenness of the colour, as a fraction of the albedo
    float grain_stretch = 1.0F;    // wood: how much longer the grain is along X than across
};

// A rough earthen body, with water in it and on it, or with glaze over it. Water in the body darkens it;
// water on the surface makes it shine. They are separate, because a body that has absorbed its water is dark
// and dull.
struct LatheMaterial {
    vec3 albedo{0.5F};        // of the dry body; glazed: as seen through the glaze
    float roughness = 0.62F;  // GGX, of the dry body
    float streaks = 0.35F;    // left by the fingers, as a fraction of the albedo
    float soft_edge = 0.14F;  // how far light scatters past the edge of the lit side, as a cosine: 0 to 0.5
    float wetness = 0.0F;     // water in the body, 0 to 1; used where Lathe::wetness is empty
    float film = 0.0F;        // water on the surface, 0 to 1; used where Lathe::film is empty
    float coat = 0.0F;        // glaze, 0 to 1
    float coat_roughness = 0.13F;

    friend bool operator==(const LatheMaterial&, const LatheMaterial&) = default;
};

// A texel of paint on a lathe's outside.
struct LatheMark {
    // Bytes from the lowest: red, green and blue as square roots of light, then coverage.
    std::uint32_t colour = 0;
    // Bytes from the lowest: the wall's slope around it (counter-clockwise from above), then up it. 128 is
    // upright; the range is +-kMarkLean.
    std::uint32_t lean = kUpright;

    static constexpr std::uint32_t kUpright = 128U | 128U << 8U;
    friend bool operator==(const LatheMark&, const LatheMark&) = default;
};
constexpr int kMarkColumns = 1024;  // evenly around it, counter-clockwise from +X of the lathe's own frame
constexpr int kMarkRows = 512;      // evenly over its height, from the bottom
constexpr float kMarkLean = 1.0F;

// The texture of all marks. Equal contents have equal revisions.
struct LatheMarks {
    std::vector<LatheMark> texels{};  // kMarkRows rows of kMarkColumns texels
    std::uint64_t revision = 0;
};

// How a lathe is cut open to show its wall. Everything in front of the vertical half plane through the axis
// that faces `towards_rad` is left out, and the cut faces are drawn.
struct LatheCut {
    float towards_rad = 0.0F;  // direction that the section faces: (sin, 0, cos)
    vec3 section{0.75F, 0.66F, 0.52F};
};

// A pot: rings about +Y that may change in every frame, hollow or solid. All spans must live until the draw
// call returns; each is empty or has as many entries as radii_mm.
struct Lathe {
    std::span<const float> radii_mm{};  // of the outer face, bottom first
    std::span<const float>
        inner_mm{};  // of the inner face, 0 where a ring is solid; empty: all solid, with a flat top
    // Top of each ring, ascending; empty: each ring is element_height_mm high.
    std::span<const float> top_mm{};
    std::span<const vec2> centre_mm{};  // x and z of each ring in the lathe's own frame, which turns with it
    std::span<const float> wetness{};   // water in the body, 0 to 1
    std::span<const float> film{};      // water on the surface, 0 to 1
    std::span<const float> load{};      // how close each ring is to collapse: 1 collapses
    // Displacement of the wall, the same for both faces: rows of kDentSectors, evenly spaced over the height
    // from bottom to top; sectors counter-clockwise from +X of the lathe's own frame. Empty: round.
    std::span<const float> dents_mm{};
    float element_height_mm = 0.1F;
    float edge_rounding_mm = 0.0F;  // maximum rounding of the top edge, which catches light; 0: sharp
    vec2 turn{1.0F, 0.0F};          // (cos, sin) of the rotation about +Y
    LatheMaterial material{};
    bool shows_load = false;            // draws `load` as a hatch and a colour; then marks are not drawn
    const LatheMarks* marks = nullptr;  // on its outside; null: no marks
    std::optional<LatheCut> cut{};
};

// Invisible: casts the shadow of a moving thing of about this shape.
struct Sphere {
    vec3 centre_mm{0.0F};
    float radius_mm = 10.0F;
};

// Triangles, counter-clockwise seen from outside. `open_sky` is 1 where ambient light arrives unobstructed
// and 0 in the deepest corner.
struct Mesh {
    struct Vertex {
        vec3 position_mm;
        vec3 normal;
        float open_sky = 1.0F;
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

// Everything that stands still. Drawn again only when `revision`, the camera, the light or the size changes.
struct StillLife {
    struct Part {
        std::shared_ptr<const Mesh> mesh{};
        Material material{};
        vec3 position_mm{0.0F};
        bool casts_shadow = true;  // onto other parts; false for the ground plane
    };
    std::vector<Part> parts;
    std::uint64_t revision = 0;
};

// A directional light with a finite angular size.
struct DirectionalLight {
    vec3 towards_light{0.0F, 1.0F, 0.0F};  // unit length
    vec3 radiance{1.0F};
    float angular_radius_rad = 0.05F;  // of the source; determines the penumbra
};

// Ambient light: a vertical gradient and a few soft panels (windows, reflectors). A panel's radiance falls
// off as exp(sharpness (cos angle - 1)), a spherical Gaussian.
struct Environment {
    struct Panel {
        vec3 direction{0.0F, 1.0F, 0.0F};  // unit length
        vec3 radiance{0.0F};
        float sharpness = 4.0F;
    };
    vec3 zenith{0.2F};
    vec3 horizon{0.1F};
    vec3 nadir{0.05F};
    std::array<Panel, 3> panels{};
};

// The wall behind everything: a gradient with one pool of light.
struct Backdrop {
    vec3 low{0.05F};
    vec3 high{0.02F};
    vec3 glow{0.1F};
    vec2 glow_centre{0.0F};  // in picture coordinates: x right, y up, half the shorter side is 1
    float glow_radius = 1.0F;
};

// Two photographs of the still life, with and without the key light, of the same size; values as encode() of
// shaders/tone.glsl returns them with exact sRGB. They replace the colours of the still life and of the
// backdrop; the still life then only provides geometry. A picture of another aspect ratio shows their middle,
// see background_camera().
struct Background {
    int width_px = 0;  // size of each photograph
    int height_px = 0;
    std::shared_ptr<Photographs> photographs;
    Camera camera;  // camera of the whole photograph
};
// Main thread. Returns both photographs, which stay until the background's let_go(). Errors: they cannot be
// read, or do not have the background's size.
[[nodiscard]] Result<const PhotographPair*> whole_pair(const Background& background);

// The view that the camera will cut to as soon as FrameStats::next_view_ready is set.
struct NextView {
    Camera camera;
    std::shared_ptr<const Background> background;
};

// Light levels, for dimming in the evening. 1: as the lights say and the backgrounds show.
struct LightLevels {
    vec3 ambient{1.0F};  // all light except the key light
    float key = 1.0F;
};

constexpr int kMaxSpheres = 4;

// The region in which the lathe and the spheres cast shadows: the ground y = 0 and the still life below it.
// Things outside the region cast none.
struct ShadowRegion {
    float half_width_mm = 150.0F;  // of the region, across the light
    float height_mm = 230.0F;      // of the tallest caster
};

struct Scene {
    Camera camera;
    DirectionalLight key;
    Environment environment;
    std::optional<std::array<vec3, 9>>
        irradiance;  // see sky_irradiance(); empty: computed from the environment
    LightLevels levels;
    Backdrop backdrop;
    std::shared_ptr<const StillLife> still_life;
    std::shared_ptr<const Background> background;  // null: the still life in its own colours
    std::optional<NextView> next_view;             // empty: the camera stays
    // Cross-fade weight of this view over the last picture of the previous view, 0 to 1, after a cut. Empty:
    // no fade in progress.
    std::optional<float> fade_in;
    std::vector<std::shared_ptr<const Background>>
        backgrounds_at_hand;  // kept loaded, because the view may cut to them in any frame
    ShadowRegion shadow_region;
    std::optional<Lathe> lathe;
    std::vector<Sphere> spheres;  // at most kMaxSpheres cast shadows
    std::shared_ptr<const PropLibrary> prop_library;
    std::vector<Prop> props;  // these cast no shadow themselves
};

}  // namespace onggi::render
