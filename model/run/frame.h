// What views, plots and exporters see of a simulation: one instant, complete and immutable.
#pragma once

#include "base/laws.h"
#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ripstop {

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

    // Particles and links that a tear has doubled have the id of those that they came from.
    std::vector<std::uint32_t> particleId; // [particles]
    std::vector<std::uint8_t> pinned;      // [particles]
    std::vector<Link> links;               // in the author's order
    std::vector<std::uint32_t> panelId;    // [panels]
    std::vector<std::array<int, 3>> panelCorners;
    std::vector<std::uint32_t> inputId;    // [inputs] ids of the controls
    std::vector<std::uint32_t> colliderId; // [colliders]
    std::vector<Probe> probes;

    friend bool operator==(const Layout&, const Layout&) = default;
};

struct Tear
{
    double time = 0.0;         // s
    std::uint32_t link = 0;    // id
    double length = 0.0;       // m
    double strain = 0.0;       // 1
    double force = 0.0;        // N
    Vec3 place = Vec3::Zero(); // m
    double energy = 0.0;       // J, released
};

struct ControlCommand
{
    double time;           // s
    std::uint32_t control; // id
    double value;          // m, where the control is told to go
};

struct Frame
{
    std::uint64_t generation = 0; // which System made it
    std::uint64_t run = 0;
    std::shared_ptr<const Layout> layout;

    double time = 0.0;          // s
    std::int64_t step = 0;      // time steps since the start
    int substeps = 0;           // that the next step will take
    std::string solverChoice;   // what Solver::Auto began with and why; empty for others
    std::uint64_t hash = 0;     // of the state, as stateHash() has it
    double realTimeRatio = 0.0; // simulated seconds per second of the clock, lately
    std::vector<Vec3> position; // [particles] m
    std::vector<Vec3> velocity; // [particles] m/s

    std::vector<double> strain;           // [links] 1
    std::vector<double> tension;          // [links] N, negative in compression
    std::vector<std::uint8_t> torn;       // [links]
    std::vector<Vec3> panelLoad;          // [panels] N
    std::vector<std::uint8_t> gone;       // [panels]
    Vec3 gust = Vec3::Zero();             // m/s, of all gusts together, the same everywhere
    std::vector<Vec3> colliderPosition;   // [colliders] m
    std::vector<double> inputCommand;     // [inputs] m
    std::vector<double> inputValue;       // [inputs] m
    std::vector<double> probe;            // [probes] in the unit of the probe
    std::vector<Tear> tears;              // all since the start, in order of time
    std::vector<ControlCommand> commands; // all since the start, in order of time
    std::string stopped;                  // why the simulation cannot go on; empty when it can
    std::uint32_t culprit = 0;            // id of the element that stopped it
};

} // namespace ripstop
