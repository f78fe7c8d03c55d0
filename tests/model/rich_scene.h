// A scene with something of every kind, tied by springs and by rods, with numbers of its own here
// and there: what an edit of any property may meet.
#pragma once

#include "builders/builder.h"
#include "builders/network.h"

namespace ripstop {

inline Scene rich(Integrator integrator = Integrator::Auto)
{
    Scene scene = *build(*findBuilder("cloth"),
                         {{"columns", 5}, {"rows", 4}, {"sphere", 0.3}, {"bending", 1e-5}});
    scene.settings.integrator = integrator;
    Material line{"line"};
    line.diameter = 0.002;
    line.airLaw = AirLaw::LiftDrag;
    line.compliance = 1e-6;
    line.tearRule = TearRule::Strain;
    line.bendingStiffness = 1e-5;
    line.flexuralRigidity = 1e-4;
    const Id material = addItem(scene, line);
    const Id other = addItem(scene, Material{"other"});

    Network frame(scene, "frame");
    std::vector<Id> nodes;
    for (int i = 0; i < 6; ++i)
        nodes.push_back(frame.particle({0.2 * i, 3.0 + 0.1 * (i % 2), 1.0}, 0.02));
    for (std::size_t i = 1; i < nodes.size(); ++i)
        frame.rod(nodes[i - 1], nodes[i], i % 2 ? material : other);
    for (std::size_t i = 2; i < nodes.size(); ++i)
        frame.spring(nodes[i - 2], nodes[i], other);
    for (std::size_t i = 2; i < nodes.size(); ++i)
        frame.panel(nodes[i - 2], nodes[i - 1], nodes[i], i % 2 ? material : noId);
    frame.row(nodes[0]).pinned = true;
    const Id part = frame.finish({}, {});

    Part& rows = std::get<Part>(*findItem(scene, part));
    rows.links[1].compliance = 2e-6;
    rows.links[2].tearLimit = 0.7;
    rows.links[6].stiffness = 3.0;
    rows.links[7].damping = 0.1;
    rows.links[8].material = noId;

    Control weight{"weight"};
    weight.kind = ControlKind::WeightShift;
    weight.targets = {nodes[2], nodes[3]};
    weight.automaticRate = 0.1;
    addItem(scene, weight);
    addWind(scene, {1.0, 0.0, 2.0});
    addWind(scene, {0.0, 0.3, 0.0});
    Wind gusts{"gusts"};
    gusts.kind = WindKind::Gusts;
    addItem(scene, gusts);
    Wind fan{"fan", {0.0, 0.0, 3.0}};
    fan.kind = WindKind::Jet;
    addItem(scene, fan);
    Wind gust{"gust", {4.0, 0.0, 0.0}, WindKind::DiscreteGust};
    gust.onset = 0.0;
    addItem(scene, gust);
    Wind measured{"measured", Vec3::Zero(), WindKind::Measured};
    measured.velocities = {{0.0, 1.0, 0.0, 0.5}, {2.0, 1.5, 0.1, 0.0}, {2.5, 0.5, 0.0, 0.0}};
    addItem(scene, measured);
    Wind shear{"shear", {2.0, 0.0, 0.0}};
    shear.kind = WindKind::LogLaw;
    addItem(scene, shear);
    const Id group = addGroup(scene, "some", {nodes[1], rows.links[3].id, rows.panels[0].id});
    addProbe(scene, "group", Quantity::MaxTension, group);
    addProbe(scene, "elevation", Quantity::Elevation, nodes[5], nodes[0]);
    addProbe(scene, "one link", Quantity::Tension, rows.links[4].id);
    addItem(scene, Plot{"plot"});
    return scene;
}

} // namespace ripstop
