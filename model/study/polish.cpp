// next() makes an optimiser of NLopt, whose questions Replay answers from what is known.
#include "study/polish.h"

#ifdef RIPSTOP_HAS_NLOPT
#include <nlopt.h>
#endif

#include <memory>

namespace ripstop {

#ifdef RIPSTOP_HAS_NLOPT
namespace {

constexpr double firstStep = 0.1; // of the range of a variable
constexpr double lastStep = 1e-7; // it is over when steps are as small as this

// What NLopt asks while it runs again through what is known.
struct Replay
{
    nlopt_opt optimiser;
    const std::vector<Score>& known;
    double worst;
    std::size_t asked = 0;
    SharePlace unknown; // the first place whose value is not known
};

double valueAt(unsigned count, const double* x, double*, void* data)
{
    auto& replay = *static_cast<Replay*>(data);
    if (replay.asked < replay.known.size()) {
        const Score& score = replay.known[replay.asked++];
        return score.isWhole && score.brokenOutcomes == 0 ? score.objective.front() : replay.worst;
    }
    if (replay.unknown.empty())
        replay.unknown.assign(x, x + count);
    nlopt_force_stop(replay.optimiser);
    return replay.worst;
}

// COBYLA asks for the constraints of a place after its value.
void excessAt(unsigned constraints, double* excess, unsigned, const double*, double*, void* data)
{
    const auto& replay = *static_cast<Replay*>(data);
    const Score* score = replay.asked > 0 ? &replay.known[replay.asked - 1] : nullptr;
    for (unsigned i = 0; i < constraints; ++i)
        excess[i] = score ? (score->isWhole ? score->excess[i] : 1.0) : 0.0;
}

} // namespace

bool Polish::isThere() { return true; }

std::optional<SharePlace> Polish::next() const
{
    if (m_known.size() >= m_count)
        return std::nullopt;
    const bool isFree = m_constraints == 0 && m_start.size() > 1;
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(isFree ? NLOPT_LN_BOBYQA : NLOPT_LN_COBYLA, unsigned(m_start.size())),
        nlopt_destroy);
    Replay replay{optimiser.get(), m_known, m_worst, 0, {}};
    nlopt_set_min_objective(optimiser.get(), valueAt, &replay);
    nlopt_set_lower_bounds1(optimiser.get(), 0.0);
    nlopt_set_upper_bounds1(optimiser.get(), 1.0);
    nlopt_set_initial_step1(optimiser.get(), firstStep);
    nlopt_set_xtol_abs1(optimiser.get(), lastStep);
    if (m_constraints > 0)
        nlopt_add_inequality_mconstraint(optimiser.get(), unsigned(m_constraints), excessAt,
                                         &replay, nullptr);
    SharePlace place = m_start; // BOBYQA begins beside it where it is too near to a bound
    double value = 0.0;
    nlopt_optimize(optimiser.get(), place.data(), &value); // however it ends, the replay knows
    if (replay.unknown.empty())
        return std::nullopt;
    return std::move(replay.unknown);
}

#else

bool Polish::isThere() { return false; }

std::optional<SharePlace> Polish::next() const { return std::nullopt; }

#endif

} // namespace ripstop
