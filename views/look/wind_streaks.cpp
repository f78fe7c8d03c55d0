// A cell hashes its place and the number of the streak to where that passes; windStreaks() walks
// over the cells about the middle of the view and follows each streak through the air by midpoint
// steps: forwards in the mean wind to its head, and back from there in that of the moment.
#include "look/wind_streaks.h"

#include "look/steady_range.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ripstop {
namespace {

constexpr int cellsAcross = 3;        // to either side of the middle
constexpr double stepOverView = 0.22; // of a cell, before it is made round
constexpr double cellsOfLife = 1.5;   // that the wind blows through while a streak lives
constexpr double tailShare = 0.3;     // of a life, from head to tail
constexpr double slowestDrift = 0.5;  // m/s, that a life is reckoned with
constexpr double calm = 1e-3;         // m/s
constexpr int stepsToHead = 8;        // midpoint steps

// Steele, Lea and Flood 2014: the mixing of SplitMix64.
std::uint64_t mixed(std::uint64_t value)
{
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31);
}

using Cell = std::array<std::int64_t, 3>;

// Even between 0 and 1, another one for each number of each cell.
double chance(const Cell& cell, std::int64_t number)
{
    std::uint64_t hash = mixed(std::uint64_t(number));
    for (const std::int64_t place : cell)
        hash = mixed(hash ^ std::uint64_t(place));
    return double(hash >> 11) * 0x1p-53;
}

struct Air
{
    std::span<const Airflow> winds;
    Vec3 gust;

    Vec3 mean(const Vec3& place) const
    {
        Vec3 sum = Vec3::Zero();
        for (const Airflow& wind : winds)
            sum += velocityAt(wind, place);
        return sum;
    }
    Vec3 at(const Vec3& place) const { return mean(place) + gust; }
    Vec3 carried(const Vec3& place, double time) const // by the mean wind
    {
        return place + time * mean(place + 0.5 * time * mean(place));
    }
    Vec3 blown(const Vec3& place, double time) const // by the wind of the moment
    {
        return place + time * at(place + 0.5 * time * at(place));
    }
};

WindStreak streakOf(const Air& air, const Cell& cell, double step, double time)
{
    const Vec3 middle = step * Vec3(double(cell[0]), double(cell[1]) + 0.5, double(cell[2]));
    const Vec3 mean = air.mean(middle);
    const double life = cellsOfLife * step / std::max(mean.norm(), slowestDrift);
    const double lives = time / life + chance(cell, 0);
    const auto number = std::int64_t(std::floor(lives));
    const double age = (lives - double(number)) * life;

    const Vec3 aside(chance(cell, 4 * number + 1) - 0.5, chance(cell, 4 * number + 2) - 0.5,
                     chance(cell, 4 * number + 3) - 0.5);
    Vec3 place = middle + step * aside - 0.5 * life * mean;
    for (int i = 0; i < stepsToHead; ++i)
        place = air.carried(place, age / stepsToHead);

    WindStreak streak;
    streak.path.back() = place;
    const double stretch = std::min(age, tailShare * life) / (WindStreak::points - 1);
    for (std::size_t i = streak.path.size() - 1; i > 0; --i)
        streak.path[i - 1] = air.blown(streak.path[i], -stretch);
    const double share = age / life;
    streak.opacity = 4.0 * share * (1.0 - share);
    return streak;
}

} // namespace

std::vector<WindStreak> windStreaks(std::span<const Airflow> winds, const Vec3& gust, double time,
                                    const StreakView& view)
{
    if (winds.empty() && gust.norm() < calm)
        return {};
    const double step = roundedUp(stepOverView * std::max(view.size, 1e-3));
    const Air air{winds, gust};
    const Vec3 inCells = view.middle / step;
    std::vector<WindStreak> streaks;
    for (int i = -cellsAcross; i <= cellsAcross; ++i)
        for (int j = -cellsAcross; j <= cellsAcross; ++j)
            for (int k = -cellsAcross; k <= cellsAcross; ++k) {
                const Cell cell{std::llround(inCells.x()) + i, std::llround(inCells.y()) + j,
                                std::llround(inCells.z()) + k};
                if (cell[1] < 0)
                    continue;
                WindStreak streak = streakOf(air, cell, step, time);
                const Vec3& head = streak.path.back();
                // those far from the middle fade, so that none appears when the camera moves
                const double away = (head - view.middle).norm() / (step * cellsAcross);
                streak.opacity *= std::clamp(2.0 * (1.0 - away), 0.0, 1.0);
                if (streak.opacity > 0.0 && streak.path.front().y() > 0.0
                    && air.at(head).norm() > calm)
                    streaks.push_back(streak);
            }
    return streaks;
}

} // namespace ripstop
