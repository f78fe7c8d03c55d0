// Scene to System.
//
// Stages: what particles, links, surroundings, controls and probes of a scene become in the
// System, by numbers and by order; then scenes that are refused with a sentence; and that
// compiling twice gives the same system and motion.
#include "compile/compile.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "builders/network.h"
#include "measure/diagnostics.h"
#include "model/systems.h"

#include <QtTest>

#include <algorithm>

namespace ripstop::test_compile {

namespace {

// Two parts: a pinned swing of a spring, a rod and a panel, and a lone particle.
struct Made
{
    Scene scene;
    Id soft, strong, swing, a, b, c, spring, rod, panel, other, lone;
};

Made made()
{
    Made m;
    Scene& scene = m.scene;
    Material soft;
    soft.stiffness = 120.0;
    soft.damping = 0.4;
    soft.compliance = 2e-5;
    soft.tearRule = TearRule::Strain;
    soft.tearLimit = 0.3;
    soft.airLaw = AirLaw::Paper;
    soft.normalCoefficient = 3.0;
    soft.skinFriction = 0.01;
    m.soft = addItem(scene, soft);
    m.strong = addItem(scene, Material{});

    Network swing(scene, "swing");
    m.a = swing.particle({0.0, 1.0, 0.0}, 0.5);
    m.b = swing.particle({1.0, 1.0, 0.0}, 0.2);
    m.c = swing.particle({0.0, 1.0, 1.0}, 0.3);
    swing.row(m.a).pinned = true;
    swing.row(m.a).velocity = {1.0, 1.0, 1.0};
    swing.row(m.b).velocity = {0.0, 2.0, 0.0};
    m.spring = swing.spring(m.a, m.b, m.soft);
    m.rod = swing.rod(m.c, m.a, m.soft, Resists::Tension);
    m.panel = swing.panel(m.a, m.b, m.c, m.soft);
    m.swing = swing.finish("", {});

    Network other(scene, "other");
    m.lone = other.particle({5.0, 0.0, 0.0}, 2.0);
    m.other = other.finish("", {});
    return m;
}

std::shared_ptr<const System> compiled(const Scene& scene)
{
    const auto system = compile(scene, 7, 3);
    if (!system)
        qFatal("%s", system.message().english().c_str());
    return *system;
}

} // namespace

class TestCompile : public QObject
{
    Q_OBJECT

private slots:
    void particles()
    {
        const Made m = made();
        const auto system = compiled(m.scene);
        QCOMPARE(system->generation, std::uint64_t(7));
        QCOMPARE(system->run, std::uint64_t(3));
        QCOMPARE(system->key, (std::vector<Key>{Key(m.a), Key(m.b), Key(m.c), Key(m.lone)}));
        QCOMPARE(system->mass, (std::vector<double>{0.5, 0.2, 0.3, 2.0}));
        QCOMPARE(system->inverseMass, (std::vector<double>{0.0, 1.0 / 0.2, 1.0 / 0.3, 0.5}));
        QCOMPARE(system->start.position[3], Vec3(5.0, 0.0, 0.0));
        QCOMPARE(system->start.velocity[0], Vec3(Vec3::Zero())); // pinned
        QCOMPARE(system->start.velocity[1], Vec3(0.0, 2.0, 0.0));
        QCOMPARE(totalMass(*system), 3.0);
    }

    void numbersFromMaterial()
    {
        const Made m = made();
        const auto system = compiled(m.scene);
        QCOMPARE(system->springs.size(), std::size_t(1));
        QCOMPARE(system->rods.size(), std::size_t(1));
        const Spring& spring = system->springs[0];
        QCOMPARE(spring.a, 0);
        QCOMPARE(spring.b, 1);
        QCOMPARE(spring.restLength, 1.0);
        QCOMPARE(spring.stiffness, 120.0);
        QCOMPARE(spring.damping, 0.4);
        QVERIFY(spring.tear.rule == TearRule::Strain && spring.tear.limit == 0.3);
        const Rod& rod = system->rods[0];
        QCOMPARE(rod.compliance, 2e-5);
        QVERIFY(rod.resists == Resists::Tension);
        QVERIFY(rod.tear.rule == TearRule::Strain && rod.tear.limit == 0.3);
        const FabricPanel& panel = system->panels[0];
        const MaterialAir& air = system->materialAir[std::size_t(panel.air)];
        QVERIFY(air.law == AirLaw::Paper);
        QCOMPARE(air.normalCoefficient, 3.0);
        QCOMPARE(air.skinFriction, 0.01);
        QCOMPARE(panel.corner, (std::array{0, 1, 2}));
        QCOMPARE(system->panelKey, std::vector<Key>{Key(m.panel)});
        QCOMPARE(system->tearableSprings.size() + system->tearableRods.size(), std::size_t(2));
    }

    void ownNumbersWin()
    {
        Made m = made();
        Part& part = std::get<Part>(*findItem(m.scene, m.swing));
        Link& spring = *findRow(part.links, m.spring);
        spring.stiffness = 5.0;
        spring.damping = 0.0;
        spring.tearLimit = 0.9;
        findRow(part.links, m.rod)->compliance = 0.0;
        const auto system = compiled(m.scene);
        QCOMPARE(system->springs[0].stiffness, 5.0);
        QCOMPARE(system->springs[0].damping, 0.0);
        QCOMPARE(system->springs[0].tear.limit, 0.9);
        QCOMPARE(system->rods[0].compliance, 0.0);
    }

    // Links keep the author's order whatever order the solver likes, and point at the right rods.
    void linksInOrder()
    {
        const auto scene = build(*findBuilder("hang_glider"), {});
        QVERIFY(bool(scene));
        const auto system = compiled(*scene);
        std::vector<Key> authored;
        forEachPart(*scene, [&](Id, const Part& part) {
            for (const Link& link : part.links)
                authored.push_back(Key(link.id));
        });
        QCOMPARE(system->links.size(), authored.size());
        for (std::size_t l = 0; l < authored.size(); ++l) {
            const LinkPlace& link = system->links[l];
            QCOMPARE(link.key, authored[l]);
            QVERIFY(link.kind == LinkKind::Rod);
            const Rod& rod = system->rods[std::size_t(link.index)];
            QVERIFY(rod.a == link.a && rod.b == link.b);
            QCOMPARE(system->rodLink[std::size_t(link.index)], int(l));
        }
        for (const ShiftedRod& shifted : system->shiftedRods) {
            const Rod& rod = system->rods[std::size_t(shifted.rod)];
            QVERIFY(rod.a == shifted.weight || rod.b == shifted.weight);
            const int anchor = rod.a == shifted.weight ? rod.b : rod.a;
            QVERIFY(isNear(shifted.anchor,
                           system->start.position[std::size_t(anchor)]
                               - system->start.position[std::size_t(shifted.weight)],
                           1e-14));
        }
        QVERIFY(!system->shiftedRods.empty());
    }

    void surroundings()
    {
        Made m = made();
        addWind(m.scene, {3.0, 0.0, 0.0});
        addWind(m.scene, {0.0, 0.5, -1.0});
        Collider ball;
        ball.shape = ColliderShape::Sphere;
        ball.position = {1.0, 2.0, 3.0};
        ball.radius = 0.4;
        ball.response = Response::Slide;
        ball.friction = 0.7;
        addItem(m.scene, ball);
        Collider slope;
        slope.normal = {0.0, 3.0, 4.0};
        addItem(m.scene, slope);
        m.scene.settings.timeStep = 0.002;
        m.scene.settings.substeps = 3;
        m.scene.settings.sweeps = 17;
        m.scene.settings.integrator = Integrator::Verlet;
        m.scene.settings.solver = Solver::PaperJacobi;
        m.scene.settings.gravity = {0.0, -1.62, 0.0};
        m.scene.settings.airDensity = 0.9;
        m.scene.settings.viscosity = 0.3;
        m.scene.settings.speedLimit = 55.0;
        const auto system = compiled(m.scene);
        QCOMPARE(system->wind, Vec3(3.0, 0.5, -1.0));
        QCOMPARE(system->obstacles.size(), std::size_t(2));
        QCOMPARE(system->obstacles[0].position, Vec3(1.0, 2.0, 3.0));
        QCOMPARE(system->obstacles[0].radius, 0.4);
        QVERIFY(system->obstacles[0].response == Response::Slide);
        QCOMPARE(system->obstacles[0].friction, 0.7);
        QVERIFY(isNear(system->obstacles[1].normal, Vec3(0.0, 0.6, 0.8), 1e-15));
        QCOMPARE(system->timeStep, 0.002);
        QCOMPARE(system->substeps, 3);
        QCOMPARE(system->sweeps, 17);
        QVERIFY(system->integrator == Integrator::Verlet);
        QVERIFY(system->solver == Solver::PaperJacobi);
        QCOMPARE(system->gravity, Vec3(0.0, -1.62, 0.0));
        QCOMPARE(system->airDensity, 0.9);
        QCOMPARE(system->viscosity, 0.3);
        QCOMPARE(system->speedLimit, 55.0);
    }

    void controls()
    {
        Made m = made();
        Control hand;
        hand.targets = {m.a};
        hand.axis = {0.0, 0.0, 2.0};
        hand.limit = 0.8;
        hand.rate = 0.25;
        hand.automaticRate = 0.1;
        const Id handId = addItem(m.scene, hand);
        Control weight;
        weight.kind = ControlKind::WeightShift;
        weight.targets = {m.c};
        const Id weightId = addItem(m.scene, weight);
        const auto system = compiled(m.scene);
        QCOMPARE(system->inputs.size(), std::size_t(2));
        QCOMPARE(system->inputs[0].key, Key(handId));
        QCOMPARE(system->inputs[0].axis, Vec3(0.0, 0.0, 1.0));
        QCOMPARE(system->inputs[0].limit, 0.8);
        QCOMPARE(system->inputs[0].rate, 0.25);
        QCOMPARE(system->inputs[0].automaticRate, 0.1);
        QCOMPARE(system->inputs[0].targets, std::vector<int>{0});
        QCOMPARE(system->inputs[1].key, Key(weightId));
        QCOMPARE(system->shiftedRods.size(), std::size_t(1));
        QCOMPARE(system->shiftedRods[0].weight, 2);
        QCOMPARE(system->shiftedRods[0].anchor, Vec3(0.0, 0.0, -1.0));
        QCOMPARE(system->start.inputValue.size(), std::size_t(2));
    }

    void probeTargets()
    {
        Made m = made();
        const Id group = addGroup(m.scene, "some", {m.b, m.spring, m.lone});
        addProbe(m.scene, "all", Quantity::MaxStrain);
        addProbe(m.scene, "one", Quantity::PositionY, m.b);
        addProbe(m.scene, "part", Quantity::MaxTension, m.swing);
        addProbe(m.scene, "group", Quantity::Speed, group);
        addProbe(m.scene, "line", Quantity::Elevation, m.c, m.a);
        addProbe(m.scene, "panel", Quantity::AirForce, addGroup(m.scene, "sail", {m.panel}));
        const auto system = compiled(m.scene);
        QCOMPARE(system->probes.size(), std::size_t(6));
        const auto& p = system->probes;
        QCOMPARE(p[0].particles, (std::vector<int>{0, 1, 2, 3}));
        QCOMPARE(p[0].links, (std::vector<int>{0, 1}));
        QCOMPARE(p[0].panels, std::vector<int>{0});
        QCOMPARE(p[1].particles, std::vector<int>{1});
        QCOMPARE(p[2].particles, (std::vector<int>{0, 1, 2}));
        QCOMPARE(p[2].links, (std::vector<int>{0, 1}));
        QCOMPARE(p[3].particles, (std::vector<int>{1, 3}));
        QCOMPARE(p[3].links, std::vector<int>{0});
        QCOMPARE(p[4].particles, std::vector<int>{2});
        QCOMPARE(p[4].from, 0);
        QCOMPARE(p[5].panels, std::vector<int>{0});
        QCOMPARE(QString::fromStdString(p[4].name), QString("line"));
    }

    void refused_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what :
             {"dangling end", "no mass", "link from a particle to itself", "panel with two corners",
              "plane without normal", "control without axis", "twice the same id"})
            QTest::newRow(what) << QString(what);
    }

    // A scene that cannot run is refused with a sentence, not run and not crashed on. (Numbers out
    // of range never get into a scene: edits and files refuse them.)
    void refused()
    {
        QFETCH(QString, what);
        Made m = made();
        Part& part = std::get<Part>(*findItem(m.scene, m.swing));
        if (what == "dangling end")
            part.links[0].to = Id(4711);
        else if (what == "no mass")
            part.particles[1].mass = 0.0;
        else if (what == "link from a particle to itself")
            part.links[0].to = part.links[0].from;
        else if (what == "panel with two corners")
            part.panels[0].c = part.panels[0].a;
        else if (what == "plane without normal")
            std::get<Collider>(*findItem(m.scene, addGround(m.scene))).normal.setZero();
        else if (what == "control without axis")
            std::get<Control>(*findItem(m.scene, addItem(m.scene, Control{}))).axis.setZero();
        else
            part.links[0].id = part.particles[0].id;
        const auto system = compile(m.scene);
        QVERIFY2(!system, "refused");
        QVERIFY(!system.message().empty());
    }

    // Deterministic: the same scene makes the same system, and the same motion, each time.
    void again()
    {
        const auto scene = build(*findBuilder("delta_kite"), {});
        QVERIFY(bool(scene));
        QCOMPARE(stateHash(run(*compiled(*scene), 50)), stateHash(run(*compiled(*scene), 50)));
    }
};

const RegisteredTest registered("test_compile", runPlain<TestCompile>);

} // namespace ripstop::test_compile
#include "test_compile.moc"
