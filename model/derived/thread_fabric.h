// Threads for a fabric of panels that is to be carried by threads and has none: a rod along each
// side of a panel, as the import makes them of a mesh of triangles (author/mesh_network.h). It
// stands for all of the area of the triangles beside it, a strip of the width (A + A') / L, is as
// long at rest as the panels are cut, and is as stiff and as strong of its material as they are on
// average. Three directions of threads resist shear too, with 3/8 of the membrane stiffness.
#pragma once

#include "scene/edit.h"

#include <vector>

namespace ripstop {

// Parts whose pull threads are to carry and that have a panel which no thread holds: no link runs
// along a side of it, and one of its corners is on no link at all.
std::vector<Id> partsWithoutThreads(const Scene& scene);

// Changes that add the threads to these parts. Sides that are tied already get none.
std::vector<Change> threadsFor(const Scene& scene, const std::vector<Id>& parts);

// The edit, and with it the threads of those parts that it has carried by threads and leaves
// without any: what a person means who chooses that threads carry.
Edit threaded(const Scene& scene, Edit edit);

} // namespace ripstop
