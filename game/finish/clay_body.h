// The looks of each clay body from wet to glazed, defined only here: for the wheel's picture, for exported
// files and for the workshop's maker (assets/workshop/maker/paint.py keeps a copy of stoneware's, which a
// test compares). Chosen by eye, against photographs of the three bodies. Any thread; constant. Linear light.
#pragma once

#include "engine/math/math.h"
#include "game/clay/studio/pot.h"

namespace onggi::finish {

struct BodyLook {
    dvec3 raw;       // without its water
    dvec3 bone_dry;  // dust lies on it
    dvec3 bisque;
    dvec3 glazed;     // under the body's own glaze: celadon on stoneware and porcelain, clear on earthenware
    float streaks;    // slip is as fine as the body
    float soft_edge;  // porcelain lets light in
};

inline constexpr BodyLook kStoneware{.raw = {0.36, 0.29, 0.215},
                                     .bone_dry = {0.42, 0.36, 0.29},
                                     .bisque = {0.56, 0.37, 0.25},
                                     .glazed = {0.30, 0.40, 0.31},
                                     .streaks = 0.35F,
                                     .soft_edge = 0.14F};
inline constexpr BodyLook kPorcelain{.raw = {0.72, 0.69, 0.63},
                                     .bone_dry = {0.80, 0.785, 0.75},
                                     .bisque = {0.83, 0.79, 0.735},
                                     .glazed = {0.80, 0.815, 0.795},
                                     .streaks = 0.10F,
                                     .soft_edge = 0.32F};
inline constexpr BodyLook kEarthenware{.raw = {0.40, 0.155, 0.075},
                                       .bone_dry = {0.48, 0.245, 0.15},
                                       .bisque = {0.60, 0.27, 0.14},
                                       .glazed = {0.36, 0.11, 0.045},
                                       .streaks = 0.30F,
                                       .soft_edge = 0.14F};

[[nodiscard]] constexpr const BodyLook& look_of(clay::ClayBody body) {
    return body == clay::ClayBody::kPorcelain     ? kPorcelain
           : body == clay::ClayBody::kEarthenware ? kEarthenware
                                                  : kStoneware;
}

}  // namespace onggi::finish
