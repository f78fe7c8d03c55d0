// Control tracks: what a pilot did is written down, and flies again to the same bits.
#include "builders/builder.h"
#include "compile/compile.h"
#include "io/control_track.h"
#include "measure/diagnostics.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace ripstop;

namespace {

Scene glider(double span)
{
    const Builder* builder = findBuilder("hang_glider");
    return *build(*builder, {{"span", span}});
}

std::vector<Id> controlsOf(const Scene& scene)
{
    std::vector<Id> ids;
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Control>(entry.item))
            ids.push_back(entry.id);
    return ids;
}

} // namespace

class TestControlTrack : public QObject
{
    Q_OBJECT

private slots:
    void fliesAgainToTheSameBits()
    {
        const Scene scene = glider(9.0);
        const auto system = compile(scene);
        QVERIFY(system);
        Simulation pilot(*system);
        const auto id = std::uint32_t(controlsOf(scene).front());
        for (int step = 0; step < 240; ++step) {
            if (step % 37 == 5)
                pilot.command({{id, 0.003 * step - 0.2}});
            if (step % 50 == 0)
                pilot.command({{id, pilot.state().inputCommand[0]}}); // says nothing new
            QVERIFY(pilot.step());
        }
        const std::shared_ptr<const Frame> flown = pilot.frame();
        QCOMPARE(flown->commands.size(), std::size_t(7));

        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("track.csv").toStdString();
        QVERIFY(!writeControlTrack(scene, flown->commands, file));
        const auto track = readControlTrack(file, scene);
        QVERIFY2(track, track ? "" : track.message().c_str());
        ControlPlayer player(*track);
        Simulation again(*system);
        for (int step = 0; step < 240; ++step) {
            player.giveTo(again);
            QVERIFY(again.step());
        }
        QCOMPARE(stateHash(again.state()), stateHash(pilot.state()));

        // and another design that has a control of that name
        const Scene other = glider(10.5);
        const auto onOther = readControlTrack(file, other);
        QVERIFY2(onOther, onOther ? "" : onOther.message().c_str());
        QCOMPARE(onOther->size(), track->size());
    }

    // A new run has a track of its own.
    void startsAnew()
    {
        const Scene scene = glider(9.0);
        Simulation simulation(*compile(scene));
        simulation.command({{std::uint32_t(controlsOf(scene).front()), 0.1}});
        QCOMPARE(simulation.frame()->commands.size(), std::size_t(1));
        auto next = std::make_shared<System>(simulation.system());
        ++next->run;
        simulation.load(std::move(next));
        QCOMPARE(simulation.frame()->commands.size(), std::size_t(0));
    }

    // Names that would not be found again are written as numbers.
    void awkwardNames_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("byName");
        QTest::newRow("plain") << "pitch" << true;
        QTest::newRow("comma") << "left, rear" << true;
        QTest::newRow("quotes") << "the \"stick\"" << false;
        QTest::newRow("like a number") << "#3" << false;
        QTest::newRow("none") << "" << false;
        QTest::newRow("blanks around") << " bar " << false;
    }
    void awkwardNames()
    {
        QFETCH(QString, name);
        QFETCH(bool, byName);
        Scene scene;
        Control control;
        control.name = name.toStdString();
        scene.items.push_back({Id{7}, control});
        const QTemporaryDir folder;
        const QString file = folder.filePath("track.csv");
        QVERIFY(!writeControlTrack(scene, std::vector<ControlCommand>{{0.1, 7, 0.25}},
                                   file.toStdString()));
        QFile text(file);
        QVERIFY(text.open(QIODevice::ReadOnly));
        QCOMPARE(text.readAll().contains("#7"), !byName);
        const auto track = readControlTrack(file.toStdString(), scene);
        QVERIFY2(track, track ? "" : track.message().c_str());
        QCOMPARE(track->front().control, 7u);
        QCOMPARE(track->front().time, 0.1);
        QCOMPARE(track->front().value, 0.25);
    }

    // Of two controls of one name, the second is told apart by its number.
    void namesakes()
    {
        Scene scene;
        Control control;
        control.name = "bar";
        scene.items.push_back({Id{7}, control});
        scene.items.push_back({Id{8}, control});
        const QTemporaryDir folder;
        const std::string file = folder.filePath("track.csv").toStdString();
        QVERIFY(!writeControlTrack(scene, std::vector<ControlCommand>{{0.0, 8, 0.1}, {0.0, 7, 0.2}},
                                   file));
        const auto track = readControlTrack(file, scene);
        QVERIFY2(track, track ? "" : track.message().c_str());
        QCOMPARE(track->front().control, 8u);
        QCOMPARE(track->back().control, 7u);
    }
};

QTEST_APPLESS_MAIN(TestControlTrack)
#include "test_control_track.moc"
