// Laws, cuts and factors are noted by their keys and compared after the edit. How far the cloth has
// to go is found panel by panel: the strain that the same pull would have under the law to come, or
// what the cut shrinks by.
#include "simulation/cloth_ramps.h"

#include "base/key_index.h"
#include "system/membrane.h"

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using Mat2 = Eigen::Matrix2d;

// Stiffness along the threads, N/m.
Mat2 alongOf(const ClothLaw& law)
{
    Mat2 matrix;
    matrix << law.warp, law.coupling, law.coupling, law.weft;
    return matrix;
}

Mat2 shapeOf(const PanelCut& cut)
{
    Mat2 matrix;
    matrix << cut.shape[0], cut.shape[1], cut.shape[2], cut.shape[3];
    return matrix;
}

// The way of one cut to another, as a turn and what stretches before it.
struct CutWay
{
    double angle; // rad, at most a quarter of a turn: warps run both ways
    Mat2 stretch; // symmetric and positive

    CutWay(const PanelCut& from, const PanelCut& to)
    {
        const Mat2 all = shapeOf(to).inverse() * shapeOf(from);
        angle = std::atan2(all(1, 0) - all(0, 1), all(0, 0) + all(1, 1));
        stretch = Eigen::Rotation2Dd(-angle) * all;
        angle = std::remainder(angle, std::numbers::pi);
    }

    // 1, the largest change of a length.
    double strain() const
    {
        const Mat2 change = stretch - Mat2::Identity();
        const double mean = 0.5 * change.trace();
        return std::abs(mean)
               + std::hypot(0.5 * (change(0, 0) - change(1, 1)),
                            0.5 * (change(0, 1) + change(1, 0)));
    }
};

// What a cloth shrinks by when it goes over from one law to another and pulls as before, as a share
// of how long it is. One that gets softer does not.
double shrinkage(const ClothLaw& from, const ClothLaw& to, const Vec3& strain)
{
    if (!to.isElastic())
        return 0.0;
    const Vec3 before = from.isElastic() ? pullingStrain(from, strain) : strain;
    const Vec3 after =
        from.isElastic() ? strainOf(to, tensionOf(from, strain).tension) : Vec3::Zero();
    const double now = 1.0 + 2.0 * largestStrain(before); // square of the length, over that at rest
    const double then = std::max(now - 2.0 * largestStrain(Vec3(before - after)), 0.0);
    return 1.0 - std::sqrt(then / now);
}

} // namespace

ClothLaw lawBetween(const ClothLaw& from, const ClothLaw& to, double share)
{
    if (share >= 1.0)
        return to;
    ClothLaw law = to;
    law.dampingTime = between(from.dampingTime, to.dampingTime, share);
    Mat2 along;
    if (from.isElastic() && to.isElastic()) {
        const Mat2 compliance =
            (1.0 - share) * alongOf(from).inverse() + share * alongOf(to).inverse();
        along = compliance.inverse();
        law.shear = 1.0 / between(1.0 / from.shear, 1.0 / to.shear, share);
    } else {
        along = (1.0 - share) * alongOf(from) + share * alongOf(to);
        law.shear = between(from.shear, to.shear, share);
    }
    law.warp = along(0, 0);
    law.weft = along(1, 1);
    law.coupling = along(0, 1);
    return law;
}

PanelCut cutBetween(const PanelCut& from, const PanelCut& to, double share)
{
    if (share >= 1.0)
        return to;
    const CutWay way(from, to);
    const Mat2 stretch = Mat2::Identity() + share * (way.stretch - Mat2::Identity());
    const Mat2 shape =
        shapeOf(from) * stretch.inverse() * Eigen::Rotation2Dd(-share * way.angle).matrix();
    return {0.5 / shape.determinant(), {shape(0, 0), shape(0, 1), shape(1, 0), shape(1, 1)}};
}

NotedCloth::NotedCloth(const System& system, const State& state)
    : m_time(state.time)
    , m_lawRamps(state.clothRamps)
    , m_cutRamps(state.panelRamps)
    , m_factorRamps(state.factorRamps)
{
    RampFinder lawRampOf(m_lawRamps, &ClothRamp::material);
    for (std::size_t i = 0; i < system.cloth.size(); ++i) {
        const Key material = system.materialAir[i].key;
        const ClothRamp* ramp = lawRampOf(material);
        m_laws.push_back({material, ramp ? lawBetween(ramp->from, ramp->to, shareOf(*ramp, m_time))
                                         : system.cloth[i]});
    }
    m_panels.reserve(system.membranes.size());
    RampFinder cutRampOf(m_cutRamps, &PanelRamp::panel);
    RampFinder factorRampOf(m_factorRamps, &FactorRamp::panel);
    for (const Membrane& membrane : system.membranes) {
        const auto panel = std::size_t(membrane.panel);
        const Key key = system.panelKey[panel];
        const PanelRamp* ramp = cutRampOf(key);
        const FactorRamp* factorRamp = factorRampOf(key);
        m_panels.push_back(
            {key, system.materialAir[std::size_t(system.panels[panel].air)].key,
             ramp ? cutBetween(ramp->from, ramp->to, shareOf(*ramp, m_time)) : PanelCut(membrane),
             factorRamp
                 ? stiffnessBetween(factorRamp->from, factorRamp->to, shareOf(*factorRamp, m_time))
                 : membrane.factors.stiffness,
             cornersOf(system, membrane, state.position)});
    }
}

std::vector<ClothRamp> NotedCloth::lawRampsTo(const System& edited, RampWay& way) const
{
    std::vector<ClothRamp> ramps;
    RampFinder rampOf(m_lawRamps, &ClothRamp::material);
    for (std::size_t i = 0; i < edited.cloth.size(); ++i) {
        const Key material = edited.materialAir[i].key;
        const ClothLaw& to = edited.cloth[i];
        const auto noted = std::ranges::find(m_laws, material, &Law::material);
        if (noted == m_laws.end())
            continue;
        const ClothRamp* ramp = rampOf(material);
        if (ramp && ramp->to == to) {
            ramps.push_back(*ramp);
            continue;
        }
        ClothLaw from = noted->law;
        from.pushes = to.pushes;
        if (from == to || edited.rampTime == 0.0)
            continue;
        ramps.push_back({material, m_time, 0.0, from, to});
        for (const Panel& panel : m_panels)
            if (panel.material == material) {
                const Vec3 strain = strainAt(Membrane{panel.cut, 0, {}}, panel.corners);
                way.strain = std::max(way.strain, shrinkage(from, to, strain));
                for (const Vec3& corner : panel.corners)
                    way.box.extend(corner);
            }
    }
    std::ranges::sort(ramps, {}, &ClothRamp::material);
    return ramps;
}

void NotedCloth::addCutRamp(const Membrane& edited, const Panel& noted, const PanelRamp* underWay,
                            std::vector<PanelRamp>& ramps, RampWay& way) const
{
    const PanelCut& to = edited;
    if (underWay && underWay->to == to) {
        ramps.push_back(*underWay);
    } else if (noted.cut != to) {
        ramps.push_back({noted.key, m_time, 0.0, noted.cut, to});
        way.strain = std::max(way.strain, CutWay(noted.cut, to).strain());
        for (const Vec3& corner : noted.corners)
            way.box.extend(corner);
    }
}

void NotedCloth::addFactorRamp(const Membrane& edited, const Panel& noted,
                               const FactorRamp* underWay, std::vector<FactorRamp>& ramps,
                               RampWay& way) const
{
    const double to = edited.factors.stiffness;
    if (underWay && underWay->to == to) {
        ramps.push_back(*underWay);
        return;
    }
    if (noted.factor == to)
        return;
    ramps.push_back({noted.key, m_time, 0.0, noted.factor, to});
    const auto law = std::ranges::find(m_laws, noted.material, &Law::material);
    if (law == m_laws.end())
        return;
    const Vec3 strain = strainAt(Membrane{noted.cut, 0, {}}, noted.corners);
    way.strain =
        std::max(way.strain, shrinkage(law->law.times(noted.factor), law->law.times(to), strain));
    for (const Vec3& corner : noted.corners)
        way.box.extend(corner);
}

void NotedCloth::panelRampsTo(const System& edited, State& state, RampWay& way) const
{
    state.panelRamps.clear();
    state.factorRamps.clear();
    KeyIndex index(m_panels.size());
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        index.add(m_panels[i].key, int(i));
    RampFinder cutRampOf(m_cutRamps, &PanelRamp::panel);
    RampFinder factorRampOf(m_factorRamps, &FactorRamp::panel);
    for (const Membrane& membrane : edited.membranes) {
        const Key key = edited.panelKey[std::size_t(membrane.panel)];
        const int place = index(key);
        if (place < 0)
            continue;
        const Panel& noted = m_panels[std::size_t(place)];
        addCutRamp(membrane, noted, cutRampOf(key), state.panelRamps, way);
        addFactorRamp(membrane, noted, factorRampOf(key), state.factorRamps, way);
    }
    if (edited.rampTime == 0.0) { // what is under way goes on
        std::erase_if(state.panelRamps, [](const PanelRamp& ramp) { return ramp.lasts == 0.0; });
        std::erase_if(state.factorRamps, [](const FactorRamp& ramp) { return ramp.lasts == 0.0; });
    }
    std::ranges::sort(state.panelRamps, {}, &PanelRamp::panel);
    std::ranges::sort(state.factorRamps, {}, &FactorRamp::panel);
}

void addCloth(const System& system, const State& state, double time, Patch& patch)
{
    RampFinder lawRampOf(state.clothRamps, &ClothRamp::material);
    for (std::size_t i = 0; i < system.cloth.size(); ++i) {
        const Key key = system.materialAir[i].key;
        if (const ClothRamp* ramp = lawRampOf(key))
            patch.laws.emplace_back(key, lawBetween(ramp->from, ramp->to, shareOf(*ramp, time)));
    }
    if (state.panelRamps.empty() && state.factorRamps.empty())
        return;
    RampFinder cutRampOf(state.panelRamps, &PanelRamp::panel);
    RampFinder factorRampOf(state.factorRamps, &FactorRamp::panel);
    for (std::size_t i = 0; i < system.membranes.size(); ++i) {
        const Key key = system.panelKey[std::size_t(system.membranes[i].panel)];
        if (const PanelRamp* ramp = cutRampOf(key))
            patch.cuts.emplace_back(int(i), cutBetween(ramp->from, ramp->to, shareOf(*ramp, time)));
        if (const FactorRamp* ramp = factorRampOf(key))
            patch.factors.emplace_back(
                int(i), stiffnessBetween(ramp->from, ramp->to, shareOf(*ramp, time)));
    }
}

} // namespace ripstop
