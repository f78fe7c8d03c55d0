// Where fabric and spars bend, and how stiff they are there.
//
// A bend is the side that two panels share, or the particle that two links of a spar share. Its
// turn y is a sum over particles, y = sum of w x, with weights that sum to zero and give no turn to
// what is flat or straight. Its length is the angle (2 sin of half of it) times the length of the
// side, or times the length of spar that turns there.
//
// Fabric. The weights are the cotangents of isometric bending (Bergou et al. 2006, A quadratic
// bending model for inextensible surfaces, section 3): w_a = cot b + cot b', w_b = cot a + cot a',
// w_c = -(cot a + cot b) for the side ab and the corners c and c' across. They follow from rest
// lengths alone. Fabric is flat at rest. What turns at the three sides e of a panel of area A is
// spread over the panels beside them by area, and makes one curvature, as in the triangle of Onate
// and Zarate 2000 (Rotation-free triangular plate and shell elements):
//
//     k = sum over e of y_e / (A + A_e) n_e n_e^T,  n_e across the side, in the plane
//     energy = B A |k|^2 / 2, so that the moment of a bend is z_e = sum of C_ef y_f,
//     C_ef = B A cos^2(angle of e and f) / ((A + A_e) (A + A_f))
//
// The weight 3 B / (A + A') for each bend alone, of Bergou and of Grinspun 2003, makes a strip of
// square or of equilateral cells two and a half times too stiff.
//
// Spars. With links of l and l' of which the length L = (l + l') / 2 turns, w = L / l for their
// outer ends; the moment is EI / L^3 times y. A link or panel that is pinned throughout is a clamp
// and does not bend itself, so that what it holds starts at its edge.
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
#include <vector>

namespace ripstop {

struct Bending // of a material
{
    double fabric = 0.0; // N m, B of panels
    double spar = 0.0;   // N m^2, EI of links

    friend bool operator==(const Bending&, const Bending&) = default;
};

struct Bend
{
    std::array<int, 4> corner;        // particle indices: a, b, c, c', or three and one repeated
    std::array<double, 4> weight;     // 1
    double stiffness;                 // N/m
    double restTurn = 0.0;            // m, of spars that are built bent
    std::array<int, 4> beside = {};   // bends of the same panels
    std::array<double, 4> coupling{}; // N/m, to them; 0 for none
    std::array<int, 2> of{};          // the two panels, or the two links
    bool ofSpar = false;
    bool withRods = false; // solved together with them instead of pulling as a force

    friend bool operator==(const Bend&, const Bend&) = default;
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
        std::uint32_t material; // a spar goes on where links of one material meet
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
// 60 degrees, the straightest pair first; spars keep the turn that they are built with.
std::vector<Bend> bendsOf(const BendingNet& net);

// How many of these pull as forces; the others come last.
std::size_t countOfForces(const std::vector<Bend>& bends);

// What bending as a force asks of the step (step_limit.h) at each particle, N/m, as springs would.
std::vector<double> bendSums(const std::vector<Bend>& bends, std::size_t particles);

} // namespace ripstop
