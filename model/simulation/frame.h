// What views, plots and exporters see of a simulation: one instant, complete. A frame is made by
// the thread that steps and never changes afterwards, so that any thread may read it; what it
// shares with other frames (its layout, what hands have done) does not change either.
//
// Arrays are in the order of the system: [particles], [links] in the author's order, [panels]. Ids
// are those of the scene.
#pragma once

#include "base/message.h"
#include "base/vec3.h"
#include "laws/guide.h"
#include "laws/link_laws.h"
#include "laws/load_margin.h"
#include "laws/panel_pull.h"
#include "simulation/hand_track.h"
#include "simulation/run_accuracy.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

struct TornSystem; // simulation/torn_system.h

// What the arrays of a frame are about, by the ids of the scene. Shared by all frames of one
// compiled system, until a tear splits its mesh.
struct Layout
{
    struct Link
    {
        std::uint32_t id;
        LinkKind kind;
        int a; // particle indices
        int b;
        double restLength; // m

        friend bool operator==(const Link&, const Link&) = default;
    };
    struct Probe
    {
        std::uint32_t id;
        std::string name;
        std::string unit;
        bool plotted;

        friend bool operator==(const Probe&, const Probe&) = default;
    };

    // Particles and links that a tear has doubled have the id of those that they came from, and
    // keys of their own.
    std::vector<std::uint32_t> particleId;  // [particles]
    std::vector<std::uint32_t> particleKey; // [particles], or empty when all are those ids
    std::vector<std::uint8_t> pinned;       // [particles]
    std::vector<GuidedParticle> guided;     // in ascending order of particle
    std::vector<Link> links;                // in the author's order
    std::vector<std::uint32_t> panelId;     // [panels]
    std::vector<std::array<int, 3>> panelCorners;
    std::vector<std::uint32_t> inputId;    // [inputs] ids of the controls
    std::vector<std::uint32_t> colliderId; // [colliders]
    std::vector<Probe> probes;
    std::shared_ptr<const TornSystem> torn; // null when no tear has parted anything

    std::uint32_t keyOf(std::size_t particle) const
    {
        return particleKey.empty() ? particleId[particle] : particleKey[particle];
    }

    friend bool operator==(const Layout&, const Layout&) = default;
};

struct Tear
{
    double time = 0.0;         // s
    std::uint32_t element = 0; // id of a link, or of a panel that carried the pull of a fabric
    double length = 0.0;       // m, of a panel its width across the pull, 0 where a spar snaps
    double strain = 0.0;       // 1
    double force = 0.0;        // N, of a panel N/m, where a spar snaps N m
    Vec3 place = Vec3::Zero(); // m
    double energy = 0.0;       // J, released
};

struct ControlCommand
{
    double time;           // s
    std::uint32_t control; // id
    double value;          // m, where the control is told to go
};

// What the hand pulls at.
struct HeldPoint
{
    Vec3 point;       // m
    Vec3 to;          // m
    double force;     // N
    double stiffness; // N/m, that the time step allows
};

// How far a run has come that ends when all is still (settle.h).
struct Settling
{
    enum class Outcome { Under, Still, GaveUp };
    Outcome outcome = Outcome::Under;
    double speed = 0.0;   // m/s, of the fastest particle; where it gave up, the last too fast
    double goal = 0.0;    // m/s
    double kinetic = 0.0; // J
    double since = 0.0;   // s, simulated, that it has taken
    double within = 0.0;  // s
    int number = 0;       // of the goal
};

struct Frame
{
    std::uint64_t generation = 0; // which System made it
    std::uint64_t run = 0;
    std::shared_ptr<const Layout> layout;

    double time = 0.0;          // s
    std::int64_t step = 0;      // time steps since the start
    int substeps = 0;           // that the next step will take
    Message solverChoice;       // what Solver::Auto began with and why; empty for others
    RunAccuracy accuracy;       // of the run so far
    std::uint64_t hash = 0;     // of the state, as stateHash() has it
    double realTimeRatio = 0.0; // simulated seconds per second of the clock, lately
    std::vector<Vec3> position; // [particles] m
    std::vector<Vec3> velocity; // [particles] m/s

    std::vector<double> strain;           // [links] 1
    std::vector<double> tension;          // [links] N, negative in compression
    std::vector<std::uint8_t> torn;       // [links]
    std::vector<Vec3> panelLoad;          // [panels] N
    std::vector<PanelPull> panelPull;     // [panels], or empty where no panel carries a pull
    std::vector<double> linkMargin;       // [links] load over strength, not a number where there
    std::vector<double> panelMargin;      // [panels] is none; both empty where nothing has one
    WorstPlaces worstNow;                 // of these margins
    WorstPlaces worstOfRun;               // of every step since the start of the run; of a moment
                                          // of a recording there is none
    FirstBreaks firstBreaks;              // the same
    std::vector<std::uint8_t> gone;       // [panels]
    Vec3 gust = Vec3::Zero();             // m/s, of all gusts together, the same everywhere
    Vec3 wind = Vec3::Zero();             // m/s, gusts included, in the middle of the particles
    std::vector<Vec3> colliderPosition;   // [colliders] m
    std::vector<double> inputCommand;     // [inputs] m
    std::vector<double> inputValue;       // [inputs] m
    std::vector<double> probe;            // [probes] in the unit of the probe
    std::vector<double> highest;          // the same, as ProbeSample has it
    std::vector<Tear> tears;              // all since the start, in order of time
    std::vector<ControlCommand> commands; // all since the start, in order of time
    HandTrack hands;                      // the same
    std::optional<HeldPoint> held;
    std::vector<Carry> carries;          // how far hands have taken colliders, m
    std::vector<std::uint32_t> handPins; // keys of particles
    std::optional<Settling> settling;    // while it does, and at its end
    bool underWay = false;               // the run has left the design
    Message stopped;                     // why the simulation cannot go on; empty when it can
    std::uint32_t culprit = 0;           // id of the element that stopped it
};

// What the probes read at an instant of which there is no frame.
//
// An instant is the end of a time step. What a load was within a step that was done again in finer
// ones, for a blow, or when something broke, may be higher (simulation/probe_peaks.h).
struct ProbeSample
{
    std::uint64_t run = 0;
    std::shared_ptr<const Layout> layout;
    double time = 0.0;                // s
    std::vector<double> probe;        // [probes] in the unit of the probe
    std::vector<double> highest = {}; // the same within the step; empty where none is higher

    const std::vector<double>& most() const { return highest.empty() ? probe : highest; }
};

} // namespace ripstop
