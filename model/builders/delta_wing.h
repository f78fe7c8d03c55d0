// The sail of a delta: one surface for the hang glider and the kite.
//
// Nose at the origin, flight towards +x, y up, z to the right.
#pragma once

#include "builders/network.h"

namespace ripstop {

struct DeltaShape
{
    double span;     // m, tip to tip
    double chord;    // m, length of the keel
    double dihedral; // rad, rise of the leading edges
    double billow;   // 1, arch between keel and leading edge over the local half width
    double washout;  // rad, by how much less the tips meet the wind than the root
    double reflex;   // 1, rise of the rear end of the keel over its length
};

// s runs along the keel from 0 at the nose to 1, u across from -1 at the left edge to 1.
Vec3 sailPoint(const DeltaShape& shape, double s, double u);

struct SailMaterials
{
    Id sail;
    Id border; // panels along the leading edges
    Id seams;
    Id edges; // rods along the leading edges
    Id hem;   // rods along the trailing edge
};

// Nodes, rods and panels, with texture coordinates; the particles have no mass yet.
Lattice addSail(Network& network, const DeltaShape& shape, int segments,
                const SailMaterials& materials);

// Where frames are tied to a sail.
struct SailFrame
{
    std::vector<Id> leadingEdges; // nose, and from there both sides to the tips
    std::vector<Id> axis;         // the nose, and evenly from there to the trailing edge
    // Of halves, between keel and tip, from the keel out, the left half first.
    std::vector<Id> trailingEdge = {};

    static SailFrame of(const Lattice& lattice);
};

// Where the rows of nodes of a sail lie along its keel, from 0 at the nose to 1, at equal steps.
std::vector<double> evenRows(int segments);

// How each half of a sail is cut.
struct SailCut
{
    std::vector<double> rows; // of nodes, where they lie along the keel, from 0 at the nose to 1
    int strips;
};

// The sail of two halves that are sewn together along the keel, of strips that all begin in the
// nose. Sails billow as cones about the nose, and a mesh bends along the edges of its panels only:
// here these lie along the rulings of the cones, so that coarse meshes billow as fine ones do.
// Across, the cloth is cut as long as the arch of the shape, not as the chords that panels make of
// it. All rows have a node in the fold of the dihedral: where only every second one has, rods and
// panels cut across the fold, and the wing is another one for each mesh. There are no rods along
// the seam, where the caller lays the keel.
SailFrame addHalves(Network& network, const DeltaShape& shape, const SailCut& cut,
                    const SailMaterials& materials);

// Two particles above and below the sail, tied to leading edges and axis. They stand at a steep
// angle to the sail, so that no node can give way.
std::vector<Id> addStiffeners(Network& network, const DeltaShape& shape, const SailFrame& frame,
                              Id material);

// The wind, m/s, that a wing of this frame meets at `speed` and an angle of attack, rad.
Vec3 headwind(double speed, double angle);

} // namespace ripstop
