// What states and kept frames are made of, for base/bytes.h.
#pragma once

#include "base/bytes.h"
#include "run/run_input.h"
#include "system/state.h"

namespace ripstop {

template <typename A>
void visit(A& archive, Of<A, Grip>& grip)
{
    auto& [particle, share] = grip;
    archive(particle, share);
}

template <typename A>
void visit(A& archive, Of<A, HandPull>& pull)
{
    auto& [grip, to, stiffness, damping, most] = pull;
    archive(grip, to, stiffness, damping, most);
}

template <typename A>
void visit(A& archive, Of<A, Airflow>& flow)
{
    auto& [kind, velocity, height, exponent, roughness, origin, radius, widening] = flow;
    archive(kind, velocity, height, exponent, roughness, origin, radius, widening);
}

template <typename A>
void visit(A& archive, Of<A, Carry>& carry)
{
    auto& [collider, way] = carry;
    archive(collider, way);
}

template <typename A>
void visit(A& archive, Of<A, Hands>& hands)
{
    auto& [pull, fan, pins, carries] = hands;
    archive(pull, fan, pins, carries);
}

template <typename A>
void visit(A& archive, Of<A, Cut::Edge>& edge)
{
    auto& [near, far] = edge;
    archive(near, far);
}

template <typename A>
void visit(A& archive, Of<A, Cut>& cut)
{
    archive(cut.edges);
}

template <typename A>
void visit(A&, Of<A, HandNote::LetGo>&)
{}

template <typename A>
void visit(A& archive, Of<A, HandNote::Pin>& pin)
{
    auto& [particle, holds] = pin;
    archive(particle, holds);
}

template <typename A>
void visit(A&, Of<A, HandNote::FanOff>&)
{}

template <typename A>
void visit(A&, Of<A, HandNote::Halt>&)
{}

template <typename A>
void visit(A& archive, Of<A, DesignChange>& change)
{
    archive(change.number);
}

template <typename A>
void visit(A& archive, Of<A, ControlCommand>& command)
{
    auto& [time, control, value] = command;
    archive(time, control, value);
}

template <typename A>
void visit(A& archive, Of<A, RunInput>& input)
{
    auto& [step, what] = input;
    archive(step, what);
}

template <typename A>
void visit(A& archive, Of<A, GustState>& gust)
{
    auto& [along, across, up] = gust;
    archive(along, across, up);
}

template <typename A>
void visit(A& archive, Of<A, CanopyAir>& air)
{
    auto& [started, volume, pressure, fullness, addedMass, momentum, push] = air;
    archive(started, volume, pressure, fullness, addedMass, momentum, push);
}

template <typename A>
void visit(A& archive, Of<A, Split::Cut>& cut)
{
    auto& [link, twin, share] = cut;
    archive(link, twin, share);
}

template <typename A>
void visit(A& archive, Of<A, Split>& split)
{
    auto& [from, twin, share, panels, links, cut] = split;
    archive(from, twin, share, panels, links, cut);
}

template <typename A>
void visit(A& archive, Of<A, TearHold>& hold)
{
    auto& [link, ratio] = hold;
    archive(link, ratio);
}

template <typename A>
void visit(A& archive, Of<A, State::Tear>& tear)
{
    auto& [time, link, length, strain, force, place, energy] = tear;
    archive(time, link, length, strain, force, place, energy);
}

template <typename A>
void visit(A& archive, Of<A, Work>& work)
{
    auto& [air, hands, damping, contact, tearing, residual] = work;
    archive(air, hands, damping, contact, tearing, residual);
}

template <typename A>
void visit(A& archive, Of<A, State>& state)
{
    auto& [time, step, substep, substeps, driftSubstep, position, velocity, drift, inputCommand,
           inputValue, hands, carried, gusts, canopies, springTorn, rodTorn, panelGone, rodTension,
           tears, splits, tearHolds, work] = state;
    (void)work; // beside it, in run_chunk.cpp
    archive(time, step, substep, substeps, driftSubstep, position, velocity, drift, inputCommand,
            inputValue, hands, carried, gusts, canopies, springTorn, rodTorn, panelGone, rodTension,
            tears, splits, tearHolds);
}

} // namespace ripstop
