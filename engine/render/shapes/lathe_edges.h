// Silhouettes of moving things as line segments: a pixel on a segment is shared by the surfaces on its two
// sides. A picture with one sample per pixel is smoothed along them (edge_pixels.h). Any thread; pure
// functions. mm, pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/scene.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// The camera and the picture's size.
struct EdgeView {
    const Camera& camera;
    int width_px;
    int height_px;
};

// Projects points from the world to pixels, for whole grids. The depth is a little nearer than the point's
// own, so that an edge is not hidden by its own faces. Points behind the eye are treated as just in front of
// it.
class Projector {
  public:
    explicit Projector(const EdgeView& view)
        : matrix_(view_projection(view.camera, view.width_px, view.height_px)),
          half_(0.5F * static_cast<float>(view.width_px), 0.5F * static_cast<float>(view.height_px)),
          least_mm_(view.camera.near_mm) {
        const float near = view.camera.near_mm;
        const float far = view.camera.far_mm;
        depth_scale_ = -near * far / (far - near);
        depth_offset_ = far / (far - near);
    }
    // z: depth; w: distance along the view in mm.
    [[nodiscard]] vec4 operator()(vec3 point) const {
        constexpr float kNearerMm = 2.5F;
        const float x =
            matrix_[0][0] * point.x + matrix_[1][0] * point.y + matrix_[2][0] * point.z + matrix_[3][0];
        const float y =
            matrix_[0][1] * point.x + matrix_[1][1] * point.y + matrix_[2][1] * point.z + matrix_[3][1];
        const float w = std::max(
            matrix_[0][3] * point.x + matrix_[1][3] * point.y + matrix_[2][3] * point.z + matrix_[3][3],
            least_mm_);
        const float fraction = 1.0F / w;
        return {half_.x + half_.x * x * fraction, half_.y + half_.y * y * fraction,
                std::max(depth_offset_ + depth_scale_ / std::max(w - kNearerMm, least_mm_), 0.0F), w};
    }

  private:
    mat4 matrix_;
    vec2 half_;
    float least_mm_;
    float depth_scale_ = 0.0F;
    float depth_offset_ = 0.0F;
};

constexpr std::size_t kMaxEdges = 4096;

// A line segment of the picture.
struct OutlinePiece {
    vec4 from;  // xy pixels, z depth
    vec4 to;
};

// Appends a segment; from and to are a Projector's results. Very short segments are skipped, and all of them
// once kMaxEdges are there.
void add_edge(const vec4& from, const vec4& to, std::vector<OutlinePiece>& edges);

// `vertices` is a lathe's grid: rows of sectors + 1, outward faces counter-clockwise. Appends the edges
// between front and back faces and the border of the first row; with open_sides also the two borders across
// the rows. Hidden edges are included: the depth test rejects them.
void add_grid_edges(std::span<const shaders::VertexData> vertices, int sectors, bool open_sides,
                    const EdgeView& view, std::vector<OutlinePiece>& edges);

}  // namespace onggi::render
