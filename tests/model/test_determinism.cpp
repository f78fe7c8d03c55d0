// The same bits in every run and at every number of threads (validation C9).
//
// Stages: designs, networks and tears that are large enough to be shared out are flown at several
// numbers of threads and compared by their hash or bits; then all sample scenes and builders; and
// a run that goes on from a checkpoint.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "io/scene_file.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <QDir>
#include <QtTest>

#include <cstring>

namespace ripstop::test_determinism {

namespace {

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size()
           && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// More than the hash covers: all that a step leaves behind.
bool sameBits(const State& a, const State& b)
{
    return a.time == b.time && a.step == b.step && stateHash(a) == stateHash(b)
           && sameBits(a.position, b.position) && sameBits(a.velocity, b.velocity)
           && sameBits(a.drift, b.drift) && sameBits(a.rodTension, b.rodTension)
           && a.tears.size() == b.tears.size();
}

// A tangle of 8000 particles: 12000 rods and springs and 11000 panels at random between
// neighbours, in a wind, over a floor, some of it tearing. Large enough that every loop of the step
// is shared out between threads.
System tangle(Integrator integrator, Solver solver)
{
    const int count = 8000;
    Dice dice(11);
    System system = emptySystem(1.0 / 500.0, integrator);
    system.solver = solver;
    system.sweeps = 4;
    system.substeps = 2;
    system.gravity = {0.0, -standardGravity, 0.0};
    system.wind = {2.0, 0.5, -1.0};
    system.viscosity = 0.3;
    system.obstacles = {
        {ColliderShape::Plane, {0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, 0.0, Response::Contact, 0.3, 0.4},
        {ColliderShape::Sphere, Vec3::Zero(), {0.0, 1.0, 0.0}, 0.3, Response::Slide, 0.0, 0.0}};
    addCostlyObstacles(system, {2.0, 0.0, 0.0});
    for (int i = 0; i < count; ++i) {
        const Vec3 place = Vec3(0.002 * i - 8.0, 0.0, 0.0) + dice.vector(0.5);
        const Vec3 velocity = dice.vector(1.0);
        const double mass = dice(0.01, 0.1);
        if (i % 97 == 0)
            addPin(system, place, mass);
        else
            addParticle(system, place, mass, velocity);
    }
    const auto neighbour = [&](int i) { return (i + 1 + dice.below(200)) % count; };
    for (int k = 0; k < 12000; ++k) {
        const int a = dice.below(count);
        const int b = neighbour(a);
        Rod& rod = addRod(system, a, b, distance(system, a, b), k % 3 == 0 ? 1e-5 : 0.0);
        rod.resists = k % 5 == 0 ? Resists::Tension : Resists::Both;
        if (k % 4 == 0)
            rod.tear = {TearRule::Force, 300.0};
    }
    for (int k = 0; k < 12000; ++k) {
        const int a = dice.below(count);
        const int b = neighbour(a);
        Spring& spring = addSpring(system, a, b, distance(system, a, b), 20.0, 0.01);
        if (k % 4 == 0)
            spring.tear = {TearRule::Strain, 0.02};
    }
    for (int k = 0; k < 11000; ++k) {
        const int a = dice.below(count - 210);
        addPanel(system, a, a + 1 + dice.below(90), a + 100 + dice.below(90),
                 k % 2 ? AirLaw::LinearNormal : AirLaw::Paper, 1.2, 0.02);
    }
    finish(system);
    return system;
}

// 6000 particles whose rods go to neighbours at random, eight each, and hubs of 100 rods that go
// further, so that their chunks touch many others. Some rods are soft, some pull or push only,
// some are torn from the start, some break on the way; one pilot shifts his weight. Single sweeps
// of it are worth threads too.
System hubs(std::uint32_t seed, int sweeps)
{
    const int count = 6000;
    Dice dice(seed);
    System system = emptySystem(1.0 / 240.0);
    system.solver = Solver::GaussSeidel;
    system.sweeps = sweeps;
    system.substeps = 3;
    system.gravity = {0.0, -standardGravity, 0.0};
    system.viscosity = 1.0;
    for (int i = 0; i < count; ++i) {
        const Vec3 place = Vec3(0.001 * i, 0.0, 0.0) + dice.vector(0.2);
        if (dice.below(200) == 0)
            addPin(system, place);
        else // half of them alike, so that there are rods of every kind
            addParticle(system, place, i % 2 ? 0.05 : dice(0.01, 0.1), dice.vector(0.5));
    }
    const auto join = [&](int a, int b) {
        if (a == b)
            return;
        const bool isSoft = dice.below(6) == 0;
        Rod& rod = addRod(system, a, b, distance(system, a, b), isSoft ? dice(1e-7, 1e-4) : 0.0);
        const int kind = dice.below(12);
        rod.resists = kind == 0   ? Resists::Tension
                      : kind == 1 ? Resists::Compression
                                  : Resists::Both;
        if (dice.below(10) == 0)
            rod.tear = {TearRule::Strain, 0.02};
    };
    for (int a = 0; a < count; ++a)
        for (int k = 0; k < 8; ++k)
            join(a, (a + 1 + dice.below(60)) % count);
    for (int hub = 50; hub < count; hub += 600)
        for (int k = 0; k < 100; ++k)
            join(hub, (hub + 1 + dice.below(500)) % count);

    const int pilot = addParticle(system, {3.0, -0.5, 0.0}, 2.0);
    for (int k = 0; k < 3; ++k) {
        const int end = 2900 + 100 * k;
        system.shiftedRods.push_back(
            {int(system.rods.size()), pilot,
             system.start.position[std::size_t(end)] - system.start.position[std::size_t(pilot)]});
        join(pilot, end);
    }
    system.inputs = {{1, ControlKind::WeightShift, Vec3::UnitX(), 0.1, 0.5, 0.5, {pilot}}};
    finish(system);
    for (std::uint8_t& torn : system.start.rodTorn)
        torn = dice.below(30) == 0;
    return system;
}

// 90 ropes of 100 particles, hung side by side and tied by springs: what the direct solver likes,
// and large enough for all other loops to be shared out.
System ropes()
{
    System system = emptySystem(1.0 / 240.0);
    system.solver = Solver::Direct;
    system.sweeps = 3;
    system.substeps = 2;
    system.gravity = {1.0, -standardGravity, 0.5};
    for (int rope = 0; rope < 90; ++rope)
        for (int i = 0; i < 100; ++i) {
            const Vec3 place(0.1 * rope, -0.05 * i, 0.0);
            const int at = i == 0 ? addPin(system, place) : addParticle(system, place, 0.01);
            if (i > 0)
                addRod(system, at - 1, at, 0.05).resists =
                    rope % 2 ? Resists::Tension : Resists::Both;
            if (rope > 0)
                addSpring(system, at - 100, at, 0.09, 5.0, 0.01);
        }
    finish(system);
    return system;
}

QStringList shippedScenes()
{
    return QDir(QStringLiteral(SCENES_DIR)).entryList({"*.ripstop.json"}, QDir::Files, QDir::Name);
}

} // namespace

class TestDeterminism : public QObject
{
    Q_OBJECT

private slots:
    void threads_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<Solver>("solver");
        const auto row = [](Integrator integrator, Solver solver) {
            QTest::addRow("C9 tangle, %s, %s",
                          choiceNames<Integrator>[std::size_t(integrator)].data(),
                          choiceNames<Solver>[std::size_t(solver)].data())
                << integrator << solver;
        };
        row(Integrator::SemiImplicitEuler, Solver::GaussSeidel);
        row(Integrator::SemiImplicitEuler, Solver::AveragedJacobi);
        row(Integrator::SemiImplicitEuler, Solver::PaperJacobi);
        row(Integrator::ExplicitEuler, Solver::GaussSeidel);
        row(Integrator::Verlet, Solver::GaussSeidel);
        row(Integrator::VelocityVerlet, Solver::GaussSeidel);
    }

    void threads()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        const System system = tangle(integrator, solver);
        const int steps = 8;
        const State alone = run(system, steps);
        QVERIFY(!alone.tears.empty());
        QVERIFY2(sameBits(run(system, steps), alone), "a second run");
        for (const int threads : {2, 3, 8})
            QVERIFY2(sameBits(run(system, steps, threads), alone),
                     qPrintable(QString("%1 threads").arg(threads)));
    }

    // More are above their limits than may break: who goes first must not hang on threads.
    void fewTearsPerStep()
    {
        System system = tangle(Integrator::SemiImplicitEuler, Solver::GaussSeidel);
        system.tearsPerStep = 7;
        const int steps = 8;
        const State alone = run(system, steps);
        QCOMPARE(alone.tears.size(), std::size_t(7 * steps));
        for (const int threads : {1, 2, 3, 8}) {
            const State again = run(system, steps, threads);
            QVERIFY2(sameBits(again, alone), qPrintable(QString("%1 threads").arg(threads)));
            QVERIFY(again.tears == alone.tears);
        }
    }

    void networks_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<int>("sweeps");
        QTest::addColumn<bool>("beside");
        for (const int seed : {1, 2, 3})
            for (const int sweeps : {1, 2, 7})
                QTest::addRow("C9 hubs %d, %d sweeps", seed, sweeps) << seed << sweeps << false;
        QTest::newRow("C9 hubs beside a direct block, 1 sweep") << 4 << 1 << true;
        QTest::newRow("C9 hubs beside a direct block, 4 sweeps") << 4 << 4 << true;
    }

    void networks()
    {
        QFETCH(int, seed);
        QFETCH(int, sweeps);
        QFETCH(bool, beside);
        System system = hubs(std::uint32_t(seed), sweeps);
        if (beside) { // what few particles lie within is small enough
            system.direct.assign(system.rods.size(), 0);
            for (std::size_t i = 0; i < system.rods.size(); ++i)
                system.direct[i] = system.rods[i].a < 150 && system.rods[i].b < 150;
        }
        // what coloured_sweeps.cpp asks for before it calls threads, and something to share
        QVERIFY(system.rods.size() * std::size_t(sweeps) >= 30000);
        QVERIFY(std::ranges::count(system.chunkClass, 0) > 1);
        const int steps = 12;
        const State alone = run(system, steps);
        QVERIFY(!alone.tears.empty());
        QVERIFY(alone.inputValue[0] > 0.0);
        for (const Vec3& position : alone.position)
            QVERIFY(position.allFinite());
        for (const int threads : {1, 2, 3, 8})
            QVERIFY2(sameBits(run(system, steps, threads), alone),
                     qPrintable(QString("%1 threads").arg(threads)));
    }

    void directSolver()
    {
        const System system = ropes();
        const State alone = run(system, 10);
        for (const int threads : {1, 2, 3, 8})
            QVERIFY2(sameBits(run(system, 10, threads), alone),
                     qPrintable(QString("%1 threads").arg(threads)));
    }

    // Cloth of real stiffness that is large enough for threads to share its global solve.
    void stiffSheets_data()
    {
        QTest::addColumn<FabricKind>("carrier");
        QTest::newRow("C9 stiff sheet of threads") << FabricKind::Threads;
        QTest::newRow("C9 stiff sheet of panels") << FabricKind::Panels;
    }

    void stiffSheets()
    {
        QFETCH(FabricKind, carrier);
        Scene scene = *build(*findBuilder("cloth"),
                             {{"columns", 60}, {"rows", 60}, {"membrane", 40e3}, {"sphere", 0}});
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item))
                part->carrier = carrier;
        const auto system = *compile(scene);
        std::vector<State> states;
        for (const int threads : {1, 1, 2, 3, 8}) {
            Simulation simulation(system, threads);
            QVERIFY(simulation.runUntil(4.0 * scene.settings.timeStep));
            states.push_back(simulation.state());
        }
        QVERIFY(states[0].step > 0);
        for (const State& state : states)
            QVERIFY(sameBits(state, states[0]));
    }

    // What is shipped, with every control in use.
    void scenes_data()
    {
        QTest::addColumn<QString>("file");
        for (const QString& file : shippedScenes())
            QTest::addRow("C9 %s", qPrintable(file)) << file;
    }

    void scenes()
    {
        QFETCH(QString, file);
        const auto scene = readScene((QStringLiteral(SCENES_DIR) + "/" + file).toStdString());
        QVERIFY2(bool(scene), scene ? "" : scene.message().english().c_str());
        std::vector<State> states;
        for (const int threads : {1, 1, 2, 3, 8}) {
            const auto system = compile(*scene);
            QVERIFY(bool(system));
            Simulation simulation(*system, threads);
            Commands commands;
            for (const Input& input : (*system)->inputs)
                commands[input.key] = 0.3 * input.limit;
            simulation.command(commands);
            QVERIFY(simulation.runUntil(0.5));
            states.push_back(simulation.state());
        }
        QVERIFY(states[0].step > 0);
        for (const State& state : states)
            QVERIFY(sameBits(state, states[0]));
    }

    // Compiling and running once more, and running on more threads, changes no bit of any design.
    void designs_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("fineness"); // rows of cloth, 0 for the default
        for (const Builder& builder : allBuilders())
            QTest::addRow("C9 %s", std::string(builder.name).c_str())
                << QString::fromStdString(std::string(builder.name)) << 0;
        QTest::newRow("C9 fine cloth") << QString("cloth") << 100;
    }

    void designs()
    {
        QFETCH(QString, name);
        QFETCH(int, fineness);
        const Builder& builder = *findBuilder(name.toStdString());
        Parameters parameters;
        for (const Parameter& parameter : builder.parameters)
            if (fineness > 0 && (parameter.key == "columns" || parameter.key == "rows"))
                parameters[std::string(parameter.key)] = fineness;
        QVERIFY(fineness == 0 || parameters.size() == 2);
        const auto scene = build(builder, parameters);
        QVERIFY2(bool(scene), scene ? "" : scene.message().english().c_str());

        std::vector<State> states;
        for (const int threads : {1, 1, 2, 3, 8}) {
            const auto system = compile(*scene); // anew for each
            QVERIFY(bool(system));
            Simulation simulation(*system, threads);
            const double seconds = fineness > 0 ? 0.02 : 0.3;
            QVERIFY(simulation.runUntil(seconds));
            states.push_back(simulation.state());
        }
        for (const State& state : states)
            QVERIFY(sameBits(state, states[0]));
    }

    // A checkpoint in the middle changes nothing: a copied State goes on with the same bits.
    void checkpoint()
    {
        const System system = tangle(Integrator::Verlet, Solver::GaussSeidel);
        const State half = run(system, 4);
        QVERIFY(sameBits(run(system, half, 4), run(system, 8)));
    }
};

const RegisteredTest registered("test_determinism", runPlain<TestDeterminism>);

} // namespace ripstop::test_determinism
#include "test_determinism.moc"
