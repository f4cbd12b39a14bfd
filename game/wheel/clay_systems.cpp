// What happens to the clay once a frame: a snapshot's columns become the picture's own, and those the lathe
// that is drawn.
#include <algorithm>
#include <cmath>

#include "game/wheel/clay_look.h"
#include "game/wheel/systems.h"

namespace onggi::wheel {
namespace {

void copy(std::span<const float> from, std::vector<float>& into) {
    into.assign(from.begin(), from.end());
}

}  // namespace

void receive_clay(ecs::Registry& registry, FrameContext& context) {
    const PotView& pot = *context.pot;
    registry.each<Clay>([&](ecs::Entity, Clay& clay) {
        copy(pot.radii_mm, clay.radii_mm);
        copy(pot.inner_mm, clay.inner_mm);
        copy(pot.top_mm, clay.top_mm);
        copy(pot.film, clay.film);
        copy(pot.load_index, clay.load);
        clay.centre_mm.resize(pot.centre_mm.size() / 2);
        for (std::size_t i = 0; i < clay.centre_mm.size(); ++i)
            clay.centre_mm[i] = {pot.centre_mm[2 * i], pot.centre_mm[2 * i + 1]};
        clay.wetness.resize(pot.liquidity.size());
        std::transform(pot.liquidity.begin(), pot.liquidity.end(), clay.wetness.begin(), darkness_of);
        // The picture knows maps of its own number of sectors only; another one is drawn round.
        clay.dents_mm.clear();
        if (pot.dent_sectors == render::kDentSectors) copy(pot.dents_mm, clay.dents_mm);
        clay.height_mm = pot.height_mm;
        clay.body = pot.body;
        clay.stage = pot.stage;
    });
}

void extract_clay(ecs::Registry& registry, FrameContext& context) {
    context.scene.lathe.reset();
    registry.each<Clay, Wheel>([&](ecs::Entity, const Clay& clay, const Wheel& wheel) {
        if (clay.radii_mm.empty()) return;
        render::Lathe lathe{.radii_mm = clay.radii_mm,
                            .inner_mm = clay.inner_mm,
                            .top_mm = clay.top_mm,
                            .centre_mm = clay.centre_mm,
                            .load = clay.load,
                            .dents_mm = clay.dents_mm,
                            .element_height_mm = static_cast<float>(
                                clay.height_mm / static_cast<double>(clay.radii_mm.size())),
                            .edge_rounding_mm = clay.edge_rounding_mm,
                            .turn = vec2(wheel.direction),
                            .material = clay_material(clay.body, clay.stage),
                            .shows_load = clay.shows_load};
        // Dry clay has neither, whatever it held when it was thrown.
        if (clay.stage == clay::Firing::kWet) {
            lathe.wetness = clay.wetness;
            lathe.film = clay.film;
        }
        if (clay.is_cut_open) {
            const vec3& eye = context.scene.camera.eye_mm;
            lathe.cut = render::LatheCut{.towards_rad = std::atan2(eye.x, eye.z),
                                         .section = section_colour(lathe.material)};
        }
        context.scene.lathe = lathe;
    });
}

}  // namespace onggi::wheel
