#include "study/probe_names.h"

#include <algorithm>
#include <set>

namespace ripstop {

std::vector<std::string> distinctNames(const std::vector<Layout::Probe>& probes)
{
    std::set<std::string> given;
    for (const Layout::Probe& probe : probes)
        given.insert(probe.name);
    std::set<std::string> used;
    std::vector<std::string> names;
    for (const Layout::Probe& probe : probes) {
        std::string name = probe.name;
        for (int count = 2; used.contains(name) || (name != probe.name && given.contains(name));
             ++count)
            name = probe.name + " (" + std::to_string(count) + ")";
        used.insert(name);
        names.push_back(std::move(name));
    }
    return names;
}

} // namespace ripstop
