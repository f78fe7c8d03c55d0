// What probes read: one number from one instant of a simulation, in the SI unit of its quantity;
// angles are in degrees.
//
// A Readings refers to a system and a state that must outlive it, and is used by one thread. It
// does not fail: what cannot be read is not a number.
#pragma once

#include "measure/diagnostics.h"
#include "measure/margins.h"
#include "system/system.h"

#include <cstdint>
#include <vector>

namespace ripstop {

// Whether it is a load or what follows from one at once, so that the highest within a time step is
// what counts of it.
bool isLoad(Quantity quantity);

// One instant, measured no further than it is asked for: several probes of the same quantity cost
// one pass over the elements. It holds pointers to both values.
class Readings
{
public:
    // `before` is the state one time step ago, or null.
    Readings(const System& system, const State& state, const State* before = nullptr)
        : m_system(&system)
        , m_state(&state)
        , m_before(before)
    {}

    // Another instant, maybe of another system, read into the same arrays: of loads (isLoad()) that
    // takes nothing from the heap while the system is the same.
    void goTo(const System& system, const State& state);

    const System& system() const { return *m_system; }
    const State& state() const { return *m_state; }
    const std::vector<double>& strain();       // [links] 1
    const std::vector<double>& tension();      // [links] N
    const std::vector<Vec3>& panelLoad();      // [panels] N
    const std::vector<PanelPull>& panelPull(); // [panels], or empty where none carries a pull
    const Energies& energy();
    const Margins& margin();

    // [links] Whether it is one of the probe's, until this is asked of another.
    const std::vector<std::uint8_t>& isOf(const ProbeSpec& probe);

    const State* before() const { return m_before; }
    Vec3 airForceOf(const ProbeSpec& probe); // N, of its panels and lines

    // The value that the probe reads now. Not a number when it has nothing to read, for example
    // the glide ratio of something that does not sink, and for a formula.
    double value(const ProbeSpec& probe);

private:
    template <typename T>
    struct Kept // from one instant to the next, as far as its memory goes
    {
        T value{};
        bool isKnown = false;
    };

    Vec3 lineDragOf(const ProbeSpec& probe); // N

    const System* m_system;
    const State* m_state;
    const State* m_before;
    Kept<std::vector<double>> m_strain;
    Kept<std::vector<double>> m_tension;
    Kept<std::vector<Vec3>> m_panelLoad;
    Kept<std::vector<Vec3>> m_lineDrag;
    Kept<std::vector<PanelPull>> m_panelPull;
    Kept<Energies> m_energy;
    Kept<Margins> m_margin;
    Kept<JudgedPlaces> m_judged; // of the system with these serials
    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
    std::vector<double> m_restLength; // [rods] m, scratch
    std::vector<std::uint8_t> m_isOf; // [links]
};

} // namespace ripstop
