// The least effort with which a solver keeps the strain of a network below a limit. The race for
// quality compares solvers by it, because a comparison at equal effort would compare numbers of
// sweeps with numbers of substeps, which cost differently. Each effort is tried once and kept for
// all limits.
#pragma once

#include "bench/quality.h"

#include <map>
#include <optional>

namespace ripstop {

// A solver and what its effort is: sweeps, substeps, or of the automatic one the n of 1 % / n, the
// strain that it is told to keep.
struct Choice
{
    const char* name;
    Setup (*at)(int effort);
    std::string (*text)(int effort); // with its unit
    bool ownSystem;                  // needs a system that was finished for it
    double mostParticles;            // more would take too long or too much memory
};

const std::vector<Choice>& allChoices();

enum class Gate { Strain, StrainAndPath };

inline constexpr double pathTolerance = 0.05; // m, RMS over the first second

class Search
{
public:
    Search(const BenchNetwork& network, const Choice& choice, const Path& reference);

    // Tries efforts within `budget`, s of wall time, from `guess` on: up or down by factors of 1.5,
    // then by halving until two efforts within 3 % are told apart. Nothing when none was enough.
    std::optional<int> leastEffort(double limit, Gate gate, int guess, double budget);

    // Tries one effort unless that would take longer than `budget`, s.
    const Quality* at(int effort, double budget);

    const std::map<int, Quality>& tried() const { return m_tried; }
    double best() const; // the smallest strain of all that was tried

private:
    const BenchNetwork& m_network;
    const Choice& m_choice;
    const Path& m_reference;
    std::map<int, Quality> m_tried;
};

} // namespace ripstop
