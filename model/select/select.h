// Selections from selections.
//
// All of these take ids of items and elements in ascending order, an item standing for its elements
// (elements.h), and return ids of elements in ascending order. Each is one or two passes over the
// tables: some milliseconds for 100 000 particles.
#pragma once

#include "select/elements.h"

namespace ripstop {

// Adds one ring to each kind that is selected: particles to those that a panel's side or a link
// ties to them, links to links that meet them at an end, panels to panels that meet them at a
// corner. Links that run across fabric from ring to ring, as shear and bend springs do, are not a
// way.
std::vector<Id> grown(const Scene& scene, const std::vector<Id>& selected);

// Takes one ring away: what has a neighbour that is not selected goes.
std::vector<Id> shrunk(const Scene& scene, const std::vector<Id>& selected);

// All that links and panels tie to the selected, in any number of steps.
std::vector<Id> connected(const Scene& scene, const std::vector<Id>& selected);

// All elements of the kinds that are selected, less the selected; everything where nothing is.
std::vector<Id> inverted(const Scene& scene, const std::vector<Id>& selected);

// The lines that go on from the selected links, or from selected particles that a link joins: on
// through a particle where nothing else of the material meets, around the edge of fabric, else
// straight on, within 40 degrees. A particle alone stands for the edge that it lies on, or for the
// line that runs through it; two on one edge, for the shortest stretch of it between them. The
// particles of the lines are added where particles are selected,
// and the links where links are.
std::vector<Id> loop(const Scene& scene, const std::vector<Id>& selected);

// The edge of the selected panels, or of all when none is: the particles and links along sides that
// belong to one panel only.
std::vector<Id> boundary(const Scene& scene, const std::vector<Id>& selected);

// The same place as elements of one kind: particles at ends and corners, or links and panels all of
// whose particles are there. `kind` is that of an element.
std::vector<Id> turnedInto(Kind kind, const Scene& scene, const std::vector<Id>& selected);

enum class Alike {
    Type,     // springs, rods; pinned or free particles; panels
    Material, // of links and panels
    Role,     // of links
    Measure,  // mass, rest length or area, within 1 %
    Group,    // members of the groups that the selected are members of
    Part
};

// All elements that are like one of the selected, and those themselves.
std::vector<Id> similar(Alike alike, const Scene& scene, const std::vector<Id>& selected);

} // namespace ripstop
