// The highest that probes of loads read within the last time step, for ProbeSample::highest.
//
// A step that was too long for a blow is done again in finer ones (snatch_loads.h), and its end
// misses their peak. What breaks bears nothing at the end of its step, and what it bore when it
// broke counts. All other steps are told by their end.
#pragma once

#include "measure/probe.h"
#include "step/stepper.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ripstop {

class ProbePeaks final : public SubstepWatch
{
public:
    void forget() { m_isNoted = false; } // of the last step, also when probes may be others now

    // Forgets, and readies what is read of a system that is new, so that its substeps take nothing
    // from the heap.
    void beginStep(const System& system, const State& state);

    void afterSubstep(const System& system, const State& state, double h,
                      Integrator integrator) override;

    // Of what broke in the step, while the system is still the one that it broke in.
    void noteTears(const System& system, std::span<const State::Tear> torn,
                   const JudgedPlaces& judged);

    bool isEmpty() const { return !m_isNoted; } // nothing is known but of the end of the step

    // [probes] Puts in what was higher than it is at the end of the step.
    void raise(std::span<double> values) const;

private:
    void note(const System& system, std::size_t probe, double value);

    std::optional<Readings> m_instant;
    std::uint64_t m_serial = 0; // of the system that it was readied for
    std::uint64_t m_valuesSerial = 0;
    std::vector<double> m_highest; // [probes] not a number where there is none
    bool m_isNoted = false;        // anything, in this step
};

} // namespace ripstop
