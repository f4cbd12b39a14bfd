// What happens to the clay once a frame: the pot on the wheel becomes the lathe that is drawn.
#include <algorithm>
#include <cmath>

#include "game/wheel/clay_look.h"
#include "game/wheel/systems.h"

namespace onggi::wheel {
static_assert(pot::kDentSectors == render::kDentSectors, "the lathe draws the pot's map of dents as it is");

void receive_clay(ecs::Registry& registry, FrameContext& context) {
    const pot::Pot& pot = *context.shown->pot;
    registry.each<Clay>([&](ecs::Entity, Clay& clay) {
        clay.pot = &pot;
        const render::LatheMaterial* own = context.shown->material;
        clay.material = own != nullptr ? *own : clay_material(pot.body, pot.stage);
        clay.marks = context.shown->marks;
        clay.wetness.clear();
        // Dry clay has none, whatever it held when it was thrown.
        if (pot.stage != clay::Firing::kWet) return;
        clay.wetness.resize(pot.liquidity.size());
        std::transform(pot.liquidity.begin(), pot.liquidity.end(), clay.wetness.begin(), darkness_of);
    });
}

void extract_clay(ecs::Registry& registry, FrameContext& context) {
    context.scene.lathe.reset();
    registry.each<Clay, Wheel>([&](ecs::Entity, const Clay& clay, const Wheel& wheel) {
        const pot::Pot& pot = *clay.pot;
        if (pot.outer_mm.empty()) return;
        render::Lathe lathe{
            .radii_mm = pot.outer_mm,
            .inner_mm = pot.inner_mm,
            .top_mm = pot.top_mm,
            .centre_mm = pot.centre_mm,
            .wetness = clay.wetness,
            .load = pot.load_index,
            .dents_mm = pot.dents_mm,
            .element_height_mm = static_cast<float>(pot.height_mm / static_cast<double>(pot.ring_count())),
            .edge_rounding_mm = clay.edge_rounding_mm,
            .turn = vec2(wheel.direction),
            .material = clay.material,
            .shows_load = clay.shows_load,
            .marks = clay.marks};
        if (pot.stage == clay::Firing::kWet) lathe.film = pot.film;
        if (clay.is_cut_open) {
            const vec3& eye = context.scene.camera.eye_mm;
            lathe.cut = render::LatheCut{.towards_rad = std::atan2(eye.x, eye.z),
                                         .section = section_colour(lathe.material)};
        }
        context.scene.lathe = lathe;
    });
}

}  // namespace onggi::wheel
