// Converts positions on the wheel to pixels: clay_places WIDTH HEIGHT [low|plain] [CLAY_MM] reads a place a
// line, radius (negative: left of the axis) and height in mm on the upright plane through the axis, and
// writes its pixel. For scripts. Uses the kiosk's camera at rest, for clay of the given height, or up to 144
// mm; plain: safe mode's camera, which is another and the same for any clay.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "engine/files/asset_folder.h"
#include "game/app/kiosk/presentation/kiosk_camera.h"
#include "game/wheel/wheel_scene.h"

namespace {

using namespace onggi;

// Writes the pixel of each place that the standard input names; returns the exit code.
template <typename Project>
int write_pixels(const Project& project) {
    double radius_mm = 0.0;
    double height_mm = 0.0;
    while (std::cin >> radius_mm >> height_mm) {
        const std::optional<dvec2> px = project(dvec3(radius_mm, height_mm, 0.0));
        if (!px) {
            std::fprintf(stderr, "clay_places: %g %g: the camera does not see it\n", radius_mm, height_mm);
            return 1;
        }
        const std::string line = fmt::format("{:.0f} {:.0f}\n", px->x, px->y);
        std::fwrite(line.data(), 1, line.size(), stdout);
    }
    return 0;
}

int write_plain_pixels(int width_px, int height_px) {
    wheel::WheelScene scene;
    const render::Camera& camera = scene.camera_now(width_px, height_px);
    return write_pixels([&](const dvec3& place_mm) -> std::optional<dvec2> {
        const auto seen = render::project(camera, width_px, height_px, place_mm);
        return seen ? std::optional(seen->pixel) : std::nullopt;
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("clay_places: expected WIDTH HEIGHT [low|plain] [CLAY_MM]\n", stderr);
        return 2;
    }
    const int width_px = std::atoi(argv[1]);
    const int height_px = std::atoi(argv[2]);
    const std::string_view word = argc > 3 ? argv[3] : "";
    if (word == "plain") return write_plain_pixels(width_px, height_px);
    const auto folder = files::find_asset("workshop");
    if (!folder) {
        std::fprintf(stderr, "clay_places: %s\n", folder.error().message.c_str());
        return 3;
    }
    auto workshop = wheel::load_workshop(*folder);
    if (!workshop) {
        std::fprintf(stderr, "clay_places: %s\n", workshop.error().message.c_str());
        return 3;
    }
    wheel::WheelScene scene(std::make_shared<const wheel::Workshop>(std::move(*workshop)));
    const app::BackgroundSight sight{
        .width_px = width_px,
        .height_px = height_px,
        .project = [&](wheel::View view, const wheel::Framing& framing, const dvec3& place_mm) {
            return scene.project_framed(view, framing, width_px, height_px, place_mm);
        }};
    kiosk::State state;
    state.screen = kiosk::Screen::kThrow;
    state.comfort.reach = word == "low";
    constexpr double kLumpMm = 50.0;
    const double clay_mm = std::atof(argv[argc - 1]);  // 0 if not a number
    app::KioskCamera camera;
    const app::CameraRequest request =
        camera.request(state, true, argc > 3 && clay_mm > 0.0 ? clay_mm : kLumpMm, sight);
    return write_pixels(
        [&](const dvec3& place_mm) { return sight.project(request.view, request.framing, place_mm); });
}
