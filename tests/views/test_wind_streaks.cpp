// Streaks of the wind: they move by mean wind times time, in the wind of their place, stand with
// it, and trail in the gust of the moment.
#include "look/wind_streaks.h"
#include "registered_test.h"

#include <Eigen/Geometry>

namespace ripstop::test_wind_streaks {

namespace {

const StreakView view{Vec3(0.0, 12.0, 0.0), 20.0};

Airflow steady(const Vec3& velocity)
{
    Airflow flow;
    flow.velocity = velocity;
    return flow;
}

Vec3 head(const WindStreak& streak) { return streak.path.back(); }

// The streak of `later` that a streak has become: the one whose head is nearest to `place`.
double nearest(const std::vector<WindStreak>& later, const Vec3& place)
{
    double least = 1e300;
    for (const WindStreak& streak : later)
        least = std::min(least, (head(streak) - place).norm());
    return least;
}

} // namespace

class TestWindStreaks : public QObject
{
    Q_OBJECT

private slots:
    // Between two moments each has gone on by velocity times time, but for those that ended.
    void theyMoveByWindTimesTime()
    {
        const Vec3 velocity(6.0, 0.0, -2.0), gust(0.5, 0.3, 0.0);
        const std::array winds{steady(velocity)};
        const auto before = windStreaks(winds, gust, 7.0, view);
        const auto after = windStreaks(winds, -2.0 * gust, 7.05, view); // gusts do not shift them
        QVERIFY(before.size() > 60);
        std::size_t moved = 0;
        for (const WindStreak& streak : before)
            moved += nearest(after, head(streak) + 0.05 * velocity) < 1e-9;
        QVERIFY(10 * moved > 9 * before.size());
    }

    void theyStandWhileTimeDoes()
    {
        const std::array winds{steady(Vec3(6.0, 0.0, 0.0))};
        const auto one = windStreaks(winds, {0.0, 0.0, 1.0}, 3.0, view);
        const auto other = windStreaks(winds, {0.0, 0.0, 1.0}, 3.0, view);
        QCOMPARE(one.size(), other.size());
        for (std::size_t i = 0; i < one.size(); ++i)
            QVERIFY(one[i].path == other[i].path && one[i].opacity == other[i].opacity);
    }

    // Heads are where time has them, whatever the gust; tails trail in the wind of the moment: from
    // tail to head is its velocity times the age of what is drawn, at most a share of the life.
    void gustsTurnTheirTails()
    {
        const Vec3 velocity(6.0, 0.0, 0.0), gust(0.0, 0.0, 3.0);
        const std::array winds{steady(velocity)};
        const auto without = windStreaks(winds, Vec3::Zero(), 7.0, view);
        const auto with = windStreaks(winds, gust, 7.0, view);
        QCOMPARE(with.size(), without.size());
        for (std::size_t i = 0; i < with.size(); ++i) {
            QVERIFY(head(with[i]) == head(without[i]));
            const Vec3 way = head(with[i]) - with[i].path.front();
            QVERIFY(way.cross(velocity + gust).norm()
                    < 1e-9 * way.norm() * velocity.norm() + 1e-12);
        }
    }

    // Tail to head points where the wind blows to.
    void theyPointAlongTheWind()
    {
        const Vec3 velocity(3.0, 0.0, 4.0);
        const std::array winds{steady(velocity)};
        for (const WindStreak& streak : windStreaks(winds, Vec3::Zero(), 2.0, view)) {
            const Vec3 way = head(streak) - streak.path.front();
            QVERIFY(way.norm() < 1e-9 || way.normalized().dot(velocity.normalized()) > 1.0 - 1e-9);
        }
    }

    // In a power law those higher up are longer: u(h) = U (h / H)^a.
    void theyDriftWithTheWindOfTheirPlace()
    {
        Airflow flow = steady(Vec3(6.0, 0.0, 0.0));
        flow.kind = WindKind::PowerLaw;
        flow.exponent = 0.5;
        const std::array winds{flow};
        const auto before = windStreaks(winds, Vec3::Zero(), 7.0, view);
        const auto after = windStreaks(winds, Vec3::Zero(), 7.05, view);
        std::size_t moved = 0;
        for (const WindStreak& streak : before) {
            const double speed = 6.0 * std::sqrt(head(streak).y() / 10.0);
            moved += nearest(after, head(streak) + Vec3(0.05 * speed, 0.0, 0.0)) < 1e-6;
        }
        QVERIFY(10 * moved > 8 * before.size());
    }

    void calmAirHasNone()
    {
        QVERIFY(windStreaks({}, Vec3::Zero(), 1.0, view).empty());
        const std::array winds{steady(Vec3::Zero())};
        QVERIFY(windStreaks(winds, Vec3::Zero(), 1.0, view).empty());
    }

    void noneIsBelowTheGround()
    {
        const std::array winds{steady(Vec3(6.0, 0.0, 0.0))};
        const auto streaks = windStreaks(winds, Vec3::Zero(), 1.0, {Vec3(0.0, 1.0, 0.0), 10.0});
        QVERIFY(!streaks.empty());
        for (const WindStreak& streak : streaks)
            QVERIFY(streak.path.front().y() > 0.0);
    }
};

const RegisteredTest registered("test_wind_streaks", runPlain<TestWindStreaks>);

} // namespace ripstop::test_wind_streaks

#include "test_wind_streaks.moc"
