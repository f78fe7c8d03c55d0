// Which forces there are, and what each derives from the rest of a System.
//
// The type of what a force derives stands for that force: its makeForce(), which the source of the
// force defines, gives the force itself, and a program that lacks one does not link. What the
// author's own arrays say already (springs, panels, weights) is not repeated here.
//
// Whoever changes a finished system in place has the lists filled anew by listForces()
// (forces/forces.h).
#pragma once

#include "base/rows.h"
#include "laws/bend.h"
#include "laws/wing_strips.h"
#include "system/links.h"

#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace ripstop {

class Force;

struct SpringLists
{
    static std::unique_ptr<Force> makeForce();

    friend bool operator==(const SpringLists&, const SpringLists&) = default;
};

struct FabricLists
{
    std::vector<WingStrips> wings; // pieces of fabric with the vortex law

    static std::unique_ptr<Force> makeForce();

    friend bool operator==(const FabricLists&, const FabricLists&) = default;
};

struct LineLists
{
    std::vector<DragLine> list; // in the order of their links
    Rows at;                    // [particles], or empty when there are none

    static std::unique_ptr<Force> makeForce();

    friend bool operator==(const LineLists&, const LineLists&) = default;
};

struct BendLists
{
    std::vector<Bend> list;        // where what bends stiffly can bend
    std::vector<BentPanel> panels; // that bend
    bool panelsAreSolved = false;  // with those that carry the pull, instead of being forces
    Rows at; // [particles] corners of pullingPanels() and then of spars(), by three

    // What pulls as a force.
    std::span<const Bend> forces() const
    {
        const std::span all = std::span(list).first(countOfForces(list));
        return panelsAreSolved ? all.subspan(countOfFabric(list)) : all;
    }
    bool arePulling() const { return !forces().empty(); }
    std::span<const BentPanel> pullingPanels() const
    {
        return panelsAreSolved ? std::span<const BentPanel>() : panels;
    }
    std::span<const Bend> spars() const
    {
        return std::span(list).first(countOfForces(list)).subspan(countOfFabric(list));
    }

    // What is solved together with rods.
    std::span<const BentPanel> solvedPanels() const
    {
        return panelsAreSolved ? panels : std::span<const BentPanel>();
    }
    std::span<const Bend> withRods() const { return std::span(list).subspan(countOfForces(list)); }

    std::span<const Bend> ofSpars() const { return std::span(list).subspan(countOfFabric(list)); }

    static std::unique_ptr<Force> makeForce();

    friend bool operator==(const BendLists&, const BendLists&) = default;
};

struct WeightLists
{
    static std::unique_ptr<Force> makeForce();

    friend bool operator==(const WeightLists&, const WeightLists&) = default;
};

struct HandLists
{
    static std::unique_ptr<Force> makeForce();

    friend bool operator==(const HandLists&, const HandLists&) = default;
};

// Forces stand in the order in which they are added up at a particle; another order gives other
// bits.
using ForceLists =
    std::tuple<SpringLists, FabricLists, LineLists, BendLists, WeightLists, HandLists>;

} // namespace ripstop
