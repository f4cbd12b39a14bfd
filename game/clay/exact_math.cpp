#include "game/clay/exact_math.h"

#include <bit>
#include <cstdint>

namespace onggi::clay {
namespace {

// ln 2 and pi/2, each as a sum of two parts. The low bits of the first part are zero, so that its integer
// multiples are exact.
constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kHalfPiHigh = 0x1.921fb544p+0;
constexpr double kHalfPiLow = 0x1.0b4611a626331p-34;

constexpr double kSqrt2 = 0x1.6a09e667f3bcdp+0;
constexpr std::uint64_t kMantissaMask = (std::uint64_t{1} << 52) - 1;
constexpr int kExponentBias = 1023;

// The integer nearest to x. Precondition: |x| < 2^62.
std::int64_t nearest_whole(double x) {
    return static_cast<std::int64_t>(x < 0.0 ? x - 0.5 : x + 0.5);
}

// 2^n as bits. Precondition: -1022 <= n <= 1023.
double power_of_two(std::int64_t n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(n + kExponentBias) << 52);
}

}  // namespace

// x = 2^n m with m in [sqrt(1/2), sqrt(2)), and
// ln m = 2 atanh(s) = 2 (s + s^3/3 + s^5/5 + ...) with s = (m - 1)/(m + 1), |s| < 0.172.
double natural_log(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    auto n = static_cast<std::int64_t>(bits >> 52) - kExponentBias;
    auto m = std::bit_cast<double>((bits & kMantissaMask) | (std::uint64_t{kExponentBias} << 52));
    if (m >= kSqrt2) {
        m *= 0.5;
        ++n;
    }
    const double s = (m - 1.0) / (m + 1.0);
    const double s2 = s * s;
    double series = 0.0;
    for (int odd = 23; odd >= 1; odd -= 2)
        series = series * s2 + 1.0 / odd;  // next term: 0.172^25 < 1e-19
    const auto whole = static_cast<double>(n);
    return whole * kLn2High + (whole * kLn2Low + 2.0 * s * series);
}

// x = n ln 2 + r with |r| <= ln 2 / 2, and the Taylor series of e^r.
double exponential(double x) noexcept {
    const std::int64_t n = nearest_whole(x * (1.0 / (kLn2High + kLn2Low)));
    const auto whole = static_cast<double>(n);
    const double r = (x - whole * kLn2High) - whole * kLn2Low;
    double series = 1.0;
    for (int k = 14; k >= 1; --k)
        series = 1.0 + series * r / k;  // next term: 0.347^15 / 15! < 1e-19
    return series * power_of_two(n);
}

double power(double base, double exponent) noexcept {
    constexpr double kSmallestNormal = 0x1p-1022;
    constexpr double kSmallestExponential = -700.0;
    if (!(base >= kSmallestNormal)) return 0.0;
    if (base >= 1.0) return 1.0;
    if (exponent == 1.0) return base;  // the paper's own rate must follow its equation exactly
    const double x = exponent * natural_log(base);
    return x > kSmallestExponential ? exponential(x) : 0.0;
}

Rotation rotation_by(double angle_rad) noexcept {
    // angle = n pi/2 + r with |r| <= pi/4, and the Taylor series of both functions there.
    const std::int64_t n = nearest_whole(angle_rad * (1.0 / (kHalfPiHigh + kHalfPiLow)));
    const auto whole = static_cast<double>(n);
    const double r = (angle_rad - whole * kHalfPiHigh) - whole * kHalfPiLow;
    const double r2 = r * r;
    double sine = 1.0;
    for (int k = 16; k >= 2; k -= 2)
        sine = 1.0 - sine * r2 / (k * (k + 1));  // next: (pi/4)^18/19! < 1e-18
    sine *= r;
    double cosine = 1.0;
    for (int k = 17; k >= 1; k -= 2)
        cosine = 1.0 - cosine * r2 / (k * (k + 1));  // next: (pi/4)^20/20!
    switch (n & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

double angle_of(double cosine, double sine) noexcept {
    // q is the smaller over the larger coordinate, in [0, 1]. It is reduced to |z| <= tan(pi/16) about one of
    // three angles with known tangents; then the series of arctan applies.
    constexpr double kHalfPi = kHalfPiHigh + kHalfPiLow;
    constexpr double kTanEighthPi = 0x1.a827999fcef32p-2;
    const double c = cosine < 0.0 ? -cosine : cosine;
    const double s = sine < 0.0 ? -sine : sine;
    const double larger = c > s ? c : s;
    if (!(larger > 0.0)) return 0.0;
    const double q = (c > s ? s : c) / larger;
    // Nearest of 0, pi/8, pi/4: the bounds are tan(pi/16) and tan(3 pi/16).
    const double base = q < 0.1989 ? 0.0 : q < 0.6682 ? kHalfPi / 4.0 : kHalfPi / 2.0;
    const double tangent = q < 0.1989 ? 0.0 : q < 0.6682 ? kTanEighthPi : 1.0;
    const double z = (q - tangent) / (1.0 + q * tangent);
    const double z2 = z * z;
    double series = 0.0;
    for (int odd = 21; odd >= 1; odd -= 2)
        series = 1.0 / odd - series * z2;  // next term: 0.199^23 / 23 < 1e-17
    double angle = base + z * series;
    if (s > c) angle = kHalfPi - angle;
    if (cosine < 0.0) angle = 2.0 * kHalfPi - angle;
    if (sine < 0.0) angle = 4.0 * kHalfPi - angle;
    return angle < 0.0 || angle >= 4.0 * kHalfPi ? 0.0 : angle;
}

}  // namespace onggi::clay
