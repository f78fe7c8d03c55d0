// Particles that are free along a line or in a plane only, against mechanics: beads on wires, a
// trammel, a pendulum on a trolley, and what every solver makes of them.
//
// Stages: motions along wires and in planes against mechanics; that nothing leaves its guide,
// whatever the solver and the number of threads; hands and contact on guides; and how scenes say
// guides, turn them, weld them, and count them in rigidity.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "author/rigidity.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "shaping/copy.h"
#include "shaping/transform.h"
#include "shaping/weld.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_guides {

namespace {

constexpr double pi = std::numbers::pi;

int addBead(System& system, const Vec3& position, double mass, Guide guide, const Vec3& axis,
            const Vec3& velocity = Vec3::Zero())
{
    const int particle = addParticle(system, position, mass, velocity);
    system.guided.push_back({particle, guide, axis.normalized()});
    return particle;
}

const std::vector<Solver> everySolver{Solver::AveragedJacobi, Solver::PaperJacobi,
                                      Solver::GaussSeidel,    Solver::SmallSteps,
                                      Solver::Direct,         Solver::Auto};

std::string_view nameOf(Solver solver) { return choiceNames<Solver>[std::size_t(solver)]; }

void rowForEachSolver()
{
    QTest::addColumn<Solver>("solver");
    for (const Solver solver : everySolver)
        QTest::newRow(nameOf(solver).data()) << solver;
}

// A bob of mass m on a rod of 1 m under a trolley of mass M on a level rail.
System trolley(double bob, double trolleyMass, double angle, Solver solver)
{
    System system = heavySystem(1.0 / 2000.0);
    system.solver = solver;
    system.sweeps = 4;
    addBead(system, Vec3::Zero(), trolleyMass, Guide::Line, Vec3::UnitX());
    addParticle(system, {std::sin(angle), -std::cos(angle), 0.0}, bob);
    addRod(system, 0, 1, 1.0);
    finish(system);
    return system;
}

// A net of rods with a corner pinned, one on a skew line and two in a skew plane.
System guidedNet(Solver solver, Integrator integrator)
{
    System system = heavySystem(1.0 / 240.0, integrator);
    system.solver = solver;
    system.substeps = 4;
    constexpr int side = 5;
    for (int i = 0; i < side * side; ++i) {
        const Vec3 place(0.1 * (i % side), 1.0, 0.1 * (i / side));
        if (i == 0)
            addPin(system, place);
        else if (i == side - 1)
            addBead(system, place, 0.02, Guide::Line, Vec3(1.0, 0.3, -0.2));
        else if (i >= side * side - 2)
            addBead(system, place, 0.02, Guide::Plane, Vec3(0.4, 1.0, 0.3));
        else
            addParticle(system, place, 0.01);
    }
    for (int i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            addRod(system, i, i + 1, 0.1);
        if (i + side < side * side)
            addRod(system, i, i + side, 0.1, i % 2 ? 0.0 : 1e-5);
    }
    finish(system);
    return system;
}

double acrossGuides(const System& system, const State& state)
{
    double worst = 0.0;
    for (const GuidedParticle& guided : system.guided) {
        const auto p = std::size_t(guided.particle);
        const Vec3 way = state.position[p] - system.start.position[p];
        worst = std::max(worst, (way - guided.freePart(way)).norm());
        const Vec3 v = state.velocity[p];
        worst = std::max(worst, (v - guided.freePart(v)).norm());
    }
    return worst;
}

Scene oneBead(Guide guide, const Vec3& axis)
{
    Scene scene;
    Part part;
    const Id id = takeId(scene);
    for (const double x : {0.0, 1.0}) {
        Particle particle;
        particle.id = takeId(scene);
        particle.position = Vec3(x, 2.0, 0.0);
        particle.velocity = Vec3(3.0, 4.0, 5.0);
        particle.guide = guide;
        particle.guideAxis = axis;
        part.particles.push_back(particle);
    }
    scene.items.push_back({id, part});
    return scene;
}

const Particle& particleOf(const Scene& scene, std::size_t i)
{
    return std::get<Part>(scene.items.front().item).particles[i];
}

} // namespace

class TestGuides : public QObject
{
    Q_OBJECT

private slots:
    // v = g sin(angle) t along the wire, and x = v t / 2 but for half a step of Euler's.
    void aBeadSlidesDownAWire_data();
    void aBeadSlidesDownAWire();
    // In a plane that leans by the angle, the pull down the slope is the same as along the line.
    void aPuckSlidesDownAPlane();
    // The ends of a trammel run round an ellipse: with equal masses, x^2 + y^2 = L^2 is a circle in
    // the plane of (x, y) and its angle grows evenly. A projection takes 2 w^2 h of the energy per
    // second from a circular motion (x_n+1 = 2 x_n - x_n-1, put back: d(angle) falls by its cube).
    void aTrammelTurnsEvenly_data();
    void aTrammelTurnsEvenly();
    // w^2 = g / L (1 + m / M), and nothing pushes along the rail.
    void aPendulumSwingsFasterOnATrolley_data();
    void aPendulumSwingsFasterOnATrolley();
    // A bead of weight W on a wire that leans by 30 degrees, tied to a pin by a rod at 20 degrees
    // from the wire: W sin(30) / cos(20).
    void aRodHoldsABeadOnASlope_data();
    void aRodHoldsABeadOnASlope();
    void nothingLeavesItsGuide_data();
    void nothingLeavesItsGuide();
    void aLevelPlaneIsKeptToTheBit();
    // A rod that stands across its guide and is a little too short for it pushes the bead aside as
    // far as its length asks, sqrt(L^2 - 1), and no further.
    void aRodAcrossItsGuideFlingsNothing();
    void threadsAgree();
    void aBeadStopsWhereItsWireMeetsTheGround();
    void aHandPinsABead();
    void aSceneSaysWhatIsGuided();
    void aGuideNeedsADirection();
    void guidesTurnWithTheDesign();
    void aWeldKeepsTheGuide();
    // Two ends with 3 ways each and a rod: 5 rigid motions. A line leaves each end one way, and the
    // rod takes one of these away unless both lines stand across it.
    void guidesLeaveOneWay();
};

void TestGuides::aBeadSlidesDownAWire_data()
{
    QTest::addColumn<Integrator>("integrator");
    for (std::size_t i = 0; i < choiceNames<Integrator>.size(); ++i)
        QTest::newRow(choiceNames<Integrator>[i].data()) << Integrator(i);
}

void TestGuides::aBeadSlidesDownAWire()
{
    QFETCH(Integrator, integrator);
    const double angle = pi / 6.0;
    const Vec3 down(std::cos(angle), -std::sin(angle), 0.0);
    System system = heavySystem(1e-3, integrator);
    addBead(system, {1.0, 5.0, -2.0}, 0.3, Guide::Line, 7.0 * down);
    finish(system);
    const State state = run(system, 1000);
    const double pull = standardGravity * std::sin(angle);
    QVERIFY2(isNear(state.velocity[0], pull * down, 1e-9), told(state.velocity[0], pull * down));
    const Vec3 expected = Vec3(1.0, 5.0, -2.0) + 0.5 * pull * down;
    const double halfStep = 0.5 * pull * 1e-3;
    QVERIFY2(isNear(state.position[0], expected, 1.001 * halfStep),
             told(state.position[0], expected));
}

void TestGuides::aPuckSlidesDownAPlane()
{
    const double angle = pi / 5.0;
    const Vec3 normal(std::sin(angle), std::cos(angle), 0.0);
    System system = heavySystem(1e-3);
    addBead(system, Vec3::Zero(), 2.0, Guide::Plane, normal, Vec3(0.0, 0.0, 1.5));
    finish(system);
    const State state = run(system, 1000);
    const double pull = standardGravity * std::sin(angle);
    const Vec3 expected = pull * Vec3(std::cos(angle), -std::sin(angle), 0.0) + 1.5 * Vec3::UnitZ();
    QVERIFY2(isNear(state.velocity[0], expected, 1e-9), told(state.velocity[0], expected));
}

void TestGuides::aTrammelTurnsEvenly_data() { rowForEachSolver(); }

void TestGuides::aTrammelTurnsEvenly()
{
    QFETCH(Solver, solver);
    const double h = 1e-4, turnRate = 2.0 * pi, length = 0.5;
    System system = emptySystem(h);
    system.solver = solver;
    system.sweeps = 4;
    const double angle = 0.3;
    addBead(system, {length * std::cos(angle), 0.0, 0.0}, 0.2, Guide::Line, Vec3::UnitX(),
            {-length * turnRate * std::sin(angle), 0.0, 0.0});
    addBead(system, {0.0, length * std::sin(angle), 0.0}, 0.2, Guide::Line, Vec3::UnitY(),
            {0.0, length * turnRate * std::cos(angle), 0.0});
    addRod(system, 0, 1, length);
    finish(system);
    const double before = kineticEnergy(system, system.start);
    const State state = run(system, 10000); // once round
    const double lost = 1.0 - kineticEnergy(system, state) / before;
    const double expected = 2.0 * turnRate * turnRate * h;
    QVERIFY2(isNear(lost, expected, 0.1 * expected), told(lost, expected));
    const double turned = std::atan2(state.position[1].y(), state.position[0].x());
    // d(rate)/dt = -rate^3 h over one second
    const double late = 0.5 * std::pow(turnRate, 3.0) * h;
    QVERIFY2(isNear(turned, angle - late, 0.1 * late), told(turned, angle - late));
    const double now = (state.position[1] - state.position[0]).norm();
    QVERIFY2(isNear(now, length, 1e-5), told(now, length));
}

void TestGuides::aPendulumSwingsFasterOnATrolley_data()
{
    QTest::addColumn<Solver>("solver");
    QTest::addColumn<double>("ratio"); // m / M
    for (const Solver solver : everySolver)
        for (const double ratio : {0.1, 1.0, 5.0}) {
            if (solver == Solver::PaperJacobi)
                continue; // it keeps no momentum
            QTest::addRow("%s, m/M %g", nameOf(solver).data(), ratio) << solver << ratio;
        }
}

void TestGuides::aPendulumSwingsFasterOnATrolley()
{
    QFETCH(Solver, solver);
    QFETCH(double, ratio);
    const System system = trolley(0.4, 0.4 / ratio, 0.02, solver);
    Stepper stepper;
    State state = system.start;
    std::vector<double> crossings;
    double before = 1.0;
    while (crossings.size() < 9 && state.time < 20.0) {
        stepper.step(system, state);
        const double now = state.position[1].x() - state.position[0].x();
        if ((now > 0.0) != (before > 0.0) && state.step > 1)
            crossings.push_back(state.time - system.timeStep * now / (now - before));
        before = now;
    }
    const double rate = std::sqrt(standardGravity * (1.0 + ratio));
    const double period = 2.0 * (crossings.back() - crossings.front()) / 8.0;
    QVERIFY2(isNear(period, 2.0 * pi / rate, 1e-3 * period), told(period, 2.0 * pi / rate));
    const double along = momentum(system, state).x();
    QVERIFY2(isNear(along, 0.0, 1e-9), told(along, 0.0));
}

void TestGuides::aRodHoldsABeadOnASlope_data()
{
    QTest::addColumn<Solver>("solver");
    QTest::addColumn<double>("compliance");
    for (const Solver solver : everySolver)
        for (const double compliance : {0.0, 1e-3}) {
            if (solver == Solver::PaperJacobi)
                continue; // it knows neither compliance nor the force of a rod
            QTest::addRow("%s, %g m/N", nameOf(solver).data(), compliance) << solver << compliance;
        }
}

void TestGuides::aRodHoldsABeadOnASlope()
{
    QFETCH(Solver, solver);
    QFETCH(double, compliance);
    const double slope = pi / 6.0, between = pi / 9.0, weight = 0.5 * standardGravity;
    System system = heavySystem(1.0 / 400.0);
    system.solver = solver;
    system.sweeps = 8;
    system.viscosity = 20.0;
    const Vec3 up(std::cos(slope), std::sin(slope), 0.0);
    const Vec3 toPin(std::cos(slope + between), std::sin(slope + between), 0.0);
    addPin(system, toPin);
    addBead(system, Vec3::Zero(), 0.5, Guide::Line, up);
    const double expected = weight * std::sin(slope) / std::cos(between);
    // the rod is shorter by its stretch, so that the angle is right where the bead comes to rest
    addRod(system, 0, 1, 1.0 - compliance * expected, compliance);
    system.rods.back().resists = Resists::Tension;
    finish(system);
    const State state = run(system, 2000);
    QVERIFY2(isNear(state.rodTension[0], expected, 2e-3 * expected),
             told(state.rodTension[0], expected));
    QVERIFY2(state.velocity[1].norm() < 1e-4, "it rests");
}

void TestGuides::nothingLeavesItsGuide_data()
{
    QTest::addColumn<Solver>("solver");
    QTest::addColumn<Integrator>("integrator");
    for (const Solver solver : everySolver)
        for (std::size_t i = 0; i < choiceNames<Integrator>.size(); ++i) {
            if (solver == Solver::SmallSteps && Integrator(i) == Integrator::Bdf2)
                continue; // they do not go together, of which problemsOf() warns
            QTest::addRow("%s, %s", nameOf(solver).data(), choiceNames<Integrator>[i].data())
                << solver << Integrator(i);
        }
}

void TestGuides::nothingLeavesItsGuide()
{
    QFETCH(Solver, solver);
    QFETCH(Integrator, integrator);
    const System system = guidedNet(solver, integrator);
    const State state = run(system, 500);
    const double across = acrossGuides(system, state);
    QVERIFY2(across < 1e-12, told(across, 0.0));
    for (const GuidedParticle& guided : system.guided) { // and they do move
        const auto p = std::size_t(guided.particle);
        QVERIFY((state.position[p] - system.start.position[p]).norm() > 1e-3);
    }
    for (std::size_t i = 0; i < system.rods.size(); ++i) {
        const Rod& rod = system.rods[i];
        const double length =
            (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm();
        QVERIFY2(isNear(length, rod.restLength, 0.03 * rod.restLength),
                 told(length, rod.restLength));
    }
}

void TestGuides::aLevelPlaneIsKeptToTheBit()
{
    System system = guidedNet(Solver::GaussSeidel, Integrator::Verlet);
    for (GuidedParticle& guided : system.guided)
        guided = {guided.particle, Guide::Plane, Vec3::UnitY()};
    const State state = run(system, 500);
    for (const GuidedParticle& guided : system.guided)
        QCOMPARE(state.position[std::size_t(guided.particle)].y(), 1.0);
}

void TestGuides::aRodAcrossItsGuideFlingsNothing()
{
    System system = emptySystem(0.01);
    system.solver = Solver::GaussSeidel;
    system.sweeps = 1;
    const double rest = 1.0 + 1e-6;
    addPin(system, {0.0, 1.0, 0.0});
    addBead(system, {1e-9, 0.0, 0.0}, 0.1, Guide::Line, Vec3::UnitX());
    addRod(system, 0, 1, rest);
    finish(system);
    const State state = run(system, 1);
    const double aside = std::sqrt(rest * rest - 1.0);
    QVERIFY2(isNear(state.position[1].x(), aside, 1e-6 * aside),
             told(state.position[1].x(), aside));
}

void TestGuides::threadsAgree()
{
    System system = heavySystem(1.0 / 240.0);
    system.solver = Solver::GaussSeidel;
    system.sweeps = 4;
    constexpr int side = 120;
    for (int i = 0; i < side * side; ++i) {
        const Vec3 place(0.01 * (i % side), 1.0, 0.01 * (i / side));
        if (i < side)
            addBead(system, place, 1e-4, Guide::Line, Vec3::UnitX());
        else
            addParticle(system, place, 1e-4);
    }
    for (int i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            addRod(system, i, i + 1, 0.01);
        if (i + side < side * side)
            addRod(system, i, i + side, 0.01);
    }
    finish(system);
    QCOMPARE(stateHash(run(system, 20, 2)), stateHash(run(system, 20, 1)));
}

void TestGuides::aBeadStopsWhereItsWireMeetsTheGround()
{
    const double angle = pi / 6.0;
    System system = heavySystem(1e-3);
    addBead(system, {0.0, 0.5, 0.0}, 0.3, Guide::Line, {std::cos(angle), -std::sin(angle), 0.0});
    system.obstacles.push_back(
        {ColliderShape::Plane, Vec3::Zero(), Vec3::UnitY(), 0.0, Response::Contact, 0.0, 0.0});
    finish(system);
    const State state = run(system, 2000); // it takes 0.64 s
    const Vec3 foot(0.5 / std::tan(angle), 0.0, 0.0);
    QVERIFY2(isNear(state.position[0], foot, 2e-5), told(state.position[0], foot));
    QVERIFY(state.velocity[0].norm() < 0.01);
}

void TestGuides::aHandPinsABead()
{
    System system = trolley(0.4, 0.4, 0.5, Solver::GaussSeidel);
    system.inverseMass[0] = 0.0; // as splitSystem() does
    finish(system);
    const State state = run(system, 500);
    QVERIFY(state.position[0].isZero(0.0));
}

void TestGuides::aSceneSaysWhatIsGuided()
{
    Scene scene = oneBead(Guide::Line, Vec3(0.0, 2.0, 0.0));
    std::get<Part>(scene.items.front().item).particles[1].pinned = true;
    const auto system = compile(scene);
    QVERIFY(system);
    QCOMPARE((*system)->guided.size(), std::size_t(1)); // a pin holds more than a guide
    QVERIFY(((*system)->guided.front() == GuidedParticle{0, Guide::Line, Vec3::UnitY()}));
    QVERIFY(isNear((*system)->start.velocity[0], Vec3(0.0, 4.0, 0.0), 0.0));
}

void TestGuides::aGuideNeedsADirection()
{
    const auto system = compile(oneBead(Guide::Plane, Vec3::Zero()));
    QVERIFY(!system);
    QVERIFY2(system.message().english().find("guide axis that is not zero") != std::string::npos,
             system.message().english().c_str());
}

void TestGuides::guidesTurnWithTheDesign()
{
    Scene scene = oneBead(Guide::Line, Vec3::UnitX());
    const Movable movable = movableOf(scene, {scene.items.front().id});
    const Scene before = scene;
    const Edit back = apply(scene, moved(movable, turned(Vec3::Zero(), Vec3::UnitZ(), pi / 2.0),
                                         RestLengths::Keep, Message("Turn")));
    QVERIFY(isNear(particleOf(scene, 0).guideAxis, Vec3::UnitY(), 1e-12));
    (void)apply(scene, back);
    QVERIFY(scene.items == before.items);

    // a plane that leans turns its back on its mirror image
    scene = oneBead(Guide::Plane, Vec3(1.0, 1.0, 0.0));
    const Copies copies = mirrored(scene, {scene.items.front().id}, Vec3(5.0, 0.0, 0.0), 0, 1e-3);
    (void)apply(scene, copies.edit);
    const Part& part = std::get<Part>(scene.items.front().item);
    QCOMPARE(part.particles.size(), std::size_t(4));
    QVERIFY(part.particles[2].guideAxis.cross(Vec3(-1.0, 1.0, 0.0)).norm() < 1e-12);
}

void TestGuides::aWeldKeepsTheGuide()
{
    Scene scene = oneBead(Guide::None, Vec3::UnitX());
    Particle& second = std::get<Part>(scene.items.front().item).particles[1];
    second.guide = Guide::Plane;
    second.guideAxis = Vec3::UnitZ();
    const Weld weld = welded(scene, {particleOf(scene, 0).id, second.id}, WeldAt::First);
    (void)apply(scene, weld.edit);
    QCOMPARE(std::get<Part>(scene.items.front().item).particles.size(), std::size_t(1));
    QVERIFY(particleOf(scene, 0).guide == Guide::Plane);
    QVERIFY(particleOf(scene, 0).guideAxis == Vec3::UnitZ());
}

void TestGuides::guidesLeaveOneWay()
{
    const auto twoWithARod = [](Guide guide, const Vec3& first, const Vec3& second) {
        Scene scene = oneBead(guide, first);
        Part& part = std::get<Part>(scene.items.front().item);
        part.particles[1].guideAxis = second;
        Link link;
        link.id = takeId(scene);
        link.from = part.particles[0].id;
        link.to = part.particles[1].id;
        part.links.push_back(link);
        return *rigidityOf(scene, {scene.items.front().id});
    };
    const Rigidity free = twoWithARod(Guide::None, Vec3::UnitX(), Vec3::UnitX());
    QCOMPARE(free.rigidMotions, 5);
    QCOMPARE(int(free.modes.size()), 0);

    // the rod is along x, so that along y neither end changes its length
    const Rigidity rails = twoWithARod(Guide::Line, Vec3::UnitY(), Vec3::UnitY());
    QCOMPARE(int(rails.modes.size()) + rails.rigidMotions, 2); // each end by itself, or both
    QCOMPARE(rails.redundant, 1);

    // along the rod, both go together
    const Rigidity along = twoWithARod(Guide::Line, Vec3::UnitX(), Vec3::UnitX());
    QCOMPARE(int(along.modes.size()), 0);
    QCOMPARE(along.rigidMotions, 1);
    QCOMPARE(along.redundant, 0);

    // askew, one goes as the other lets it
    const Rigidity askew = twoWithARod(Guide::Line, Vec3(1.0, 1.0, 0.0), Vec3(1.0, 2.0, 0.0));
    QCOMPARE(int(askew.modes.size()) + askew.rigidMotions, 1);
    QCOMPARE(askew.redundant, 0);
}

const RegisteredTest registered("test_guides", runPlain<TestGuides>);

} // namespace ripstop::test_guides
#include "test_guides.moc"
