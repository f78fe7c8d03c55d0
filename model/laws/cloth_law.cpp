// A taut cloth is one product. Where a component pushes, Wrinkles looks for the direction that
// pulls: along (1, u) in the plane, u being its slope, the function (t.e.t) / sqrt(D(t)) does not
// depend on the length of t and has its greatest value where a quartic in u is 0. Both ends of the
// quarter turn are looked at alike: from the warp u counts from it, from the weft its inverse does.
#include "laws/cloth_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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
        const double inverse = 1.0 / (law.warp * law.weft - law.coupling * law.coupling);
        first = law.weft * inverse;
        second = law.warp * inverse;
        coupling = -law.coupling * inverse;
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

    // Whether there may be three places where the pull neither grows nor falls, a peak near each
    // axis and a valley in between, as the signs of the slope tell (Descartes). There is one
    // otherwise. From both axes the answer is the same.
    bool mayHaveTwoPeaks() const { return m_slope[1] < 0.0 && m_slope[2] > 0.0; }

    // Of two peaks that of this axis. The slope bends upwards as u leaves the axis, so that
    // Newton's method comes to its first root from below and never passes it; where it leads out of
    // that bend, there is none in it.
    std::optional<double> peakAtAxis() const
    {
        double u = 0.0;
        for (int i = 0; i < mostSteps; ++i) {
            const double rise = riseOfSlope(u);
            if (!(rise < 0.0 && m_slope[2] + 2.0 * u * m_slope[3] >= 0.0))
                return {};
            const double way = slope(u) / rise;
            u -= way;
            if (!(std::abs(way) > nearEnough * u))
                return u;
        }
        return {};
    }

    bool growsAtDiagonal() const { return slope(1.0) > 0.0; }

    // The only one for 0 <= u <= 1: Newton's method between two places; where it leaves them, they
    // are halved. It begins where the slope would be 0 if it were straight: of cloth that pushes
    // across its pull it is nearly so. The upper place is well above 1, where the peak of cloth in
    // pure shear is, so that Newton's steps may come from there.
    double onlyPeak() const
    {
        double low = 0.0, high = 2.0;
        double u = m_slope[0] < -m_slope[1] ? -m_slope[0] / m_slope[1] : 0.5;
        for (int i = 0; i < mostSteps; ++i) {
            const double value = slope(u);
            (value > 0.0 ? low : high) = u;
            double next = u - value / riseOfSlope(u);
            if (!(next >= low && next <= high))
                next = 0.5 * (low + high);
            const double way = std::abs(next - u);
            u = next;
            if (!(way > nearEnough * u))
                break;
        }
        return u;
    }

private:
    static constexpr int mostSteps = 60;
    static constexpr double nearEnough = 1e-7; // each step squares the error that the last one left

    // Positive where the pull grows with u.
    double slope(double u) const
    {
        return m_slope[0] + u * (m_slope[1] + u * u * (m_slope[2] + u * m_slope[3]));
    }

    double riseOfSlope(double u) const
    {
        return m_slope[1] + u * u * (3.0 * m_slope[2] + 4.0 * u * m_slope[3]);
    }

    double m_e11, m_e22, m_g, m_first, m_second, m_both;
    std::array<double, 4> m_slope; // of 1, u, u^3, u^4
};

// Where a wrinkled cloth pulls: along (1, u) from one of its axes, which comes first in what has
// two components here. Which way the threads shear only mirrors the direction.
struct PullAlong
{
    bool fromWarp;
    double sign;   // of the shear
    Vec3 strain;   // 1, the shear not negative
    double first;  // m/N, of D
    double second; // m/N
    double both;   // m/N
    double u;

    double compliance() const { return first + u * u * (both + u * u * second); }
    double along() const { return strain[0] + u * (strain[2] + u * strain[1]); }
    double size() const { return along() / compliance(); } // N/m, r of the tension r (1, u^2, u)
    Vec3 tension() const { return inClothFrame(Vec3(size() * direction())); }
    Vec3 direction() const { return {1.0, u * u, u}; }

    Vec3 inClothFrame(const Vec3& value) const
    {
        return fromWarp ? Vec3(value[0], value[1], sign * value[2])
                        : Vec3(value[1], value[0], sign * value[2]);
    }
    Mat3 inClothFrame(const Mat3& value) const
    {
        const int one = fromWarp ? 0 : 1;
        const int other = 1 - one;
        const double mixed = sign * value(one, 2), shear = sign * value(other, 2);
        Mat3 result;
        result << value(one, one), value(0, 1), mixed, value(0, 1), value(other, other), shear,
            mixed, shear, value(2, 2);
        return result;
    }
};

// Nothing where it does not pull at all.
std::optional<PullAlong> findPull(const ClothLaw& law, const Vec3& strain)
{
    const double sign = strain[2] < 0.0 ? -1.0 : 1.0;
    const double g = sign * strain[2];
    const Compliance c(law);
    const double both = 2.0 * c.coupling + c.shear;
    const Wrinkles fromWarp(strain[0], strain[1], g, c.first, c.second, both);
    const Wrinkles fromWeft(strain[1], strain[0], g, c.second, c.first, both);
    std::optional<double> warpSlope, weftSlope;
    if (fromWarp.mayHaveTwoPeaks()) {
        warpSlope = fromWarp.peakAtAxis();
        weftSlope = fromWeft.peakAtAxis();
    }
    if (!warpSlope && !weftSlope) {
        if (fromWarp.growsAtDiagonal())
            weftSlope = fromWeft.onlyPeak();
        else
            warpSlope = fromWarp.onlyPeak();
    }
    const double warpPull = warpSlope ? fromWarp.pull(*warpSlope) : 0.0;
    const double weftPull = weftSlope ? fromWeft.pull(*weftSlope) : 0.0;
    if (!(std::max(warpPull, weftPull) > 0.0))
        return {};
    if (warpPull >= weftPull)
        return PullAlong{true, sign,      {strain[0], strain[1], g}, c.first, c.second,
                         both, *warpSlope};
    return PullAlong{false, sign, {strain[1], strain[0], g}, c.second, c.first, both, *weftSlope};
}

// Tension r (1, u^2, u), r = e / D, and its derivatives.
ClothTension wrinkled(const PullAlong& pull)
{
    const double u = pull.u;
    const double stiffness = 1.0 / pull.compliance();
    const double r = pull.size();
    const double slope = u * (2.0 * pull.both + 4.0 * u * u * pull.second); // of D
    const double bend = 2.0 * pull.both + 12.0 * u * u * pull.second;
    const double turned = -0.5 * r * slope * stiffness; // r' where the energy is stationary
    const double curvature =
        r * (2.0 * pull.strain[1] - 0.5 * turned * slope - 0.5 * r * bend); // of the energy
    const Vec3 t = pull.direction();
    const Vec3 t1(0.0, 2.0 * u, 1.0);
    Mat3 change = stiffness * (t * t.transpose());
    if (curvature < 0.0) {
        const Vec3 turn = turned * t + r * t1;
        change -= 1.0 / curvature * (turn * turn.transpose());
    }
    return {ClothState::Wrinkled, pull.tension(), pull.inClothFrame(change),
            0.5 * pull.along() * r};
}

Vec3 tautTension(const ClothLaw& law, const Vec3& strain)
{
    return {law.warp * strain[0] + law.coupling * strain[1],
            law.coupling * strain[0] + law.weft * strain[1], law.shear * strain[2]};
}

bool isTaut(const ClothLaw& law, const Vec3& tension)
{
    return law.pushes || pushesNowhere(tension);
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
    const Vec3 tension = tautTension(law, strain);
    if (isTaut(law, tension))
        return {ClothState::Taut, tension, stiffnessOf(law), 0.5 * tension.dot(strain)};
    const std::optional<PullAlong> pull = findPull(law, strain);
    return pull ? wrinkled(*pull) : ClothTension{};
}

Vec3 pullingStrain(const ClothLaw& law, const Vec3& strain)
{
    if (isTaut(law, tautTension(law, strain)))
        return strain;
    const std::optional<PullAlong> pull = findPull(law, strain);
    if (!pull)
        return Vec3::Zero();
    return strainOf(law, pull->tension());
}

double leastEnergyOf(const ClothLaw& law, const Vec3& strain)
{
    if (law.pushes)
        return 0.5 * tautTension(law, strain).dot(strain);
    const Compliance c(law);
    const double warp = std::max(strain[0], 0.0), weft = std::max(strain[1], 0.0);
    return 0.5 * std::max(warp * warp / c.first, weft * weft / c.second);
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
