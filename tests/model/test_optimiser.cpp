// Optimisation: functions whose optima are known, through the optimiser's own interface, and a
// weight that is thrown as far as it goes, with flights, kills and shards.
//
// Branin's function is that of Dixon and Szegő (1978), with its least value 0.397887 at three
// places; Rosenbrock's (1960) is 0 at (1, 1); Schaffer's (1985) first front is sqrt f1 + sqrt f2
// = 2.
#include "io/scene_file.h"
#include "model/files.h"
#include "registered_test.h"
#include "study/optimiser.h"
#include "study/study_run.h"
#include "study/study_search.h"
#include "study/study_table.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <atomic>
#include <cmath>
#include <numbers>

namespace ripstop::test_optimiser {

namespace {

using Function = std::function<Score(double x, double y)>;

struct Problem
{
    double xLow, xHigh, yLow, yHigh;
    Function score;

    Score at(const SharePlace& share) const
    {
        return score(xOf(share), yLow + share.back() * (yHigh - yLow));
    }
    double xOf(const SharePlace& share) const { return xLow + share.front() * (xHigh - xLow); }
};

Score scoreOfValues(std::vector<double> objectives, std::vector<double> excess = {})
{
    return {std::move(objectives), std::move(excess), true};
}

Problem branin()
{
    return {-5.0, 10.0, 0.0, 15.0, [](double x, double y) {
                using std::numbers::pi;
                const double a = y - 5.1 / (4.0 * pi * pi) * x * x + 5.0 / pi * x - 6.0;
                return scoreOfValues(
                    {a * a + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * std::cos(x) + 10.0});
            }};
}

Problem rosenbrock()
{
    return {-2.0, 2.0, -1.0, 3.0, [](double x, double y) {
                return scoreOfValues({100.0 * (y - x * x) * (y - x * x) + (1.0 - x) * (1.0 - x)});
            }};
}

// The nearest place to the origin where x + y >= 1 is (0.5, 0.5).
Problem halfPlane()
{
    return {-2.0, 2.0, -2.0, 2.0,
            [](double x, double y) { return scoreOfValues({x * x + y * y}, {1.0 - x - y}); }};
}

StudyPlan planOf(StudyPlan::Method method, int population, int generations, int polish)
{
    StudyPlan plan;
    plan.kind = StudyPlan::Kind::Optimise;
    plan.method = method;
    plan.population = population;
    plan.generations = generations;
    plan.polish = polish;
    return plan;
}

struct Looked
{
    std::vector<SharePlace> places; // in their order
    std::vector<Score> scores;

    std::size_t best() const
    {
        std::size_t best = 0;
        for (std::size_t i = 1; i < scores.size(); ++i)
            if (dominates(scores[i], scores[best]))
                best = i;
        return best;
    }
};

Looked look(const StudyPlan& plan, const Problem& problem, std::size_t variables = 2)
{
    Optimiser optimiser(plan, variables);
    Looked looked;
    while (!optimiser.asked().empty()) {
        std::vector<Score> scores;
        for (const SharePlace& place : optimiser.asked()) {
            scores.push_back(problem.at(place));
            looked.places.push_back(place);
            looked.scores.push_back(scores.back());
        }
        optimiser.tell(scores);
    }
    return looked;
}

// A weight of 1 kg without air: of all throws with 10 m/s at most, that at 45 degrees lands
// furthest, at v^2 / g. Where it comes down is where the tangent of its way down meets the ground,
// which is nearest when it lands: a parabola is below its tangents.
Scene thrown()
{
    Scene scene;
    scene.settings.timeStep = 1e-3;
    scene.settings.airDensity = 0.0;
    scene.settings.integrator = Integrator::VelocityVerlet; // exact where nothing but weight pulls
    Part part;
    part.name = "weight";
    part.particles.resize(1);
    part.particles[0].id = takeId(scene);
    part.particles[0].mass = 1.0;
    part.particles[0].velocity = {5.0, 5.0, 0.0};
    const Id particle = part.particles[0].id;
    scene.items.push_back(Entry{takeId(scene), part});
    const auto probe = [&](const char* name, Quantity quantity, const char* formula = "") {
        Probe one;
        one.name = name;
        one.quantity = quantity;
        one.formula = formula;
        if (quantity != Quantity::Formula)
            one.target = particle;
        scene.items.push_back(Entry{takeId(scene), one});
    };
    probe("x", Quantity::PositionX);
    probe("y", Quantity::PositionY);
    probe("vx", Quantity::VelocityX);
    probe("vy", Quantity::VelocityY);
    probe("v", Quantity::Speed);
    probe("lands", Quantity::Formula, "x - y*vx/vy"); // along the tangent
    return scene;
}

constexpr auto throwStudy = R"({"format": "ripstop-study", "version": 1, "seconds": 2.1,
    "scene": "throw.ripstop.json",
    "variables": [{"paths": ["weight.particles.velocity.x"], "from": 1, "to": 10},
                  {"paths": ["weight.particles.velocity.y"], "from": 1, "to": 10}],
    "measures": [{"probe": "lands", "reduction": "min", "from": 1.05}],
    "objectives": [{"probe": "lands", "reduction": "min", "from": 1.05, "goal": "maximise"}],
    "constraints": [{"probe": "v", "reduction": "max", "to": 0, "atMost": 10}],
    "plan": {"kind": "optimise", "population": 12, "generations": 12%1}})";

// The throw and its study in a folder of its own.
class Throw
{
public:
    explicit Throw(const char* polish = Polish::isThere() ? R"(, "polish": 60)" : "")
    {
        m_isThere = !saveScene(thrown(), at("throw.ripstop.json"));
        QFile study(QString::fromStdString(at("a.ripstop-study.json")));
        m_isThere = m_isThere && study.open(QIODevice::WriteOnly)
                    && study.write(QString(throwStudy).arg(polish).toUtf8()) > 0;
    }

    bool isThere() const { return m_isThere; }
    Result<OpenedStudy> open() const { return openStudy(at("a.ripstop-study.json")); }

    // Flies up to so many, and says how many there were.
    std::size_t fly(int jobs, std::size_t most = 1'000'000, Shard shard = {}) const
    {
        const auto opened = open();
        std::atomic<std::size_t> flown = 0;
        const auto did = flyMissing(
            *opened, shard, jobs, [&] { return flown >= most; },
            [&](const FlightNews&) { ++flown; });
        return did ? did->tally.flown : 0;
    }

    struct Known
    {
        OpenedStudy study;
        LedgerRows rows;
        StudyFlights flights;

        std::string table() const { return studyTable(study, flights); }
    };
    Known known() const
    {
        auto opened = open();
        auto content = readLedgers(ledgerFolder(opened->file));
        Known known{std::move(*opened), std::move(content->rows), {}};
        followSearch(known.study, known.rows);
        known.flights = flightsOf(known.study, known.rows);
        return known;
    }

private:
    std::string at(const char* name) const { return m_folder.filePath(name).toStdString(); }

    QTemporaryDir m_folder;
    bool m_isThere = false;
};

} // namespace

class TestOptimiser : public QObject
{
    Q_OBJECT

private slots:
    void findsKnownOptima_data()
    {
        QTest::addColumn<int>("function");
        QTest::addColumn<int>("generations");
        QTest::addColumn<int>("polish");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("tolerance");
        // the swarm alone comes into the valley; the polish goes to its bottom
        QTest::newRow("Branin, swarm alone") << 0 << 60 << 0 << 0.397887 << 0.001;
        if (!Polish::isThere())
            return;
        QTest::newRow("Branin") << 0 << 20 << 60 << 0.397887 << 1e-6;
        QTest::newRow("Rosenbrock") << 1 << 20 << 200 << 0.0 << 1e-6;
        QTest::newRow("a constraint that holds at the optimum") << 2 << 20 << 80 << 0.5 << 1e-5;
    }

    void findsKnownOptima()
    {
        QFETCH(int, function);
        QFETCH(int, generations);
        QFETCH(int, polish);
        QFETCH(double, least);
        QFETCH(double, tolerance);
        const Problem problem = function == 0   ? branin()
                                : function == 1 ? rosenbrock()
                                                : halfPlane();
        for (const std::uint64_t seed : {1, 2, 3}) {
            StudyPlan plan = planOf(StudyPlan::Method::ParticleSwarm, 16, generations, polish);
            plan.seed = seed;
            const Looked looked = look(plan, problem);
            QVERIFY(looked.places.size() <= Optimiser::most(plan));
            const Score& best = looked.scores[looked.best()];
            QVERIFY2(best.isFeasible(), qPrintable(QString::number(best.violation())));
            QVERIFY2(std::abs(best.objective.front() - least) <= tolerance,
                     qPrintable(QString::number(best.objective.front(), 'g', 10)));
        }
    }

    // One variable: (x - 1)^2.
    void findsTheBottomOfAParabola()
    {
        if (!Polish::isThere())
            return;
        const Problem parabola{-2.0, 5.0, 0.0, 1.0, [](double x, double) {
                                   return scoreOfValues({(x - 1.0) * (x - 1.0)});
                               }};
        const Looked looked = look(planOf(StudyPlan::Method::ParticleSwarm, 6, 5, 60), parabola, 1);
        QVERIFY(std::abs(parabola.xOf(looked.places[looked.best()]) - 1.0) < 1e-4);
    }

    // Of an outcome that comes below 13.7 only, which has no slope: the largest of the values that
    // have it.
    void findsTheEdgeOfAnOutcome()
    {
        if (!Polish::isThere())
            return;
        const Problem edge{5.0, 25.0, 0.0, 1.0, [](double x, double) {
                               Score score = scoreOfValues({-x});
                               score.brokenOutcomes = x > 13.7 ? 1 : 0;
                               return score;
                           }};
        const Looked looked = look(planOf(StudyPlan::Method::ParticleSwarm, 6, 4, 40), edge, 1);
        const double best = edge.xOf(looked.places[looked.best()]);
        QVERIFY2(best > 13.69 && best <= 13.7, qPrintable(QString::number(best)));
    }

    void findsTheFrontOfSchaffer()
    {
        const Problem schaffer{-10.0, 10.0, 0.0, 1.0, [](double x, double) {
                                   return scoreOfValues({x * x, (x - 2.0) * (x - 2.0)});
                               }};
        const Looked looked = look(planOf(StudyPlan::Method::Nsga2, 24, 30, 0), schaffer, 1);
        const std::vector<std::size_t> ranks = paretoRanks(looked.scores);
        double least = 10.0, most = -10.0;
        int members = 0;
        for (std::size_t i = 0; i < ranks.size(); ++i) {
            if (ranks[i] > 0)
                continue;
            const auto& f = looked.scores[i].objective;
            // exact between 0 and 2; at the ends a place a little outside is beaten by none
            QVERIFY(std::abs(std::sqrt(f[0]) + std::sqrt(f[1]) - 2.0) < 0.02);
            least = std::min(least, schaffer.xOf(looked.places[i]));
            most = std::max(most, schaffer.xOf(looked.places[i]));
            ++members;
        }
        QVERIFY2(members >= 24, qPrintable(QString::number(members)));
        QVERIFY2(least < 0.05 && most > 1.95, qPrintable(QString("%1 %2").arg(least).arg(most)));
    }

    // Places that cannot be flown are never the best, and end nothing.
    void passesOverWhatIsNotWhole()
    {
        Problem problem = branin();
        problem.score = [whole = problem.score](double x, double y) {
            return x > 0.0 ? Score{{std::numeric_limits<double>::infinity()}, {}, false}
                           : whole(x, y);
        };
        const int polish = Polish::isThere() ? 60 : 0;
        const Looked looked =
            look(planOf(StudyPlan::Method::ParticleSwarm, 16, 20, polish), problem);
        const std::size_t best = looked.best();
        QVERIFY(looked.scores[best].isWhole);
        QVERIFY(std::abs(looked.scores[best].objective.front() - 0.397887) < 0.02);
    }

    // The order of Deb and others: less broken before better.
    void scoresAreOrdered()
    {
        const Score good = scoreOfValues({1.0, 2.0}, {-1.0});
        const Score other = scoreOfValues({2.0, 1.0}, {-1.0});
        const Score broken = scoreOfValues({0.0, 0.0}, {0.1});
        const Score worse = scoreOfValues({1.0, 2.5}, {-0.5});
        QVERIFY(!dominates(good, other) && !dominates(other, good));
        QVERIFY(dominates(good, broken) && !dominates(broken, good));
        QVERIFY(dominates(good, worse));
        QCOMPARE(paretoRanks({good, other, broken, worse}), (std::vector<std::size_t>{0, 0, 2, 1}));
        const auto crowd = crowdingDistances(
            {scoreOfValues({0.0, 4.0}), scoreOfValues({1.0, 1.0}), scoreOfValues({4.0, 0.0})},
            {0, 1, 2});
        QVERIFY(std::isinf(crowd[0]) && std::isinf(crowd[2]));
        QCOMPARE(crowd[1], 2.0);
    }

    void throwsAt45Degrees()
    {
        const Throw thrown;
        QVERIFY(thrown.isThere());
        const auto opened = thrown.open();
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        QVERIFY(thrown.fly(2) > 100);
        const auto known = thrown.known();
        QCOMPARE(countOf(missingPoints(known.study, known.flights)), std::size_t(0));
        const auto best = bestPoints(known.study, known.flights);
        QCOMPARE(best.size(), std::size_t(1));
        const std::vector<std::string> values = known.study.points.values(best.front());
        const double angle = std::atan2(std::stod(values[1]), std::stod(values[0]));
        const double degrees = angle * 180.0 / std::numbers::pi;
        const double far = known.flights[best.front()]->measured.front();
        const double tolerance = Polish::isThere() ? 0.01 : 2.0; // degrees
        QVERIFY2(std::abs(degrees - 45.0) < tolerance, qPrintable(QString::number(degrees)));
        QVERIFY2(std::abs(far - 100.0 / 9.80665) < 0.01 * tolerance,
                 qPrintable(QString::number(far, 'g', 9)));
        QCOMPARE(bestSoFar(known.study, known.flights).back(), far);
    }

    // The same table with one job, in pieces, and by shards that take turns.
    void comesToTheSameHoweverItIsFlown()
    {
        const Throw whole;
        whole.fly(2);
        const std::string table = whole.known().table();
        const Throw pieces;
        int calls = 0;
        while (pieces.fly(1 + calls % 2, 7) > 0)
            ++calls;
        QVERIFY(calls > 10);
        QCOMPARE(pieces.known().table(), table);
        const Throw shards;
        std::size_t flown = 1;
        while (flown > 0) {
            flown = 0;
            for (const std::size_t place : {0, 1, 2})
                flown += shards.fly(1, 1'000'000, {place, 3});
        }
        QCOMPARE(shards.known().table(), table);
    }

    // More generations begin with those that are flown.
    void aLongerSearchGoesOn()
    {
        StudyPlan plan = planOf(StudyPlan::Method::ParticleSwarm, 8, 5, 0);
        const Looked shorter = look(plan, branin());
        plan.generations = 9;
        const Looked longer = look(plan, branin());
        QVERIFY(std::equal(shorter.places.begin(), shorter.places.end(), longer.places.begin()));
        QCOMPARE(longer.places.size(), std::size_t(72));
    }
};

const RegisteredTest registered("test_optimiser", runPlain<TestOptimiser>);

} // namespace ripstop::test_optimiser
#include "test_optimiser.moc"
