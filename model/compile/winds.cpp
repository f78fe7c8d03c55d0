// The winds of a system from those of its scene. A measured one is its mean, which counts as a
// uniform wind, and what it deviates by.
#include "compile/resolve.h"
#include "forces/gusts.h"
#include "scene/wind.h"

namespace ripstop {
namespace {

WindRecord recordOf(const NumberRows& rows, const Vec3& mean)
{
    WindRecord record;
    for (const std::vector<double>& row : rows)
        record.samples.push_back({row[0], Vec3(row[1], row[2], row[3]) - mean});
    return record;
}

void addWind(const Scene& scene, Id id, const Wind& item, Winds& winds)
{
    switch (item.kind) {
    case WindKind::Uniform:
        winds.uniform += item.velocity;
        break;
    case WindKind::Gusts:
        winds.gusts.push_back(drydenGusts(Key(id),
                                          meanWindAt(scene, {0.0, item.referenceHeight, 0.0}),
                                          item.referenceHeight, item.gustiness, item.seed));
        break;
    case WindKind::DiscreteGust:
        winds.discreteGusts.push_back(
            {item.velocity, item.onset, item.duration, item.interval, item.growth});
        break;
    case WindKind::Measured: {
        const Vec3 mean = meanVelocity(item.velocities);
        winds.uniform += mean;
        winds.records.push_back(recordOf(item.velocities, mean));
        break;
    }
    case WindKind::PowerLaw:
    case WindKind::LogLaw:
    case WindKind::Jet:
        winds.airflows.push_back(airflowOf(item));
        break;
    }
}

} // namespace

Winds windsOf(const Scene& scene)
{
    Winds winds;
    for (const Entry& entry : scene.items)
        if (const Wind* wind = std::get_if<Wind>(&entry.item))
            addWind(scene, entry.id, *wind, winds);
    return winds;
}

void takeWinds(const Winds& winds, System& system)
{
    system.wind = winds.uniform;
    system.airflows = winds.airflows;
    system.gusts = winds.gusts;
    system.discreteGusts = winds.discreteGusts;
    system.windRecords = winds.records;
}

} // namespace ripstop
