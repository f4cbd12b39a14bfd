#include "engine/render/camera.h"

#include <gtest/gtest.h>

namespace onggi::render {
namespace {

const Camera kCamera{
    .eye_mm = {300.0F, 400.0F, 1000.0F}, .target_mm = {0.0F, 70.0F, 0.0F}, .vertical_fov_rad = 0.4F};

TEST(Camera, SeesItsTargetInTheMiddleOfThePicture) {
    const auto projected = project(kCamera, 1280, 720, {0.0, 70.0, 0.0});
    ASSERT_TRUE(projected);
    EXPECT_NEAR(projected->pixel.x, 640.0, 1e-6);
    EXPECT_NEAR(projected->pixel.y, 360.0, 1e-6);
}

TEST(Camera, ProjectsAsItsMatrixDoes) {
    for (const dvec3 point : {dvec3(60, 0, 0), dvec3(-40, 200, 30), dvec3(0, 10, -150)}) {
        const auto projected = project(kCamera, 800, 600, point);
        ASSERT_TRUE(projected);
        const vec4 clip = view_projection(kCamera, 800, 600) * vec4(vec3(point), 1.0F);
        EXPECT_NEAR(projected->pixel.x, 400.0 * (1.0 + clip.x / clip.w), 1e-2);
        EXPECT_NEAR(projected->pixel.y, 300.0 * (1.0 + clip.y / clip.w), 1e-2);
        EXPECT_GT(clip.z, 0.0F);
        EXPECT_LT(clip.z, clip.w);
    }
}

TEST(Camera, DrawsHigherPointsFurtherUpThePicture) {
    EXPECT_LT(project(kCamera, 800, 600, {0, 200, 0})->pixel.y,
              project(kCamera, 800, 600, {0, 0, 0})->pixel.y);
}

TEST(Camera, ProjectsNoPointBehindTheEye) {
    EXPECT_FALSE(project(kCamera, 800, 600, {600, 800, 2000}));
}

TEST(Camera, SendsEveryPixelsRayBackToThatPixel) {
    for (const dvec2 pixel : {dvec2(0.5, 0.5), dvec2(100, 500), dvec2(799.5, 599.5)}) {
        const Ray ray = ray_through(kCamera, 800, 600, pixel);
        const auto projected = project(kCamera, 800, 600, ray.origin_mm + 900.0 * ray.direction);
        ASSERT_TRUE(projected);
        EXPECT_NEAR(projected->pixel.x, pixel.x, 1e-6);
        EXPECT_NEAR(projected->pixel.y, pixel.y, 1e-6);
    }
}

TEST(Camera, MeetsTheAxisPlaneWhereThePixelLooks) {
    const dvec3 away = glm::normalize(dvec3(300, 0, 1000));
    for (const dvec2 pixel : {dvec2(400, 300), dvec2(120, 40), dvec2(700, 550)}) {
        const auto place = meet_axis_plane(ray_through(kCamera, 800, 600, pixel), kCamera);
        ASSERT_TRUE(place);
        EXPECT_NEAR(glm::dot(*place, away), 0.0, 1e-9);
        const auto projected = project(kCamera, 800, 600, *place);
        ASSERT_TRUE(projected);
        EXPECT_NEAR(projected->pixel.x, pixel.x, 1e-6);
        EXPECT_NEAR(projected->pixel.y, pixel.y, 1e-6);
    }
}

TEST(Camera, MeetsNoPlaneWhereTheRayRunsAlongItOrAway) {
    const Ray along{dvec3(300, 400, 1000), {0.0, 1.0, 0.0}};
    EXPECT_FALSE(meet_axis_plane(along, kCamera));
    const Ray away{dvec3(300, 400, 1000), glm::normalize(dvec3(0.0, 0.0, 1.0))};
    EXPECT_FALSE(meet_axis_plane(away, kCamera));
    const Camera above{.eye_mm = {0.0F, 900.0F, 0.0F}, .target_mm = {0.0F, 0.0F, 0.1F}};
    EXPECT_FALSE(meet_axis_plane({dvec3(0, 900, 0), {0.0, -1.0, 0.0}}, above));
}

TEST(Camera, SaysHowManyPixelsAMillimetreSpans) {
    const double scale = pixels_per_mm(kCamera, 600);
    const dvec3 right = glm::normalize(glm::cross(dvec3(kCamera.target_mm - kCamera.eye_mm), dvec3(0, 1, 0)));
    const dvec3 target(kCamera.target_mm);
    const auto one_mm_right = project(kCamera, 800, 600, target + right);
    EXPECT_NEAR(one_mm_right->pixel.x - 400.0, scale, 1e-6);
}

TEST(BackgroundCamera, KeepsPotAndBackgroundInRegisterInEveryShapeOfPicture) {
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {1920, 1080}, {2560, 1080}, {720, 1280}, {1024, 768}, {333, 777}}) {
        const Camera camera = background_camera(kCamera, 1280, 720, width, height);
        const vec4 window = background_window(kCamera, 1280, 720, camera, width, height);
        for (const dvec3 point : {dvec3(60, 0, 0), dvec3(-40, 200, 30), dvec3(0, 10, -150)}) {
            const auto in_picture = project(camera, width, height, point);
            const auto in_background = project(kCamera, 1280, 720, point);
            ASSERT_TRUE(in_picture && in_background);
            EXPECT_NEAR(in_picture->pixel.x * window.x + window.z, in_background->pixel.x / 1280.0, 1e-5);
            EXPECT_NEAR(in_picture->pixel.y * window.y + window.w, in_background->pixel.y / 720.0, 1e-5);
        }
    }
}

TEST(BackgroundCamera, FillsThePictureAndShowsTheBackgroundsMiddle) {
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1000}, {720, 1280}}) {
        const vec4 window = background_window(
            kCamera, 1280, 720, background_camera(kCamera, 1280, 720, width, height), width, height);
        const vec2 first(window.z, window.w);
        const vec2 last =
            first + vec2(static_cast<float>(width) * window.x, static_cast<float>(height) * window.y);
        EXPECT_GE(std::min(first.x, first.y), -1e-6F);
        EXPECT_LE(std::max(last.x, last.y), 1.0F + 1e-6F);
        EXPECT_NEAR(first.x + last.x, 1.0F, 1e-6F);
        EXPECT_NEAR(std::min(first.x, first.y), 0.0F, 1e-6F) << "one way the whole plate is seen";
    }
}

TEST(BackgroundCamera, IsTheBackgroundsOwnAtTheBackgroundsSize) {
    EXPECT_NEAR(background_camera(kCamera, 1280, 720, 1280, 720).vertical_fov_rad, kCamera.vertical_fov_rad,
                1e-6F);
    EXPECT_EQ(
        background_window(kCamera, 1280, 720, background_camera(kCamera, 1280, 720, 1280, 720), 1280, 720),
        vec4(1.0F / 1280.0F, 1.0F / 720.0F, 0.0F, 0.0F));
}

TEST(BackgroundCamera, KeepsPotAndBackgroundInRegisterWhenTheLensIsShiftedAndZoomed) {
    for (const auto& [width, height] : {std::pair{1280, 720}, {720, 1280}, {1024, 768}}) {
        Camera camera = zoomed(background_camera(kCamera, 1280, 720, width, height), 0.82);
        camera.lens_shift = vec2(0.25F, -0.19F);
        const vec4 window = background_window(kCamera, 1280, 720, camera, width, height);
        const mat4 matrix = view_projection(camera, width, height);
        for (const dvec3 point : {dvec3(60, 0, 0), dvec3(-40, 200, 30), dvec3(0, 10, -150)}) {
            const auto in_picture = project(camera, width, height, point);
            const auto in_background = project(kCamera, 1280, 720, point);
            ASSERT_TRUE(in_picture && in_background);
            EXPECT_NEAR(in_picture->pixel.x * window.x + window.z, in_background->pixel.x / 1280.0, 1e-5);
            EXPECT_NEAR(in_picture->pixel.y * window.y + window.w, in_background->pixel.y / 720.0, 1e-5);
            const vec4 clip = matrix * vec4(vec3(point), 1.0F);
            EXPECT_NEAR(0.5 * width * (1.0 + double{clip.x / clip.w}), in_picture->pixel.x, 0.01);
            EXPECT_NEAR(0.5 * height * (1.0 + double{clip.y / clip.w}), in_picture->pixel.y, 0.01);
            // And back again.
            const Ray ray = ray_through(camera, width, height, in_picture->pixel);
            const dvec3 towards = glm::normalize(point - ray.origin_mm);
            EXPECT_NEAR(glm::length(towards - ray.direction), 0.0, 1e-6);
        }
    }
}

}  // namespace
}  // namespace onggi::render
