// Logarithm, exponential, sine and angle that have the same bits on every machine, unlike those of
// the mathematical libraries; exact to two units in the last place. They use sums, products,
// quotients, square roots and exact functions only, which every machine rounds alike.
#pragma once

#include <cmath>

namespace ripstop {

inline constexpr double ln2High = 0.693147180369123816490; // 33 bits, so that n ln2High is exact
inline constexpr double ln2Low = 1.90821492927058770002e-10;

// ln x = e ln 2 + 2 artanh((m - 1) / (m + 1)), x = m 2^e with m within a factor sqrt 2 of 1; x > 0.
inline double portableLog(double x)
{
    int e = 0;
    double m = std::frexp(x, &e);
    if (m < 0.70710678118654752) {
        m *= 2.0;
        --e;
    }
    const double s = (m - 1.0) / (m + 1.0);
    const double square = s * s;
    double sum = 0.0;
    for (int k = 23; k >= 3; k -= 2)
        sum = square * (sum + 1.0 / k);
    return e * ln2High + (2.0 * s + (2.0 * s * sum + e * ln2Low));
}

// e^x = 2^n e^r with |r| <= ln 2 / 2.
inline double portableExp(double x)
{
    if (!(x > -700.0))
        return x < 0.0 ? 0.0 : x; // not a number stays so
    if (x > 709.0)
        return HUGE_VAL;
    const double n = std::floor(x / (ln2High + ln2Low) + 0.5);
    const double r = (x - n * ln2High) - n * ln2Low;
    double sum = 1.0;
    for (int k = 15; k >= 1; --k)
        sum = 1.0 + r * sum / k;
    return std::ldexp(sum, int(n));
}

// sin x, 0 <= x <= pi / 2, by its series.
inline double portableSine(double x)
{
    double sum = 0.0;
    for (int k = 25; k >= 3; k -= 2)
        sum = x * x / (k * (k - 1)) * (1.0 - sum);
    return x * (1.0 - sum);
}

// Angle of (x, y) from the x axis, 0 to pi, for y >= 0. The angle is halved four times by
// tan a/2 = tan a / (1 + sqrt(1 + tan^2 a)); then comes the series of the arc tangent.
inline double portableAngle(double x, double y)
{
    if (!(y > 0.0))
        return x < 0.0 ? 3.14159265358979323846 : 0.0;
    const double r = std::sqrt(x * x + y * y);
    double t = x > 0.0 ? y / (r + x) : (r - x) / y;
    for (int halvings = 1; halvings < 4; ++halvings)
        t /= 1.0 + std::sqrt(1.0 + t * t);
    double sum = 0.0;
    for (int k = 25; k >= 3; k -= 2)
        sum = t * t * (1.0 / k - sum);
    return 16.0 * t * (1.0 - sum);
}

} // namespace ripstop
