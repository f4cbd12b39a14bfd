// Macros that make a formula valid as both GLSL and C++. A REAL is a float in GLSL, and one or eight numbers
// (Float8) in C++. A COLOUR is all three channels in GLSL and one channel in C++, so it must not use .rgb. A
// VEC is anything with the members it uses. Number literals are written 1.0F.
#ifndef ONGGI_SHADERS_FORMULA_H
#define ONGGI_SHADERS_FORMULA_H

#ifdef __cplusplus
#include "engine/math/float8.h"
#include "engine/math/math.h"
#define FORMULA [[gnu::always_inline]] inline
#define CONSTANT inline constexpr
#define REAL auto
#define COLOUR auto
#define VEC3 const auto&
#define VEC4 const auto&
namespace onggi::shaders {
using namespace float8;
}
#else
#define FORMULA
#define CONSTANT const
#define REAL float
#define COLOUR vec3
#define VEC3 vec3
#define VEC4 vec4
float select(bool is_so, float a, float b) {
    return is_so ? a : b;
}
float exp_below_0(float number) {
    return exp(number);
}
#endif

#endif
