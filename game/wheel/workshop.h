// The still life around the wheel, its materials and its light: the choices that shape the picture. Main
// thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"
#include "game/wheel/room_model.h"

namespace onggi::wheel {

// Adds the still parts, the key light and the surroundings as entities: a small still life that needs no
// file.
void furnish(ecs::Registry& registry);

// The same for a photographed workshop: its light, and the surfaces that catch a pot's shadow. They are not
// drawn themselves: the backgrounds are projected on them.
void stand_in(ecs::Registry& registry, const Workshop& workshop);

// Adds a modelled room in the workshop's light, with our wheel if it has none of its own.
void build_room(ecs::Registry& registry, const Workshop& workshop, RoomModel model);

[[nodiscard]] CameraRig throwing_camera();

}  // namespace onggi::wheel
