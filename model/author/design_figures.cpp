#include "author/design_figures.h"

#include "derived/cloth_area.h"
#include "derived/panel_sides.h"
#include "select/net.h"
#include "shaping/insert.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ripstop {
namespace {

std::vector<PanelSide> allSides(const Part& part)
{
    std::vector<PanelSide> sides;
    sides.reserve(3 * part.panels.size());
    for (const Panel& panel : part.panels)
        std::ranges::copy(sidesOf(panel), std::back_inserter(sides));
    std::sort(sides.begin(), sides.end());
    return sides;
}

double lineLength(const Scene& scene, const Part& part)
{
    double length = 0.0;
    std::vector<PanelSide> sides;
    Id looked = noId;
    bool isShown = true;
    for (const Link& link : part.links) {
        if (link.resists != Resists::Tension)
            continue;
        if (sides.empty())
            sides = allSides(part);
        if (link.material != looked) {
            const Material* material = findItem<Material>(scene, link.material);
            isShown = !material || material->shown;
            looked = link.material;
        }
        if (isShown && !std::binary_search(sides.begin(), sides.end(), sideOf(link.from, link.to)))
            length += link.restLength;
    }
    return length;
}

} // namespace

DesignFigures designFiguresOf(const Scene& scene, Family family)
{
    DesignFigures figures;
    Vec3 doubled = Vec3::Zero(); // m^2, twice the area as a vector
    Eigen::AlignedBox3d cloth;
    forEachPart(scene, [&](Id, const Part& part) {
        figures.particles += part.particles.size();
        figures.links += part.links.size();
        figures.panels += part.panels.size();
        for (const Particle& row : part.particles)
            figures.mass += row.mass;
        for (const Panel& panel : part.panels) {
            const Vec3& a = findRow(part.particles, panel.a)->position;
            const Vec3& b = findRow(part.particles, panel.b)->position;
            const Vec3& c = findRow(part.particles, panel.c)->position;
            doubled += (b - a).cross(c - a);
            for (const Vec3& corner : {a, b, c})
                cloth.extend(corner);
        }
        figures.area += ClothArea(part, &scene).whole();
        figures.lineLength += lineLength(scene, part);
    });
    if (const Eigen::AlignedBox3d box = extentOf(scene); !box.isEmpty())
        figures.size = box.sizes();
    if (!cloth.isEmpty())
        figures.span = cloth.sizes().z();
    // a keel stands along the lift and shows nothing of itself
    const double seen = 0.5 * std::hypot(doubled.x(), doubled.y());
    if (family == Family::Wings && seen > 0.0)
        figures.aspect = figures.span * figures.span / seen;
    figures.substeps = scene.settings.solver == Solver::Auto ? 0 : scene.settings.substeps;
    figures.timeStep = scene.settings.timeStep;
    return figures;
}

} // namespace ripstop
