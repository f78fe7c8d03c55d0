// Reads all probes of a system in one go, formulas of others last.
//
// A reader keeps the formulas that it has read, so each simulation has one of its own, and it is
// used by whoever steps that simulation.
#pragma once

#include "derived/formula.h"
#include "measure/probe.h"
#include "simulation/probe_peaks.h"

#include <optional>
#include <vector>

namespace ripstop {

class ProbeReader
{
public:
    // In the units of the probes; not a number where there is nothing to read.
    std::vector<double> read(Readings& readings);

    // What was higher within the step that has led there; empty where nothing was.
    //   values  that were read last
    std::vector<double> highest(const std::vector<double>& values, const ProbePeaks& peaks);

private:
    void prepare(const std::vector<ProbeSpec>& probes);
    void followFormulas(std::vector<double>& values);

    struct Known
    {
        std::string name;
        std::string unit;
        std::string formula;

        friend bool operator==(const Known&, const Known&) = default;
    };
    std::vector<Known> m_known;                     // that the formulas were read for
    std::vector<std::optional<Formula>> m_formulas; // [probes]
};

} // namespace ripstop
