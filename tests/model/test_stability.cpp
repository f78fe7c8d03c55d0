// What is told of a design before its first step, and what repairs do.
//
// Stages: a sound chain; then each reason by which a design is poor (time step, mass ratio,
// iterations, lengths, tears at once, loose or double elements) with its measure by hand and what
// its repair does.
#include "author/stability.h"
#include "check/check.h"
#include "compile/compile.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <cmath>
#include <functional>

namespace ripstop::test_stability {

namespace {

using Change = std::function<void(Scene&)>;

constexpr Id partId{1};
constexpr Id materialId{2};

// A chain of `count` particles 1 m apart, 10 g each, with rods between them; the first is pinned.
// Particles have ids from 100, links from 1000.
Scene chain(int count)
{
    Part part;
    part.name = "rope";
    for (int i = 0; i < count; ++i)
        part.particles.push_back({.id = Id{100u + unsigned(i)},
                                  .position = Vec3(i, 0, 0),
                                  .mass = 0.01,
                                  .pinned = i == 0});
    for (int i = 0; i + 1 < count; ++i)
        part.links.push_back({.id = Id{1000u + unsigned(i)},
                              .from = Id{100u + unsigned(i)},
                              .to = Id{101u + unsigned(i)},
                              .material = materialId});
    Scene scene;
    scene.settings.substeps = 1;
    scene.settings.solver = Solver::GaussSeidel;
    scene.items = {{partId, part}, {materialId, Material{"cord"}}};
    scene.nextId = Id{2000};
    return scene;
}

// Four particles, the upper two pinned, with rods around and across, and two panels.
Scene square()
{
    Part part{"sheet"};
    const auto particle = [](std::uint32_t id, const Vec3& place, bool pinned) {
        return Particle{.id = Id{id}, .position = place, .mass = 0.01, .pinned = pinned};
    };
    part.particles = {particle(100, {0.0, 2.0, 0.0}, true), particle(101, {1.0, 2.0, 0.0}, true),
                      particle(102, {0.0, 1.0, 0.0}, false), particle(103, {1.0, 1.0, 0.0}, false)};
    const auto rod = [](std::uint32_t id, std::uint32_t from, std::uint32_t to, double length) {
        return Link{.id = Id{id},
                    .from = Id{from},
                    .to = Id{to},
                    .material = materialId,
                    .restLength = length};
    };
    part.links = {rod(1000, 100, 102, 1.0), rod(1001, 101, 103, 1.0), rod(1002, 102, 103, 1.0),
                  rod(1003, 100, 103, std::sqrt(2.0))};
    part.panels = {{Id{1500}, Id{100}, Id{102}, Id{103}, materialId},
                   {Id{1501}, Id{100}, Id{103}, Id{101}, materialId}};
    Scene scene;
    scene.items = {{partId, part}, {materialId, Material{"cloth"}}};
    scene.nextId = Id{2000};
    return scene;
}

Part& part(Scene& scene) { return std::get<Part>(*findItem(scene, partId)); }
Material& cord(Scene& scene) { return std::get<Material>(*findItem(scene, materialId)); }

std::optional<Finding> about(const Scene& scene, std::string_view subject,
                             Severity severity = Severity::Warning)
{
    for (Finding& finding : stabilityOf(scene))
        if (finding.subject.english() == subject && finding.severity == severity)
            return finding;
    return std::nullopt;
}

bool isPoor(const Scene& scene, std::string_view subject)
{
    return about(scene, subject).has_value();
}

// The scene after the repair, whose inverse leads back.
void repair(Scene& scene, std::string_view subject)
{
    const auto finding = about(scene, subject);
    QVERIFY(finding && finding->repair);
    const Scene before = scene;
    const Edit inverse = apply(scene, *finding->repair);
    QVERIFY(!isPoor(scene, subject));
    const Scene repaired = scene;
    const Edit again = apply(scene, inverse);
    scene.nextId = before.nextId;
    QVERIFY(scene == before);
    scene = repaired;
    (void)again;
}

} // namespace

class TestStability : public QObject
{
    Q_OBJECT

private slots:
    void aSoundChainIsGood()
    {
        for (const Finding& finding : stabilityOf(chain(5)))
            QVERIFY2(finding.severity == Severity::Fine, finding.message.english().c_str());
        QVERIFY(stabilityOf(Scene()).empty());
    }

    // Undamped, a spring k between a pinned and a free mass m holds to h < 2 sqrt(m / k); the bound
    // of laws/step_limit.h is sqrt(2 m / K), K the sum of both springs at an inner particle.
    void timeStep()
    {
        Scene scene = chain(4);
        for (Link& link : part(scene).links)
            link.kind = LinkKind::Spring;
        cord(scene).stiffness = 100.0; // N/m: inner ones hold to 10 ms, the last one to 14 ms
        cord(scene).damping = 0.0;
        scene.settings.timeStep = 0.009;
        QVERIFY(!isPoor(scene, "Time step"));
        scene.settings.timeStep = 0.012;
        QVERIFY(about(scene, "Time step")->culprits == (std::vector{Id{101}, Id{102}}));
        scene.settings.timeStep = 0.03;
        QVERIFY(about(scene, "Time step")->culprits == (std::vector{Id{101}, Id{102}, Id{103}}));
        repair(scene, "Time step");
        QVERIFY(scene.settings.substeps >= 3);
    }

    void timeStepNamesWhatIsThere_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::addColumn<double>("rigidity"); // N m^2
        QTest::addColumn<QString>("named");

        QTest::newRow("springs") << LinkKind::Spring << 0.0 << "springs";
        QTest::newRow("rods that bend") << LinkKind::Rod << 1.0 << "bending";
        QTest::newRow("springs that bend") << LinkKind::Spring << 1.0 << "springs and bending";
    }

    // Neither of them is spoken of where it is not.
    void timeStepNamesWhatIsThere()
    {
        QFETCH(LinkKind, kind);
        QFETCH(double, rigidity);
        QFETCH(QString, named);
        Scene scene = chain(4);
        for (Link& link : part(scene).links)
            link.kind = kind;
        cord(scene).stiffness = 100.0; // N/m
        cord(scene).flexuralRigidity = rigidity;
        scene.settings.timeStep = 1e-4;
        const auto fine = about(scene, "Time step", Severity::Fine);
        QVERIFY(fine);
        QVERIFY2(QString::fromStdString(fine->message.english()).endsWith(" s for " + named + "."),
                 fine->message.english().c_str());

        scene.settings.timeStep = 0.5;
        const std::vector<Finding> problems = problemsOf(scene);
        QCOMPARE(problems.size(), std::size_t(1));
        QVERIFY2(QString::fromStdString(problems[0].message.english())
                     .contains(" may need for " + named + ": shorten"),
                 problems[0].message.english().c_str());
    }

    void staysFlat_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("isTold");
        const auto row = [](const char* name, bool isTold, Change change) {
            QTest::newRow(name) << change << isTold;
        };
        row("hangs by its upper edge", true, [](Scene&) {});
        row("a calm", true, [](Scene& s) { s.items.push_back({Id{500}, Wind{}}); });
        row("a floor below", true, [](Scene& s) { s.items.push_back({Id{500}, Collider{}}); });
        row("pulled within the plane", true, [](Scene& s) {
            s.items.push_back({Id{500}, Control{}});
        });
        row("wind in a vacuum", true, [](Scene& s) {
            s.items.push_back({Id{500}, Wind{.velocity = {0.0, 0.0, 1.0}}});
            s.settings.airDensity = 0.0;
        });
        row("wind across", false, [](Scene& s) {
            s.items.push_back({Id{500}, Wind{.velocity = {0.0, 0.0, 0.1}}});
        });
        row("gusts", false, [](Scene& s) {
            s.items.push_back({Id{500}, Wind{.kind = WindKind::Gusts}});
        });
        row("speed aside", false, [](Scene& s) {
            part(s).particles[3].velocity = {0.0, 0.0, 1e-3};
        });
        row("a corner aside", false, [](Scene& s) { part(s).particles[3].position.z() = 1e-6; });
        row("another part aside", false, [](Scene& s) {
            Part weight{"weight"};
            weight.particles = {{.id = Id{600}, .position = {0.0, 0.0, 0.5}, .mass = 1.0}};
            s.items.push_back({Id{500}, weight});
        });
        row("a ball in its way", false, [](Scene& s) {
            s.items.push_back({Id{500}, Collider{.shape = ColliderShape::Sphere}});
        });
        row("pulled aside", false, [](Scene& s) {
            s.items.push_back({Id{500}, Control{.axis = {0.0, 0.0, 1.0}}});
        });
        row("lies level", false, [](Scene& s) {
            for (Particle& particle : part(s).particles)
                particle.position = {particle.position.x(), 0.0, particle.position.y()};
        });
        row("weightless", false, [](Scene& s) { s.settings.gravity = Vec3::Zero(); });
        row("a rope, which has no sides", false, [](Scene& s) { part(s).panels.clear(); });
    }

    // A square of cloth hangs in the plane z = 0. What is told to stay in it does, to the last
    // digit; of what is pushed aside it is not told.
    void staysFlat()
    {
        QFETCH(Change, change);
        QFETCH(bool, isTold);
        Scene scene = square();
        change(scene);
        const std::vector<Finding> findings = stabilityOf(scene);
        const auto flat = std::ranges::find(findings, "flat", &Finding::sort);
        QCOMPARE(flat != findings.end(), isTold);
        if (!isTold)
            return;
        QCOMPARE(flat->severity, Severity::Fine);
        QCOMPARE(flat->culprits, std::vector{partId});
        const auto system = compile(scene);
        QVERIFY(bool(system));
        Simulation simulation(*system);
        QVERIFY(simulation.runUntil(1.0));
        for (const Vec3& place : simulation.state().position)
            QCOMPARE(place.z(), 0.0);
    }

    // One sweep finds the pull of a rod of compliance c too soft by (wa + wb) h^2 / c: 10 g at both
    // ends, h = 1 ms and c = 1e-3 m/N make it 20 %; 40 sweeps as much less.
    void softness()
    {
        Scene scene = chain(4);
        for (Link& link : part(scene).links) {
            link.kind = LinkKind::Rod;
            link.compliance = 1e-3;
        }
        scene.settings.solver = Solver::Auto;
        QVERIFY(about(scene, "Stiffness", Severity::Fine));
        scene.settings.timeStep = 1e-3;
        scene.settings.substeps = 1;
        scene.settings.solver = Solver::SmallSteps;
        QVERIFY(isPoor(scene, "Stiffness"));
        QVERIFY(about(scene, "Stiffness")->message.english().find("1.2 times")
                != std::string::npos);
        scene.settings.accuracy = 25.0; // %
        QVERIFY(!isPoor(scene, "Stiffness"));
        scene.settings.accuracy = 1.0;
        scene.settings.solver = Solver::GaussSeidel;
        scene.settings.sweeps = 40;
        QVERIFY(!isPoor(scene, "Stiffness"));
        scene.settings.sweeps = 10;
        repair(scene, "Stiffness");
        QVERIFY(scene.settings.solver == Solver::Auto);
        for (Link& link : part(scene).links)
            link.compliance = 0.0; // what never stretches is told of by its strain
        scene.settings.solver = Solver::SmallSteps;
        QVERIFY(!isPoor(scene, "Stiffness") && !about(scene, "Stiffness", Severity::Fine));
    }

    void massRatio()
    {
        Scene scene = chain(4);
        part(scene).particles[2].mass = 0.01 * mostMassRatio * 1.5;
        QVERIFY(about(scene, "Masses")->culprits == (std::vector{Id{1001}, Id{1002}}));
        scene.settings.solver = Solver::Direct;
        QVERIFY(!isPoor(scene, "Masses"));
        scene.settings.solver = Solver::GaussSeidel;
        part(scene).particles[2].pinned = true; // what is pinned is as heavy as the earth
        QVERIFY(!isPoor(scene, "Masses"));
        part(scene).particles[2].pinned = false;
        repair(scene, "Masses");
    }

    // A Jacobi sweep passes a pull on by one link.
    void iterations()
    {
        Scene scene = chain(31);
        scene.settings.solver = Solver::AveragedJacobi;
        scene.settings.sweeps = 30;
        QVERIFY(!isPoor(scene, "Iterations"));
        scene.settings.sweeps = 29;
        QVERIFY(isPoor(scene, "Iterations"));
        scene.settings.substeps = 2;
        QVERIFY(!isPoor(scene, "Iterations"));
        scene.settings.sweeps = 5;
        repair(scene, "Iterations");
        QCOMPARE(scene.settings.sweeps, 15);
        scene.settings.sweeps = 5;
        scene.settings.solver = Solver::Direct;
        QVERIFY(!isPoor(scene, "Iterations"));
    }

    void lengthOfTheNetwork()
    {
        QCOMPARE(networkLength(Scene()), 0);
        QCOMPARE(networkLength(chain(2)), 1);
        QCOMPARE(networkLength(chain(31)), 30);
        Scene ring = chain(10); // across a ring of ten it is five
        part(ring).links.push_back(
            {.id = Id{1500}, .from = Id{109}, .to = Id{100}, .material = materialId});
        QCOMPARE(networkLength(ring), 5);
        Scene two = chain(10); // of two pieces the longer one counts
        part(two).links.erase(part(two).links.begin() + 6);
        QCOMPARE(networkLength(two), 6);
    }

    void lengthsAtTheStart()
    {
        Scene scene = chain(4);
        part(scene).links[1].restLength = 0.96; // 4 % longer at the start
        QVERIFY(!isPoor(scene, "Lengths"));
        part(scene).links[1].restLength = 0.9;
        QVERIFY(about(scene, "Lengths")->culprits == std::vector{Id{1001}});
        repair(scene, "Lengths");
        QCOMPARE(part(scene).links[1].restLength, 1.0);
        part(scene).links[1].restLength = 0.9;
        part(scene).links[1].resists = Resists::Compression; // it hangs loose
        QVERIFY(!isPoor(scene, "Lengths"));
        // what is pressed together springs back as what is drawn out does
        part(scene).links[1].restLength = 1.7;
        QVERIFY(about(scene, "Lengths")->culprits == std::vector{Id{1001}});
        part(scene).links[1].resists = Resists::Both;
        QVERIFY(about(scene, "Lengths")->culprits == std::vector{Id{1001}});
        part(scene).links[1].resists = Resists::Tension;
        QVERIFY(!isPoor(scene, "Lengths"));
    }

    void whatTearsAtOnce()
    {
        Scene scene = chain(4);
        cord(scene).tearRule = TearRule::Length;
        cord(scene).tearLimit = 1.5; // m
        QVERIFY(!isPoor(scene, "Tearing"));
        part(scene).links[2].tearLimit = 0.9; // a limit of its own
        QVERIFY(about(scene, "Tearing")->culprits == std::vector{Id{1002}});
        cord(scene).tearRule = TearRule::Strain;
        cord(scene).tearLimit = 0.1;
        part(scene).links[2].tearLimit = {};
        QVERIFY(!isPoor(scene, "Tearing"));
        part(scene).links[0].restLength = 0.8; // 25 % at the start
        QVERIFY(about(scene, "Tearing")->culprits == std::vector{Id{1000}});
        // 25 % of a cord of 1 kN are 250 N
        cord(scene).tearRule = TearRule::Strength;
        cord(scene).axialStiffness = 1000.0;
        cord(scene).lineStrength = 260.0;
        QVERIFY(!isPoor(scene, "Tearing"));
        cord(scene).jointEfficiency = 0.9;
        QVERIFY(about(scene, "Tearing")->culprits == std::vector{Id{1000}});
    }

    void looseMasslessAndDouble()
    {
        Scene scene = chain(4);
        part(scene).particles.push_back({.id = Id{1600}});
        QVERIFY(about(scene, "Loose particles")->culprits == std::vector{Id{1600}});
        repair(scene, "Loose particles");
        QCOMPARE(part(scene).particles.size(), std::size_t(4));

        part(scene).links.push_back(
            {.id = Id{1500}, .from = Id{102}, .to = Id{101}, .material = materialId});
        QVERIFY(about(scene, "Double links")->culprits == std::vector{Id{1500}});
        repair(scene, "Double links");
        QCOMPARE(part(scene).links.size(), std::size_t(3));

        part(scene).particles[1].mass = 0.0;
        part(scene).particles[2].mass = 0.03;
        part(scene).particles[3].mass = 0.05;
        QVERIFY(about(scene, "Masses")->culprits == std::vector{Id{101}});
        repair(scene, "Masses");
        QCOMPARE(part(scene).particles[1].mass, 0.03); // the mean of 10, 30 and 50 g
    }

    // What points at nothing is the check's affair; here it is passed over.
    void brokenReferences()
    {
        Scene scene = chain(4);
        part(scene).links[1].to = Id{777};
        part(scene).links[2].material = Id{777};
        QVERIFY(!stabilityOf(scene).empty());
    }
};

const RegisteredTest registered("test_stability", runPlain<TestStability>);

} // namespace ripstop::test_stability
#include "test_stability.moc"
