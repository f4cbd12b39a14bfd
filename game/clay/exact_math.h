// Power, logarithm, exponential, sine, cosine and angle from + - x / only. The tick may not call libm: its
// last bits depend on the processor's fused multiply-add, and a recording would no longer replay. Tested to
// be within 1e-12 of libm. Any thread; no allocation, fit for the tick.
#pragma once

namespace onggi::clay {

// base^exponent for base in (0, 1] and exponent from 0.1 to 10. Returns 0 for a smaller base and 1 for a
// larger one.
[[nodiscard]] double power(double base, double exponent) noexcept;

// Natural logarithm. Precondition: x is a normal number above zero.
[[nodiscard]] double natural_log(double x) noexcept;

// e^x. Precondition: |x| <= 700.
[[nodiscard]] double exponential(double x) noexcept;

// The angle of a direction, 0 <= angle < 2 pi rad; 0 for (0, 0). The length does not matter.
[[nodiscard]] double angle_of(double cosine, double sine) noexcept;

// A rotation as the unit vector that +X is turned to.
struct Rotation {
    double cosine = 1.0;
    double sine = 0.0;
};

// The rotation by an angle, |angle_rad| <= 1000.
[[nodiscard]] Rotation rotation_by(double angle_rad) noexcept;

}  // namespace onggi::clay
