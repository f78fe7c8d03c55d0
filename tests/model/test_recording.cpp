// Recordings: what was flown can be looked at, computed again to the bit, saved and opened.
//
// Stages: frames and moments against the run that they were recorded from, and runs that go on or
// are computed again; memory that spills to disk; files, whole, damaged and foreign; reading while
// it grows; and the comparison of runs, also on the command line.
#include "builders/builder.h"
#include "compile/compile.h"
#include "io/recording_file.h"
#include "measure/diagnostics.h"
#include "recording/compare_runs.h"
#include "recording/recorder.h"
#include "recording/replay.h"
#include "registered_test.h"

#include "cli_call.h"
#include "compile/update.h"
#include "flown.h"
#include "simulation/simulation.h"
#include "system/moment.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <thread>

namespace ripstop::test_recording {

namespace {

Scene built(const char* builder) { return *build(*findBuilder(builder), {}); }

std::uint32_t firstControl(const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Control>(entry.item))
            return std::uint32_t(entry.id);
    return 0;
}

// Steers, pulls, pins, and edits the design in flight.
RecordedPilot busyPilot(const Scene& scene)
{
    const std::uint32_t control = firstControl(scene);
    const auto edited = std::make_shared<Scene>(scene);
    edited->settings.viscosity = 0.05;
    return [=](Simulation& simulation, Recorder& recorder, int step) {
        if (step % 31 == 7)
            simulation.command({{control, 0.002 * step - 0.1}});
        const auto particle = simulation.system().key.back();
        HandCommands hands;
        if (step >= 40 && step < 90)
            hands.hands.pull = HandPull{{{particle, 0, 0}}, Vec3(0.0, 0.02 * step, 1.0)};
        if (step >= 60)
            hands.hands.pins = {simulation.system().key[simulation.system().key.size() / 2]};
        simulation.handle(hands);
        if (step == 120) {
            simulation.load(*compile(*edited, 2, simulation.system().run));
            recorder.loaded(simulation, designOf(*edited));
        }
    };
}

} // namespace

class TestRecording : public QObject
{
    Q_OBJECT

private slots:
    // Frames are as the simulation's own, places to 1e-6 m, times and probes of inputs exactly.
    void framesShowWhatWasFlown()
    {
        const Scene scene = built("hang_glider");
        std::map<std::int64_t, std::shared_ptr<const Frame>> seen;
        const auto recording = flown(scene, 300, [&](Simulation& simulation, Recorder&, int) {
            seen[simulation.state().step] = simulation.frame();
        });
        QVERIFY(recording->frameCount() > 60);
        QCOMPARE(recording->firstStep(), std::int64_t(0));
        QCOMPARE(recording->lastStep(), std::int64_t(300));
        for (std::size_t i = 0; i < recording->frameCount(); i += 7) {
            const auto frame = recording->frame(i);
            QVERIFY2(frame, frame ? "" : frame.message().english().c_str());
            const auto live = seen[(*frame)->step];
            if (!live)
                continue;
            QCOMPARE((*frame)->time, live->time);
            QCOMPARE((*frame)->hash, live->hash);
            QCOMPARE((*frame)->inputValue, live->inputValue);
            QCOMPARE((*frame)->torn, live->torn);
            QCOMPARE((*frame)->layout->particleId, live->layout->particleId);
            for (std::size_t p = 0; p < live->position.size(); ++p)
                QVERIFY(((*frame)->position[p] - live->position[p]).norm() < 1e-6);
            for (std::size_t l = 0; l < live->tension.size(); ++l)
                if (live->layout->links[l].kind == LinkKind::Rod)
                    QVERIFY(std::abs((*frame)->tension[l] - live->tension[l])
                            <= 1e-6 * std::abs(live->tension[l]));
        }
        // the frame of a time
        const std::size_t middle = recording->frameAt(0.5);
        QVERIFY(std::abs(recording->timeOf(middle) - 0.5) <= 1.0 / 60.0);
        QCOMPARE(recording->frameAt(-1.0), std::size_t(0));
        QCOMPARE(recording->frameAt(1e9), recording->frameCount() - 1);
    }

    // Any step is computed again to the bit, also those without a frame.
    void momentsAreExact()
    {
        const Scene scene = built("hang_glider");
        const auto recording = flown(scene, 400, busyPilot(scene));
        for (const std::int64_t step : {0, 1, 59, 61, 120, 121, 239, 241, 399, 400}) {
            const auto moment = recording->moment(step);
            QVERIFY2(moment, moment ? "" : moment.message().english().c_str());
            QCOMPARE((*moment)->state.step, step);
            QCOMPARE(stateHash((*moment)->state), recording->hashOf(step));
        }
    }

    // A run goes on from a moment as it went on then.
    void goesOnFromAMoment()
    {
        const Scene scene = built("hang_glider");
        const auto recording = flown(scene, 200);
        auto moment = *recording->moment(77);
        Simulation other(*compile(scene, 5, 9));
        other.load(Update{*compile(scene, 6, 10), nullptr, {}, moment});
        QCOMPARE(other.state().step, std::int64_t(77));
        QCOMPARE(stateHash(other.state()), recording->hashOf(77));
        while (other.state().step < 200)
            QVERIFY(other.step());
        QCOMPARE(stateHash(other.state()), recording->hashOf(200));
    }

    void replaysToTheSameBits_data()
    {
        QTest::addColumn<int>("recorded");
        QTest::addColumn<int>("replayed");
        for (const int a : {1, 2})
            for (const int b : {1, 2, 3})
                QTest::addRow("%d threads, replayed by %d", a, b) << a << b;
    }
    void replaysToTheSameBits()
    {
        QFETCH(int, recorded);
        QFETCH(int, replayed);
        const Scene scene = built("hang_glider");
        const auto recording = flown(scene, 260, busyPilot(scene), recorded);
        const auto outcome = replay(*recording, replayed);
        QVERIFY2(outcome, outcome ? "" : outcome.message().english().c_str());
        QVERIFY(!outcome->difference);
        QCOMPARE(outcome->steps, std::int64_t(260));
        QCOMPARE(outcome->hash, recording->hashOf(260));
    }

    // What the recording was not told of shows: the first step, and a particle that is off.
    void namesTheFirstStepThatDiffers()
    {
        const Scene scene = built("hang_glider");
        const auto recording = flown(scene, 200, [](Simulation& simulation, Recorder&, int step) {
            if (step != 50)
                return;
            simulation.keepInputs(nullptr);
            HandCommands hands;
            hands.hands.pull =
                HandPull{{{simulation.system().key[3], 0, 0}}, Vec3(0.0, 30.0, 0.0), 500.0};
            simulation.handle(hands);
        });
        const auto outcome = replay(*recording, 1);
        QVERIFY(outcome);
        QVERIFY(outcome->difference);
        QCOMPARE(outcome->difference->step, std::int64_t(51));
        QVERIFY(outcome->difference->seen);
        QVERIFY(outcome->difference->seen->distance > 0.0);
        QVERIFY(outcome->difference->seen->step >= 51);
    }

    // With no memory at all, all that is old is on disk and reads the same.
    void spillsToDisk()
    {
        const Scene scene = built("hang_glider");
        const auto roomy = flown(scene, 600);
        const auto tight = flown(scene, 600, {}, 1, 1);
        QVERIFY(tight->size().disk > 0);
        QVERIFY(roomy->size().disk == 0);
        QVERIFY(tight->trouble().empty());
        QCOMPARE(tight->frameCount(), roomy->frameCount());
        for (std::size_t i = 0; i < roomy->frameCount(); i += 37) {
            const auto a = roomy->frame(i);
            const auto b = tight->frame(i);
            QVERIFY(a && b);
            QVERIFY((*a)->position == (*b)->position);
            QVERIFY((*a)->velocity == (*b)->velocity);
        }
    }

    void savesAndOpens()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("a.ripstop-run").toStdString();
        const Scene scene = built("hang_glider");
        const auto recording = flown(scene, 300, busyPilot(scene));
        recording->setName("flight 1");
        recording->setOrigin("2 s of flight 0");
        recording->setBookmarks({{200, 200.0 / 240.0, "later"}, {100, 100.0 / 240.0, "here"}});
        QVERIFY(!saveRecording(*recording, file));
        const auto opened = openRecording(file);
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        QCOMPARE(opened->damage.english(), std::string());
        const Recording& again = *opened->recording;
        QCOMPARE(again.name(), std::string("flight 1"));
        QCOMPARE(again.origin(), std::string("2 s of flight 0"));
        QCOMPARE(again.bookmarks().front().name, std::string("here"));
        QCOMPARE(again.frameCount(), recording->frameCount());
        QCOMPARE(again.lastStep(), recording->lastStep());
        QCOMPARE(again.designCount(), std::size_t(2));
        QVERIFY(again.events() == recording->events());
        QVERIFY((*again.frame(33))->position == (*recording->frame(33))->position);
        QCOMPARE(stateHash((*again.moment(250))->state), recording->hashOf(250));
        const auto outcome = replay(again, 2);
        QVERIFY(outcome && !outcome->difference);
    }

    // A file that is cut anywhere opens up to the cut; a changed byte is found.
    void opensUpToTheDamage_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<bool>("cut");
        for (int quarter = 1; quarter <= 3; ++quarter)
            for (const bool cut : {true, false})
                QTest::addRow("%s at %d/4", cut ? "cut" : "changed", quarter)
                    << quarter / 4.0 << cut;
    }
    void opensUpToTheDamage()
    {
        QFETCH(double, share);
        QFETCH(bool, cut);
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.ripstop-run");
        const auto recording = flown(built("hang_glider"), 1000);
        QVERIFY(!saveRecording(*recording, file.toStdString()));
        QByteArray bytes = contentOf(file);
        const auto place = qsizetype(share * double(bytes.size()));
        if (cut)
            bytes.truncate(place);
        else
            bytes[place] = char(bytes[place] ^ 16);
        write(file, bytes);
        const auto opened = openRecording(file.toStdString());
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        QVERIFY(
            QString::fromStdString(opened->damage.english()).contains(cut ? "cut off" : "damaged"));
        const std::size_t frames = opened->recording->frameCount();
        QVERIFY(frames > 0 && frames < recording->frameCount());
        QVERIFY((*opened->recording->frame(frames - 1))->position
                == (*recording->frame(frames - 1))->position);
        const auto outcome = replay(*opened->recording, 1);
        QVERIFY(outcome && !outcome->difference);
        // what was opened can be saved again, and is then whole
        QVERIFY(!saveRecording(*opened->recording, file.toStdString()));
        QCOMPARE(openRecording(file.toStdString())->damage.english(), std::string());
    }

    void refusesOtherFiles_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("says");
        QTest::newRow("empty") << QByteArray() << "is not a recording";
        QTest::newRow("text") << QByteArray("{\"format\": 1}") << "is not a recording";
        QTest::newRow("later") << QByteArray("RIPSTOP-RUN 9\nabc") << "later version";
        QTest::newRow("head only") << QByteArray("RIPSTOP-RUN 2\n") << "before its first frame";
        QTest::newRow("huge length")
            << QByteArray("RIPSTOP-RUN 1\n") + QByteArray(64, char(0xff)) << "before its first";
    }
    void refusesOtherFiles()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, says);
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.ripstop-run");
        write(file, bytes);
        const auto opened = openRecording(file.toStdString());
        QVERIFY(!opened);
        QVERIFY2(QString::fromStdString(opened.message().english()).contains(says),
                 opened.message().english().c_str());
    }

    // Nothing half written is left, and what was there stays.
    void savesWholeOrNotAtAll()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.ripstop-run");
        const auto recording = flown(built("hang_glider"), 300);
        write(file, "old");
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit tight{4096, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &tight);
        const auto failure = saveRecording(*recording, file.toStdString());
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY(failure);
        QVERIFY2(QString::fromStdString(failure->message.english()).contains("make room"),
                 failure->message.english().c_str());
        QCOMPARE(contentOf(file), QByteArray("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
        // a folder that is none
        QVERIFY(saveRecording(*recording, folder.filePath("no/a.ripstop-run").toStdString()));
    }

    // A full disk ends the recording and not the run.
    void aFullDiskEndsTheRecording()
    {
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit tight{4096, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &tight);
        const Scene scene = built("hang_glider");
        Simulation simulation(*compile(scene));
        Recorder recorder(1);
        recorder.loaded(simulation, designOf(scene));
        for (int step = 0; step < 900; ++step) {
            recorder.beforeStep(simulation);
            QVERIFY(simulation.step());
            recorder.afterStep(simulation);
            if (step % 100 == 99)
                recorder.recording()->settle();
        }
        const auto recording = recorder.recording();
        recorder.finish();
        setrlimit(RLIMIT_FSIZE, &before);
        QCOMPARE(simulation.state().step, std::int64_t(900));
        QVERIFY(QString::fromStdString(recording->trouble().english()).contains("temporary files"));
        QVERIFY(recording->frameCount() > 0);
        QVERIFY(recording->lastStep() < 900);
        QVERIFY(recording->frame(recording->frameCount() - 1));
    }

    // Reading from other threads while a run goes on.
    void isReadWhileItGrows()
    {
        const Scene scene = built("hang_glider");
        Simulation simulation(*compile(scene));
        Recorder recorder(1 << 16);
        recorder.loaded(simulation, designOf(scene));
        recorder.beforeStep(simulation);
        const auto recording = recorder.recording();
        std::atomic<bool> good = true;
        std::jthread reader([&](const std::stop_token& stop) {
            for (std::size_t i = 0; !stop.stop_requested(); i += 3) {
                const std::size_t number = i % recording->frameCount();
                const auto frame = recording->frame(number);
                good = good && frame && (*frame)->step == recording->stepOf(number);
            }
        });
        for (int step = 0; step < 800; ++step) {
            QVERIFY(simulation.step());
            recorder.afterStep(simulation);
        }
        reader.request_stop();
        reader.join();
        QVERIFY(good);
    }

    // Two flights, one steered: nothing apart before, something after.
    void comparesRuns()
    {
        const Scene scene = built("hang_glider");
        const auto calm = flown(scene, 240);
        const auto steered = flown(scene, 300, [&](Simulation& simulation, Recorder&, int step) {
            if (step == 120)
                simulation.command({{firstControl(scene), 0.2}});
        });
        const auto list = compareRuns(*calm, *steered);
        QVERIFY2(list, list ? "" : list.message().english().c_str());
        QVERIFY(list->size() > 50);
        QCOMPARE(list->front().particles, calm->frame(0).operator*()->position.size());
        for (const RunDistance& row : *list)
            QVERIFY(row.time > 0.5 + 1e-9 || row.most < 1e-6);
        QVERIFY(list->back().most > 1e-4);
        QVERIFY(list->back().rms <= list->back().most);
        // a frame against itself, moved by 3, 4, 0
        Frame moved = **calm->frame(9);
        for (Vec3& place : moved.position)
            place += Vec3(3.0, 4.0, 0.0);
        const RunDistance apart = distanceOf(**calm->frame(9), moved);
        QVERIFY(std::abs(apart.rms - 5.0) < 1e-12);
        QVERIFY(std::abs(apart.most - 5.0) < 1e-12);
    }

    // On the command line exit codes say what came out.
    void commandLine()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("kite.ripstop-run");
        const Outcome run = call({"run", SCENES_DIR "/delta_kite.ripstop.json", "--seconds", "1",
                                  "--record", file, "--json"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.error));
        const Outcome again = call({"run", "--replay", file, "--threads", "2", "--json"});
        QVERIFY2(again.exitCode == 0, qPrintable(again.error));
        QCOMPARE(again.json()["hash"].toString(), run.json()["hash"].toString());
        QVERIFY(again.json()["same"].toBool());
        const Outcome info = call({"info", file, "--json"});
        QCOMPARE(info.exitCode, 0);
        QCOMPARE(info.json()["hash"].toString(), run.json()["hash"].toString());
        QCOMPARE(info.json()["steps"].toInt(), run.json()["steps"].toInt());

        QCOMPARE(call({"compare", file, file}).exitCode, 0);
        const QString other = folder.filePath("other.ripstop-run");
        QCOMPARE(call({"run", SCENES_DIR "/delta_kite.ripstop.json", "--seconds", "1", "--record",
                       other, "--set", "settings.viscosity=0.1"})
                     .exitCode,
                 0);
        const Outcome apart = call({"compare", file, other, "--json"});
        QCOMPARE(apart.exitCode, 4);
        QCOMPARE(apart.json()["distances"].toArray().size(), 11);

        QByteArray bytes = contentOf(file);
        bytes.truncate(bytes.size() * 3 / 4);
        write(file, bytes);
        const Outcome cut = call({"info", file, "--json"});
        QCOMPARE(cut.exitCode, 0);
        QVERIFY2(cut.error.contains("cut off"), qPrintable(cut.error));
        QCOMPARE(call({"run", "--replay", folder.filePath("none")}).exitCode, 1);
        QCOMPARE(call({"run", SCENES_DIR "/rope.ripstop.json", "--seconds", "0.1", "--record",
                       folder.filePath("no/such/folder")})
                     .exitCode,
                 1);
    }
};

const RegisteredTest registered("test_recording", runWithCore<TestRecording>);

} // namespace ripstop::test_recording
#include "test_recording.moc"
