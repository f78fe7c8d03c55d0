// Flat cloth of elastic panels, laid out in the plane of x and y.
#pragma once

#include "builders/network.h"

#include <array>
#include <vector>

namespace ripstop {

struct FlatCloth
{
    std::vector<Vec3> place; // m, z = 0
    std::vector<std::array<int, 3>> triangles;
};

// How cells are parted: along the diagonal that rises with x or the one that falls, by turns, or
// along both. The particles in the middles of cells come last then.
enum class Parted { Rising, Falling, ByTurns, Crosswise };

// Columns along x.
FlatCloth rectangle(double length, double width, int along, int across,
                    Parted parted = Parted::Rising);

// Square cells of about this size, turned by so many degrees, and what the edges leave of others,
// each parted from its middle.
FlatCloth turnedRectangle(double length, double width, double cell, double degrees);

// Rings of 6, 12, 18 ... particles around one.
FlatCloth disc(double radius, int rings);

// E t along the warp and the weft, Poisson's ratio, and G t; N/m.
Material woven(double warp, double weft, double poisson, double shear);
Material clothA(); // E1 t 40, E2 t 25, G t 1.2 kN/m, nu12 0.2
Material isotropic(double stiffness, double poisson);

// A scene of one part, its particles and panels in the order of the cloth; the particles have no
// mass but that of the cloth. Settings are those of a new scene, but that it is viscous (20 1/s),
// without weight and in no air.
//   warp     degrees from x
//   density  kg/m^2
Scene sceneOf(const FlatCloth& cloth, const Material& material, double warp,
              double density = 0.042);

std::vector<Particle>& particlesOf(Scene& scene); // of its last item, a part

// The particles of a straight edge and the share of it that each one carries.
struct OfEdge
{
    std::size_t particle;
    double share; // 1
};

// The edge where the coordinate `across` is `at`, along the other one.
std::vector<OfEdge> edgeOf(const FlatCloth& cloth, int across, double at);

// The cloth hangs along x, its upper edge, x = 0, on rollers; at its lower one is a weight, N, that
// pulls alike everywhere.
Scene hungByRollers(const FlatCloth& cloth, const Material& material, double warp, double load);

} // namespace ripstop
