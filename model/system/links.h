// Springs and rods, and the links that the author knows them by.
//
// A link of the scene becomes a spring (a force, forces/spring_force.h) or a rod (a constraint,
// constraints/rod_solver.h). A spring that is too stiff for a force becomes a rod of the same law,
// with the compliance 1 / k and the damping time nu / k (check/step_limits.h). Rods stand in the
// order of the sweeps; LinkPlace says which spring or rod a link became. What tears is told by
// tearing/tearing.h.
#pragma once

#include "laws/tear_limits.h"
#include "system/key.h"

#include <cstdint>

namespace ripstop {

// A link that is a force: F = k (|d| - l) + nu (vb - va).u along u = d/|d|, on `a` towards `b`.
struct Spring
{
    int a; // particle index
    int b;
    double restLength; // m
    double stiffness;  // N/m
    double damping;    // N s/m
    Resists resists;
    TearLimit tear;

    friend bool operator==(const Spring&, const Spring&) = default;
};

// A link that is a constraint. Damping pulls along with the stretch C: (C + dampingTime C') /
// compliance, Kelvin and Voigt's solid; it pulls only where the stretch does, and not at all on
// rods without compliance.
struct Rod
{
    int a; // particle index
    int b;
    double restLength; // m
    double compliance; // m/N, 0 never stretches
    Resists resists;
    TearLimit tear;
    double dampingTime = 0.0; // s

    friend bool operator==(const Rod&, const Rod&) = default;
};

// The rod and the spring of the same law; neither may be without compliance or stiffness.
inline Rod asRod(const Spring& spring)
{
    return {spring.a,
            spring.b,
            spring.restLength,
            1.0 / spring.stiffness,
            spring.resists,
            spring.tear,
            spring.damping / spring.stiffness};
}

inline Spring asSpring(const Rod& rod)
{
    return {rod.a,
            rod.b,
            rod.restLength,
            1.0 / rod.compliance,
            rod.dampingTime / rod.compliance,
            rod.resists,
            rod.tear};
}

// A link as the author sees it: which spring or rod it became, and whom it joins.
struct LinkPlace
{
    Key key;
    LinkKind kind;
    int index; // in springs or rods
    int a;     // particle indices
    int b;

    friend bool operator==(const LinkPlace&, const LinkPlace&) = default;
};

// What a link takes its numbers from, so that an edit of a material finds the links made of it and
// what it makes of them.
struct LinkStuff
{
    Key material = 0;
    std::uint8_t own = 0; // bits, one for each number that is the link's own
    LinkRole role = LinkRole::Line;
    double width = 0.0; // m, of the strip of fabric

    friend bool operator==(const LinkStuff&, const LinkStuff&) = default;
};

// How many times as stiff and as strong an element is as its material: a reinforced place, a worn
// one.
struct ElementFactors
{
    double stiffness = 1.0; // 1
    double strength = 1.0;  // 1

    friend bool operator==(const ElementFactors&, const ElementFactors&) = default;
};

struct LinkFactors : ElementFactors
{
    double cellAspect = 1.0; // 1, of the cells beside a thread (derived/link_stiffness.h)

    friend bool operator==(const LinkFactors&, const LinkFactors&) = default;
};

struct DragLine // a link that the wind drags
{
    int link; // index into System::links
    int a;    // particle indices
    int b;
    double width; // m, drag coefficient times diameter

    friend bool operator==(const DragLine&, const DragLine&) = default;
};

} // namespace ripstop
