#include "engine/render/camera.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

struct Frame {
    dvec3 forward;
    dvec3 right;
    dvec3 up;
};

Frame frame_of(const Camera& camera) {
    const dvec3 forward = glm::normalize(dvec3(camera.target_mm) - dvec3(camera.eye_mm));
    const dvec3 right = glm::normalize(glm::cross(forward, dvec3(0.0, 1.0, 0.0)));
    return {forward, right, glm::cross(right, forward)};
}

// Half the height of the view frustum at a distance of 1 mm.
double half_height_of(const Camera& camera) {
    return std::tan(0.5 * static_cast<double>(camera.vertical_fov_rad));
}

}  // namespace

mat4 view_projection(const Camera& camera, int width_px, int height_px) {
    const float aspect = static_cast<float>(width_px) / static_cast<float>(height_px);
    mat4 projection = glm::perspective(camera.vertical_fov_rad, aspect, camera.near_mm, camera.far_mm);
    projection[1][1] *= -1.0F;  // Vulkan's y points down
    projection[2][0] -= camera.shift.x + camera.lens_shift.x;
    projection[2][1] -= camera.shift.y + camera.lens_shift.y;
    return projection * glm::lookAt(camera.eye_mm, camera.target_mm, vec3(0.0F, 1.0F, 0.0F));
}

Ray ray_through(const Camera& camera, int width_px, int height_px, dvec2 pixel) {
    const Frame frame = frame_of(camera);
    const double half_height = half_height_of(camera);
    const double half_width = half_height * width_px / height_px;
    const dvec2 lens(camera.lens_shift);
    const double x = (2.0 * pixel.x / width_px - 1.0 - lens.x) * half_width;
    const double y = (1.0 - 2.0 * pixel.y / height_px + lens.y) * half_height;
    return {dvec3(camera.eye_mm), glm::normalize(frame.forward + x * frame.right + y * frame.up)};
}

std::optional<dvec3> meet_axis_plane(const Ray& ray, const Camera& camera) {
    const dvec3 away(static_cast<double>(camera.eye_mm.x), 0.0, static_cast<double>(camera.eye_mm.z));
    const double distance = glm::length(away);
    if (distance == 0.0) return std::nullopt;  // the camera looks straight down: no vertical plane faces it
    const dvec3 normal = away / distance;
    const double slope = glm::dot(ray.direction, normal);
    constexpr double kParallel = 1e-6;
    if (slope > -kParallel) return std::nullopt;
    const double along = -glm::dot(ray.origin_mm, normal) / slope;
    return ray.origin_mm + along * ray.direction;
}

std::optional<Projected> project(const Camera& camera, int width_px, int height_px, dvec3 point_mm) {
    const Frame frame = frame_of(camera);
    const dvec3 from_eye = point_mm - dvec3(camera.eye_mm);
    const double depth = glm::dot(from_eye, frame.forward);
    if (depth <= 0.0) return std::nullopt;
    const double half_height = half_height_of(camera) * depth;
    const double half_width = half_height * width_px / height_px;
    const double x = glm::dot(from_eye, frame.right) / half_width;
    const double y = glm::dot(from_eye, frame.up) / half_height;
    const dvec2 lens(camera.lens_shift);
    return Projected{{(1.0 + lens.x + x) * 0.5 * width_px, (1.0 + lens.y - y) * 0.5 * height_px}, depth};
}

namespace {

// The factor by which the background is enlarged to cover the picture in both directions.
double background_scale(int background_width_px, int background_height_px, int width_px, int height_px) {
    return std::max(static_cast<double>(width_px) / background_width_px,
                    static_cast<double>(height_px) / background_height_px);
}

}  // namespace

Camera background_camera(const Camera& of_background, int background_width_px, int background_height_px,
                         int width_px, int height_px) {
    const double scale = background_scale(background_width_px, background_height_px, width_px, height_px);
    Camera camera = of_background;
    camera.vertical_fov_rad = static_cast<float>(
        2.0 * std::atan(half_height_of(of_background) * height_px / (scale * background_height_px)));
    return camera;
}

vec4 background_window(const Camera& of_background, int background_width_px, int background_height_px,
                       const Camera& shown, int width_px, int height_px) {
    const double scale = background_scale(background_width_px, background_height_px, width_px, height_px) *
                         half_height_of(background_camera(of_background, background_width_px,
                                                          background_height_px, width_px, height_px)) /
                         half_height_of(shown);
    const dvec2 pixel(1.0 / (scale * background_width_px), 1.0 / (scale * background_height_px));
    const dvec2 middle = 0.5 * dvec2(width_px, height_px) * (dvec2(1.0) + dvec2(shown.lens_shift));
    return vec4(vec2(pixel), vec2(0.5 - middle.x * pixel.x, 0.5 - middle.y * pixel.y));
}

Camera zoomed(const Camera& camera, double factor) {
    Camera nearer = camera;
    if (factor != 1.0)
        nearer.vertical_fov_rad = static_cast<float>(2.0 * std::atan(half_height_of(camera) / factor));
    return nearer;
}

double pixels_per_mm(const Camera& camera, int height_px) {
    const double distance = glm::length(dvec3(camera.target_mm) - dvec3(camera.eye_mm));
    return height_px / (2.0 * half_height_of(camera) * distance);
}

}  // namespace onggi::render
