#include "builders/statics.h"

#include <Eigen/Geometry>

namespace ripstop {

Load airLoad(const Scene& scene, const Part& part, const Vec3& wind)
{
    Load total;
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
        const Vec3 force = 0.25 * scene.settings.airDensity * doubled.norm()
                           * (material->normalCoefficient * wind.norm() * headOn * normal
                              + material->skinFriction * along.norm() * along);
        total.force += force;
        total.moment += ((a + b + c) / 3.0).cross(force);
    }
    return total;
}

Weight weightOf(const Part& part)
{
    Weight weight;
    for (const Particle& particle : part.particles) {
        weight.mass += particle.mass;
        weight.center += particle.mass * particle.position;
    }
    if (weight.mass > 0.0)
        weight.center /= weight.mass;
    return weight;
}

} // namespace ripstop
