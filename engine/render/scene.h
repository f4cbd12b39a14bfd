// What a frame shows, as plain data: filled in by whoever owns the world (game/wheel does), read by the
// renderer. It knows lathes, spheres and meshes, never clay. Any thread; one writer. Lengths are mm, angles
// rad, colours linear light (1 is a white sheet facing the key light, more or less). Frame: right-handed, +Y
// up.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/camera.h"

namespace onggi::render {

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

// Clay and its like: a rough body with a film of water on it.
struct LatheMaterial {
    vec3 albedo{0.40F, 0.225F, 0.13F};
    float wetness = 0.0F;  // 0 dry to 1 dripping: darkens the body and lays a film over it
    float streaks = 0.3F;  // slip left by the fingers, as a fraction of the albedo
};

// A surface of revolution about +Y that may change every frame. Element i is centred on y = (i + 0.5)
// element_height_mm; the solid is closed by a flat base at y = 0 and a flat top.
struct Lathe {
    std::span<const float> radii_mm{};  // bottom first; must live until the draw call returns
    float element_height_mm = 0.1F;
    float edge_rounding_mm = 0.0F;  // of the top edge, so that it catches light; 0 draws the exact solid
    vec2 turn{1.0F, 0.0F};          // (cos, sin) of the angle turned about +Y
    LatheMaterial material{};
};

struct Sphere {
    vec3 centre_mm{0.0F};
    float radius_mm = 10.0F;
    Material material{};
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

constexpr int kMaxSpheres = 2;

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
    Backdrop backdrop;
    std::shared_ptr<const StillLife> still_life;
    ShadowRegion shadow_region;
    std::optional<Lathe> lathe;
    std::vector<Sphere> spheres;  // at most kMaxSpheres are drawn and cast shadows
};

}  // namespace onggi::render
