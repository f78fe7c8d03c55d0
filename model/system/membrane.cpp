// Gradients first; then what the law makes of the strain: the tension, the strain that the threads
// have, the numbers that people read, and what damping takes.
#include "system/membrane.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

// d(warp, weft) of the barycentric coordinate of a corner, 1/m.
std::array<double, 2> gradient(const Membrane& membrane, int corner)
{
    const auto& s = membrane.shape;
    switch (corner) {
    case 1:
        return {s[0], s[1]};
    case 2:
        return {s[2], s[3]};
    default:
        return {-s[0] - s[2], -s[1] - s[3]};
    }
}

namespace {

std::size_t materialOf(const System& system, const Membrane& membrane)
{
    return std::size_t(system.panels[std::size_t(membrane.panel)].air);
}

} // namespace

double stretchOf(double strain) { return std::sqrt(std::max(1.0 + 2.0 * strain, 0.0)); }

PieceLaw lawOf(const System& system, const Membrane& membrane)
{
    const std::size_t material = materialOf(system, membrane);
    PieceLaw law = system.cloth[material].times(membrane.factors.stiffness);
    if (!system.bending.empty())
        law.bucklingLoad =
            bucklingLoadOf(system.bending[material].fabric, std::sqrt(2.0 * membrane.area));
    return law;
}

FabricTear tearOf(const System& system, const Membrane& membrane)
{
    return system.clothTear.empty() ? FabricTear()
                                    : timesStrength(system.clothTear[materialOf(system, membrane)],
                                                    membrane.factors.strength);
}

namespace {

// N/m, the largest principal tension as a tensile test has it: times the stretch of the cloth along
// it, and so per width of the flat cloth.
double pullAlongMost(const Vec3& tension, const Vec3& threads)
{
    const double half = 0.5 * (tension[0] - tension[1]);
    const double radius = std::sqrt(half * half + tension[2] * tension[2]);
    const double cosine = radius > 0.0 ? half / radius : 0.0; // of twice its angle from the warp
    const double sine = radius > 0.0 ? tension[2] / radius : 0.0;
    const double along =
        0.5 * ((1.0 + cosine) * threads[0] + (1.0 - cosine) * threads[1] + sine * threads[2]);
    return stretchOf(along) * largestTension(tension);
}

// How a piece lies as people see it: cloth that pushes, if only as far as it would take to fold a
// piece so short, has folds or is about to.
ClothState lieOf(const PieceLaw& law, const Vec3& tension)
{
    const double most = largestTension(tension);
    const double least = tension[0] + tension[1] - most;
    if (law.pushes || least >= 0.0)
        return ClothState::Taut;
    return most > 0.0 ? ClothState::Wrinkled : ClothState::Slack;
}

// 1, the larger of warp and weft, of threads of this strain of Green's.
double longerBy(const Vec3& threads)
{
    return std::max(stretchOf(std::max(threads[0], threads[1])) - 1.0, 0.0);
}

} // namespace

ClothTension tensionIn(const System& system, const Membrane& membrane, const Corners& corners)
{
    const PieceLaw law = lawOf(system, membrane);
    return law.isElastic() ? tensionOf(law, strainAt(membrane, corners)) : ClothTension();
}

namespace {

// N, of a tension: the slope of A w(e), e1 and e2 being half of the squares of the axes and g their
// product.
Corners pullsOf(const Membrane& membrane, const Corners& corners, const Vec3& tension)
{
    const auto [warp, weft] = axesOf(membrane, corners[1] - corners[0], corners[2] - corners[0]);
    Corners pulls;
    for (int i = 0; i < 3; ++i) {
        const auto [alongWarp, alongWeft] = gradient(membrane, i);
        pulls[std::size_t(i)] = -membrane.area
                                * ((tension[0] * alongWarp + tension[2] * alongWeft) * warp
                                   + (tension[1] * alongWeft + tension[2] * alongWarp) * weft);
    }
    return pulls;
}

// What the law makes of the way that the threads of a panel have stretched, with the dampers of
// what they shrank; nothing where there is no damping.
ClothTension tensionOfWay(const PieceLaw& law, const Membrane& membrane, const Corners& from,
                          const Corners& to)
{
    if (!law.isElastic() || law.dampingTime == 0.0)
        return {};
    const Vec3 change =
        pullingStrain(law, strainAt(membrane, to)) - pullingStrain(law, strainAt(membrane, from));
    ClothLaw straight = law;
    straight.pushes = true;
    return tensionOf(straight, change);
}

} // namespace

Corners pullsOnCorners(const System& system, const Membrane& membrane, const Corners& corners)
{
    return pullsOf(membrane, corners, tensionIn(system, membrane, corners).tension);
}

Corners dampingPulls(const System& system, const Membrane& membrane, const Corners& from,
                     const Corners& to, double h)
{
    const PieceLaw law = lawOf(system, membrane);
    return pullsOf(membrane, to,
                   law.dampingTime / h * tensionOfWay(law, membrane, from, to).tension);
}

PanelPull pullOf(const System& system, const Membrane& membrane, const Corners& corners)
{
    const PieceLaw law = lawOf(system, membrane);
    if (!law.isElastic())
        return {};
    const Vec3 strain = strainAt(membrane, corners);
    const ClothTension now = tensionOf(law, strain);
    const Vec3 threads = threadStrain(law, strain, now);
    const double warp = stretchOf(threads[0]), weft = stretchOf(threads[1]);
    return {true,
            law.bucklingLoad > 0.0 ? lieOf(law, now.tension) : now.state,
            longerBy(threads),
            pullAlongMost(now.tension, threads),
            warp * now.tension[0],
            weft * now.tension[1],
            warp - 1.0,
            weft - 1.0};
}

double largestStrain(const Vec3& strain)
{
    const double mean = 0.5 * (strain[0] + strain[1]);
    const double half = 0.5 * (strain[0] - strain[1]);
    return std::max(mean + std::sqrt(half * half + 0.25 * strain[2] * strain[2]), 0.0);
}

double threadElongation(const System& system, const Membrane& membrane, const Corners& corners)
{
    const PieceLaw law = lawOf(system, membrane);
    return law.isElastic() ? longerBy(pullingStrain(law, strainAt(membrane, corners))) : 0.0;
}

double lossIn(const System& system, const Membrane& membrane, const Corners& from,
              const Corners& to, double h)
{
    const PieceLaw law = lawOf(system, membrane);
    return membrane.area * law.dampingTime / h * 2.0 * tensionOfWay(law, membrane, from, to).energy;
}

} // namespace ripstop
