// One system for each design of the recording, with the probes in it, takes on the kept states one
// after the other and reads them. Works are unknown where the run kept no ledger of them.
#include "recording/probe_past.h"

#include "compile/compile.h"
#include "measure/energy_ledger.h"
#include "scene/property.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace ripstop {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The design with these probes alone, as far as it has what they are of: one that it lacks would
// leave the others unread, too. Plots go with the probes that they are of.
Scene withProbes(Scene scene, const std::vector<Entry>& probes)
{
    std::erase_if(scene.items, [](const Entry& entry) {
        return std::holds_alternative<Probe>(entry.item)
               || std::holds_alternative<Plot>(entry.item);
    });
    const auto isThere = [&](Id id) { return id == noId || find(scene, id); };
    for (const Entry& entry : probes) {
        const auto& probe = std::get<Probe>(entry.item);
        if (isThere(probe.target) && isThere(probe.from) && isThere(probe.side))
            scene.items.push_back(entry);
    }
    return scene;
}

bool keptLedger(const Scene& scene)
{
    return std::ranges::any_of(scene.items, [](const Entry& entry) {
        const auto* probe = std::get_if<Probe>(&entry.item);
        return probe && isOfLedger(probe->quantity);
    });
}

// Makes samples of kept states, with the probes.
class Reader
{
public:
    Reader(const Recording& recording, const std::vector<Entry>& probes)
        : m_recording(recording)
        , m_probes(probes)
    {}

    // Nothing where the design had not what the probes are of.
    std::optional<ProbeSample> sampleOf(std::size_t frame)
    {
        const int design = m_recording.designOf(frame);
        if (design != m_design) {
            m_design = design;
            m_simulation.reset();
            Scene scene = m_recording.design(design).scene();
            m_keptLedger = keptLedger(scene);
            auto made = compile(withProbes(std::move(scene), m_probes));
            m_system = made ? *made : nullptr;
        }
        auto state = m_recording.keptState(frame);
        if (!m_system || !state)
            return std::nullopt;
        if (!m_keptLedger)
            state->work = {unknown, unknown, unknown, unknown, unknown, unknown};
        if (m_simulation)
            m_simulation->place(std::move(*state));
        else
            m_simulation.emplace(m_system, std::move(*state));
        return m_simulation->sample();
    }

private:
    const Recording& m_recording;
    const std::vector<Entry>& m_probes;
    int m_design = -1;
    bool m_keptLedger = false;              // the run did, of that design
    std::shared_ptr<const System> m_system; // of that design
    std::optional<Simulation> m_simulation;
};

} // namespace

ProbePast probePast(const Recording& recording, const std::vector<Entry>& probes,
                    const Progress& progress)
{
    ProbePast past;
    past.value.resize(probes.size());
    Reader reader(recording, probes);
    const std::size_t count = recording.frameCount();
    for (std::size_t frame = 0; frame < count; ++frame) {
        if (progress && !progress(double(frame) / double(count)))
            break;
        const std::optional<ProbeSample> sample = reader.sampleOf(frame);
        past.time.push_back(recording.timeOf(frame));
        for (std::size_t i = 0; i < probes.size(); ++i) {
            double value = unknown;
            if (sample)
                for (std::size_t p = 0; p < sample->probe.size(); ++p)
                    if (sample->layout->probes[p].id == std::uint32_t(probes[i].id))
                        value = sample->probe[p];
            past.value[i].push_back(value);
        }
    }
    return past;
}

} // namespace ripstop
