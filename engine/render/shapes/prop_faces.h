// Which triangles of hands and tools are drawn, where the processor is the device and pays for each vertex
// and each triangle: those that look at the eye, and of them not those that are inside the pot for sure. What
// the picture shows is the same. Any thread; pure functions. mm.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/prop.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_profile.h"

namespace onggi::render {

// What is inside the pot and cannot be seen through its mouth. A ray from there to the eye that has left the
// pot's outline before it is as high as the rim has passed the wall.
class InsidePot {
  public:
    // Nothing, of a lathe that is cut open. The samples, which are the lathe's, must outlive it.
    InsidePot(const Lathe& lathe, const LatheSamples& samples, vec3 eye_mm);
    [[nodiscard]] bool hides(vec3 point_mm) const;

  private:
    const LatheSamples* samples_;
    vec3 eye_mm_;
    float slack_mm_;       // of the outline, by which dents and a throw off the centre move it
    float rim_mm_;         // a little below the top; 0: hides nothing
    float outside_2_mm2_;  // at that height, from the axis, squared
};

// A triangle's plane in its mesh's own frame: the normal outwards, not of unit length, and how far along it
// the triangle lies. One a triangle, in the order of the indices.
[[nodiscard]] std::vector<vec4> face_planes(const PropMesh& mesh);

// A mesh where a prop has it.
struct PlacedMesh {
    const PropMesh& mesh;
    std::span<const vec4> planes;
    const mat4& place;
};
// One entry a triangle: whether it looks at the eye, or is seen edge on.
[[nodiscard]] std::vector<std::uint8_t> faces_towards(const PlacedMesh& placed, vec3 eye_mm);
// Appends the indices of the triangles to draw, of those that look at the eye. `pot` may be null: there is
// none.
void choose_prop_faces(const PlacedMesh& placed, std::span<const std::uint8_t> towards_eye,
                       const InsidePot* pot, std::vector<std::uint32_t>& indices);

}  // namespace onggi::render
