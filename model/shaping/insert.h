// A built design that goes into an open one.
//
// Its parts, materials, groups, controls and probes come along under ids of their own. A material
// that the scene has already is used again; other names that are taken get a number. The ground and
// the wind of a builder are for a design that stands alone: a second wind would add to the first.
#pragma once

#include "scene/edit.h"

#include <Eigen/Geometry>

#include <string>

namespace ripstop {

enum class PlaceAt {
    Origin, // where the builder has it
    Beside, // along z from what is there, a tenth of its own size away
    Point,  // the middle of its box comes to a point
    Shift,  // moved from where the builder has it
};

struct InsertWish
{
    std::string label; // of the design, "Delta kite"
    PlaceAt at = PlaceAt::Origin;
    Vec3 place = Vec3::Zero();    // m, the point or the shift
    bool withSurroundings = true; // planes, winds and settings other than at first
    bool withInstruments = true;  // controls and probes
};

// What an insertion needs to know of the open scene, so that another thread can make the edit: the
// scene without the rows of its parts, and the box around them.
struct InsertGround
{
    Scene scene;
    Eigen::AlignedBox3d box; // m, empty without particles
};
InsertGround groundOf(const Scene& scene);
bool hasSurroundings(const Scene& scene); // a plane or a wind

struct Insertion
{
    Edit edit;
    std::vector<Id> bodies; // parts and obstacles that come, ascending
    int substeps = 0;       // that the scene is raised to, 0 where it has enough
};
Insertion inserted(const InsertGround& ground, Scene built, const InsertWish& wish);

// Of all particles, m; empty without any.
Eigen::AlignedBox3d boxOf(const Scene& scene);

// The same, or of the obstacles where there are no particles.
Eigen::AlignedBox3d extentOf(const Scene& scene);

} // namespace ripstop
