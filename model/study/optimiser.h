// Looks for the best place in the cube of all shares, in batches: whoever uses it evaluates the
// places that are asked for, in any order and with as many hands as there are, and tells all of
// their scores; then the next are asked for. A global stage looks everywhere, first by a particle
// swarm or, for several objectives, by NSGA-II; then the best place is polished.
//
// What it asks for is a function of its settings and of what it was told, so that an optimisation
// that was ended is taken up by telling it again what is known.
//
// The global stage is written here and not taken from pagmo: that asks from inside a loop of its
// own, for one generation at a time, and draws from the distributions of the standard library,
// whose numbers are not the same everywhere, so that two machines would not share one search.
#pragma once

#include "study/nsga2.h"
#include "study/polish.h"
#include "study/study.h"

#include <optional>
#include <variant>

namespace ripstop {

class Optimiser
{
public:
    Optimiser(const StudyPlan& plan, std::size_t variables);

    const std::vector<SharePlace>& asked() const { return m_asked; } // empty when it is over
    void tell(const std::vector<Score>& scores);                     // of asked()

    // How many places it asks for at most.
    static std::size_t most(const StudyPlan& plan);

private:
    void beginPolish();

    std::variant<ParticleSwarm, Nsga2> m_global;
    std::size_t m_generationsLeft;
    std::size_t m_polishCount;
    std::optional<Polish> m_polish;
    std::vector<SharePlace> m_asked;
    SharePlace m_best; // of the global stage, with one objective
    std::optional<Score> m_bestScore;
    double m_worst = -std::numeric_limits<double>::infinity(); // value of what was whole
};

} // namespace ripstop
