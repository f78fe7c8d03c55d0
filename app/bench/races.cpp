#include "bench/races.h"

namespace ripstop {

std::span<const Race> races()
{
    static constexpr Race table[]{{"projection", projectionRace},
                                  {"quality", qualityRace},
                                  {"growth", growthRace},
                                  {"edits", editRace},
                                  {"export", exportRace}};
    return table;
}

bool isWanted(const BenchOptions& options, const std::string& network)
{
    return network.find(options.filter) != std::string::npos;
}

} // namespace ripstop
