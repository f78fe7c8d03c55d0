// Problems: each is found once, points at its culprit, and says what to do.
//
// Stages: a sound scene has none; then each problem is made once and has to be found once; the
// order and number of what is told; then the longest time step of springs, against chains by hand.
#include "check/check.h"
#include "check/step_check.h"
#include "registered_test.h"

#include "laws/step_limit.h"

#include "scene/edit.h"

#include <QtTest>

#include <cmath>
#include <functional>

Q_DECLARE_METATYPE(std::function<void(ripstop::Scene&)>)

namespace ripstop::test_check {

namespace {

using Break = std::function<void(Scene&)>;

constexpr Id partId{1};
constexpr Id materialId{2};

// Three particles, three rods, a panel: nothing to complain about.
Scene sound()
{
    Part part{"sail"};
    part.particles = {{Id{11}, {0, 0, 0}}, {Id{12}, {1, 0, 0}}, {Id{13}, {0, 1, 0}}};
    part.links = {{Id{21}, Id{11}, Id{12}, materialId},
                  {Id{22}, Id{12}, Id{13}, materialId},
                  {Id{23}, Id{13}, Id{11}, materialId}};
    part.panels = {{Id{31}, Id{11}, Id{12}, Id{13}, materialId}};
    Scene scene;
    scene.items = {{partId, part}, {materialId, Material{"fabric"}}};
    scene.nextId = Id{40};
    return scene;
}

Material& materialIn(Scene& scene) { return std::get<Material>(*findItem(scene, materialId)); }

Part& part(Scene& scene) { return std::get<Part>(*findItem(scene, partId)); }

template <typename T>
void addItem(Scene& scene, T item)
{
    scene.items.push_back({Id{40}, std::move(item)});
    scene.nextId = Id{41};
}

Control control()
{
    Control c;
    c.targets = {Id{11}};
    return c;
}

} // namespace

class TestCheck : public QObject
{
    Q_OBJECT

    static constexpr bool error = true;
    static constexpr bool warning = false;

private slots:
    void aSoundSceneHasNoProblems()
    {
        QVERIFY(problemsOf(sound()).empty());
        QVERIFY(!hasErrors({}));
    }

    void findsEachOnce_data()
    {
        QTest::addColumn<Break>("spoil");
        QTest::addColumn<bool>("isError");
        QTest::addColumn<quint32>("culprit");
        QTest::addColumn<QString>("says");

        const auto row = [](const char* name, bool isError, quint32 culprit, const char* says,
                            Break spoil) {
            QTest::newRow(name) << spoil << isError << culprit << QString(says);
        };

        row("empty scene", warning, 0, "no particles", [](Scene& s) { s.items.clear(); });

        row("bdf2 on single sweeps", warning, 0, "choose the automatic solver", [](Scene& s) {
            s.settings.integrator = Integrator::Bdf2;
            s.settings.solver = Solver::SmallSteps;
        });
        row("line of no stiffness that there is", error, 2, "Axial stiffness of material fabric",
            [](Scene& s) { materialIn(s).axialStiffness = 1e30; });
        row("spar of no stiffness that there is", error, 2, "above 1e+12 N m",
            [](Scene& s) { materialIn(s).flexuralRigidity = 2e12; });
        row("cloth that bends like nothing that there is", error, 2,
            "Bending stiffness of material",
            [](Scene& s) { materialIn(s).bendingStiffness = 1e30; });
        row("panel on the corners of another", warning, 32, "same three corners as panel 31",
            [](Scene& s) {
                part(s).panels.push_back({Id{32}, Id{12}, Id{13}, Id{11}, materialId});
            });
        row("grams for kilograms", warning, 2, "type 47 g/m^2, which is 0.047 kg",
            [](Scene& s) { materialIn(s).arealDensity = 47.0; });
        row("rod that does not fit", warning, 22, "are 41.4 % off from its length",
            [](Scene& s) { part(s).particles[1].pinned = part(s).particles[2].pinned = true; });
        row("link without its rest length", warning, 22, "its rest length is 0.1 m",
            [](Scene& s) { part(s).links[1].restLength = 0.1; });
        row("control that is slower than it is to be", warning, 40, "rate lets it move at 0.5 m/s",
            [](Scene& s) {
                Control c = control();
                c.rate = 0.5;
                c.automaticRate = -2.0;
                addItem(s, c);
            });
        row("two of a name", warning, 40, "#2 and #40 are both called fabric",
            [](Scene& s) { addItem(s, Material{"fabric"}); });
        row("storm", warning, 40, "speed limit of 1000 m/s", [](Scene& s) {
            addItem(s, Wind{"gale", Vec3(0.0, 0.0, 1e30)});
        });
        row("gust before the last has ended", error, 40, "comes again after 2 s", [](Scene& s) {
            Wind gust{"gust", {9.0, 0.0, 0.0}, WindKind::DiscreteGust};
            gust.interval = 2.0;
            addItem(s, gust);
        });
        row("gust of few steps", warning, 40, "less than ten steps", [](Scene& s) {
            Wind gust{"gust", {9.0, 0.0, 0.0}, WindKind::DiscreteGust};
            gust.duration = 0.01;
            addItem(s, gust);
        });
        row("link to nothing", error, 21, "from points at 99, which does not exist",
            [](Scene& s) { part(s).links[0].from = Id{99}; });
        row("link to a panel", error, 22, "to points at 31, which is a panel",
            [](Scene& s) { part(s).links[1].to = Id{31}; });
        row("link of no material", error, 21, "material points at 99",
            [](Scene& s) { part(s).links[0].material = Id{99}; });
        row("panel to nothing", error, 31, "b points at 99, which does not exist",
            [](Scene& s) { part(s).panels[0].b = Id{99}; });
        row("panel of a part", error, 31, "material points at 1, which is a part",
            [](Scene& s) { part(s).panels[0].material = partId; });
        row("group of nothing", error, 40, "members points at 99", [](Scene& s) {
            addItem(s, Group{"corners", {Id{11}, Id{99}}});
        });
        row("control of a link", error, 40, "targets points at 21, which is a link", [](Scene& s) {
            Control c = control();
            c.targets.push_back(Id{21});
            addItem(s, c);
        });
        row("control of no id", error, 40, "targets points at 0, which does not exist",
            [](Scene& s) {
                Control c = control();
                c.targets.push_back(noId);
                addItem(s, c);
            });
        row("probe of nothing", error, 40, "target points at 99", [](Scene& s) {
            addItem(s, Probe{"p", Quantity::PositionY, Id{99}});
        });

        row("link from itself to itself", error, 22, "two different particles",
            [](Scene& s) { part(s).links[1].to = Id{12}; });
        row("link with one end", error, 22, "two different particles",
            [](Scene& s) { part(s).links[1].from = noId; });
        row("panel with a corner twice", error, 31, "three different particles",
            [](Scene& s) { part(s).panels[0].c = Id{11}; });
        row("panel with two corners", error, 31, "three different particles",
            [](Scene& s) { part(s).panels[0].c = noId; });

        row("particle without mass", error, 12, "no mass",
            [](Scene& s) { part(s).particles[1].mass = 0.0; });
        row("particle of negative mass", error, 12, "no mass",
            [](Scene& s) { part(s).particles[1].mass = -1.0; });
        row("particle whose mass is no number", error, 12, "no mass",
            [](Scene& s) { part(s).particles[1].mass = std::nan(""); });

        row("two particles of one id", error, 12, "id 12 is used twice", [](Scene& s) {
            part(s).particles.insert(part(s).particles.begin() + 1, Particle{.id = Id{12}});
        });
        row("item with the id of an element", error, 21, "id 21 is used twice", [](Scene& s) {
            s.items.push_back({Id{21}, Wind{}});
        });

        row("plane without a normal", error, 40, "normal that is not zero", [](Scene& s) {
            Collider c;
            c.normal = Vec3::Zero();
            addItem(s, c);
        });
        row("control without an axis", error, 40, "axis that is not zero", [](Scene& s) {
            Control c = control();
            c.axis = Vec3::Zero();
            addItem(s, c);
        });
        row("control without targets", warning, 40, "no targets",
            [](Scene& s) { addItem(s, Control{"pull"}); });
        row("distance from nowhere", warning, 40, "a particle to measure from", [](Scene& s) {
            addItem(s, Probe{"d", Quantity::Distance, Id{11}});
        });
        row("elevation of nothing", warning, 40, "a particle to measure from", [](Scene& s) {
            addItem(s, Probe{"e", Quantity::Elevation, noId, Id{11}});
        });

        row("two links between the same", warning, 24, "joined already", [](Scene& s) {
            part(s).links.push_back({Id{24}, Id{12}, Id{11}});
        });
        row("particle without links", warning, 14, "no links",
            [](Scene& s) { part(s).particles.push_back({Id{14}}); });

        row("flag in one plane with the wind", warning, 1, "does not flutter", [](Scene& s) {
            addItem(s, Wind{.velocity = {6.0, 0.0, 0.0}});
        });

        row("time step above the limit", warning, 13, "shorten the time step", [](Scene& s) {
            s.settings.integrator = Integrator::SemiImplicitEuler;
            s.settings.timeStep = 0.1;
            s.settings.substeps = 1;
            part(s).links[1].kind = LinkKind::Spring;
            part(s).particles[2].mass = 1e-3;
        });
    }

    void findsEachOnce()
    {
        QFETCH(Break, spoil);
        QFETCH(bool, isError);
        QFETCH(quint32, culprit);
        QFETCH(QString, says);
        Scene scene = sound();
        spoil(scene);
        const std::vector<Finding> problems = problemsOf(scene);
        QStringList messages;
        for (const Finding& problem : problems)
            messages << QString::fromStdString(problem.message.english());
        QVERIFY2(problems.size() == 1, qPrintable(messages.join('\n')));
        QCOMPARE(problems[0].severity == Severity::Error, isError);
        QCOMPARE(hasErrors(problems), isError);
        QCOMPARE(quint32(problems[0].culprit()), culprit);
        const QString& message = messages[0];
        QVERIFY2(message.contains(says), qPrintable(message));
        // a sentence
        QVERIFY2(message.front().isUpper(), qPrintable(message));
        QVERIFY2(message.endsWith('.'), qPrintable(message));
    }

    void allowed_data()
    {
        QTest::addColumn<Break>("change");
        const auto row = [](const char* name, Break change) { QTest::newRow(name) << change; };

        row("pinned particle without mass", [](Scene& s) {
            part(s).particles[0].mass = 0.0;
            part(s).particles[0].pinned = true;
        });
        row("links without material", [](Scene& s) { part(s).links[0].material = noId; });
        row("pinned particle without links",
            [](Scene& s) { part(s).particles.push_back({.id = Id{14}, .pinned = true}); });
        row("particles of a part without links", [](Scene& s) {
            Part dust{"dust"};
            dust.particles = {{Id{50}}, {Id{51}}};
            addItem(s, dust);
        });
        row("link to another part", [](Scene& s) {
            Part tail{"tail"};
            tail.particles = {{Id{50}}};
            tail.links = {{Id{51}, Id{50}, Id{13}}};
            addItem(s, tail);
        });
        row("corner of an elastic panel without links", [](Scene& s) {
            Part& sail = part(s);
            sail.carrier = FabricKind::Panels;
            std::get<Material>(*findItem(s, materialId)).membraneStiffness = 4e4;
            sail.links.pop_back();
            sail.links.pop_back();
        });
        row("felt", [](Scene& s) { materialIn(s).arealDensity = 9.9; });
        row("panels side by side", [](Scene& s) {
            part(s).particles.push_back({Id{14}, {1, 1, 0}});
            part(s).links.push_back({Id{24}, Id{14}, Id{12}, materialId});
            part(s).panels.push_back({Id{32}, Id{12}, Id{13}, Id{14}, materialId});
        });
        row("sphere without a normal", [](Scene& s) {
            Collider ball;
            ball.shape = ColliderShape::Sphere;
            ball.normal = Vec3::Zero();
            ball.position.x() = 5.0;
            addItem(s, ball);
        });
        row("flag in a wind from aside", [](Scene& s) {
            addItem(s, Wind{.velocity = {6.0, 0.0, 0.1}});
        });
        row("flag that no air pushes", [](Scene& s) {
            addItem(s, Wind{.velocity = {6.0, 0.0, 0.0}});
            std::get<Material>(*findItem(s, materialId)).airLaw = AirLaw::None;
        });
        row("flag in gusts", [](Scene& s) {
            addItem(s, Wind{.velocity = {6.0, 0.0, 0.0}, .kind = WindKind::Gusts});
        });
        row("flag that is pushed aside", [](Scene& s) {
            addItem(s, Wind{.velocity = {6.0, 0.0, 0.0}});
            part(s).particles[1].velocity = {0.0, 0.0, 0.1};
        });
        row("sheet that falls across the wind", [](Scene& s) {
            addItem(s, Wind{.velocity = {6.0, 0.0, 0.0}});
            s.settings.gravity = {0.0, 0.0, -9.80665};
        });
        row("probe of the whole scene", [](Scene& s) {
            addItem(s, Probe{"energy", Quantity::TotalEnergy});
        });
    }

    void allowed()
    {
        QFETCH(Break, change);
        Scene scene = sound();
        change(scene);
        const std::vector<Finding> problems = problemsOf(scene);
        QVERIFY2(problems.empty(), problems.empty() ? "" : problems[0].message.english().c_str());
    }

    void errorsComeFirst()
    {
        Scene scene = sound();
        part(scene).particles.push_back({Id{14}}); // a warning, found last
        addItem(scene, Control{"pull"});           // a warning
        part(scene).links[0].from = Id{99};        // an error
        part(scene).particles[2].mass = 0.0;       // an error
        const std::vector<Finding> problems = problemsOf(scene);
        bool warned = false;
        int errors = 0;
        for (const Finding& problem : problems) {
            warned |= problem.severity == Severity::Warning;
            QVERIFY(!warned || problem.severity == Severity::Warning);
            errors += problem.severity == Severity::Error;
        }
        QCOMPARE(errors, 2);
    }

    // A broken table of many rows stays readable, and other sorts are still seen.
    void atMostSomeOfEachSort()
    {
        Scene scene = sound();
        for (std::uint32_t i = 0; i < 1000; ++i)
            part(scene).links.push_back({Id{100 + i}, Id{5000}, Id{11}});
        part(scene).particles[2].mass = 0.0;
        const std::vector<Finding> problems = problemsOf(scene, 5);
        int dangling = 0;
        int massless = 0;
        for (const Finding& problem : problems) {
            dangling += problem.message.english().find("does not exist") != std::string::npos;
            massless += problem.message.english().find("no mass") != std::string::npos;
        }
        QCOMPARE(dangling, 5);
        QCOMPARE(massless, 1);
    }

    // A particle that is gone leaves links dangling; removal() does not.
    void removalCausesNoErrors()
    {
        Scene scene = sound();
        (void)apply(scene, removal(scene, {Id{12}}));
        QVERIFY(!hasErrors(problemsOf(scene)));
    }

    // T-S2: (w h)^2 + 2 c h < 4; a particle of 1 kg with w = 10 1/s has K = w^2 / 2, N = c / 2.
    void dampingShortensTheLimit_data()
    {
        QTest::addColumn<double>("c");     // 1/s
        QTest::addColumn<double>("limit"); // s
        QTest::newRow("S2 undamped") << 0.0 << 0.200000;
        QTest::newRow("S2 c = 1") << 1.0 << 0.190250;
        QTest::newRow("S2 c = 5") << 5.0 << 0.156155;
        QTest::newRow("S2 c = 20") << 20.0 << 0.082843;
    }

    void dampingShortensTheLimit()
    {
        QFETCH(double, c);
        QFETCH(double, limit);
        QVERIFY(std::abs(springStepLimit(1.0, 50.0, 0.5 * c, Integrator::SemiImplicitEuler) - limit)
                < 1e-6);
        QCOMPARE(springStepLimit(1.0, 0.0, 0.5, Integrator::SemiImplicitEuler),
                 2.0); // a damper alone: h < 2 / c
    }

    void noLimitWithoutSprings() { QVERIFY(!stepLimit(sound())); }

    void stepLimitOfAChain_data()
    {
        QTest::addColumn<double>("mass");      // kg
        QTest::addColumn<double>("stiffness"); // N/m
        QTest::addColumn<double>("expected");  // s
        QTest::addColumn<double>("tolerance"); // 1

        // Two springs meet at each inner particle: h = sqrt(2 m / 2 k) = sqrt(m / k).
        QTest::newRow("unit chain") << 1.0 << 1.0 << 1.0 << 1e-12;
        QTest::newRow("1 g, 1 kN/m") << 1e-3 << 1e3 << 1e-3 << 1e-12;
        // Dyneema 4 mm, EA 614600 N, 9.10 g/m, cut into segments (validation 2.4).
        QTest::newRow("Dyneema, 10 m") << 9.10e-2 << 61460.0 << 1.22e-3 << 5e-3;
        QTest::newRow("Dyneema, 1 m") << 9.10e-3 << 614600.0 << 1.22e-4 << 5e-3;
        QTest::newRow("Dyneema, 0.1 m") << 9.10e-4 << 6146000.0 << 1.22e-5 << 5e-3;
    }

    void stepLimitOfAChain()
    {
        QFETCH(double, mass);
        QFETCH(double, stiffness);
        QFETCH(double, expected);
        QFETCH(double, tolerance);
        Part rope{"rope"};
        for (std::uint32_t i = 0; i < 6; ++i)
            rope.particles.push_back(
                {.id = Id{10 + i}, .position = Vec3(i, 0.0, 0.0), .mass = mass});
        for (std::uint32_t i = 0; i < 5; ++i) {
            Link link{Id{20 + i}, Id{10 + i}, Id{11 + i}};
            link.kind = LinkKind::Spring;
            link.stiffness = stiffness;
            rope.links.push_back(link);
        }
        Scene scene;
        scene.settings.integrator = Integrator::SemiImplicitEuler;
        scene.items = {{partId, rope}};

        const auto limit = stepLimit(scene);
        QVERIFY(limit);
        QVERIFY2(std::abs(limit->timeStep / expected - 1.0) < tolerance,
                 qPrintable(QString::number(limit->timeStep)));

        // the warning appears on one side of the limit only
        scene.settings.substeps = 3;
        scene.settings.timeStep = 3.0 * 0.999 * limit->timeStep;
        QVERIFY(problemsOf(scene).empty());
        scene.settings.timeStep = 3.0 * 1.001 * limit->timeStep;
        QCOMPARE(problemsOf(scene).size(), std::size_t(1));
    }

    // h = sqrt(2 m / sum k), the least over the free particles. By hand:
    // 11: 2 x 0.5 / (100 + 300) = 0.0025; 12: 2 x 0.02 / 100 = 0.0004; 13 is pinned.
    void stepLimitTakesTheWorstFreeParticle()
    {
        Scene scene = sound();
        Part& sail = part(scene);
        sail.particles[0].mass = 0.5;
        sail.particles[1].mass = 0.02;
        sail.particles[2].mass = 1e-9;
        sail.particles[2].pinned = true;
        std::get<Material>(*findItem(scene, materialId)).stiffness = 100.0;
        sail.links[0].kind = LinkKind::Spring; // 11-12, the material's 100 N/m
        sail.links[1] = {Id{22}, Id{11}, Id{13}, materialId, LinkKind::Spring};
        sail.links[1].stiffness = 300.0;          // its own
        sail.links[2] = {Id{23}, Id{12}, Id{13}}; // a rod counts for nothing
        const auto limit = stepLimit(scene);
        QVERIFY(limit);
        QVERIFY(limit->particle == Id{12});
        QVERIFY(std::abs(limit->timeStep - 0.02) < 1e-15);
    }

    void springWithoutStiffnessHasNoLimit()
    {
        Scene scene = sound();
        part(scene).links[0].kind = LinkKind::Spring;
        part(scene).links[0].stiffness = 0.0;
        QVERIFY(!stepLimit(scene));
    }
};

const RegisteredTest registered("test_check", runPlain<TestCheck>);

} // namespace ripstop::test_check
#include "test_check.moc"
