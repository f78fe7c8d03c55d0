// Weights that are above what all their links bear together, and those of which nothing is said.
//
// Stages: what is told, with its figures; then what else may bear a weight, of which each keeps it
// from being told.
#include "check/check.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "registered_test.h"
#include "scene/particle_of.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <functional>

Q_DECLARE_METATYPE(std::function<void(ripstop::Scene&)>)

namespace ripstop::test_weight_check {

namespace {

using Change = std::function<void(Scene&)>;

constexpr Id partId{1}, cordId{2}, groundId{3};
constexpr Id left{11}, right{12}, load{13};

// A weight of 50 kg hangs 10 m below two pins by lines of 300 N, whose knots leave 80 %: together
// they bear 480 N, the weight of 48.95 kg.
Scene hanging()
{
    Material cord{"cord"};
    cord.tearRule = TearRule::Strength;
    cord.lineStrength = 300.0;
    cord.jointEfficiency = 0.8;
    Part part{"mobile"};
    part.particles = {{.id = left, .position = {0.0, 9.0, 0.0}, .pinned = true},
                      {.id = right, .position = {1.0, 9.0, 0.0}, .pinned = true},
                      {.id = load, .position = {0.5, -1.0, 0.0}, .mass = 50.0}};
    for (const Id pin : {left, right})
        part.links.push_back({.id = Id{std::uint32_t(pin) + 10},
                              .from = pin,
                              .to = load,
                              .material = cordId,
                              .resists = Resists::Tension,
                              .restLength = 10.0});
    Scene scene;
    scene.items = {{partId, part}, {cordId, cord}};
    scene.nextId = Id{40};
    return scene;
}

Part& partOf(Scene& scene) { return std::get<Part>(*findItem(scene, partId)); }
Particle& loadOf(Scene& scene) { return partOf(scene).particles[2]; }
Material& cordOf(Scene& scene) { return std::get<Material>(*findItem(scene, cordId)); }

void add(Scene& scene, const Collider& collider) { scene.items.push_back({groundId, collider}); }

} // namespace

class TestWeightCheck : public QObject
{
    Q_OBJECT

private slots:
    void told_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* says, Change change) {
            QTest::newRow(name) << change << QString(says);
        };

        // 50 x 9.80665 N of 2 x 0.8 x 300 N
        row("two lines",
            "Particle 13 of mobile, of 50 kg, weighs 490.3 N, and the 2 links that hold it break "
            "at 480 N together",
            [](Scene&) {});
        row("one line", "weighs 245.2 N, and the link that holds it breaks at 240 N", [](Scene& s) {
            loadOf(s).mass = 25.0;
            partOf(s).links.pop_back();
        });
        row("on the moon", "weighs 486 N", [](Scene& s) {
            loadOf(s).mass = 300.0;
            s.settings.gravity = {0.0, -1.62, 0.0};
        });
        row("a worn line", "break at 360 N together", [](Scene& s) {
            loadOf(s).mass = 40.0;
            partOf(s).links[0].strengthFactor = 0.5;
        });
        row("a line with a limit of its own", "break at 340 N together",
            [](Scene& s) { partOf(s).links[0].tearLimit = 100.0; });
        row("by a force", "break at 200 N together", [](Scene& s) {
            cordOf(s).tearRule = TearRule::Force;
            cordOf(s).tearLimit = 100.0;
        });
        // a line to one side bears no more than its strength, whichever way the load takes
        row("a line to one side", "the 3 links that hold it break at 720 N", [](Scene& s) {
            loadOf(s).mass = 80.0;
            partOf(s).particles.push_back(
                {.id = Id{14}, .position = {9.0, -1.0, 0.0}, .pinned = true});
            Link aside = partOf(s).links[1];
            aside.id = Id{23};
            aside.from = Id{14};
            partOf(s).links.push_back(aside);
        });
        row("high above the ground", "weighs 490.3 N", [](Scene& s) {
            add(s, Collider{.position = {0.0, -5.0, 0.0}});
        });
        row("beside a box", "weighs 490.3 N", [](Scene& s) {
            add(s, Collider{.shape = ColliderShape::Box,
                            .position = {3.0, -1.0, 0.0},
                            .size = {2.0, 2.0, 2.0}});
        });
    }

    void told()
    {
        QFETCH(Change, change);
        QFETCH(QString, says);
        Scene scene = hanging();
        change(scene);
        const std::vector<Finding> problems = problemsOf(scene);
        QCOMPARE(problems.size(), std::size_t(1));
        QVERIFY(problems[0].severity == Severity::Warning);
        QVERIFY(problems[0].culprit() == load);
        const QString message = QString::fromStdString(problems[0].message.english());
        QVERIFY2(message.contains(says), qPrintable(message));
    }

    void untold_data()
    {
        QTest::addColumn<Change>("change");
        const auto row = [](const char* name, Change change) { QTest::newRow(name) << change; };

        row("lines that bear it", [](Scene& s) { loadOf(s).mass = 48.9; });
        row("lines that bear it on the moon", [](Scene& s) {
            loadOf(s).mass = 296.0;
            s.settings.gravity = {0.0, -1.62, 0.0};
        });
        row("without gravity", [](Scene& s) { s.settings.gravity = Vec3::Zero(); });
        row("lines that never tear", [](Scene& s) { cordOf(s).tearRule = TearRule::Never; });
        row("lines that tear by strain", [](Scene& s) { cordOf(s).tearRule = TearRule::Strain; });
        row("one line that never tears", [](Scene& s) { partOf(s).links[0].material = noId; });
        row("pinned", [](Scene& s) { loadOf(s).pinned = true; });
        row("guided", [](Scene& s) { loadOf(s).guide = Guide::Line; });
        row("held by a control", [](Scene& s) {
            Control hand;
            hand.targets = {load};
            s.items.push_back({Id{4}, hand});
        });
        row("on the ground", [](Scene& s) { add(s, Collider{.position = {0.0, -1.0, 0.0}}); });
        row("on a box", [](Scene& s) {
            add(s, Collider{.shape = ColliderShape::Box,
                            .position = {0.0, -2.0, 0.0},
                            .size = {2.0, 2.0, 2.0}});
        });
        row("on a strut", [](Scene& s) {
            partOf(s).particles[0].position.y() = -11.0;
            partOf(s).links[0].resists = Resists::Both;
        });
        row("slack lines", [](Scene& s) {
            for (Link& link : partOf(s).links)
                link.restLength = 12.0;
        });
        row("a corner of cloth", [](Scene& s) {
            partOf(s).panels = {{.id = Id{31}, .a = left, .b = right, .c = load}};
        });
        row("nothing to hang from", [](Scene& s) {
            for (Particle& particle : partOf(s).particles)
                particle.pinned = false;
        });
    }

    void untold()
    {
        QFETCH(Change, change);
        Scene scene = hanging();
        change(scene);
        const std::vector<Finding> problems = problemsOf(scene);
        QVERIFY2(problems.empty(), problems.empty() ? "" : problems[0].message.english().c_str());
    }

    // That it begins there is told (test_start_check.cpp), and nothing of its weight.
    void belowTheGround()
    {
        Scene scene = hanging();
        add(scene, Collider{.position = {0.0, 2.0, 0.0}});
        const std::vector<Finding> problems = problemsOf(scene);
        QCOMPARE(problems.size(), std::size_t(1));
        QCOMPARE(problems[0].sort, "inside");
    }

    // Weighing by densities takes a payload away, and says so, or leaves it where it is told to.
    void weighingTellsOfPayloads()
    {
        Scene scene = hanging();
        std::get<Material>(*findItem(scene, cordId)).linearDensity = 0.01;
        constexpr double length = 10.0; // m
        for (Link& link : std::get<Part>(*findItem(scene, partId)).links)
            link.restLength = length;
        const double ofLines = 2.0 * 0.5 * 0.01 * length; // kg, half of each line

        const QTemporaryDir folder;
        const QString file = folder.filePath("load.ripstop.json");
        const QString weighed = folder.filePath("weighed.ripstop.json");
        QVERIFY(!saveScene(scene, file.toStdString()));
        const auto massOfLoad = [&] {
            const Result<Scene> read = readScene(weighed.toStdString());
            return read ? particleOf(*read, load)->mass : -1.0;
        };
        const Outcome taken = call({"weigh", file, "-o", weighed});
        QVERIFY2(taken.error.contains("49.9 kg, of particle 13: --keep-heavier"),
                 qPrintable(taken.error));
        QVERIFY(std::abs(massOfLoad() - ofLines) < 1e-12);
        const Outcome kept = call({"weigh", file, "--keep-heavier", "-o", weighed});
        QVERIFY2(kept.exitCode == 0 && kept.error.isEmpty(), qPrintable(kept.error));
        QCOMPARE(massOfLoad(), 50.0);
    }
};

const RegisteredTest registered("test_weight_check", runPlain<TestWeightCheck>);

} // namespace ripstop::test_weight_check
#include "test_weight_check.moc"
