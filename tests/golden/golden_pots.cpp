#include "tests/golden/golden_pots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace onggi::golden {
namespace {

constexpr int kRings = 900;
constexpr int kDentRows = 64;
constexpr int kSectors = 64;

// Uneven, as fingers leave them: about nine millimetres from one to the next.
double throwing_rings(double y) {
    return std::sin(y * 0.72 + 2.3 * std::sin(y * 0.051) + 0.8 * std::sin(y * 0.21));
}

}  // namespace

double bump(double y, double centre, double width) {
    const double fraction = (y - centre) / width;
    return std::exp(-fraction * fraction);
}

pot::Pot studio_pot(const StudioShape& shape) {
    pot::Pot pot;
    pot.height_mm = shape.height_mm;
    pot.floor_mm = shape.wall_mm ? shape.floor_mm : shape.height_mm;
    double top = 0.0;
    for (int i = 0; i < kRings; ++i) {
        // Rings are not of one height: the lower ones are taller.
        const double fraction = (i + 1.0) / kRings;
        const double next = shape.height_mm * (fraction + 0.12 * fraction * (1.0 - fraction));
        const double y = 0.5 * (top + next);
        const double outer = shape.outer_mm(y) + shape.rings_mm * throwing_rings(y);
        pot.outer_mm.push_back(static_cast<float>(outer));
        const bool hollow = shape.wall_mm && top + 1e-6 >= shape.floor_mm;
        pot.inner_mm.push_back(
            hollow
                ? static_cast<float>(std::max(
                      outer - shape.wall_mm(y) + 0.7 * shape.rings_mm * throwing_rings(y * 0.87 + 11.0), 1.0))
                : 0.0F);
        pot.top_mm.push_back(static_cast<float>(next));
        // The foot is wetter from water that ran down, the rim drier.
        const double wet = shape.liquidity * (1.15 - 0.3 * fraction);
        pot.liquidity.push_back(static_cast<float>(wet));
        pot.film.push_back(static_cast<float>(shape.film * (1.1 - 0.4 * fraction)));
        pot.load_index.push_back(0.0F);
        top = next;
    }
    return pot;
}

StudioShape jar() {
    return {
        .height_mm = 185.0,
        .outer_mm = [](double y) { return 37.0 + 43.0 * bump(y, 84.0, 50.0) + 8.0 * bump(y, 192.0, 18.0); },
        .wall_mm = [](double y) { return 8.0 - 0.018 * y; }};
}

StudioShape bottle() {
    return {
        .height_mm = 190.0,
        .outer_mm = [](double y) { return 15.0 + 52.0 * bump(y, 58.0, 46.0) + 9.0 * bump(y, 198.0, 14.0); },
        .wall_mm = [](double) { return 4.0; },
        .rings_mm = 0.25};
}

StudioShape bowl() {
    return {.height_mm = 80.0,
            .outer_mm = [](double y) { return 30.0 + 62.0 * std::pow(y / 80.0, 0.72); },
            .wall_mm = [](double y) { return 7.5 - 0.04 * y; }};
}

StudioShape plate() {
    return {.height_mm = 34.0,
            .floor_mm = 7.0,
            .outer_mm = [](double y) { return 62.0 + 73.0 * std::pow(y / 34.0, 0.8); },
            .wall_mm = [](double) { return 7.0; },
            .rings_mm = 0.2};
}

StudioShape cylinder() {
    return {.height_mm = 160.0,
            .outer_mm = [](double y) { return 46.0 - 1.5 * std::sin(y * 0.02); },
            .wall_mm = [](double) { return 6.0; }};
}

StudioShape lump() {
    return {
        .height_mm = 92.0,
        .outer_mm = [](double y) { return 64.0 * std::sqrt(std::max(1.0 - std::pow(y / 93.5, 2.6), 0.0)); },
        .wall_mm = nullptr,
        .rings_mm = 0.5};
}

StudioShape cone() {
    return {.height_mm = 165.0,
            .outer_mm = [](double y) { return 50.0 - 0.19 * y + 5.0 * std::exp(-y / 14.0); },
            .wall_mm = nullptr,
            .rings_mm = 0.8,
            .film = 1.0};
}

StudioShape opened() {
    return {.height_mm = 72.0,
            .floor_mm = 12.0,
            .outer_mm = [](double y) { return 62.0 - 3.0 * bump(y, 72.0, 20.0); },
            .wall_mm = [](double y) { return 34.0 - 0.12 * y; },
            .film = 0.9};
}

StudioShape widened() {
    return {.height_mm = 66.0,
            .floor_mm = 11.0,
            .outer_mm = [](double y) { return 64.0 - 5.0 * bump(y, 66.0, 24.0); },
            .wall_mm = [](double y) { return 14.0 - 0.05 * y; },
            .film = 0.9};
}

StudioShape bellied() {
    return {.height_mm = 150.0,
            .outer_mm = [](double y) { return 46.0 + 17.0 * bump(y, 84.0, 34.0); },
            .wall_mm = [](double y) { return 6.5 - 0.008 * y; },
            .film = 0.9};
}

StudioShape collared() {
    return {
        .height_mm = 168.0,
        .outer_mm = [](double y) { return 42.0 + 20.0 * bump(y, 66.0, 40.0) - 14.0 * bump(y, 138.0, 26.0); },
        .wall_mm = [](double y) { return 6.0 + 2.0 * bump(y, 138.0, 26.0); },
        .film = 0.9};
}

StudioShape thick_rimmed() {
    return {.height_mm = 120.0,
            .outer_mm = [](double y) { return 49.0 + 2.5 * bump(y, 121.0, 6.0); },
            .wall_mm = [](double y) { return 6.0 + 4.5 * bump(y, 121.0, 6.0); }};
}

StudioShape trimmed() {
    return {
        .height_mm = 84.0,
        .outer_mm = [](double y) { return y < 9.0 ? 36.0 : 40.0 + 48.0 * std::pow((y - 9.0) / 75.0, 0.6); },
        .wall_mm = [](double y) { return 7.0 - 0.03 * y; },
        .rings_mm = 0.12,
        .liquidity = 0.05,
        .film = 0.0};
}

StudioShape rough() {
    StudioShape shape = jar();
    shape.rings_mm = 0.0;
    shape.outer_mm = [smooth = shape.outer_mm](double y) {
        return smooth(y) + 0.25 * std::sin(2.0 * std::numbers::pi * y * 150.0 / 185.0);
    };
    return shape;
}

void press_dent(pot::Pot& pot, double y_mm, double direction_rad, double depth_mm, double width_mm) {
    pot.dents_mm.resize(std::size_t{kDentRows} * kSectors, 0.0F);
    for (int row = 0; row < kDentRows; ++row) {
        const double y = (row + 0.5) * pot.height_mm / kDentRows;
        for (int sector = 0; sector < kSectors; ++sector) {
            const double angle = (sector + 0.5) * 2.0 * std::numbers::pi / kSectors;
            const double away = std::remainder(angle - direction_rad, 2.0 * std::numbers::pi) * 50.0;
            const auto at = static_cast<std::size_t>(row * kSectors + sector);
            pot.dents_mm[at] -=
                static_cast<float>(depth_mm * bump(y, y_mm, width_mm) * bump(away, 0.0, width_mm));
        }
    }
}

void lean(pot::Pot& pot, double x_mm, double z_mm) {
    pot.centre_mm.clear();
    for (const float top : pot.top_mm) {
        const double fraction = top / pot.height_mm;
        pot.centre_mm.push_back(vec2(dvec2(x_mm, z_mm) * fraction * fraction));
    }
}

void slump(pot::Pot& pot) {
    for (std::size_t i = 0; i < pot.outer_mm.size(); ++i) {
        const double y = pot.top_mm[i];
        const auto bulge = static_cast<float>(16.0 * bump(y, 0.36 * pot.height_mm, 0.12 * pot.height_mm));
        pot.outer_mm[i] += bulge;
        if (pot.inner_mm[i] > 0.0F) pot.inner_mm[i] += bulge + 0.08F * bulge;
        pot.load_index[i] = static_cast<float>(1.1 * bump(y, 0.36 * pot.height_mm, 0.22 * pot.height_mm));
    }
    lean(pot, 17.0, 8.0);
    press_dent(pot, 0.45 * pot.height_mm, 4.4, 7.0, 24.0);
    press_dent(pot, 0.62 * pot.height_mm, 2.6, -6.0, 26.0);
}

}  // namespace onggi::golden
