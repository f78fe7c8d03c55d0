#include "simulation/probe_reader.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

// Probes change with the system, and it by patches too; they are few.
void ProbeReader::prepare(const std::vector<ProbeSpec>& probes)
{
    const auto isKnown = [](const ProbeSpec& probe, const Known& known) {
        return probe.name == known.name && probe.unit == known.unit
               && probe.formula == known.formula;
    };
    if (std::ranges::equal(probes, m_known, isKnown))
        return;
    m_known.clear();
    m_formulas.clear();
    std::vector<Formula::Name> names;
    for (const ProbeSpec& probe : probes) {
        m_known.push_back({probe.name, probe.unit, probe.formula});
        names.push_back({probe.name, probe.unit});
    }
    for (const ProbeSpec& probe : probes) {
        m_formulas.emplace_back();
        if (probe.formula.empty())
            continue;
        if (Result<Formula> formula = Formula::read(probe.formula, names))
            m_formulas.back() = std::move(*formula);
    }
}

std::vector<double> ProbeReader::read(Readings& readings)
{
    const std::vector<ProbeSpec>& probes = readings.system().probes;
    prepare(probes);
    std::vector<double> values;
    values.reserve(probes.size());
    for (const ProbeSpec& probe : probes)
        values.push_back(readings.value(probe));
    followFormulas(values);
    return values;
}

std::vector<double> ProbeReader::highest(const std::vector<double>& values, const ProbePeaks& peaks)
{
    if (peaks.isEmpty())
        return {};
    std::vector<double> highest = values;
    peaks.raise(highest);
    followFormulas(highest);
    for (std::size_t i = 0; i < values.size(); ++i) // a formula may fall with what it is made of
        highest[i] = std::fmax(highest[i], values[i]);
    return highest;
}

void ProbeReader::followFormulas(std::vector<double>& values)
{
    for (std::size_t i = 0; i < m_formulas.size(); ++i)
        if (m_formulas[i])
            values[i] = m_formulas[i]->value(values);
}

} // namespace ripstop
