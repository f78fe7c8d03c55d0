// A taut cloth is one product. Where a component pushes, Wrinkles looks for the direction that
// pulls: along (1, u) in the plane, u being its slope, the function (t.e.t) / sqrt(D(t)) does not
// depend on the length of t and has its greatest value where a quartic in u is 0.
#include "base/cloth_law.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

bool pushesNowhere(const Vec3& tension)
{
    return tension[0] >= 0.0 && tension[1] >= 0.0
           && tension[0] * tension[1] >= tension[2] * tension[2];
}

struct Compliance // m/N; D(t) = first + both u^2 + second u^4 for t = (1, u)
{
    double first, second, coupling, shear;
    explicit Compliance(const ClothLaw& law)
    {
        const double determinant = law.warp * law.weft - law.coupling * law.coupling;
        first = law.weft / determinant;
        second = law.warp / determinant;
        coupling = -law.coupling / determinant;
        shear = 1.0 / law.shear;
    }
};

// Tension along t = (1, u) alone. `e` along t, e11 + g u + e22 u^2, must be positive there.
class Wrinkles
{
public:
    Wrinkles(double e11, double e22, double g, double first, double second, double both)
        : m_e11(e11)
        , m_e22(e22)
        , m_g(g)
        , m_first(first)
        , m_second(second)
        , m_both(both)
        , m_slope{g * first, 2.0 * e22 * first - e11 * both, e22 * both - 2.0 * e11 * second,
                  -g * second}
    {}

    double strain(double u) const { return m_e11 + u * (m_g + u * m_e22); }
    double compliance(double u) const { return m_first + u * u * (m_both + u * u * m_second); }

    // The square of what is to be greatest; 0 where t does not pull.
    double pull(double u) const
    {
        const double along = strain(u);
        return along > 0.0 ? along * along / compliance(u) : 0.0;
    }

    // Where the pull is greatest for 0 <= u <= `last`. A peak in between is a root of the slope.
    // There is one positive root, or there are three: a peak near each axis, and samples of the
    // slope, which stand closer near 0, part them.
    double greatest(double last) const
    {
        const bool hasTwoPeaks = m_slope[1] < 0.0 && m_slope[2] > 0.0;
        if (!hasTwoPeaks)
            return slope(last) > 0.0 ? last : peak(0.0, last);
        constexpr int samples = 14;
        double best = pull(0.0) > pull(last) ? 0.0 : last;
        double most = pull(best);
        double high = last;
        bool risesAtHigh = slope(high) > 0.0;
        for (int i = 0; i < samples; ++i) {
            const double low = i + 1 < samples ? 0.5 * high : 0.0;
            const bool rises = slope(low) > 0.0;
            if (rises && !risesAtHigh) {
                const double found = peak(low, high);
                if (const double pulls = pull(found); pulls > most) {
                    best = found;
                    most = pulls;
                }
            }
            high = low;
            risesAtHigh = rises;
        }
        return best;
    }

private:
    // Positive where the pull grows with u.
    double slope(double u) const
    {
        return m_slope[0] + u * (m_slope[1] + u * u * (m_slope[2] + u * m_slope[3]));
    }

    // Newton's method between two places; where it leaves them, they are halved. Each step squares
    // the error that the last one left.
    double peak(double low, double high) const
    {
        double u = 0.5 * (low + high);
        for (int i = 0; i < 60; ++i) {
            const double value = slope(u);
            (value > 0.0 ? low : high) = u;
            const double rise = m_slope[1] + u * u * (3.0 * m_slope[2] + 4.0 * u * m_slope[3]);
            double next = u - value / rise;
            if (!(next >= low && next <= high))
                next = 0.5 * (low + high);
            const double way = std::abs(next - u);
            u = next;
            if (!(way > 1e-9 * u))
                break;
        }
        return u;
    }

    double m_e11, m_e22, m_g, m_first, m_second, m_both;
    std::array<double, 4> m_slope; // of 1, u, u^3, u^4
};

// Tension r (1, u^2, u), r = e / D, and its derivatives, in the order of the axes that u belongs
// to.
ClothTension wrinkled(const Vec3& strain, double first, double second, double both, double u)
{
    const double compliance = first + u * u * (both + u * u * second);
    const double along = strain[0] + u * (strain[2] + u * strain[1]);
    const double r = along / compliance;
    const double slope = u * (2.0 * both + 4.0 * u * u * second); // of D
    const double bend = 2.0 * both + 12.0 * u * u * second;
    const double turned = -0.5 * r * slope / compliance; // r' where the energy is stationary
    const double curvature =
        r * (2.0 * strain[1] - 0.5 * turned * slope - 0.5 * r * bend); // of the energy
    const Vec3 t(1.0, u * u, u);
    const Vec3 t1(0.0, 2.0 * u, 1.0);
    ClothTension result;
    result.state = ClothState::Wrinkled;
    result.tension = r * t;
    result.energy = 0.5 * along * r;
    result.stiffness = t * t.transpose() / compliance;
    if (curvature < 0.0) {
        const Vec3 turn = turned * t + r * t1;
        result.stiffness -= turn * turn.transpose() / curvature;
    }
    return result;
}

void swapAxes(ClothTension& tension)
{
    std::swap(tension.tension[0], tension.tension[1]);
    tension.stiffness.row(0).swap(tension.stiffness.row(1));
    tension.stiffness.col(0).swap(tension.stiffness.col(1));
}

ClothTension wrinkledOf(const ClothLaw& law, const Vec3& strain)
{
    // Which way the threads shear only mirrors the direction.
    const double sign = strain[2] < 0.0 ? -1.0 : 1.0;
    const double g = sign * strain[2];
    const Compliance c(law);
    const double both = 2.0 * c.coupling + c.shear;
    const double middle = std::sqrt(std::sqrt(c.first / c.second));
    const Wrinkles fromWarp(strain[0], strain[1], g, c.first, c.second, both);
    const Wrinkles fromWeft(strain[1], strain[0], g, c.second, c.first, both);
    const double warpSlope = fromWarp.greatest(middle);
    const double weftSlope = fromWeft.greatest(1.0 / middle);
    const bool warp = fromWarp.pull(warpSlope) >= fromWeft.pull(weftSlope);
    if (!(std::max(fromWarp.pull(warpSlope), fromWeft.pull(weftSlope)) > 0.0))
        return {};
    ClothTension result =
        warp ? wrinkled({strain[0], strain[1], g}, c.first, c.second, both, warpSlope)
             : wrinkled({strain[1], strain[0], g}, c.second, c.first, both, weftSlope);
    if (!warp)
        swapAxes(result);
    result.tension[2] *= sign;
    result.stiffness.row(2) *= sign;
    result.stiffness.col(2) *= sign;
    return result;
}

} // namespace

ClothLaw ClothLaw::of(double warp, double weft, double poisson, double shear)
{
    const double across = poisson * weft / warp;
    const double share = 1.0 / (1.0 - poisson * across);
    ClothLaw law;
    law.warp = warp * share;
    law.weft = weft * share;
    law.coupling = poisson * weft * share;
    law.shear = shear;
    return law;
}

Mat3 stiffnessOf(const ClothLaw& law)
{
    Mat3 stiffness;
    stiffness << law.warp, law.coupling, 0.0, law.coupling, law.weft, 0.0, 0.0, 0.0, law.shear;
    return stiffness;
}

ClothTension tensionOf(const ClothLaw& law, const Vec3& strain)
{
    ClothTension taut{ClothState::Taut, Vec3::Zero(), stiffnessOf(law), 0.0};
    taut.tension = taut.stiffness * strain;
    taut.energy = 0.5 * taut.tension.dot(strain);
    return law.pushes || pushesNowhere(taut.tension) ? taut : wrinkledOf(law, strain);
}

Vec3 strainOf(const ClothLaw& law, const Vec3& tension)
{
    const Compliance c(law);
    return {c.first * tension[0] + c.coupling * tension[1],
            c.coupling * tension[0] + c.second * tension[1], c.shear * tension[2]};
}

double largestTension(const Vec3& tension)
{
    const double mean = 0.5 * (tension[0] + tension[1]);
    const double half = 0.5 * (tension[0] - tension[1]);
    return mean + std::sqrt(half * half + tension[2] * tension[2]);
}

} // namespace ripstop
