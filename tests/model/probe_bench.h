// A scene whose probes are read after so many steps, for tests of what they measure.
#pragma once

#include "compile/compile.h"
#include "simulation/simulation.h"

#include <QtGlobal>

#include <algorithm>
#include <string>
#include <vector>

namespace ripstop {

class Bench
{
public:
    Scene scene;

    void add(Probe probe)
    {
        const Id id = takeId(scene);
        probe.name = std::to_string(unsigned(id)).insert(0, 1, 'p');
        m_names.push_back(probe.name);
        scene.items.push_back({id, probe});
    }

    // What they read after so many steps, in the order in which they were added.
    std::vector<double> read(int steps = 0) const
    {
        const auto system = compile(scene);
        if (!system)
            qFatal("%s", system.message().english().c_str());
        Simulation simulation(*system);
        for (int i = 0; i < steps; ++i)
            simulation.step();
        const auto frame = simulation.frame();
        std::vector<double> values;
        for (const std::string& name : m_names) {
            const auto at = std::ranges::find(frame->layout->probes, name, &Layout::Probe::name);
            values.push_back(frame->probe[std::size_t(at - frame->layout->probes.begin())]);
        }
        return values;
    }

private:
    std::vector<std::string> m_names;
};

} // namespace ripstop
