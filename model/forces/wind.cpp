#include "forces/wind.h"

#include "forces/discrete_gust.h"
#include "forces/gusts.h"

namespace ripstop {

Vec3 commonWind(const System& system, const State& state)
{
    Vec3 wind = system.wind;
    for (std::size_t i = 0; i < system.gusts.size(); ++i)
        wind += velocityOf(system.gusts[i], state.gusts[i]);
    for (const DiscreteGust& gust : system.discreteGusts)
        wind += velocityOf(gust, state.time);
    for (const WindRecord& record : system.windRecords)
        wind += velocityOf(record, state.time);
    return wind;
}

Vec3 localWind(const System& system, const Vec3& place)
{
    Vec3 wind = Vec3::Zero();
    for (const Airflow& flow : system.airflows)
        wind += velocityAt(flow, place);
    return wind;
}

bool hasLocalWind(const System& system, const State& state)
{
    return !system.airflows.empty() || state.hands.fan;
}

Vec3 localWind(const System& system, const State& state, const Vec3& place)
{
    const Vec3 wind = localWind(system, place);
    return state.hands.fan ? Vec3(wind + velocityAt(*state.hands.fan, place)) : wind;
}

Vec3 windAt(const System& system, const State& state, const Vec3& place)
{
    return commonWind(system, state) + localWind(system, state, place);
}

} // namespace ripstop
