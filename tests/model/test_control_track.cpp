// Control tracks: what a pilot did is written down, and flies again to the same bits.
//
// Stages: a flight with commands is written, read and flown again; tracks of new runs; names that
// are awkward or double; then the hands in a track, read, written, and refused.
#include "builders/builder.h"
#include "compile/compile.h"
#include "io/control_track.h"
#include "measure/diagnostics.h"
#include "model/files.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_control_track {

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
        QVERIFY(!writeControlTrack(scene, trackOf(*flown), file));
        const auto track = readControlTrack(file, scene);
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        ControlPlayer player(*track);
        Simulation again(*system);
        for (int step = 0; step < 240; ++step) {
            player.giveTo(again);
            QVERIFY(again.step());
        }
        QCOMPARE(stateHash(again.state()), stateHash(pilot.state()));

        // the track can also be read for another design that has a control of that name
        const Scene other = glider(10.5);
        const auto onOther = readControlTrack(file, other);
        QVERIFY2(onOther, onOther ? "" : onOther.message().english().c_str());
        QCOMPARE(onOther->commands.size(), track->commands.size());
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
        QTest::newRow("like a hand") << "@pull" << false;
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
        QVERIFY(!writeControlTrack(scene, ControlTrack{{{0.1, 7, 0.25}}, {}}, file.toStdString()));
        QFile text(file);
        QVERIFY(text.open(QIODevice::ReadOnly));
        QCOMPARE(text.readAll().contains("#7"), !byName);
        const auto track = readControlTrack(file.toStdString(), scene);
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        QCOMPARE(track->commands.front().control, 7u);
        QCOMPARE(track->commands.front().time, 0.1);
        QCOMPARE(track->commands.front().value, 0.25);
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
        QVERIFY(!writeControlTrack(scene, ControlTrack{{{0.0, 8, 0.1}, {0.0, 7, 0.2}}, {}}, file));
        const auto track = readControlTrack(file, scene);
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        QCOMPARE(track->commands.front().control, 8u);
        QCOMPARE(track->commands.back().control, 7u);
    }

    // A file of nothing is no flight without a pilot, as one with a heading alone is.
    void emptyFilesAreRefused()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("track.csv");
        for (const QByteArray& text : {QByteArray(), QByteArray(" \n")}) {
            write(file, text);
            const auto track = readControlTrack(file.toStdString(), Scene());
            QVERIFY(!track);
            QVERIFY(QString::fromStdString(track.message().english()).contains("is empty"));
        }
        write(file, "time (s),control,value (m)\n");
        const auto heading = readControlTrack(file.toStdString(), Scene());
        QVERIFY(heading && heading->commands.empty());
    }

    // Files of earlier versions have no rows of hands.
    void readsVersion1()
    {
        Scene scene;
        Control control;
        control.name = "left, rear";
        scene.items.push_back({Id{7}, control});
        const auto track =
            readControlTrack(SOURCE_DIR "/tests/model/golden/control_track_v1.csv", scene);
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        QVERIFY(track->hands.empty());
        QCOMPARE(track->commands.size(), std::size_t(2));
        QCOMPARE(track->commands[1].time, 0.5);
        QCOMPARE(track->commands[1].value, -0.125);
    }

    void readsHands()
    {
        const auto track =
            readControlTrack(SOURCE_DIR "/tests/model/golden/control_track_v2.csv", Scene());
        QVERIFY2(track, track ? "" : track.message().english().c_str());
        HandPull pull;
        pull.grip = {{5, 6, 7}, {0.25, 0.25, 0.5}};
        pull.to = {1.0, 2.0, -3.0};
        pull.stiffness = 80.0;
        pull.damping = 0.5;
        pull.most = 12.0;
        Airflow fan;
        fan.kind = WindKind::Jet;
        fan.origin = {0.0, 1.0, 2.0};
        fan.velocity = {0.0, 0.0, -8.0};
        fan.radius = 0.25;
        fan.widening = 0.2;
        HandCommands told;
        for (const HandNote& note : track->hands)
            if (note.time < 1.0)
                add(note.what, told);
        QCOMPARE(told.hands.pull, std::optional(pull));
        QCOMPARE(told.hands.fan, std::optional(fan));
        QCOMPARE(told.hands.pins, (std::vector<std::uint32_t>{6}));
        QCOMPARE(told.hands.carries, (std::vector<Carry>{{9, Vec3(0.0, 0.5, 0.0)}}));
        QCOMPARE(told.cuts.size(), std::size_t(1));
        const Cut cut{{{{0, 0, 5}, {0, 0, -1}}, {{1, 0, 5}, {1, 0, -1}}}};
        QVERIFY(*told.cuts.front() == cut);
        QCOMPARE(told.halts, 1);
        for (const HandNote& note : track->hands)
            if (note.time >= 1.0)
                add(note.what, told);
        QVERIFY(!told.hands.pull && !told.hands.fan && told.hands.pins.empty());
    }

    // What is written is read again, to the bit.
    void writesHands()
    {
        const auto track =
            readControlTrack(SOURCE_DIR "/tests/model/golden/control_track_v2.csv", Scene());
        QVERIFY(track);
        ControlTrack odd = *track;
        for (HandNote& note : odd.hands)
            note.time /= 3.0;
        std::get<HandPull>(odd.hands.front().what).stiffness = 1.0 / 7.0;
        const QTemporaryDir folder;
        const std::string file = folder.filePath("track.csv").toStdString();
        QVERIFY(!writeControlTrack(Scene(), odd, file));
        const auto again = readControlTrack(file, Scene());
        QVERIFY2(again, again ? "" : again.message().english().c_str());
        QCOMPARE(again->hands.size(), odd.hands.size());
        for (std::size_t i = 0; i < odd.hands.size(); ++i) {
            QVERIFY(again->hands[i].time == odd.hands[i].time); // QCOMPARE forgives the last bits
            HandCommands one, other; // cuts are compared by what they are
            add(again->hands[i].what, one);
            add(odd.hands[i].what, other);
            QVERIFY(one.hands == other.hands && one.halts == other.halts);
            QCOMPARE(one.cuts.size(), other.cuts.size());
            QVERIFY(one.cuts.empty() || *one.cuts.front() == *other.cuts.front());
        }
    }

    void refusesBadHands_data()
    {
        QTest::addColumn<QString>("row");
        QTest::addColumn<QString>("says");
        QTest::newRow("unknown") << "0.1,@pul,1"
                                 << "did you mean \"@pull\"?";
        QTest::newRow("too few") << "0.1,@pull,1,2,3"
                                 << "must be three particles";
        QTest::newRow("half a particle") << "0.1,@pin,1.5"
                                         << "must be a particle";
        QTest::newRow("no number") << "0.1,@carry,4,a,b,c"
                                   << "must be finite numbers";
        QTest::newRow("one point") << "0.1,@cut,1,2,3,4,5,6"
                                   << "two or more points";
        QTest::newRow("no time") << "x,@let go"
                                 << "time (s)";
    }
    void refusesBadHands()
    {
        QFETCH(QString, row);
        QFETCH(QString, says);
        const QTemporaryDir folder;
        const QString file = folder.filePath("track.csv");
        QFile text(file);
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("time (s),control,value (m)\n" + row.toUtf8() + "\n");
        text.close();
        const auto track = readControlTrack(file.toStdString(), Scene());
        QVERIFY(!track);
        const QString message = QString::fromStdString(track.message().english());
        QVERIFY2(message.contains("line 2") && message.contains(says), qPrintable(message));
    }
};

const RegisteredTest registered("test_control_track", runPlain<TestControlTrack>);

} // namespace ripstop::test_control_track
#include "test_control_track.moc"
