// Small scenes with known answers and fixed ids, for tests of views and of edits: a pair of
// particles that falls, and a scene with one element of each kind.
//
// The ids stand above each function, and tests use them as numbers, so they must not change. SI
// units as everywhere.
#pragma once

#include "scene/edit.h"
#include "scene/property.h"

namespace ripstop {

inline Link rod(Id id, Id from, Id to, Id material)
{
    Link link;
    link.id = id;
    link.from = from;
    link.to = to;
    link.material = material;
    return link;
}

// One link, free, and without anything that could touch or slow it: falls with g.
// Ids: part 1, particles 2 and 3, link 4, material 5, wind 6, control 7 (moves particle 2).
inline Scene fallingPair()
{
    Scene scene;
    scene.settings.timeStep = 0.01; // s
    scene.settings.substeps = 1;
    scene.settings.airDensity = 0.0;                           // kg/m^3
    scene.settings.integrator = Integrator::SemiImplicitEuler; // by g h^2 n (n + 1) / 2 in n steps

    Part part;
    part.name = "pair";
    part.particles.push_back({.id = Id{2}, .position = Vec3(0, 10, 0), .mass = 0.5});
    part.particles.push_back({.id = Id{3}, .position = Vec3(1, 10, 0), .mass = 0.5});
    part.links.push_back(rod(Id{4}, Id{2}, Id{3}, Id{5}));

    Material material;
    material.name = "dacron";
    Control control;
    control.name = "hand";
    control.targets = {Id{2}};
    control.step = 0.1;   // m
    control.limit = 0.25; // m

    scene.items = {{Id{1}, part}, {Id{5}, material}, {Id{6}, Wind{"breeze"}}, {Id{7}, control}};
    scene.nextId = Id{8};
    return scene;
}

// The pair with two probes of particle 2: its height (8) and its speed (9).
inline Scene measuredPair()
{
    Scene scene = fallingPair();
    Probe height;
    height.name = "height";
    height.target = Id{2};
    Probe speed;
    speed.name = "speed";
    speed.quantity = Quantity::Speed;
    speed.target = Id{2};
    scene.items.push_back({Id{8}, height});
    scene.items.push_back({Id{9}, speed});
    scene.nextId = Id{10};
    return scene;
}

// One of everything, as an edit may meet it. Ids: 1 part (2, 3, 4 particles; 5 to 7 links; 8
// panel), 9 and 10 materials, 11 group, 12 collider, 13 wind, 14 control, 15 probe.
inline Scene oneOfEverything()
{
    Scene scene;
    Part part;
    part.name = "sail";
    part.particles.push_back({.id = Id{2}, .position = Vec3(0, 1, 0), .pinned = true});
    part.particles.push_back({.id = Id{3}, .position = Vec3(1, 1, 0)});
    part.particles.push_back({.id = Id{4}, .position = Vec3(0, 0, 0)});
    part.links.push_back(rod(Id{5}, Id{2}, Id{3}, Id{9}));
    part.links.push_back(rod(Id{6}, Id{3}, Id{4}, Id{9}));
    part.links.push_back(rod(Id{7}, Id{4}, Id{2}, Id{9}));
    part.panels.push_back({.id = Id{8}, .a = Id{2}, .b = Id{3}, .c = Id{4}, .material = Id{10}});

    Material thread;
    thread.name = "thread";
    Material cloth;
    cloth.name = "cloth";
    Group group;
    group.members = {Id{3}, Id{5}, Id{8}};
    Control control;
    control.targets = {Id{2}};
    Probe probe;
    probe.target = Id{3};
    Plot plot;
    plot.probes = {Id{15}};
    scene.items = {{Id{1}, part},     {Id{9}, thread},      {Id{10}, cloth},
                   {Id{11}, group},   {Id{12}, Collider{}}, {Id{13}, Wind{}},
                   {Id{14}, control}, {Id{15}, probe},      {Id{16}, plot}};
    scene.nextId = Id{17};
    return scene;
}

inline Edit setValue(const Scene& scene, Id id, std::string_view key, Value value)
{
    const Property* property = findProperty(kindOf(*find(scene, id)), key);
    return {Message("Set %1", property->label), {SetValues{property, {id}, {std::move(value)}}}};
}

} // namespace ripstop
