// What stands about the wheel, what it is made of, and how it is lit: the choices that make the picture.
// Main thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"
#include "game/wheel/room_model.h"

namespace onggi::wheel {

// Adds the still parts, the key light and the surroundings as entities: a small still life that needs no
// file.
void furnish(ecs::Registry& registry);

// The same for a photographed workshop: its light, and the surfaces on which a pot's shadow can fall. They
// have no looks of their own: the backgrounds lie on them.
void stand_in(ecs::Registry& registry, const Workshop& workshop);

// A modelled room in the workshop's light, with our wheel if it has none of its own.
void build_room(ecs::Registry& registry, const Workshop& workshop, RoomModel model);

[[nodiscard]] CameraRig throwing_camera();

}  // namespace onggi::wheel
