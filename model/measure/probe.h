#pragma once

#include "measure/diagnostics.h"
#include "sim/system.h"

#include <optional>
#include <string_view>
#include <vector>

namespace ripstop {

// "m", "deg", "N", ...; empty when dimensionless. Elevation is in degrees because that is how
// fliers speak of it.
std::string_view unitOf(Quantity quantity);

// One instant, measured no further than it is asked for: several probes of the same quantity cost
// one pass over the elements. It holds references to both values.
class Readings
{
public:
    Readings(const System& system, const State& state)
        : m_system(system)
        , m_state(state)
    {}

    const System& system() const { return m_system; }
    const State& state() const { return m_state; }
    const std::vector<double>& strain();  // [links] 1
    const std::vector<double>& tension(); // [links] N
    const std::vector<Vec3>& panelLoad(); // [panels] N
    const Energies& energy();

    // The value that the probe reads now. Not a number when it has nothing to read, for example
    // the glide ratio of something that does not sink.
    double value(const ProbeSpec& probe);

private:
    Vec3 lineDragOf(const ProbeSpec& probe); // N

    const System& m_system;
    const State& m_state;
    std::optional<std::vector<double>> m_strain;
    std::optional<std::vector<double>> m_tension;
    std::optional<std::vector<Vec3>> m_panelLoad;
    std::optional<std::vector<Vec3>> m_lineDrag;
    std::optional<Energies> m_energy;
};

} // namespace ripstop
