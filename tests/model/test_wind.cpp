// Wind over height, jets and gusts (validation 3.7, T-W1 to T-W3).
//
// Stages: functions that give the same bits everywhere; profiles, jets and discrete gusts in closed
// form; then gusts: numbers of the Dryden model, statistics, independence of components, seeds,
// edits; and what panels and lines meet where several winds add up.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/carry_over.h"
#include "base/portable_math.h"
#include "builders/network.h"
#include "check/check.h"
#include "compile/compile.h"
#include "forces/discrete_gust.h"
#include "forces/gusts.h"
#include "forces/wind.h"
#include "measure/diagnostics.h"

#include <QtTest>

#include <complex>
#include <numbers>

namespace ripstop::test_wind {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double knot = 1852.0 / 3600.0; // m/s

Airflow profile(WindKind kind, double height, double number)
{
    Airflow flow;
    flow.kind = kind;
    flow.velocity = {1.0, 0.0, 0.0};
    flow.referenceHeight = height;
    (kind == WindKind::PowerLaw ? flow.exponent : flow.roughness) = number;
    return flow;
}

// Gusts of unit strength whose lengths are 1 m, carried past at 1 m/s.
GustSpec unitGusts(int seed)
{
    GustSpec gusts;
    gusts.sigmaAlong = gusts.sigmaUp = 1.0;
    gusts.seed = seed;
    return gusts;
}

// One component (0 along, 1 up, 2 across) at steps of `distance` lengths.
std::vector<double> series(int component, double distance, std::size_t count, int seed)
{
    const GustSpec gusts = unitGusts(seed);
    GustState state = firstGust(gusts);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(velocityOf(gusts, state)[component]);
        advanceGust(gusts, distance, std::int64_t(i), state);
    }
    return values;
}

double lagged(const std::vector<double>& values, std::size_t lag)
{
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < values.size(); ++i)
        sum += values[i] * values[i + lag];
    return sum / double(values.size() - lag);
}

double autocorrelation(int component, double x)
{
    return std::exp(-x) * (component == 0 ? 1.0 : 1.0 - 0.5 * x);
}

// Radix two, in place.
void transform(std::vector<std::complex<double>>& a)
{
    const std::size_t n = a.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1;
        for (; j & bit; bit >>= 1)
            j ^= bit;
        j ^= bit;
        if (i < j)
            std::swap(a[i], a[j]);
    }
    for (std::size_t size = 2; size <= n; size *= 2) {
        std::vector<std::complex<double>> turn(size / 2);
        for (std::size_t k = 0; k < size / 2; ++k)
            turn[k] = std::polar(1.0, -2.0 * pi * double(k) / double(size));
        for (std::size_t i = 0; i < n; i += size)
            for (std::size_t k = 0; k < size / 2; ++k) {
                const auto even = a[i + k];
                const auto odd = a[i + k + size / 2] * turn[k];
                a[i + k] = even + odd;
                a[i + k + size / 2] = even - odd;
            }
    }
}

// Spectrum of the sampled process, sum over m of R(m d) cos(m w): with A = (1 - r^2) / (1 - 2 r cos
// w
// + r^2) the sum of r^|m| cos(m w), it is A along the wind and A - d/2 r dA/dr across it.
double sampledSpectrum(int component, double d, double w)
{
    const double r = std::exp(-d);
    const double below = 1.0 - 2.0 * r * std::cos(w) + r * r;
    const double a = (1.0 - r * r) / below;
    if (component == 0)
        return a;
    const double slope =
        (-2.0 * r * below - (1.0 - r * r) * (2.0 * r - 2.0 * std::cos(w))) / (below * below);
    return a - 0.5 * d * r * slope;
}

System gustySystem(int seed)
{
    System system = emptySystem(1.0 / 240.0);
    system.gusts.push_back(drydenGusts(7, {8.0, 0.0, 0.0}, 10.0, 15.4, seed));
    for (const Vec3& x : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)})
        addParticle(system, x, 0.1);
    addPanel(system, 0, 1, 2, AirLaw::LinearNormal, 2.0);
    finish(system);
    return system;
}

} // namespace

class TestWind : public QObject
{
    Q_OBJECT

private slots:
    void portableFunctions()
    {
        Dice dice(3);
        for (int i = 0; i < 10000; ++i) {
            const double x = std::exp(dice(-600.0, 600.0));
            const double tolerance = 1e-15 * std::max(1.0, std::abs(std::log(x)));
            QVERIFY2(isNear(portableLog(x), std::log(x), tolerance),
                     told(portableLog(x), std::log(x)));
            const double y = dice(-600.0, 600.0);
            QVERIFY2(std::abs(portableExp(y) / std::exp(y) - 1.0) < 1e-15,
                     told(portableExp(y), std::exp(y)));
        }
        QCOMPARE(portableLog(1.0), 0.0);
        QCOMPARE(portableExp(0.0), 1.0);
        QCOMPARE(portableExp(-1000.0), 0.0);
        for (int i = 0; i <= 10000; ++i) {
            const double x = 0.5 * pi * i / 10000.0;
            QVERIFY2(isNear(portableSine(x), std::sin(x), 3e-16),
                     told(portableSine(x), std::sin(x)));
        }
    }

    void profiles_data()
    {
        QTest::addColumn<double>("height"); // m
        QTest::addColumn<double>("byLog");
        QTest::addColumn<double>("byPower");
        QTest::newRow("3.7 at 2 m") << 2.0 << 0.7229 << 0.7946;
        QTest::newRow("3.7 at 10 m") << 10.0 << 1.0 << 1.0;
        QTest::newRow("3.7 at 20 m") << 20.0 << 1.1193 << 1.1041;
        QTest::newRow("3.7 at 50 m") << 50.0 << 1.2771 << 1.2585;
        QTest::newRow("3.7 at 100 m") << 100.0 << 1.3964 << 1.3895;
    }

    // z0 0.03 m, a 1/7, reference 10 m.
    void profiles()
    {
        QFETCH(double, height);
        QFETCH(double, byLog);
        QFETCH(double, byPower);
        const Vec3 place(3.0, height, -2.0);
        const double log = velocityAt(profile(WindKind::LogLaw, 10.0, 0.03), place).x();
        const double power = velocityAt(profile(WindKind::PowerLaw, 10.0, 1.0 / 7.0), place).x();
        QVERIFY2(isNear(log, byLog, 0.5e-4), told(log, byLog));
        QVERIFY2(isNear(power, byPower, 0.5e-4), told(power, byPower));
    }

    // KiteModels' profile is 2 log - power with z0 0.0002 m, a 0.08163, reference 6 m.
    void kiteModelsProfile()
    {
        for (const auto& [height, expected] :
             {std::pair(10.0, 1.05652), std::pair(50.0, 1.22239), std::pair(100.0, 1.28765),
              std::pair(150.0, 1.32397)}) {
            const Vec3 place(0.0, height, 0.0);
            const double got = 2.0 * velocityAt(profile(WindKind::LogLaw, 6.0, 0.0002), place).x()
                               - velocityAt(profile(WindKind::PowerLaw, 6.0, 0.08163), place).x();
            QVERIFY2(isNear(got, expected, 1e-5), told(got, expected));
        }
    }

    void calmOnTheGround()
    {
        for (const double height : {0.0, -1.0, 0.02})
            QCOMPARE(velocityAt(profile(WindKind::LogLaw, 10.0, 0.03), {0.0, height, 0.0}),
                     Vec3(Vec3::Zero()));
        QCOMPARE(velocityAt(profile(WindKind::PowerLaw, 10.0, 0.2), {0.0, -1.0, 0.0}),
                 Vec3(Vec3::Zero()));
    }

    // The flux of momentum is the same through every section; nothing beside the jet or behind it.
    void jet()
    {
        Airflow jet;
        jet.kind = WindKind::Jet;
        jet.velocity = {0.0, 0.0, 12.0};
        jet.origin = {1.0, 2.0, 3.0};
        jet.radius = 0.4;
        jet.widening = std::tan(12.0 * pi / 180.0);
        QVERIFY(isNear(velocityAt(jet, jet.origin), jet.velocity, 1e-12));
        QCOMPARE(velocityAt(jet, {1.0, 2.0, 2.9}), Vec3(Vec3::Zero()));
        QCOMPARE(velocityAt(jet, {1.5, 2.0, 3.0}), Vec3(Vec3::Zero()));
        const auto flux = [&](double along) {
            double sum = 0.0;
            const double dr = 1e-3;
            for (double r = 0.5 * dr; r < 4.0; r += dr) {
                const double u = velocityAt(jet, jet.origin + Vec3(r, 0.0, along)).z();
                sum += u * u * 2.0 * pi * r * dr;
            }
            return sum;
        };
        const double first = pi * 0.4 * 0.4 * 144.0 / 5.0; // of (1 - d^2 / r^2)^4 over the section
        for (const double along : {0.0, 0.5, 2.0, 8.0})
            QVERIFY2(std::abs(flux(along) / first - 1.0) < 1e-3, told(flux(along), first));
    }

    void discreteGust_data()
    {
        QTest::addColumn<double>("time"); // s
        QTest::addColumn<double>("share");
        QTest::newRow("before") << 1.999 << 0.0;
        QTest::newRow("a sixth") << 2.5 << 0.25; // (1 - cos 60) / 2
        QTest::newRow("a quarter") << 2.75 << 0.5;
        QTest::newRow("peak") << 3.5 << 1.0;
        QTest::newRow("five sixths") << 4.5 << 0.25;
        QTest::newRow("over") << 5.1 << 0.0;
        QTest::newRow("second peak") << 7.5 << 1.25;
        QTest::newRow("tenth, half") << 2.0 + 9 * 4.0 + 0.75 << 0.5 * (1.0 + 9 * 0.25);
        QTest::newRow("long before") << -1e300 << 0.0;
    }

    void discreteGust()
    {
        QFETCH(double, time);
        QFETCH(double, share);
        const DiscreteGust train{{8.0, 2.0, 0.0}, 2.0, 3.0, 4.0, 0.25};
        const Vec3 got = velocityOf(train, time);
        QVERIFY2(isNear(got, share * train.velocity, 1e-12), told(got, share * train.velocity));
        DiscreteGust once = train;
        once.interval = 0.0;
        if (time < 6.0)
            QCOMPARE(velocityOf(once, time), got);
        else
            QCOMPARE(velocityOf(once, time), Vec3(Vec3::Zero()));
    }

    void drydenNumbers_data()
    {
        QTest::addColumn<double>("height"); // m
        QTest::addColumn<double>("length"); // m
        QTest::addColumn<double>("sigma");  // m/s
        QTest::newRow("3.7 at 10 m") << 10.0 << 67.37 << 2.915;
        QTest::newRow("3.7 at 50 m") << 50.0 << 202.29 << 2.459;
        QTest::newRow("3.7 at 100 m") << 100.0 << 262.79 << 2.130;
    }

    // Moderate turbulence, 30 kt at 20 ft. At 100 ft: 505.169 ft and a ratio of 1.715849.
    void drydenNumbers()
    {
        QFETCH(double, height);
        QFETCH(double, length);
        QFETCH(double, sigma);
        const GustSpec gusts = drydenGusts(1, {8.0, 0.0, 0.0}, height, 30.0 * knot, 1);
        QVERIFY2(isNear(gusts.lengthAlong, length, 0.005), told(gusts.lengthAlong, length));
        QVERIFY2(isNear(gusts.sigmaAlong, sigma, 0.0005), told(gusts.sigmaAlong, sigma));
        QVERIFY2(isNear(gusts.sigmaUp, 1.543, 0.0005), told(gusts.sigmaUp, 1.543));
        QVERIFY2(isNear(gusts.lengthUp, height, 1e-9), told(gusts.lengthUp, height));
        const GustSpec feet = drydenGusts(1, Vec3::Zero(), 100.0 * 0.3048, 10.0, 1);
        QVERIFY(isNear(feet.lengthAlong / 0.3048, 505.169, 0.0005));
        QVERIFY(isNear(feet.sigmaAlong / feet.sigmaUp, 1.715849, 1e-6));
        QCOMPARE(drydenGusts(1, Vec3::Zero(), 0.0, 10.0, 1).lengthUp, 10.0 * 0.3048);
        QCOMPARE(feet.speed, 1.0);
    }

    void statistics_data()
    {
        QTest::addColumn<int>("component");
        QTest::addColumn<double>("distance"); // lengths per sample
        for (const double distance : {0.02, 0.2, 1.0}) {
            QTest::addRow("T-W1 along, %g lengths", distance) << 0 << distance;
            QTest::addRow("T-W1 up, %g lengths", distance) << 1 << distance;
            QTest::addRow("T-W1 across, %g lengths", distance) << 2 << distance;
        }
    }

    // T-W1: variance within 5 % over 2^20 samples, spectrum in octaves within 4 sigma. T-W3: both
    // hold at every step, as does the autocorrelation after one length.
    void statistics()
    {
        QFETCH(int, component);
        QFETCH(double, distance);
        const std::size_t count = std::size_t(1) << 20;
        const std::vector<double> values = series(component, distance, count, 5);
        const double variance = lagged(values, 0);
        QVERIFY2(isNear(variance, 1.0, 0.05), told(variance, 1.0));
        const auto lag = std::size_t(1.0 / distance + 0.5);
        const double correlation = lagged(values, lag);
        // 4 sigma, with about two lengths for each independent sample
        const double tolerance = 4.0 * std::sqrt(4.0 / (double(count) * std::min(1.0, distance)));
        QVERIFY2(isNear(correlation, autocorrelation(component, 1.0), tolerance),
                 told(correlation, autocorrelation(component, 1.0)));

        std::vector<std::complex<double>> spectrum(values.begin(), values.end());
        transform(spectrum);
        for (std::size_t band = 16; band < count / 2; band *= 2) {
            double got = 0.0;
            double expected = 0.0;
            double squares = 0.0;
            for (std::size_t k = band; k < 2 * band; ++k) {
                const double s =
                    sampledSpectrum(component, distance, 2.0 * pi * double(k) / double(count));
                got += std::norm(spectrum[k]) / double(count);
                expected += s;
                squares += s * s;
            }
            QVERIFY2(isNear(got, expected, 4.0 * std::sqrt(squares)), told(got, expected));
        }
    }

    // The three components know nothing of each other.
    void independence()
    {
        const std::vector<double> u = series(0, 1.0, 200000, 9);
        const std::vector<double> v = series(2, 1.0, 200000, 9);
        const std::vector<double> w = series(1, 1.0, 200000, 9);
        for (const auto& [a, b] : {std::pair(&u, &v), std::pair(&v, &w), std::pair(&w, &u)}) {
            double sum = 0.0;
            for (std::size_t i = 0; i < a->size(); ++i)
                sum += (*a)[i] * (*b)[i];
            const double got = sum / double(a->size());
            QVERIFY2(std::abs(got) < 4.0 * std::sqrt(2.0 / 200000.0), told(got, 0.0));
        }
    }

    // T-W2: the same seed is the same wind, bit for bit; another seed is another.
    void seeds()
    {
        const System one = gustySystem(1);
        const System other = gustySystem(2);
        const State first = run(one, 500);
        QVERIFY(first == run(one, 500, 2));
        QCOMPARE(stateHash(first), stateHash(run(gustySystem(1), 500)));
        QVERIFY(!(first.gusts == run(other, 500).gusts));
        const State half = run(one, 250); // a checkpoint goes on with the same wind
        QVERIFY(run(one, half, 250) == first);
        QVERIFY(commonWind(one, first).norm() > 0.0);
    }

    // Gusts are matched by key when a system is edited.
    void gustsCarryOver()
    {
        const System one = gustySystem(1);
        System edited = gustySystem(1);
        edited.gusts.insert(edited.gusts.begin(), drydenGusts(3, Vec3::UnitX(), 20.0, 9.0, 4));
        finish(edited);
        const State state = run(one, 100);
        const State carried = carryOver(one, state, edited, {});
        QCOMPARE(carried.gusts.size(), std::size_t(2));
        QVERIFY(carried.gusts[1] == state.gusts[0]);
        QVERIFY(carried.gusts[0] == edited.start.gusts[0]);
    }

    // Panels and lines meet the wind of their height: loads grow as (h / H)^(2 a).
    void windOfThePlace()
    {
        System system = emptySystem(0.01);
        system.airflows.push_back(profile(WindKind::PowerLaw, 10.0, 0.2));
        system.airflows.back().velocity = {7.0, 0.0, 0.0};
        for (const double height : {10.0, 40.0}) {
            const int a = addParticle(system, {0.0, height - 1.0, 0.0}, 0.1);
            const int b = addParticle(system, {0.0, height + 2.0, 0.0}, 0.1);
            const int c = addParticle(system, {0.0, height - 1.0, 1.0}, 0.1);
            const int d = addParticle(system, {0.0, height - 2.0, 3.0}, 0.1);
            addPanel(system, a, b, c, AirLaw::Paper, 1.0);
            system.links.push_back({Key(a), LinkKind::Rod, int(system.rods.size()), b, d});
            addRod(system, b, d, distance(system, b, d));
            system.of<LineLists>().list.push_back({int(system.links.size()) - 1, b, d, 0.01});
        }
        finish(system);
        const std::vector<Vec3> loads = panelLoads(system, system.start);
        const double expected = 0.5 * 1.225 * 1.5 * 49.0;
        QVERIFY2(isNear(loads[0], Vec3(expected, 0.0, 0.0), 1e-9), told(loads[0].x(), expected));
        const double ratio = std::pow(4.0, 0.4);
        QVERIFY2(isNear(loads[1].x() / loads[0].x(), ratio, 1e-9), told(loads[1].x(), expected));
        const std::vector<Vec3> drags = lineDrags(system, system.start);
        QVERIFY2(isNear(drags[0], Vec3(0.5 * 1.225 * 0.01 * 5.0 * 49.0, 0.0, 0.0), 1e-9),
                 told(drags[0].x(), 0.0));
        QVERIFY(isNear(drags[1].x() / drags[0].x(), ratio, 1e-9));
    }

    // All winds of a scene add up; gusts are carried by the mean of the others at their height.
    void windsAddUp()
    {
        Scene scene;
        addWind(scene, {1.0, 0.0, 0.0});
        addWind(scene, {0.0, 0.5, 0.0});
        Wind shear{"shear", {0.0, 0.0, 6.0}};
        shear.kind = WindKind::PowerLaw;
        addItem(scene, shear);
        Wind gusts{"gusts"};
        gusts.kind = WindKind::Gusts;
        addItem(scene, gusts);
        Wind fan{"fan", {3.0, 0.0, 0.0}};
        fan.kind = WindKind::Jet;
        fan.position = {-1.0, 10.0, 5.0};
        addItem(scene, fan);
        Wind single{"gust", {0.0, 0.0, 2.0}, WindKind::DiscreteGust};
        single.onset = 0.0;
        addItem(scene, single);
        const auto system = compile(scene);
        QVERIFY(bool(system));
        QCOMPARE((*system)->wind, Vec3(1.0, 0.5, 0.0));
        QCOMPARE((*system)->airflows.size(), std::size_t(2));
        QVERIFY(isNear((*system)->gusts[0].speed, std::sqrt(1.0 + 36.0), 1e-12));
        QVERIFY(isNear((*system)->gusts[0].along, Vec3(1.0, 0.0, 6.0).normalized(), 1e-12));
        const State& start = (*system)->start;
        const Vec3 gust = velocityOf((*system)->gusts[0], start.gusts[0]);
        const Vec3 got = windAt(**system, start, {-1.0, 10.0, 5.0});
        QVERIFY2(isNear(got, gust + Vec3(4.0, 0.5, 6.0), 1e-12),
                 told(got, gust + Vec3(4.0, 0.5, 6.0)));
        State later = start;
        later.time = 0.5 * single.duration;
        QVERIFY(isNear(windAt(**system, later, {-1.0, 10.0, 5.0}), got + single.velocity, 1e-12));
    }

    void roughnessNeedsHeight()
    {
        Scene scene;
        Wind wind{"valley", {3.0, 0.0, 0.0}};
        wind.kind = WindKind::LogLaw;
        wind.roughness = 10.0;
        addItem(scene, wind);
        const auto system = compile(scene);
        QVERIFY(!system);
        QVERIFY(QString::fromStdString(system.message().english()).contains("roughness"));
    }
};

const RegisteredTest registered("test_wind", runPlain<TestWind>);

} // namespace ripstop::test_wind
#include "test_wind.moc"
