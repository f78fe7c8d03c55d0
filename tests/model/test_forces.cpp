// The list of forces: whatever stands on it is compared, by differences and by the ledger, with
// what it says of its energy, its work and its stiffness. Each force needs an example of it here.
//
// Stages: that each force has an example and stands on the lists; then each example is compared
// with its energy by differences, its dampers with their power, the ledger with both, and its
// stiffness with the largest frequency; at the end the lists after edits, and sums made in two
// ways.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "forces/forces.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <Eigen/Eigenvalues>

#include <QtTest>

#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>

#include <cmath>
#include <map>

namespace ripstop::test_forces {

namespace {

// A system in which the force acts, its start state anything but at rest.
struct Example
{
    System system;
    HandCommands hands;
};

System twoTriangles(double size = 1.0)
{
    System system = emptySystem(1e-5);
    Dice dice(3);
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0.1, 1), Vec3(1, 0.2, 1.1)})
        addParticle(system, size * place, dice(0.1, 0.3), dice.vector(1.0));
    return system;
}

Example springs()
{
    System system = twoTriangles();
    for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b)
            addSpring(system, a, b, 0.9 * distance(system, a, b), 20.0 + a + 5.0 * b, 0.3);
    return {system, {}};
}

Example fabric()
{
    System system = twoTriangles();
    system.wind = {3.0, 1.0, -2.0};
    addPanel(system, 0, 1, 2, AirLaw::LinearNormal, 2.0, 0.1);
    addPanel(system, 1, 3, 2, AirLaw::Paper, 4.0);
    return {system, {}};
}

Example lineDrag()
{
    System system = twoTriangles();
    system.wind = {3.0, 1.0, -2.0};
    for (const auto& [a, b] : {std::pair{0, 3}, {3, 1}}) {
        addSpring(system, a, b, distance(system, a, b), 1.0);
        system.links.push_back(
            {Key(system.links.size()), LinkKind::Spring, int(system.links.size()), a, b});
        system.of<LineLists>().list.push_back({int(system.links.size()) - 1, a, b, 0.1});
    }
    return {system, {}};
}

Example bending()
{
    System system = twoTriangles(0.1);
    system.timeStep = 5e-6; // the panels turn right over: semi-implicit Euler needs it short
    addPanel(system, 0, 1, 2, AirLaw::None, 0.0);
    addPanel(system, 1, 3, 2, AirLaw::None, 0.0);
    system.bending = {{0.1, 0.0}};
    return {system, {}};
}

Example weight()
{
    System system = twoTriangles();
    system.gravity = {1.0, -9.0, 2.0};
    return {system, {}};
}

Example hand()
{
    System system = twoTriangles();
    system.key = {1, 2, 3, 4};
    HandPull pull;
    pull.grip.particle = {1, 2, 3};
    pull.grip.share = {0.5, 0.3, 0.2};
    pull.to = {1.0, 2.0, 0.5};
    pull.stiffness = 2.0;
    pull.damping = 0.1;
    HandCommands hands;
    hands.hands.pull = pull;
    return {system, hands};
}

const std::map<std::string_view, Example (*)()> examples = {
    {"springs", springs}, {"air on fabric", fabric}, {"line drag", lineDrag},
    {"bending", bending}, {"weight", weight},        {"hand", hand},
};

// One force of a list of its own, with an example of it that is ready to run.
struct Acting
{
    explicit Acting(const QString& name)
    {
        Example example = examples.at(name.toStdString())();
        system = std::move(example.system);
        hands = std::move(example.hands);
        finish(system);
        state = system.start;
        state.hands = hands.hands;
        for (const auto& each : forces)
            if (name == QString::fromStdString(each->name().english()))
                force = each.get();
        force->prepare(system, state);
    }

    // N, on each particle, in the state as it is.
    std::vector<Vec3> sum()
    {
        ThreadPool alone(1);
        const Lane lane = force->fill(system, state, alone);
        std::vector<PaddedVec3> acceleration(state.position.size());
        gatherAccelerations(lane.load ? std::span(&lane, 1) : std::span<const Lane>(),
                            force->acceleration(system), system.inverseMass.data(),
                            acceleration.data(), 0, acceleration.size());
        force->addToFew(system, state, system.timeStep, acceleration);
        std::vector<Vec3> sum;
        for (std::size_t i = 0; i < acceleration.size(); ++i)
            sum.push_back(system.mass[i] * acceleration[i]);
        return sum;
    }

    double power(const std::vector<Vec3>& on) const
    {
        double power = 0.0;
        for (std::size_t i = 0; i < on.size(); ++i)
            power += on[i].dot(state.velocity[i]);
        return power;
    }

    bool holdsEnergy() const
    {
        return force->kind() == ForceKind::Elastic || force->kind() == ForceKind::Weight;
    }

    System system;
    HandCommands hands;
    State state;
    Forces forces;
    Force* force = nullptr;
};

void stop(State& state)
{
    for (PaddedVec3& velocity : state.velocity)
        velocity = PaddedVec3();
}

QString textOf(const QString& file)
{
    QFile source(file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

// N/m, by differences: how the force on one coordinate falls as another one grows.
Eigen::MatrixXd stiffnessOf(Acting& c)
{
    constexpr double step = 1e-6; // m
    const auto n = Eigen::Index(3 * c.state.position.size());
    Eigen::MatrixXd stiffness(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        double& x = c.state.position[std::size_t(k / 3)][k % 3];
        const double before = x;
        x = before + step;
        const std::vector<Vec3> more = c.sum();
        x = before - step;
        const std::vector<Vec3> less = c.sum();
        x = before;
        for (std::size_t i = 0; i < more.size(); ++i)
            stiffness.block<3, 1>(Eigen::Index(3 * i), k) = (less[i] - more[i]) / (2.0 * step);
    }
    return stiffness;
}

} // namespace

class TestForces : public QObject
{
    Q_OBJECT

    static void everyForce()
    {
        QTest::addColumn<QString>("name");
        for (const auto& force : knownForces()) {
            const std::string name = force->name().english();
            QTest::newRow(name.c_str()) << QString::fromStdString(name);
        }
    }

private slots:
    // Each force has an example, in which it acts and pushes something.
    void hasExample_data() { everyForce(); }
    void hasExample()
    {
        QFETCH(QString, name);
        QVERIFY2(examples.count(name.toStdString()),
                 "show an example of the force in `examples` of this test");
        Acting c(name);
        QVERIFY(c.force->acts(c.system, c.state));
        double largest = 0.0;
        for (const Vec3& force : c.sum())
            largest = std::max(largest, force.norm());
        QVERIFY(largest > 1e-3);
    }

    // A force that was written and stands on no list would do nothing.
    void allAreListed()
    {
        static const QRegularExpression made("(\\w+)::makeForce\\(\\)\\s*\\{");
        static const QRegularExpression written(": public Force\\b");
        QSet<QString> types;
        int count = 0;
        QDirIterator found(SOURCE_DIR "/model/forces", {"*.h", "*.cpp"}, QDir::Files);
        while (found.hasNext()) {
            const QString text = textOf(found.next());
            for (auto all = made.globalMatch(text); all.hasNext();)
                types << all.next().captured(1);
            for (auto all = written.globalMatch(text); all.hasNext(); all.next())
                ++count;
        }
        QCOMPARE(types.size(), qsizetype(std::tuple_size_v<ForceLists>));
        QCOMPARE(count, int(types.size()));
        QSet<QString> names;
        for (const auto& force : knownForces())
            names << QString::fromStdString(force->name().english());
        QCOMPARE(names.size(), types.size());
    }

    // At rest, what holds energy pulls the way that it falls: F = -dE/dx.
    void pullsDownItsEnergy_data() { everyForce(); }
    void pullsDownItsEnergy()
    {
        QFETCH(QString, name);
        Acting c(name);
        stop(c.state);
        if (!c.holdsEnergy()) {
            QCOMPARE(c.force->energy(c.system, c.state), 0.0); // its work is counted instead
            return;
        }
        constexpr double step = 1e-6; // m
        const std::vector<Vec3> forces = c.sum();
        double largest = 0.0;
        for (const Vec3& force : forces)
            largest = std::max(largest, force.norm());
        QVERIFY(largest > 0.0);
        for (std::size_t i = 0; i < forces.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                double& x = c.state.position[i][k];
                const double before = x;
                x = before + step;
                const double more = c.force->energy(c.system, c.state);
                x = before - step;
                const double less = c.force->energy(c.system, c.state);
                x = before;
                const double slope = (less - more) / (2.0 * step);
                QVERIFY2(isNear(forces[i][k], slope, 1e-6 * largest), told(forces[i][k], slope));
            }
    }

    // What such a force does beyond that as things move is the power of its dampers, which only
    // take; other forces have none, and what forces hold is no work.
    void dampersTakeTheRest_data() { everyForce(); }
    void dampersTakeTheRest()
    {
        QFETCH(QString, name);
        Acting c(name);
        ThreadPool alone(1);
        const double moving = c.power(c.sum());
        const double damping = c.force->dampingPower(c.system, c.state, alone);
        QVERIFY(damping <= 0.0);
        if (!c.holdsEnergy()) {
            QCOMPARE(damping, 0.0);
            return;
        }
        const auto velocity = c.state.velocity;
        stop(c.state);
        const std::vector<Vec3> still = c.sum();
        c.state.velocity = velocity;
        const double rest = moving - c.power(still);
        QVERIFY2(isNear(damping, rest, 1e-9 * (std::abs(moving) + std::abs(rest))),
                 told(damping, rest));
        c.force->startWork(c.system, c.state, 1e-3);
        QCOMPARE(c.force->workSince(c.system, c.state, 1e-3), 0.0);
    }

    // The work of a hand over a short way is force times way.
    void handsWork_data() { everyForce(); }
    void handsWork()
    {
        QFETCH(QString, name);
        Acting c(name);
        if (c.force->kind() != ForceKind::Hand)
            return;
        constexpr double h = 1e-6; // s
        c.force->startWork(c.system, c.state, c.system.timeStep);
        const double power = c.power(c.sum());
        for (std::size_t i = 0; i < c.state.position.size(); ++i)
            c.state.position[i] += h * c.state.velocity[i];
        const double work = c.force->workSince(c.system, c.state, c.system.timeStep);
        QVERIFY2(isNear(work, h * power, 1e-4 * h * std::abs(power)), told(work, h * power));
    }

    // With steps this short the solver makes next to nothing of energy, so that all that the force
    // does is in the ledger: in the energy that it holds or in somebody's work.
    void ledgerKnowsIt_data() { everyForce(); }
    void ledgerKnowsIt()
    {
        QFETCH(QString, name);
        Acting c(name);
        askForLedger(c.system);
        Simulation simulation(std::make_shared<const System>(c.system));
        simulation.handle(c.hands);
        const double before = kineticEnergy(c.system, c.system.start);
        double exchanged = 0.0; // J, with what moves, either way
        double last = before;
        while (simulation.state().time < 0.02 && simulation.step()) {
            const double now = kineticEnergy(c.system, simulation.state());
            exchanged += std::abs(now - last);
            last = now;
        }
        const Work& work = simulation.state().work;
        QVERIFY(exchanged > 1e-5);
        QVERIFY2(isNear(work.residual, 0.0, 1e-3 * exchanged), told(work.residual, exchanged));
        QCOMPARE(work.air != 0.0, c.force->kind() == ForceKind::Air);
        QCOMPARE(work.hands != 0.0, c.force->kind() == ForceKind::Hand);
    }

    // What is stiff says so: the largest frequency w of all particles together has w^2 at most the
    // largest 2 K / m of one (Gershgorin), K what it asks of the step there.
    void stiffnessIsTold_data() { everyForce(); }
    void stiffnessIsTold()
    {
        QFETCH(QString, name);
        Acting c(name);
        if (!c.holdsEnergy())
            return;
        stop(c.state);
        Eigen::MatrixXd matrix = stiffnessOf(c);
        std::vector<double> stiffness(c.state.position.size(), 0.0);
        std::vector<double> damping(c.state.position.size(), 0.0);
        c.force->addStiffness(c.system, stiffness, damping);
        double told2 = 0.0; // 1/s^2
        for (std::size_t i = 0; i < stiffness.size(); ++i) {
            told2 = std::max(told2, 2.0 * stiffness[i] * c.system.inverseMass[i]);
            for (std::size_t j = 0; j < stiffness.size(); ++j)
                matrix.block<3, 3>(Eigen::Index(3 * i), Eigen::Index(3 * j)) *=
                    std::sqrt(c.system.inverseMass[i] * c.system.inverseMass[j]);
        }
        const Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
        const double largest =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().maxCoeff();
        QVERIFY2(largest <= told2 + 1e-3, told(largest, told2));
        QCOMPARE(c.force->boundsSubstep(c.system) && !(told2 > 0.0), false);
    }

    // What is derived twice is what was derived once, and only edits of something make it anew.
    void listsAgain_data() { everyForce(); }
    void listsAgain()
    {
        QFETCH(QString, name);
        Acting c(name);
        System again = c.system;
        c.force->list(again);
        QVERIFY(again == c.system);
        QVERIFY(!c.force->hangsOn({}));
    }

    // The two ways to add up, for accelerations and for power, agree on every lane.
    void bothSumsAgree_data() { everyForce(); }
    void bothSumsAgree()
    {
        QFETCH(QString, name);
        Acting c(name);
        ThreadPool alone(1);
        const Lane lane = c.force->fill(c.system, c.state, alone);
        if (!lane.load)
            return;
        std::vector<Vec3> sum(c.state.position.size(), Vec3::Zero());
        addForces(lane, sum);
        const std::vector<Vec3> gathered = c.sum();
        for (std::size_t i = 0; i < sum.size(); ++i)
            QVERIFY2(isNear(gathered[i], sum[i], 1e-12 * (1.0 + sum[i].norm())),
                     told(gathered[i], sum[i]));
    }
};

const RegisteredTest registered("test_forces", runPlain<TestForces>);

} // namespace ripstop::test_forces
#include "test_forces.moc"
