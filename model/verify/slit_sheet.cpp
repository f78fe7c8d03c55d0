// The cloth as it lies, with its slit; what it is; and how it is drawn, with looks at what the
// cells beside the upper edge pull.
#include "verify/slit_sheet.h"

#include "compile/compile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// Two lips that touch, or what is left without a row of cells.
FlatCloth slitCloth(const SlitSheet& slit)
{
    const int n = slit.cells;
    const double cell = slit.side / n, middle = 0.5 * slit.side;
    FlatCloth cloth = rectangle(slit.side, slit.side, n, n, Parted::ByTurns);
    const auto isBeside = [&](double x) { return std::abs(x - middle) < slit.halfSlit - 1e-9; };
    const auto middleOf = [&](const std::array<int, 3>& triangle) -> Vec3 {
        Vec3 sum = Vec3::Zero();
        for (const int corner : triangle)
            sum += cloth.place[std::size_t(corner)];
        return sum / 3.0;
    };
    if (slit.isBlunt) {
        std::erase_if(cloth.triangles, [&](const std::array<int, 3>& triangle) {
            const Vec3 at = middleOf(triangle);
            return isBeside(at.x()) && at.y() > middle && at.y() < middle + cell;
        });
        return cloth;
    }
    const int first = n / 2 * (n + 1); // of the row of particles in the middle
    for (int i = first; i <= first + n; ++i) {
        if (!isBeside(cloth.place[std::size_t(i)].x()))
            continue;
        const int upperLip = int(cloth.place.size());
        cloth.place.push_back(cloth.place[std::size_t(i)]);
        for (std::array<int, 3>& triangle : cloth.triangles)
            if (middleOf(triangle).y() > middle)
                std::ranges::replace(triangle, i, upperLip);
    }
    return cloth;
}

Material clothOf(const SlitSheet& slit)
{
    Material cloth = isotropic(slit.stiffness, slit.poisson);
    cloth.resistsPushing = slit.pushes;
    cloth.dampingTime = 1e-3;
    cloth.airLaw = AirLaw::None;
    cloth.tearRule = TearRule::Energy;
    cloth.tearStrength = slit.tearStrength;
    cloth.warpStrength = cloth.weftStrength = 3000.0; // N/m, six times the load
    return cloth;
}

// Its upper edge is held, its lower one drawn down, across the weft.
Scene sceneOf(const SlitSheet& slit, double rate)
{
    Scene scene = sceneOf(slitCloth(slit), clothOf(slit), 90.0, 0.05);
    scene.settings.tearMesh = slit.tearMesh;
    Control jaw;
    jaw.name = "jaw";
    jaw.kind = ControlKind::Move;
    jaw.axis = {0.0, -1.0, 0.0};
    jaw.limit = 1.0;
    jaw.automaticRate = rate;
    for (Particle& particle : particlesOf(scene)) {
        const double y = particle.position.y();
        particle.pinned = y < 1e-9 || y > slit.side - 1e-9;
        if (y < 1e-9)
            jaw.targets.push_back(particle.id);
    }
    addItem(scene, jaw);
    return scene;
}

// N/m, over the width, in the row of cells at the upper edge.
double upperPull(const Frame& frame, int cells)
{
    const std::size_t count = 2 * std::size_t(cells);
    double sum = 0.0;
    for (std::size_t i = frame.panelPull.size() - count; i < frame.panelPull.size(); ++i)
        sum += frame.panelPull[i].warp;
    return sum / double(count);
}

} // namespace

double SlitSheet::expected()
{
    const double wide = 2.0 * tearStrength * stiffness / (std::numbers::pi * halfSlit);
    return std::sqrt(wide * std::cos(std::numbers::pi * halfSlit / side));
}

SlitTorn drawnApart(const SlitSheet& slit)
{
    const double rate = 0.004; // m/s, so that at 2 % of strain 3 s have gone
    Simulation simulation(*compile(sceneOf(slit, rate)));
    SlitTorn torn;
    for (int n = 1; n <= 300; ++n) {
        simulation.runUntil(0.02 * n);
        const double load = upperPull(*simulation.frame(), slit.cells);
        torn.most = std::max(torn.most, load);
        torn.left = load;
        if (simulation.state().tears.empty())
            torn.began = load;
        else if (torn.first.time == 0.0)
            torn.first = simulation.state().tears[0];
        if (torn.first.time > 0.0 && load < 0.4 * torn.began)
            break;
    }
    return torn;
}

} // namespace ripstop
