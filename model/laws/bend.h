// Where fabric and spars bend, and how stiff they are there.
//
// Energies of bending are of angles alone, whatever the lengths are: what is bent pulls across
// itself and does not push itself together. With a turn that shrinks with the lengths, as the
// quadratic one of isometric bending does (Bergou et al. 2006, A quadratic bending model for
// inextensible surfaces), cloth of curvature k would push with about B k^2 along it, which cloth
// that wrinkles has nothing against.
//
// Fabric is flat at rest. The normal N of a panel jumps at its sides e; a jump is spread over the
// panels A and A_e beside a side by area, and makes one gradient of the normal, as in the triangle
// of Onate and Zarate 2000 (Rotation-free triangular plate and shell elements):
//
//     G = sum over e of |e| / (A + A_e) (N_e - N) (x) n_e,  n_e across the side, in the plane at
//     rest energy = B A |G|^2 / 2
//
// It does not change while a panel moves or deforms in its plane, and it pulls corners along N.
//
// For small turns this is the curvature k = sum of y_e / (A + A_e) n_e (x) n_e, with the jump of
// the slope y_e = sum of w x, a bend of its four corners. The weights are the cotangents of
// isometric bending (there, section 3): w_a = cot b + cot b', w_b = cot a + cot a', w_c = -(cot a +
// cot b) for the side ab and the corners c and c' across. They follow from rest lengths alone. The
// moment of a bend is z_e = sum of C_ef y_f, C_ef = B A cos^2(angle of e and f) / ((A + A_e) (A +
// A_f)), of which the limit of the step is made.
//
// The weight 3 B / (A + A') for each bend alone, of Bergou and of Grinspun 2003, makes a strip of
// square or of equilateral cells two and a half times too stiff.
//
// Spars bend at the particle that two links share, by the turn y = L (u + u') with unit vectors u
// and u' along the links. Of links of l and l' the length L = (l + l') / 2 turns; the moment is
// EI / L^3 times y, with what links of two EI have in series (joined_spars.h). For small turns y =
// sum of w x with w = L / l for the outer ends. A link or panel that is pinned throughout is a
// clamp and does not bend itself, so that what it holds starts at its edge.
//
// What is short pulls hard for a turn. No step could bear what has no length: where the height of a
// panel over a side, to the length of the side, is less than `leastShare` of that at rest, or a
// link less of its length, it counts as if it had that much. N and u are shorter than 1 there, and
// the push along them is back. So a corner never turns what it bends by more than 1 / leastShare of
// what it does at rest. With 9/10 the limit of the step, which is made for what is flat at rest,
// holds for cloth that is crumpled or squeezed one way, however far
// (tests/model/test_bent_cloth.cpp); for cloth squeezed both ways, with edges as heavy as the rest,
// it can be a twentieth too long, and for spars squeezed along them as forces a tenth.
//
// Spars of rods that are solved together bend together with them (constraints/spar_bends.h). As a
// force beside such rods a spar that is bent far would not come to rest: rods that push take
// stiffness away from it at the end of a substep, after bending has given it at the start.
//
// There is no damping: what is stable with explicit steps damps the fastest vibration and leaves
// the others alone, and three particles do not tell a spar that turns about itself from one that
// bends another way.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

struct Bending // of a material
{
    double fabric = 0.0;   // N m, B of panels
    double spar = 0.0;     // N m^2, EI of links
    double breaking = 0.0; // N m, the moment at which these links snap, or 0 for never

    friend bool operator==(const Bending&, const Bending&) = default;
};

inline constexpr double leastShare = 0.9; // 1, see above

struct Bend
{
    std::array<int, 4> corner;        // particle indices: a, b, c, c', or three and one repeated
    std::array<double, 4> weight;     // 1, for small turns
    double stiffness;                 // N/m
    std::array<double, 2> length{};   // m, of the links of a spar
    double restTurn = 0.0;            // m, of spars that are built bent
    double breaking = 0.0;            // N m, the moment at which a spar snaps, or 0 for never
    std::array<int, 4> beside = {};   // bends of the same panels
    std::array<double, 4> coupling{}; // N/m, to them; 0 for none
    std::array<int, 2> of{};          // the two panels, or the two links
    bool ofSpar = false;
    bool withRods = false; // solved together with them instead of pulling as a force

    friend bool operator==(const Bend&, const Bend&) = default;
};

// The turn of a spar at a particle, and how it changes where the outer ends of its links go; where
// the particle goes it changes by the opposite of both.
struct SparTurn
{
    Vec3 turn;                 // m
    std::array<Mat3, 2> slope; // 1, symmetric
};

//   ways  m, from the particle to the outer ends
SparTurn turnOf(const Bend& bend, const std::array<Vec3, 2>& ways);

// The bending moment of a spar at the particle, N m: the slope of its energy over the angle between
// its two links. At rest it is exactly the moment about the particle of all that pulls at either
// side. The energy, J, is half of the stiffness times the square of the turn beyond that at rest.
double momentOf(const Bend& spar, const std::array<Vec3, 2>& ways);
double energyOf(const Bend& spar, const std::array<Vec3, 2>& ways);

// A panel with a side that bends.
struct BentPanel
{
    using Plane = std::array<double, 2>; // along axes of the panel at rest

    std::array<int, 3> corner;                 // particle indices
    std::array<int, 3> beside{};               // rows across from the corners, or its own
    std::array<double, 3> sign{1.0, 1.0, 1.0}; // -1 where the panel beside is turned over
    std::array<Plane, 3> share{};              // 1/m, |e| / (A + A_e) n_e
    std::array<Plane, 3> shareBeside{};        // 1/m, that of the panel beside, times the sign
    Plane own{};                               // 1/m, less the sum of its shares
    double stiffness = 0.0;                    // N m^3, B A, or 0 of a clamp
    std::array<double, 3> leastHeight{};       // m, of the corners, over sides as at rest
    int panel = 0;

    friend bool operator==(const BentPanel&, const BentPanel&) = default;
};

// The network that bends are found in: what can bend, and what tells how stiffly.
struct BendingNet
{
    struct Panel
    {
        std::array<int, 3> corner; // particle indices
        Bending bending;
    };
    struct Link
    {
        int a; // particle indices
        int b;
        double restLength;      // m
        std::uint32_t material; // links of one material are joined first
        Bending bending;
        bool isRod = false;
    };

    std::vector<Vec3> position;       // [particles] m, as built
    std::vector<std::uint8_t> pinned; // [particles]
    std::vector<Panel> panels;
    std::vector<Link> links;     // all of them, as they tell how long the sides of panels are
    bool solvesTogether = false; // rods, and with them the spars that they make
};

// Bends in ascending order of their first particles: first those of fabric, then those of spars,
// and last those that are solved together with rods. Sides that a single
// panel or more than two have do not bend. Links go on into each other where they turn by at most
// 60 degrees, those of one material first and the straightest pair first; spars keep the turn that
// they are built with.
std::vector<Bend> bendsOf(const BendingNet& net);

// The same, with the panels of the bends of fabric, in the order of the net.
struct BendsAndPanels
{
    std::vector<Bend> bends;
    std::vector<BentPanel> panels;
};
BendsAndPanels bendsAndPanelsOf(const BendingNet& net);

// How many of these are of fabric, and how many pull as forces; those come first.
std::size_t countOfFabric(const std::vector<Bend>& bends);
std::size_t countOfForces(const std::vector<Bend>& bends);

// What these bends ask of the step (step_limit.h) as forces at each particle, N/m, as springs
// would.
std::vector<double> bendSums(std::span<const Bend> bends, std::size_t particles);

// Whether the fabric among them bends too stiffly to be a force in whole time steps of BDF2, so
// that it is better solved together with what carries its pull.
//   mass      [particles]  kg, or 0 of what is pinned
//   timeStep  s
bool fabricBendsStiffly(const std::vector<Bend>& bends, std::span<const double> mass,
                        double timeStep);

} // namespace ripstop
