// What is told of breaks: the summary and the table.
//
// Stages: runs without and with tears are summed up, and the front of a tear is followed; then the
// table is written, and refused where nothing can be written.
#include "compile/compile.h"
#include "io/tear_table.h"
#include "registered_test.h"
#include "run/tear_events.h"
#include "run/tear_report.h"
#include "simulation/simulation.h"

#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_tear_report {

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
        const TearReport none = tearReport({}, Layout(), PlaceInDesign());
        QCOMPARE(none.count, 0);
        QCOMPARE(none.energy, 0.0);
        QVERIFY(none.front.empty());
    }

    // The front goes on only where a break is farther from the first than all before it, in the
    // design: there particles 10 to 16 stand at x = 0, 1, ... 6 m, links 1 to 5 between neighbours
    // have their middles at 0.5 to 4.5 m, and the panel 6 over the last three at 5 m. That the
    // sheet has fallen by 100 m between two breaks does not count, nor does a link of which an
    // edit has taken an end.
    void front()
    {
        Layout layout;
        for (int i = 0; i < 7; ++i)
            layout.particleId.push_back(std::uint32_t(10 + i));
        layout.particleId.push_back(99); // no longer in the design
        for (int i = 0; i < 5; ++i)
            layout.links.push_back({std::uint32_t(i + 1), LinkKind::Rod, i, i + 1, 1.0});
        layout.links.push_back({7, LinkKind::Rod, 0, 7, 1.0});
        layout.panelId = {6};
        layout.panelCorners = {{4, 5, 6}};
        const PlaceInDesign place = [](std::uint32_t id) -> std::optional<Vec3> {
            return id == 99 ? std::nullopt : std::optional(Vec3(id - 10.0, 1.0, 0.0));
        };
        std::vector<Tear> tears;
        for (const auto& [time, element] :
             {std::pair(0.5, 3), {0.6, 4}, {0.6, 2}, {0.7, 7}, {0.8, 1}, {0.9, 6}}) {
            Tear tear;
            tear.time = time;
            tear.element = std::uint32_t(element);
            tear.energy = 0.25;
            tear.place = {0.0, -250.0 * time, 0.0};
            tears.push_back(tear);
        }
        const TearReport some = tearReport(tears, layout, place);
        QCOMPARE(some.count, 6);
        QCOMPARE(some.energy, 1.5);
        QCOMPARE(some.front.size(), std::size_t(4));
        const double expected[][2] = {{0.5, 0.0}, {0.6, 1.0}, {0.8, 2.0}, {0.9, 2.5}};
        for (std::size_t i = 0; i < std::size(expected); ++i) {
            QCOMPARE(some.front[i].time, expected[i][0]);
            QCOMPARE(some.front[i].distance, expected[i][1]);
        }

        // without the first in the design, the next one begins the front there
        const TearReport late = tearReport(std::span(tears).subspan(3), layout, place);
        QCOMPARE(late.front.size(), std::size_t(2));
        QCOMPARE(late.front[0].time, 0.7);
        QCOMPARE(late.front[1].distance, 4.5);
    }

    // Two links 0.1 m apart, of a scene that knows where its particles are.
    void frontInAScene()
    {
        const Scene scene = twoParts();
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.step());
        const std::shared_ptr<const Frame> frame = simulation.frame();
        const TearReport both = tearReport(frame->tears, *frame->layout, placesIn(scene));
        QCOMPARE(both.count, 2);
        QCOMPARE(both.front.size(), std::size_t(2));
        QVERIFY(std::abs(both.front[1].distance - 0.1) < 1e-12);
    }

    // A row of four links, 1 to 4, between particles 10 to 14, and a link 5 elsewhere. Neighbours
    // within 0.1 s are one event: 2 and 3 are at once; 1 comes by 2 alone; 5 has no neighbour; 4
    // comes 0.15 s after 3, and joins the event by nothing. Where they are does not count.
    void events()
    {
        Layout layout;
        for (const int id : {10, 11, 12, 13, 14, 20, 21})
            layout.particleId.push_back(std::uint32_t(id));
        for (int i = 0; i < 4; ++i)
            layout.links.push_back({std::uint32_t(i + 1), LinkKind::Rod, i, i + 1, 1.0});
        layout.links.push_back({5, LinkKind::Rod, 5, 6, 1.0});
        std::vector<Tear> tears;
        for (const auto& [time, element] :
             {std::pair(1.0, 3), {1.0, 2}, {1.05, 5}, {1.08, 1}, {1.15, 4}, {1.2, 99}}) {
            Tear tear;
            tear.time = time;
            tear.element = std::uint32_t(element);
            tear.energy = 0.5 * element;
            tear.place = {17.0 * time, 0.0, 0.0};
            tears.push_back(tear);
        }
        const TearEvents events = tearEvents(tears, layout);
        QCOMPARE(events.of, (std::vector<std::size_t>{0, 0, 1, 0, 2, 3}));
        const TearEvent expected[]{{1.0, 1.08, 3, 3.0, 3, {17.0, 0.0, 0.0}},
                                   {1.05, 1.05, 1, 2.5, 5, {17.0 * 1.05, 0.0, 0.0}},
                                   {1.15, 1.15, 1, 2.0, 4, {17.0 * 1.15, 0.0, 0.0}},
                                   {1.2, 1.2, 1, 49.5, 99, {17.0 * 1.2, 0.0, 0.0}}};
        QCOMPARE(events.all.size(), std::size(expected));
        for (std::size_t i = 0; i < std::size(expected); ++i)
            QVERIFY(events.all[i] == expected[i]);
        QVERIFY(tearEvents({}, layout).all.empty());
    }

    // Two events become one where a break joins them: 1 and 5 of a row of panels, then 3 between
    // them, which has one panel to either side.
    void eventsAreJoined()
    {
        Layout layout;
        layout.particleId = {10, 11, 12, 13, 14, 15};
        for (int i = 0; i < 5; ++i) {
            layout.panelId.push_back(std::uint32_t(i + 1));
            layout.panelCorners.push_back({i, i, i + 1});
        }
        std::vector<Tear> tears(3);
        for (std::size_t i = 0; i < 3; ++i) {
            tears[i].time = 1.0 + 0.01 * double(i);
            tears[i].element = std::array{1u, 5u, 3u}[i];
        }
        QCOMPARE(tearEvents(std::span(tears).first(2), layout).all.size(), std::size_t(2));
        const TearEvents events = tearEvents(tears, layout);
        QCOMPARE(events.all.size(), std::size_t(1));
        QCOMPARE(events.all[0].count, 3);
        QCOMPARE(events.of, (std::vector<std::size_t>{0, 0, 0}));
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
        QTemporaryDir folder;
        const QString path = folder.filePath("tears.csv");
        const auto failure = writeTears(scene, *simulation.frame(), path.toStdString());
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList rows = QString(file.readAll()).split('\n');
        QCOMPARE(rows.size(), qsizetype(4)); // and the end of the last
        QCOMPARE(rows[0],
                 QString("time (s),element,part,strain,force (N),energy (J),x (m),y (m),z (m),"
                         "tension (N/m),moment (N m),event"));
        for (int i = 0; i < 2; ++i) {
            const double rest = i == 0 ? 0.4 : 0.3;
            const double stretch = 0.5 - rest;
            const QString part = i == 0 ? "\"left, \"\"upper\"\"\"" : "right";
            QVERIFY2(rows[i + 1].contains(',' + part + ','), qPrintable(rows[i + 1]));
            const QStringList cells = QString(rows[i + 1]).replace(part, "part").split(',');
            QCOMPARE(cells.size(), qsizetype(12)); // two before the last are of panels and spars
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
            QVERIFY(near(11, i + 1)); // they share no particle
        }
    }

    void tableIntoNowhere()
    {
        const auto failure = writeTears(twoParts(), Frame(), "/nowhere/tears.csv");
        QVERIFY(failure);
        QVERIFY(failure->message.english().find("/nowhere/tears.csv") != std::string::npos);
    }
};

const RegisteredTest registered("test_tear_report", runPlain<TestTearReport>);

} // namespace ripstop::test_tear_report
#include "test_tear_report.moc"
