// A weight on a slack tether, for what tears when it is tight: the largest pull of a stiffness k on
// a weight W that has fallen by h is W (1 + sqrt(1 + 2 h k / W)).
#pragma once

#include "scene/scene.h"

namespace ripstop {

// A weight of 1 kg that falls half a metre before its tether is tight.
inline Scene tether()
{
    Scene scene;
    const auto id = [&] { return takeId(scene); };
    Material cord;
    cord.name = "cord";
    cord.compliance = 1e-3;
    cord.dampingTime = 0.0;
    cord.tearRule = TearRule::Force;
    cord.tearLimit = 100.0;
    const Id cordId = id();
    scene.items.push_back(Entry{cordId, cord});
    Part part;
    part.name = "tether";
    part.particles.resize(2);
    part.particles[0].id = id();
    part.particles[0].pinned = true;
    part.particles[1].id = id();
    part.particles[1].position = {0.0, -1.0, 0.0};
    part.particles[1].mass = 1.0;
    Link link;
    link.id = id();
    link.from = part.particles[0].id;
    link.to = part.particles[1].id;
    link.material = cordId;
    link.resists = Resists::Tension;
    link.restLength = 1.5;
    part.links.push_back(link);
    scene.items.push_back(Entry{id(), part});
    return scene;
}

} // namespace ripstop
