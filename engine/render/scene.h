// What a frame shows, as plain data: filled in by whoever owns the world (game/wheel does), read by the
// renderer. It knows lathes, spheres and meshes alone. Any thread; one writer. Lengths are mm, angles
// rad, colours linear light (1 is a white sheet facing the key light, more or less). Frame: right-handed, +Y
// up.
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

// Photographs of a room with the key light and without it, of one size.
struct PhotographPair {
    asset::Image key;
    asset::Image ambient;
};

// The photographs of a background on their way to the renderer. There they stay; what lies here is let go,
// for it is as much again: 7 MB a background of 1280x720. Made by any thread, then of the main thread.
class Photographs {
  public:
    using Read = std::function<Result<PhotographPair>()>;

    // `read` gives the same pair once more, where a lost device wants it again; without it they stay here.
    explicit Photographs(PhotographPair pair, Read read = {})
        : pair_(std::move(pair)),
          read_(std::move(read)) {}

    // The pair, read again if it was let go: some tens of ms. It stays until the next call or let_go().
    // Errors: those of `read`.
    [[nodiscard]] Result<const PhotographPair*> pair();
    // The renderer has them now.
    void let_go();
    [[nodiscard]] bool are_here() const { return pair_.has_value(); }

  private:
    std::optional<PhotographPair> pair_;
    Read read_;
};

// How a surface answers light.
struct Material {
    vec3 albedo{0.5F};             // of a metal: its reflectance straight on
    float roughness = 0.6F;        // GGX, 0.05 to 1; the square of it is alpha
    float metalness = 0.0F;        // 0 or 1
    float groove_pitch_mm = 0.0F;  // rings left by a lathe tool around +Y; 0: none
    float groove_tilt = 0.0F;      // how far those rings tilt the normal, as a slope
    float grain = 0.0F;            // uneven colour, as a fraction of the albedo
    float grain_stretch = 1.0F;    // how much longer along X than across: wood
};

// Earth and its like: a rough body, the water in it and the water on it, or the glaze over it. Water in the
// body darkens it, water on it shines; the two are told apart, because a body that has drunk its water is
// dark and dull.
struct LatheMaterial {
    vec3 albedo{0.5F};        // of the dry body; of a glazed one: what is seen through the glaze
    float roughness = 0.62F;  // GGX, of the dry body
    float streaks = 0.35F;    // left by the fingers, as a fraction of the albedo
    float soft_edge = 0.14F;  // how far round the edge of the lit side light scatters, as a cosine: 0 to 0.5
    float wetness = 0.0F;     // water in the body, 0 to 1, where the lathe does not say it ring by ring
    float film = 0.0F;        // water on it, likewise
    float coat = 0.0F;        // glaze, 0 none to 1
    float coat_roughness = 0.13F;

    friend bool operator==(const LatheMaterial&, const LatheMaterial&) = default;
};

// A place of a lathe's outside that was painted on.
struct LatheMark {
    // Bytes from the lowest: red, green and blue as roots of light, and how far it covers.
    std::uint32_t colour = 0;
    // Likewise: how it leans the wall, as a slope of kMarkLean at most, round it counter-clockwise from above
    // and up it; 128 not at all.
    std::uint32_t lean = kUpright;

    static constexpr std::uint32_t kUpright = 128U | 128U << 8U;
    friend bool operator==(const LatheMark&, const LatheMark&) = default;
};
constexpr int kMarkColumns = 1024;  // evenly round it, counter-clockwise in the lathe's own frame from its +X
constexpr int kMarkRows = 512;      // evenly over its height, from below
constexpr float kMarkLean = 1.0F;

// All of them. What is the same has the same revision.
struct LatheMarks {
    std::vector<LatheMark> texels{};  // kMarkRows of kMarkColumns
    std::uint64_t revision = 0;
};

// How a lathe is cut open to show its wall: what lies before the upright half plane through the axis that
// faces this way is left out, and where it was the section is drawn.
struct LatheCut {
    float towards_rad = 0.0F;  // the way the section faces: (sin, 0, cos) of it
    vec3 section{0.75F, 0.66F, 0.52F};
};

// A pot: rings about +Y that may change every frame, with an inside or solid. All spans must live until the
// draw call returns; each is empty, or has as many entries as radii_mm.
struct Lathe {
    std::span<const float> radii_mm{};  // of the outer face, bottom first
    std::span<const float>
        inner_mm{};  // of the inner face, 0 where a ring is solid; empty: solid, with a flat top
    std::span<const float> top_mm{};    // of each ring, rising; empty: rings of element_height_mm each
    std::span<const vec2> centre_mm{};  // x and z of each ring in the lathe's own frame, which turns with it
    std::span<const float> wetness{};   // water in the body, 0 to 1
    std::span<const float> film{};      // water on it, 0 to 1
    std::span<const float> load{};      // how near each ring is to giving way: 1 gives way
    // What moves the wall, both faces alike: rows of kDentSectors, evenly spaced over the height from bottom
    // to top, sectors counter-clockwise in the lathe's own frame from its +X; empty: round.
    std::span<const float> dents_mm{};
    float element_height_mm = 0.1F;
    float edge_rounding_mm = 0.0F;  // of the top edge, at most: it catches light; 0 draws it sharp
    vec2 turn{1.0F, 0.0F};          // (cos, sin) of the angle turned about +Y
    LatheMaterial material{};
    bool shows_load = false;            // `load` as a hatch and a colour, and then no marks
    const LatheMarks* marks = nullptr;  // on its outside; null: none
    std::optional<LatheCut> cut{};
};

// Not seen itself: it casts the shadow of something that moves and is about as round.
struct Sphere {
    vec3 centre_mm{0.0F};
    float radius_mm = 10.0F;
};

// Triangles, counter-clockwise seen from outside. `open_sky` is 1 where nothing stands in the way of ambient
// light and 0 in the deepest corner.
struct Mesh {
    struct Vertex {
        vec3 position_mm;
        vec3 normal;
        float open_sky = 1.0F;
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

// What stands still: drawn again only when `revision`, the camera, the light or the size changes.
struct StillLife {
    struct Part {
        std::shared_ptr<const Mesh> mesh{};
        Material material{};
        vec3 position_mm{0.0F};
        bool casts_shadow = true;  // onto other parts; not for ground as wide as the world
    };
    std::vector<Part> parts;
    std::uint64_t revision = 0;
};

// One far light with a soft edge.
struct DirectionalLight {
    vec3 towards_light{0.0F, 1.0F, 0.0F};  // unit length
    vec3 radiance{1.0F};
    float angular_radius_rad = 0.05F;  // of the source: makes the penumbra
};

// Light from everywhere else: a vertical gradient and a few soft panels (windows, reflectors). A panel's
// radiance falls off as exp(sharpness (cos angle - 1)), a spherical Gaussian.
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

// The wall behind everything: a gradient with one pool of light on it.
struct Backdrop {
    vec3 low{0.05F};
    vec3 high{0.02F};
    vec3 glow{0.1F};
    vec2 glow_centre{0.0F};  // of the picture: x right, y up, the shorter half side is 1
    float glow_radius = 1.0F;
};

// Two photographs of what stands still, with the key light and without it, of one size: values as encode() of
// shaders/tone.glsl gives them with exact sRGB. They stand in for the still life's colours and the
// backdrop's; the still life then only says where things are. A picture of another shape shows their middle,
// see background_camera().
struct Background {
    int width_px = 0;  // of both
    int height_px = 0;
    std::shared_ptr<Photographs> photographs;
    Camera camera;  // that took the whole of it
};
// Main thread. Both photographs, which stay until the background's let_go(). Errors: they cannot be read, or
// are not of the background's size.
[[nodiscard]] Result<const PhotographPair*> whole_pair(const Background& background);

// Where the camera will be cut to as soon as it may, see FrameStats::next_view_ready.
struct NextView {
    Camera camera;
    std::shared_ptr<const Background> background;
};

// How much of the light there is; the evening dims it. All 1: as the lights say and the backgrounds show.
struct LightLevels {
    vec3 ambient{1.0F};  // everything but the key light
    float key = 1.0F;
};

constexpr int kMaxSpheres = 4;

// Where the lathe and the spheres may cast shadows: the ground y = 0 and all still life below it. Whatever
// moves further out than this casts none.
struct ShadowRegion {
    float half_width_mm = 150.0F;  // of the region, across the light
    float height_mm = 230.0F;      // of the tallest thing that casts
};

struct Scene {
    Camera camera;
    DirectionalLight key;
    Environment environment;
    std::optional<std::array<vec3, 9>>
        irradiance;  // see sky_irradiance(); none: worked out from the environment
    LightLevels levels;
    Backdrop backdrop;
    std::shared_ptr<const StillLife> still_life;
    std::shared_ptr<const Background> background;  // none: the still life in its own colours
    std::optional<NextView> next_view;             // none: the camera will stay
    // What there is of this view in the picture, 0 to 1, since the camera was cut to it; the rest is the last
    // picture of the view before. None: all of it.
    std::optional<float> fade_in;
    std::vector<std::shared_ptr<const Background>>
        backgrounds_at_hand;  // kept where they are drawn from: another view may begin with any frame
    ShadowRegion shadow_region;
    std::optional<Lathe> lathe;
    std::vector<Sphere> spheres;  // at most kMaxSpheres cast shadows
    std::shared_ptr<const PropLibrary> prop_library;
    std::vector<Prop> props;  // these cast no shadow themselves
};

}  // namespace onggi::render
