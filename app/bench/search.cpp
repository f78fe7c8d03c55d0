// The table says for each solver what its effort is. at() tries one effort, unless what the last
// trial took says that it would exceed the budget. leastEffort() first goes up or down by factors
// of 1.5 until one effort is enough and a smaller one is not, then halves the interval; it relies
// on more effort never being worse.
#include "bench/search.h"

#include "terminal/terminal.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

std::string sweeps(int effort) { return std::to_string(effort) + " sweeps"; }
std::string substeps(int effort) { return std::to_string(effort) + " substeps"; }

} // namespace

const std::vector<Choice>& allChoices()
{
    static const std::vector<Choice> choices{
        {"averaged_jacobi",
         [](int effort) {
             return Setup{Solver::AveragedJacobi, 1, effort, 1};
         },
         sweeps, false, 2e6},
        {"gauss_seidel",
         [](int effort) {
             return Setup{Solver::GaussSeidel, 1, effort, 1};
         },
         sweeps, false, 2e6},
        {"small_steps",
         [](int effort) {
             return Setup{Solver::SmallSteps, effort, 1, 1};
         },
         substeps, false, 2e6},
        {"direct",
         [](int effort) {
             return Setup{Solver::Direct, effort, 1, 1};
         },
         substeps, true, 5e3},
        {"auto",
         [](int effort) {
             return Setup{Solver::Auto, 1, 1, 1, 0.01 / effort};
         },
         [](int effort) { return shortNumber(1.0 / effort) + " % wanted"; }, true, 2e6}};
    return choices;
}

Search::Search(const BenchNetwork& network, const Choice& choice, const Path& reference)
    : m_network(network)
    , m_choice(choice)
    , m_reference(reference)
{}

const Quality* Search::at(int effort, double budget)
{
    if (const auto found = m_tried.find(effort); found != m_tried.end())
        return &found->second;
    if (!m_tried.empty()) {
        const auto& [known, quality] = *m_tried.rbegin();
        const double perEffort = quality.seconds / known;
        if (perEffort * effort * qualityFrames(m_network) > budget)
            return nullptr;
    }
    const std::optional<Quality> quality = qualityOf(m_network, m_choice.at(effort), m_reference);
    return quality ? &(m_tried[effort] = *quality) : nullptr;
}

std::optional<int> Search::leastEffort(double limit, Gate gate, int guess, double budget)
{
    const auto isEnough = [&](const Quality& quality) {
        return quality.strain < limit
               && (gate == Gate::Strain || quality.centerError < pathTolerance);
    };
    const auto start = std::chrono::steady_clock::now();
    const auto left = [&] {
        return budget
               - std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    constexpr int most = 1'000'000;
    int enough = most;
    int less = 0;
    for (int effort = guess; enough == most || less == 0;) {
        const Quality* quality = effort < most ? at(effort, left()) : nullptr;
        if (!quality)
            break;
        if (isEnough(*quality))
            enough = effort;
        else
            less = effort;
        if (enough == 1)
            return 1;
        effort = enough == most ? int(std::ceil(1.5 * effort)) : std::max(1, int(effort / 1.5));
    }
    if (enough == most)
        return std::nullopt;
    while (enough - less > std::max(1, int(0.03 * enough))) {
        const int middle = (enough + less) / 2;
        const Quality* quality = at(middle, left());
        if (!quality)
            break;
        (isEnough(*quality) ? enough : less) = middle;
    }
    return enough;
}

double Search::best() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [effort, quality] : m_tried)
        least = std::min(least, quality.strain);
    return least;
}

} // namespace ripstop
