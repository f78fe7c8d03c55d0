// Spreads mass over the particles that a selection means: evenly, in proportion, or by shares that
// links and panels among them give (half to each end, a third to each corner). massPropertiesOf()
// sums mass, centre and inertia in two passes, since the inertia is about the centre.
#include "shaping/spread_mass.h"

#include "base/key_index.h"
#include "derived/cloth_area.h"
#include "shaping/movable.h"

#include <Eigen/Geometry>

#include <numeric>

namespace ripstop {
namespace {

struct Bodies
{
    std::vector<Id> ids;              // ascending
    std::vector<const Particle*> row; // [ids]
    KeyIndex place{0};

    int operator()(Id id) const { return place(std::uint32_t(id)); }
};

Bodies bodiesOf(const Scene& scene, const std::vector<Id>& ids)
{
    Bodies bodies;
    bodies.ids = particlesOf(scene, ids);
    bodies.place = KeyIndex(bodies.ids.size());
    for (const Id id : bodies.ids) {
        bodies.place.add(std::uint32_t(id), int(bodies.row.size()));
        bodies.row.push_back(std::get<const Particle*>(*find(scene, id)));
    }
    return bodies;
}

// What each particle gets of 1 kg/m or 1 kg/m^2, m or m^2.
std::vector<double> sharesOf(const Scene& scene, const Bodies& bodies, MassBy by)
{
    std::vector<double> share(bodies.ids.size(), 0.0);
    const auto add = [&](std::initializer_list<Id> corners, double size) {
        for (const Id corner : corners)
            share[std::size_t(bodies(corner))] += size / double(corners.size());
    };
    const auto has = [&](Id id) { return bodies(id) != KeyIndex::none; };
    forEachPart(scene, [&](Id, const Part& part) {
        if (by == MassBy::Length)
            for (const Link& row : part.links)
                if (has(row.from) && has(row.to))
                    add({row.from, row.to}, row.restLength);
        if (by != MassBy::Area)
            return;
        const ClothArea cloth(part, &scene);
        for (const Panel& row : part.panels)
            if (has(row.a) && has(row.b) && has(row.c))
                add({row.a, row.b, row.c}, cloth.of(row));
    });
    return share;
}

} // namespace

Result<Edit> massSpread(const Scene& scene, const std::vector<Id>& ids, MassBy by, double amount)
{
    const Bodies bodies = bodiesOf(scene, ids);
    if (bodies.ids.empty())
        return Failure{"No particle is selected. Select what is to have the mass."};
    std::vector<double> mass;
    for (const Particle* row : bodies.row)
        mass.push_back(row->mass);
    const double before = std::accumulate(mass.begin(), mass.end(), 0.0);

    if (by == MassBy::Particle || by == MassBy::TotalEvenly) {
        const double each = by == MassBy::Particle ? amount : amount / double(mass.size());
        mass.assign(mass.size(), each);
    } else if (by == MassBy::TotalInProportion) {
        if (before <= 0.0)
            return Failure{"What is selected has no mass yet, so there is no proportion to keep. "
                           "Share the mass out evenly."};
        for (double& one : mass)
            one *= amount / before;
    } else {
        const std::vector<double> share = sharesOf(scene, bodies, by);
        if (std::accumulate(share.begin(), share.end(), 0.0) <= 0.0)
            return by == MassBy::Length
                       ? Failure("No link lies among what is selected, so it has no length. Select "
                                 "both ends of a line.")
                       : Failure("No panel lies among what is selected, so it has no area. Select "
                                 "all corners of some fabric.");
        for (std::size_t i = 0; i < mass.size(); ++i)
            if (share[i] > 0.0)
                mass[i] = amount * share[i];
    }
    Edit edit{Message("Set mass"), {}};
    edit.changes.emplace_back(SetValues{&propertyOf<&Particle::mass>(), bodies.ids,
                                        std::vector<Value>(mass.begin(), mass.end())});
    return edit;
}

MassProperties massPropertiesOf(const Scene& scene, const std::vector<Id>& ids)
{
    MassProperties weight;
    const Bodies bodies = bodiesOf(scene, ids);
    const auto forEach = [&](auto visit) {
        for (const Particle* row : bodies.row)
            visit(*row);
        if (ids.empty())
            forEachPart(scene, [&](Id, const Part& part) {
                for (const Particle& row : part.particles)
                    visit(row);
            });
    };
    Vec3 moment = Vec3::Zero();
    forEach([&](const Particle& row) {
        weight.mass += row.mass;
        moment += row.mass * row.position;
        ++weight.particles;
    });
    if (weight.mass > 0.0)
        weight.centre = moment / weight.mass;
    forEach([&](const Particle& row) {
        const Vec3 square = (row.position - weight.centre).cwiseAbs2();
        weight.inertia += row.mass * (Vec3::Constant(square.sum()) - square);
    });
    return weight;
}

} // namespace ripstop
