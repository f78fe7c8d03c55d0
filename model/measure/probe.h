// What probes read: one number from one instant of a simulation, in the SI unit of its quantity;
// angles are in degrees.
//
// A Readings refers to a system and a state that must outlive it, and is used by one thread. It
// does not fail: what cannot be read is not a number.
#pragma once

#include "measure/diagnostics.h"
#include "measure/margins.h"
#include "system/system.h"

#include <optional>
#include <vector>

namespace ripstop {

// One instant, measured no further than it is asked for: several probes of the same quantity cost
// one pass over the elements. It holds references to both values.
class Readings
{
public:
    // `before` is the state one time step ago, or null.
    Readings(const System& system, const State& state, const State* before = nullptr)
        : m_system(system)
        , m_state(state)
        , m_before(before)
    {}

    const System& system() const { return m_system; }
    const State& state() const { return m_state; }
    const std::vector<double>& strain();       // [links] 1
    const std::vector<double>& tension();      // [links] N
    const std::vector<Vec3>& panelLoad();      // [panels] N
    const std::vector<PanelPull>& panelPull(); // [panels], or empty where none carries a pull
    const Energies& energy();
    const Margins& margin();

    const State* before() const { return m_before; }
    Vec3 airForceOf(const ProbeSpec& probe); // N, of its panels and lines

    // The value that the probe reads now. Not a number when it has nothing to read, for example
    // the glide ratio of something that does not sink, and for a formula.
    double value(const ProbeSpec& probe);

private:
    Vec3 lineDragOf(const ProbeSpec& probe); // N

    const System& m_system;
    const State& m_state;
    const State* m_before;
    std::optional<std::vector<double>> m_strain;
    std::optional<std::vector<double>> m_tension;
    std::optional<std::vector<Vec3>> m_panelLoad;
    std::optional<std::vector<Vec3>> m_lineDrag;
    std::optional<std::vector<PanelPull>> m_panelPull;
    std::optional<Energies> m_energy;
    std::optional<Margins> m_margin;
};

} // namespace ripstop
