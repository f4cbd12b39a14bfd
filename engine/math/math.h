// glm, with the choices of this house made once: radians, depth 0..1, no SIMD types behind our back (the
// tick's bits must not depend on the compiler's instruction set). The only file that includes glm.
#pragma once

#define GLM_FORCE_RADIANS
#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#define GLM_FORCE_XYZW_ONLY
#define GLM_FORCE_PURE
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace onggi {

using glm::dmat3;
using glm::dmat4;
using glm::dquat;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::vec2;
using glm::vec3;
using glm::vec4;

// Half a turn and a whole one, rad; with an F where the sum is of floats.
constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2.0 * kPi;
constexpr auto kPiF = static_cast<float>(kPi);
constexpr auto kTurnF = static_cast<float>(kTurn);

}  // namespace onggi
