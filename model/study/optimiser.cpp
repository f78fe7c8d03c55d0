// tell() is the one step: it goes on with the global stage, begins the polish, or goes on with
// that.
#include "study/optimiser.h"

#include <algorithm>

namespace ripstop {
namespace {

std::variant<ParticleSwarm, Nsga2> globalStage(const StudyPlan& plan, std::size_t variables)
{
    const auto count = std::size_t(plan.population);
    if (plan.method == StudyPlan::Method::Nsga2)
        return Nsga2(variables, count, plan.seed);
    return ParticleSwarm(variables, count, plan.seed);
}

} // namespace

Optimiser::Optimiser(const StudyPlan& plan, std::size_t variables)
    : m_global(globalStage(plan, variables))
    , m_generationsLeft(std::size_t(plan.generations))
    , m_polishCount(std::size_t(plan.polish))
{
    if (variables > 0)
        m_asked = std::visit([](const auto& stage) { return stage.places(); }, m_global);
}

std::size_t Optimiser::most(const StudyPlan& plan)
{
    return std::size_t(plan.population * plan.generations + plan.polish);
}

void Optimiser::beginPolish()
{
    if (m_bestScore && m_bestScore->isWhole && m_bestScore->objective.size() == 1)
        m_polish.emplace(m_best, m_bestScore->excess.size(), m_polishCount, m_worst);
}

void Optimiser::tell(const std::vector<Score>& scores)
{
    if (m_polish) {
        m_polish->tell(scores.front());
    } else {
        for (std::size_t i = 0; i < scores.size(); ++i) {
            if (!m_bestScore || dominates(scores[i], *m_bestScore)) {
                m_best = m_asked[i];
                m_bestScore = scores[i];
            }
            if (scores[i].isWhole)
                m_worst = std::max(m_worst, scores[i].objective.front());
        }
        if (--m_generationsLeft > 0) {
            std::visit([&](auto& stage) { stage.move(scores); }, m_global);
            m_asked = std::visit([](const auto& stage) { return stage.places(); }, m_global);
            return;
        }
        beginPolish();
    }
    m_asked.clear();
    if (m_polish)
        if (auto next = m_polish->next())
            m_asked.push_back(std::move(*next));
}

} // namespace ripstop
