// What stands about the wheel, what it is made of, and how it is lit: the choices that make the picture.
// Main thread.
#pragma once

#include "engine/ecs/registry.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"

namespace onggi::wheel {

// Adds the still parts, the key light and the surroundings as entities.
void furnish(ecs::Registry& registry);

[[nodiscard]] render::LatheMaterial thrown_clay();
[[nodiscard]] render::Material polished_wood();
[[nodiscard]] CameraRig throwing_camera();

}  // namespace onggi::wheel
