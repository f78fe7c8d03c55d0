// Sums the load of the air on a part at rest. Each panel adds its normal force (linear-normal law)
// and its skin friction at its centroid. Panels with the vortex law add their skin friction only;
// wings are then found among all of them, and their loads come from the functions that the engine
// uses (laws/vortex_wing.h), because a panel of a wing alone does not know its circulation.
#include "builders/statics.h"

#include "laws/vortex_wing.h"

#include <Eigen/Geometry>

namespace ripstop {
namespace {

void addForce(const Vec3& force, const Vec3& place, Load& total)
{
    total.force += force;
    total.moment += place.cross(force);
}

WingPanel wingPanelOf(const Material& material, const Vec3& doubled, const Vec3& wind)
{
    WingPanel panel;
    panel.normal = doubled;
    panel.wind = wind;
    panel.plate = material.normalCoefficient;
    panel.saturation =
        material.normalCoefficient / material.broadsideCoefficient.value_or(panel.plate) - 1.0;
    panel.stall = std::sin(material.stallAngle * degrees);
    return panel;
}

// Adds the load of the panels with the vortex law, without their skin friction.
void addWings(const Scene& scene, const Part& part, const Vec3& wind, Load& total)
{
    std::vector<PaddedVec3> position;
    std::vector<std::array<int, 3>> corners;
    std::vector<std::uint8_t> member;
    std::vector<WingPanel> panels;
    for (const Particle& particle : part.particles)
        position.push_back(particle.position);
    const auto place = [&](Id id) { return int(findRow(part.particles, id) - &part.particles[0]); };
    for (const Panel& panel : part.panels) {
        const Material* material = findItem<Material>(scene, panel.material);
        corners.push_back({place(panel.a), place(panel.b), place(panel.c)});
        member.push_back(material && material->airLaw == AirLaw::Vortex);
        const Vec3& a = position[std::size_t(corners.back()[0])];
        const Vec3& b = position[std::size_t(corners.back()[1])];
        const Vec3& c = position[std::size_t(corners.back()[2])];
        panels.push_back(
            wingPanelOf(material ? *material : Material(), (b - a).cross(c - a), wind));
    }
    const std::vector<Vec3> winds(corners.size(), wind);
    for (const WingStrips& wing : wingsOf(corners, member, position, winds)) {
        std::vector<WingPanel> own;
        for (const int panel : wing.panels)
            own.push_back(panels[std::size_t(panel)]);
        fillWingLoads(wing, rimOf(wing.front, position), rimOf(wing.rear, position),
                      scene.settings.airDensity, own);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::array<int, 3>& corner = corners[std::size_t(wing.panels[i])];
            const Vec3 middle = (position[std::size_t(corner[0])] + position[std::size_t(corner[1])]
                                 + position[std::size_t(corner[2])])
                                / 3.0;
            addForce(own[i].load + plateLoad(own[i], scene.settings.airDensity), middle, total);
        }
    }
}

} // namespace

Load airLoad(const Scene& scene, const Part& part, const Vec3& wind)
{
    Load total;
    bool wings = false;
    for (const Panel& panel : part.panels) {
        const Material* material = findItem<Material>(scene, panel.material);
        if (!material || material->airLaw == AirLaw::None)
            continue;
        const Vec3& a = findRow(part.particles, panel.a)->position;
        const Vec3& b = findRow(part.particles, panel.b)->position;
        const Vec3& c = findRow(part.particles, panel.c)->position;
        const Vec3 doubled = (b - a).cross(c - a);
        const Vec3 normal = doubled.normalized();
        const double headOn = normal.dot(wind);
        const Vec3 along = wind - headOn * normal;
        const bool wing = material->airLaw == AirLaw::Vortex;
        wings |= wing;
        const double slope = wing ? 0.0 : material->normalCoefficient;
        const Vec3 force = 0.25 * scene.settings.airDensity * doubled.norm()
                           * (slope * wind.norm() * headOn * normal
                              + material->skinFriction * along.norm() * along);
        addForce(force, (a + b + c) / 3.0, total);
    }
    if (wings)
        addWings(scene, part, wind, total);
    return total;
}

LumpedMass lumpedMassOf(const Part& part)
{
    LumpedMass weight;
    for (const Particle& particle : part.particles) {
        weight.mass += particle.mass;
        weight.center += particle.mass * particle.position;
    }
    if (weight.mass > 0.0)
        weight.center /= weight.mass;
    return weight;
}

} // namespace ripstop
