// What changes while a system runs: time, motion, and whatever a step must remember.
//
// A State belongs to one System, which gives its arrays their sizes; copying it is a checkpoint,
// from which a run goes on with the same bits. The State of a run is changed by the thread that
// steps alone. A new field needs its line in system/fields.h, which says whether it is hashed and
// how it goes over into another system.
#pragma once

#include "base/hands.h"
#include "base/vec3.h"
#include "laws/cloth_law.h"
#include "system/canopy.h"
#include "system/gust_spec.h"
#include "system/links.h"
#include "system/panels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ripstop {

// A particle that a tear has parted (tearing/tear_opening.h). It names all by keys, so that it
// outlives edits: what it names and is no longer there is passed over.
struct Split
{
    struct Cut // a link along the tear: each lip has one afterwards
    {
        Key link;     // of the lip of `from`
        Key twin;     // of the lip of `twin`
        double share; // 1, of stiffness, damping and breaking force, that the twin takes

        friend bool operator==(const Cut&, const Cut&) = default;
    };
    Key from;                // particle; keeps pins and hands, and what the torn link leaves behind
    Key twin;                // particle; new, at the same place with the same velocity
    double share;            // 1, of the mass, that the twin takes
    std::vector<Key> panels; // whose corner is the twin from now on
    std::vector<Key> links;  // whose end is the twin from now on
    std::vector<Cut> cut;

    friend bool operator==(const Split&, const Split&) = default;
};

// A link where the mesh has just opened: it has let go and has to be given time to shrink.
struct TearHold
{
    int link;     // index into System::links
    double ratio; // 1, over its limit, of the link that tore; it fades (tearing/tearing.h)

    friend bool operator==(const TearHold&, const TearHold&) = default;
};

// Work since the start, J, on particles that are free; kept while a probe asks for it
// (measure/energy_ledger.h).
struct Work
{
    double air = 0.0;
    double hands = 0.0;    // of hands and of controls
    double damping = 0.0;  // of dampers and viscosity
    double contact = 0.0;  // with obstacles and of fabric with itself
    double tearing = 0.0;  // what torn links held
    double residual = 0.0; // what the solver made

    friend bool operator==(const Work&, const Work&) = default;
};

// What an edit in flight changes of a link: these numbers go from what they were to what was typed
// (simulation/ramps.h).
struct Ramp
{
    struct Numbers
    {
        double restLength = 0.0; // m
        double stiffness = 0.0;  // N/m of a spring; of a rod its compliance, m/N
        double damping = 0.0;    // N s/m of a spring
        double limit = 0.0;      // TearLimit::limit

        friend bool operator==(const Numbers&, const Numbers&) = default;
    };
    Key link;
    double began; // s
    double lasts; // s
    Numbers from;
    Numbers to;

    friend bool operator==(const Ramp&, const Ramp&) = default;
};

// The same of the law of a material's elastic panels, and of the cut and the stiffness factor of
// one of them (simulation/cloth_ramps.h).
struct ClothRamp
{
    Key material;
    double began; // s
    double lasts; // s
    ClothLaw from;
    ClothLaw to;

    friend bool operator==(const ClothRamp&, const ClothRamp&) = default;
};

struct PanelRamp
{
    Key panel;
    double began; // s
    double lasts; // s
    PanelCut from;
    PanelCut to;

    friend bool operator==(const PanelRamp&, const PanelRamp&) = default;
};

struct FactorRamp
{
    Key panel;
    double began; // s
    double lasts; // s
    double from;  // ElementFactors::stiffness
    double to;

    friend bool operator==(const FactorRamp&, const FactorRamp&) = default;
};

struct State
{
    double time = 0.0;         // s
    std::int64_t step = 0;     // time steps since the start
    std::int64_t substep = 0;  // substeps since the start
    int substeps = 0;          // of the next step, where the solver chooses; 0 for its first choice
    double driftSubstep = 0.0; // s, of the substep that `drift` and `velocityBefore` are of; 0 when
                               // they are of none, negative right after an impact

    std::vector<PaddedVec3> position; // [particles] m
    std::vector<PaddedVec3> velocity; // [particles] m/s
    std::vector<PaddedVec3> drift;    // [particles] m/s, (x - previous x) / h: Verlet's memory
    std::vector<PaddedVec3> velocityBefore; // [particles] m/s, a substep ago: with drift, BDF2's

    std::vector<double> inputCommand; // [inputs] m, where the input is told to go
    std::vector<double> inputValue;   // [inputs] m, where it is

    Hands hands;               // as they were told
    std::vector<Vec3> carried; // [hands.carries] m, how far each has come

    std::vector<GustState> gusts;    // [gusts]
    std::vector<CanopyAir> canopies; // [canopies]

    std::vector<std::uint8_t> springTorn; // [springs]
    std::vector<std::uint8_t> rodTorn;    // [rods]
    std::vector<std::uint8_t> panelGone;  // [panels]
    std::vector<double> panelHold;        // [panels] as TearHold::ratio: the panel waits; negative
                                          // where the mesh has yet to open, 0 for all others
    std::vector<double> rodTension;       // [rods] N, mean over the last step

    struct Tear
    {
        double time;         // s
        Key element;         // key of the link, or of the panel that carried the pull of a fabric
        double length;       // m, at the break; of a panel its width across the pull, flat; 0 of a
                             // link that goes where a spar snaps
        double strain;       // 1, of a panel that of the threads that broke
        double force;        // N, of a panel N/m: the pull of those threads per flat width; of a
                             // spar that snaps N m, its bending moment
        Vec3 place;          // m, its middle; of a spar that snaps the bend
        double energy = 0.0; // J, that it held and no longer does

        friend bool operator==(const Tear&, const Tear&) = default;
    };
    std::vector<Tear> tears; // in order of time

    std::vector<Split> splits; // in order of time; the system is one that was split by them
    std::vector<TearHold> tearHolds;

    Work work;
    std::vector<Ramp> ramps; // in ascending order of key, as are the next three
    std::vector<ClothRamp> clothRamps;
    std::vector<PanelRamp> panelRamps;
    std::vector<FactorRamp> factorRamps;

    friend bool operator==(const State&, const State&) = default;
};

inline bool isTorn(const LinkPlace& link, const State& state)
{
    return link.kind == LinkKind::Rod ? state.rodTorn[std::size_t(link.index)]
                                      : state.springTorn[std::size_t(link.index)];
}

} // namespace ripstop
