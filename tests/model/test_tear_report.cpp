// What is told of breaks: the summary and the table.
//
// Stages: runs without and with tears are summed up, and the front of a tear is followed; then the
// table is written, and refused where nothing can be written.
#include "compile/compile.h"
#include "io/tear_table.h"
#include "run/tear_report.h"
#include "simulation/simulation.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ripstop;

namespace {

// Two parts with a spring each between pins 0.5 m apart, stretched by 0.1 m and 0.2 m, 100 N/m.
Scene twoParts()
{
    Scene scene;
    const Id material = takeId(scene);
    Material fabric;
    fabric.name = "fabric";
    fabric.stiffness = 100.0;
    fabric.damping = 0.0;
    fabric.tearRule = TearRule::Length;
    fabric.tearLimit = 0.45;
    scene.items.push_back({material, fabric});
    for (const double rest : {0.4, 0.3}) {
        const Id id = takeId(scene);
        Part part;
        part.name = rest == 0.4 ? "left, \"upper\"" : "right";
        for (const double x : {0.0, 0.5}) {
            Particle end;
            end.id = takeId(scene);
            end.position = {x, rest, 0.0};
            end.pinned = true;
            part.particles.push_back(end);
        }
        Link link;
        link.id = takeId(scene);
        link.from = part.particles[0].id;
        link.to = part.particles[1].id;
        link.material = material;
        link.kind = LinkKind::Spring;
        link.restLength = rest;
        part.links.push_back(link);
        scene.items.push_back({id, part});
    }
    return scene;
}

} // namespace

class TestTearReport : public QObject
{
    Q_OBJECT

private slots:
    void nothingTore()
    {
        const TearReport none = tearReport({});
        QCOMPARE(none.count, 0);
        QCOMPARE(none.energy, 0.0);
        QVERIFY(none.front.empty());
    }

    // The front goes on only where a break is farther from the first than all before it.
    void front()
    {
        std::vector<Tear> tears;
        for (const auto& [time, x] : {std::pair(0.5, 2.0), {0.6, 3.0}, {0.6, 2.5}, {0.8, -1.0}}) {
            Tear tear;
            tear.time = time;
            tear.energy = 0.25;
            tear.place = {x, 1.0, 0.0};
            tears.push_back(tear);
        }
        const TearReport some = tearReport(tears);
        QCOMPARE(some.count, 4);
        QCOMPARE(some.energy, 1.0);
        QCOMPARE(some.front.size(), std::size_t(3));
        const double expected[][2] = {{0.5, 0.0}, {0.6, 1.0}, {0.8, 3.0}};
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(some.front[i].time, expected[i][0]);
            QCOMPARE(some.front[i].distance, expected[i][1]);
        }
    }

    // k s^2 / 2 of 0.5 J and 2 J, k s of 10 N and 20 N.
    void table_data()
    {
        QTest::addColumn<int>("most");
        QTest::newRow("all at once") << 0;
        // 0.5 m is as far above 0.45 m for both, so the first link goes first
        QTest::newRow("one per step") << 1;
    }

    void table()
    {
        QFETCH(int, most);
        Scene scene = twoParts();
        scene.settings.tearsPerStep = most;
        const auto system = compile(scene);
        QVERIFY2(bool(system), system ? "" : system.message().english().c_str());
        Simulation simulation(*system);
        QVERIFY(simulation.step());
        QCOMPARE(simulation.frame()->tears.size(), std::size_t(most > 0 ? most : 2));
        QVERIFY(simulation.step());
        const std::vector<Tear> tears = simulation.frame()->tears;

        QTemporaryDir folder;
        const QString path = folder.filePath("tears.csv");
        const auto failure = writeTears(scene, tears, path.toStdString());
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList rows = QString(file.readAll()).split('\n');
        QCOMPARE(rows.size(), qsizetype(4)); // and the end of the last
        QCOMPARE(rows[0],
                 QString("time (s),element,part,strain,force (N),energy (J),x (m),y (m),z (m),"
                         "tension (N/m),moment (N m)"));
        for (int i = 0; i < 2; ++i) {
            const double rest = i == 0 ? 0.4 : 0.3;
            const double stretch = 0.5 - rest;
            const QString part = i == 0 ? "\"left, \"\"upper\"\"\"" : "right";
            QVERIFY2(rows[i + 1].contains(',' + part + ','), qPrintable(rows[i + 1]));
            const QStringList cells = QString(rows[i + 1]).replace(part, "part").split(',');
            QCOMPARE(cells.size(), qsizetype(11)); // the last two are of panels and spars
            const auto near = [&](int column, double expected) {
                return std::abs(cells[column].toDouble() - expected) < 1e-12;
            };
            QCOMPARE(
                cells[1].toUInt(),
                std::uint32_t(std::get<Part>(scene.items[std::size_t(i) + 1].item).links[0].id));
            QVERIFY(near(3, stretch / rest));
            QVERIFY(near(4, 100.0 * stretch));
            QVERIFY(near(5, 50.0 * stretch * stretch));
            QVERIFY(near(6, 0.25));
            QVERIFY(near(7, rest));
            QVERIFY(near(8, 0.0));
        }
    }

    void tableIntoNowhere()
    {
        const auto failure = writeTears(twoParts(), {}, "/nowhere/tears.csv");
        QVERIFY(failure);
        QVERIFY(failure->message.english().find("/nowhere/tears.csv") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestTearReport)
#include "test_tear_report.moc"
