// A run knows how true it is: it says so where what was typed is not what was flown.
#include "builders/builder.h"
#include "compile/compile.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "model/first_item.h"
#include "registered_test.h"
#include "simulation/damping_percent.h"
#include "simulation/simulation.h"
#include "step/accuracy.h"

#include <QTemporaryDir>
#include <QtTest>

#include <numbers>
#include <vector>

namespace ripstop::test_accuracy {

namespace {

ThreadPool alone(1);

// 65 kg on 10 m of line: 0.64 % longer by its stiffness.
Scene pilotOnALine()
{
    Scene scene =
        *build(*findBuilder("rope"),
               {{"segments", 50}, {"length", 10}, {"axial", 1e5}, {"end_mass", 65}, {"angle", 0}});
    scene.settings.viscosity = 1.0;
    return scene;
}

RunAccuracy flown(const Scene& scene, double seconds)
{
    Simulation simulation(*compile(scene));
    if (!simulation.runUntil(seconds))
        return {};
    return simulation.frame()->accuracy;
}

} // namespace

class TestAccuracy : public QObject
{
    Q_OBJECT

private slots:
    // A step that blows up misses, and has no error that could be told.
    void motionThatRunsAwayHasNoFactor()
    {
        RunAccuracy accuracy;
        accuracy.steps = accuracy.missed = 1;
        QVERIFY(!accuracy.isMet());
        const std::string said = accuracy.complaint().english();
        QVERIFY(said.find("runs away") != std::string::npos);
        QVERIFY(said.find("factor") == std::string::npos);
    }

    // What breaks in a step that missed is told, even where hardly a step did.
    void breaksInMissedStepsAreTold()
    {
        RunAccuracy accuracy;
        accuracy.steps = 1000;
        accuracy.missed = 1;
        accuracy.worst = 2.0;
        QVERIFY(accuracy.isMet());
        QVERIFY(accuracy.complaint().empty());
        accuracy.tornUntrue = 3;
        accuracy.tornUntrueFirst = 0.5;
        QVERIFY(!accuracy.isMet());
        const std::string said = accuracy.complaint().english();
        QVERIFY2(said.find("accuracy: 3, the first at 0.5 s") != std::string::npos, said.c_str());
    }

    // In wind a flag of cloth folds where it likes, and what it pulls with has to be found in each
    // step, however many iterations that takes: 40 of them were too few for a step in thirty.
    void aFlagInWindHoldsItsAccuracy()
    {
        const Builder& cloth = *findBuilder("cloth");
        const Parameters given = {{"columns", 30},
                                  {"rows", 30},
                                  {"sphere", 0},
                                  {"hang", 1}, // by its left edge
                                  {"wind", 5}};
        const Scene flag = *build(cloth, newDesign(cloth, given));
        const RunAccuracy accuracy = flown(flag, 0.25);
        QVERIFY(accuracy.steps >= 60);
        QCOMPARE(accuracy.missed, 0);
    }

    // 65 kg on 10 m of line of 1 MN bounce with 39 rad/s, of which Euler's method damps w h / 2 =
    // 2 %, h being 1/960 s: a run says so with a remedy that is one, as BDF2 damps (w h)^3 / 4.
    // Lines that never stretch ring by the solver alone once they hang still, and have nothing to
    // tell.
    void saysWhatStepsDamp()
    {
        Scene line = *build(
            *findBuilder("rope"),
            {{"segments", 1}, {"length", 10}, {"axial", 1e6}, {"end_mass", 65}, {"angle", 0}});
        line.settings.integrator = Integrator::SemiImplicitEuler;
        const RunAccuracy euler = flown(line, 1.0);
        QVERIFY2(std::abs(euler.damping / 0.0204 - 1.0) < 0.05,
                 qPrintable(QString::number(euler.damping)));
        const std::string said = euler.dampingComplaint().english();
        QVERIFY2(said.find("integrator BDF2") != std::string::npos, said.c_str());
        line.settings.integrator = Integrator::Bdf2;
        const RunAccuracy bdf2 = flown(line, 1.0);
        QVERIFY2(bdf2.damping < 1e-4, qPrintable(QString::number(bdf2.damping)));
        QVERIFY(bdf2.dampingComplaint().empty());
        const Scene lines = *build(*findBuilder("bridle"), {{"cord", 0.0}});
        QVERIFY(flown(lines, 2.0).dampingComplaint().empty());
    }

    // A weight that is whirled on a cord loses a third of its energy in 10 s, of which no swing
    // shows much.
    void saysWhatDiesAway()
    {
        const Builder& rope = *findBuilder("rope");
        Scene scene =
            *build(rope, newDesign(rope, {{"length", 1}, {"end_mass", 0.2}, {"angle", 90}}));
        scene.settings.gravity.setZero();
        scene.settings.airDensity = 0.0;
        constexpr double turn = 2.0 * std::numbers::pi * 5.0; // 1/s
        std::vector<Particle>& particles = firstOf<Part>(scene).particles;
        const Vec3 pin = particles.front().position;
        for (Particle& particle : particles)
            particle.velocity = turn * Vec3::UnitZ().cross(particle.position - pin);
        const RunAccuracy accuracy = flown(scene, 10.0);
        QVERIFY2(accuracy.damping < RunAccuracy::mostDamping,
                 qPrintable(QString::number(accuracy.damping)));
        const std::string said = accuracy.dampingComplaint().english();
        QVERIFY2(said.find("dies away by the time steps") != std::string::npos, said.c_str());
    }

    // A rope that never stretches loses more of its swing to its jerks the shorter the steps are.
    void saysWhatLinesLose()
    {
        const Builder& rope = *findBuilder("rope");
        const RunAccuracy accuracy =
            flown(*build(rope, newDesign(rope, {{"cord", 0}, {"end_mass", 0}})), 20.0);
        const std::string said = accuracy.dampingComplaint().english();
        QVERIFY2(said.find("Lines that never stretch") != std::string::npos, said.c_str());
        QVERIFY2(said.find("shorter time step") == std::string::npos, said.c_str());
    }

    // In plain numbers, also about and above 100 %.
    void saysDampingPlainly()
    {
        const auto said = [](double damping) {
            return QString::fromStdString(dampingPercent(damping).english());
        };
        QCOMPARE(said(0.0023), "0.23");
        QCOMPARE(said(0.0996), "10");
        QCOMPARE(said(0.357), "36");
        QCOMPARE(said(0.996), "100");
        QCOMPARE(said(1.1), "more than 100");
        QCOMPARE(said(250.0), "more than 100");
    }

    // By the definition: given 1 N where the length says 1.1 N, on one rod of compliance c.
    void isWhatTheLawSaysAgainstWhatWasGiven()
    {
        System system;
        system.inverseMass = {0.0, 1.0};
        system.rods = {{0, 1, 1.0, 0.01, Resists::Both, {}}};
        State state;
        state.position = {PaddedVec3(0, 0, 0), PaddedVec3(0, -1.011, 0)};
        state.rodTorn = {0};
        state.rodTension = {1.0};
        const std::vector<double> rest{1.0};
        StepAccuracy accuracy = accuracyOf(system, state, rest, alone);
        QVERIFY(std::abs(accuracy.pulls - 0.1) < 1e-6);
        QCOMPARE(accuracy.pullsRod, 0);
        QVERIFY(std::abs(accuracy.ratio(system) - 10.0) < 1e-4);

        system.rods[0].resists = Resists::Tension;  // slack lines and those that are torn pull at
        state.position[1] = PaddedVec3(0, -0.9, 0); // nothing
        state.rodTension = {0.0};
        QCOMPARE(accuracyOf(system, state, rest, alone).pulls, 0.0);
        state.rodTorn = {1};
        QCOMPARE(accuracyOf(system, state, rest, alone).pullsRod, -1);

        system.rods[0] = {0, 1, 1.0, 0.0, Resists::Both, {}}; // without compliance: its strain
        state.position[1] = PaddedVec3(0, -1.02, 0);
        state.rodTorn = {0};
        accuracy = accuracyOf(system, state, rest, alone);
        QVERIFY(std::abs(accuracy.strain - 0.02) < 1e-12);
        QVERIFY(std::abs(accuracy.ratio(system) - 2.0) < 1e-9);
        QCOMPARE(accuracy.worstRod(system), 0);
    }

    // What a new scene gets is true, and says so.
    void isMetByDefault()
    {
        const RunAccuracy accuracy = flown(pilotOnALine(), 4.0);
        QVERIFY(accuracy.steps > 900);
        QVERIFY(accuracy.isMet());
        QVERIFY(accuracy.pulls < 0.01);
        QVERIFY(accuracy.complaint().empty());
    }

    // Sweeps that cannot hold the line say so, by at least the factor by which it is too long.
    void saysWhereSweepsAreTooSoft_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::newRow("small steps") << Solver::SmallSteps;
        QTest::newRow("sweeps") << Solver::GaussSeidel;
        QTest::newRow("averaged") << Solver::AveragedJacobi;
    }

    void saysWhereSweepsAreTooSoft()
    {
        QFETCH(Solver, solver);
        Scene scene = pilotOnALine();
        scene.settings.solver = solver;
        const RunAccuracy accuracy = flown(scene, 2.0);
        QVERIFY(!accuracy.isMet());
        QVERIFY(accuracy.pulls > 0.05);
        QVERIFY(accuracy.worstLink > 0);
        QVERIFY(accuracy.complaint().english().find("not as stiff as it says")
                != std::string::npos);
    }

    // A smaller wish is met by more work.
    void isAsSmallAsWanted()
    {
        Scene scene = pilotOnALine();
        for (const double wanted : {10.0, 0.1}) {
            scene.settings.accuracy = wanted;
            const RunAccuracy accuracy = flown(scene, 2.0);
            QCOMPARE(accuracy.wantedPulls, wanted / 100.0);
            QVERIFY(accuracy.isMet());
        }
    }

    void commandLineTells()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("line.ripstop.json");
        Scene scene = pilotOnALine();
        QVERIFY(!saveScene(scene, file.toStdString()));
        const QStringList fly{"run", file, "--seconds", "1", "--json", "--strict"};
        Outcome outcome = call(fly);
        QCOMPARE(outcome.exitCode, 0);
        QJsonObject told = outcome.json()["accuracy"].toObject();
        QVERIFY(told["met"].toBool());
        QCOMPARE(told["wanted"].toDouble(), 0.01);

        outcome = call(fly + QStringList{"--set", "settings.solver=small_steps"});
        QCOMPARE(outcome.exitCode, 5);
        QVERIFY2(outcome.error.contains("wanted accuracy"), qPrintable(outcome.error));
        told = outcome.json()["accuracy"].toObject();
        QVERIFY(!told["met"].toBool());
        QVERIFY(told["missed"].toDouble() > 0.5);

        outcome = call({"run", file, "--seconds", "1", "--set", "settings.solver=small_steps"});
        QCOMPARE(outcome.exitCode, 0); // it says so all the same
        QVERIFY(outcome.error.contains("wanted accuracy"));
    }

    // Panels are of a law of small strains: a run says what it makes of one that is not.
    void commandLineTellsOfLargeStrains()
    {
        QTemporaryDir folder;
        const QString sheet = folder.filePath("sheet.ripstop.json");
        QCOMPARE(call({"build", "cloth", "cloth=royal_target", "hang=1", "sphere=0", "flat=0",
                       "wind=0", "columns=4", "rows=4", "-o", sheet})
                     .exitCode,
                 0);
        const auto flown = [&](const QStringList& more) {
            return call(QStringList{"run", sheet, "--seconds", "3"} + more);
        };
        QVERIFY(flown({"--json"}).json()["large_strain"].isNull());

        // which comes to rest
        const QStringList soft{"--set", "cloth.membraneStiffness=20", "--set",
                               "settings.viscosity=2"};
        const QJsonObject large =
            flown(soft + QStringList{"--json"}).json()["large_strain"].toObject();
        const double strain = large["strain"].toDouble();
        QVERIFY(strain > 0.05 && strain < 0.25);
        // St. Venant and Kirchhoff: S = E t (e + e^2 / 2) along a length of 1 + e
        const double pull = (strain + 0.5 * strain * strain) * (1.0 + strain);
        QVERIFY(std::abs(large["pull_over_linear"].toDouble() - pull / strain) < 1e-9);
        QVERIFY(flown(soft).out.contains("their law is of small strains"));
    }
};

const RegisteredTest registered("test_accuracy", runWithCore<TestAccuracy>);

} // namespace ripstop::test_accuracy
#include "test_accuracy.moc"
