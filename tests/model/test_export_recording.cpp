// What a recording gives to other programs: the run as it was, without flying it again.
//
// Stages: the steps and the end of an exported recording are compared with a flight; the command
// line gives the same table from both; a damaged recording is exported as far as it can be read.
#include "assembly/finish.h"
#include "builders/builder.h"
#include "export/export_run.h"
#include "io/recording_file.h"
#include "model/cli_call.h"
#include "model/flown.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_export_recording {

namespace {

// Keeps what it is given.
struct Kept final : FrameSink
{
    std::vector<std::shared_ptr<const Frame>> frames;

    std::optional<Failure> add(const Frame& frame) override
    {
        frames.push_back(std::make_shared<Frame>(frame));
        return std::nullopt;
    }
    std::optional<Failure> finish(const Progress&) override { return std::nullopt; }
};

Kept framesOf(FrameSource& source, const ExportRange& range)
{
    Kept kept;
    const auto failure = exportSeries(source, range, kept);
    if (failure)
        qWarning("%s", failure->message.english().c_str());
    return kept;
}

QList<QByteArray> linesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n')
                                          : QList<QByteArray>();
}

} // namespace

class TestExportRecording : public QObject
{
    Q_OBJECT

private slots:
    // The sheet is so large that not every step is kept: 24 frames a second fall between those of
    // 60 a second, and must be of the same steps all the same.
    void takesTheStepsThatAFlightTakes_data()
    {
        QTest::addColumn<QString>("builder");
        QTest::addColumn<double>("fps");
        QTest::newRow("every step is kept") << "hang_glider" << 24.0;
        QTest::newRow("many are not, at 24 per second") << "cloth" << 24.0;
        QTest::newRow("many are not, at a rate that fits no step") << "cloth" << 37.0;
        QTest::newRow("many are not, each step") << "cloth" << 1e4;
    }

    void takesTheStepsThatAFlightTakes()
    {
        QFETCH(QString, builder);
        QFETCH(double, fps);
        const bool isCloth = builder == "cloth";
        const Scene scene = isCloth ? *build(*findBuilder("cloth"), {{"columns", 60}, {"rows", 60}})
                                    : *build(*findBuilder(builder.toStdString()), {});
        constexpr int steps = 48;
        const auto recording = flown(scene, steps);
        QCOMPARE(recording->frameCount() < steps * 3 / 4, isCloth);

        const double end = steps * scene.settings.timeStep;
        const ExportRange range{0.1 * end, end, fps};
        Simulation simulation(*compile(scene));
        FlownFrames flight(simulation);
        RecordedFrames asKept(recording), exact(recording, RecordedFrames::Places::Exact);
        QVERIFY(std::abs(asKept.end() - end) < 1e-9);
        const Kept original = framesOf(flight, range);
        const Kept kept = framesOf(asKept, range), same = framesOf(exact, range);
        QVERIFY(original.frames.size() > 3);
        QCOMPARE(kept.frames.size(), original.frames.size());
        QCOMPARE(same.frames.size(), original.frames.size());
        for (std::size_t i = 0; i < original.frames.size(); ++i) {
            QCOMPARE(kept.frames[i]->step, original.frames[i]->step);
            QCOMPARE(kept.frames[i]->time, original.frames[i]->time);
            QCOMPARE(kept.frames[i]->hash, original.frames[i]->hash);
            QVERIFY(same.frames[i]->position == original.frames[i]->position);
            QVERIFY(same.frames[i]->tension == original.frames[i]->tension);
            for (std::size_t p = 0; p < original.frames[i]->position.size(); ++p)
                QVERIFY((kept.frames[i]->position[p] - original.frames[i]->position[p]).norm()
                        < 1e-6);
        }
    }

    void endsWhereTheRecordingDoes()
    {
        const auto recording = flown(*build(*findBuilder("hang_glider"), {}), 60);
        RecordedFrames source(recording);
        Kept kept;
        const auto failure = exportSeries(source, {0.0, 100.0, 1e4}, kept);
        QVERIFY(failure);
        QVERIFY2(failure->message.english().find("recording ends at") != std::string::npos,
                 failure->message.english().c_str());
        QCOMPARE(kept.frames.size(), std::size_t(61));
        const auto late = exportSeries(source, {50.0, 100.0, 25.0}, kept);
        QVERIFY(late && late->message.english().find("the run ends at") != std::string::npos);
    }

    // What says no times is played at the rate of the range, and is as long as was asked for: of a
    // rate above that of the steps moments come again.
    void repeatsWhatIsPlayed()
    {
        RecordedFrames source(flown(*build(*findBuilder("hang_glider"), {}), 60));
        ExportRange range{0.0, 0.1, 1000.0, true};
        QCOMPARE(frameCount(range, source.timeStep()), std::size_t(101));
        const Kept kept = framesOf(source, range);
        QCOMPARE(kept.frames.size(), std::size_t(101));
        for (std::size_t i = 0; i < kept.frames.size(); ++i)
            QVERIFY(std::abs(kept.frames[i]->time - double(i) / range.fps) <= source.timeStep());

        QTemporaryDir folder;
        const MeshAppearance appearance(*build(*findBuilder("hang_glider"), {}));
        const auto samplesOf = [&](const char* name) {
            const QString target = folder.filePath(name);
            if (exportRun(source, appearance, {0.0, 0.1, 1000.0}, target.toStdString()))
                return qint64(-1);
            QFile file(target);
            return file.open(QIODevice::ReadOnly) ? file.size() : qint64(-1);
        };
        const qint64 cache = samplesOf("glider.pc2");
        const qint64 points = kept.frames[0]->position.size();
        QCOMPARE(cache, 32 + 101 * points * 12); // bytes: its head, and three floats a vertex
    }

    // The command line: the same table from the recording as from the scene, to what is kept.
    void commandLine()
    {
        QTemporaryDir folder;
        const auto in = [&](const char* name) { return folder.filePath(name); };
        QCOMPARE(
            call({"run", scene("delta_kite"), "--seconds", "1", "--record", in("kite.ripstop-run")})
                .exitCode,
            0);
        QCOMPARE(call({"export", scene("delta_kite"), "-o", in("flown.csv"), "--to", "1"}).exitCode,
                 0);
        const Outcome outcome = call({"export", in("kite.ripstop-run"), "-o", in("recorded.csv")});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        const auto flownLines = linesOf(in("flown.csv")), lines = linesOf(in("recorded.csv"));
        QCOMPARE(lines.size(), flownLines.size());
        QCOMPARE(lines.size(), 2 + 26 + 1);
        QCOMPARE(lines.first(), flownLines.first()); // the hashes of the first and the last state
        QCOMPARE(lines.last(), flownLines.last());
        for (const char* name : {"kite.glb", "kite.pc2", "kite.pvd", "kite.obj", "k_{frame}.ply"})
            QCOMPARE(call({"export", in("kite.ripstop-run"), "-o", in(name)}).exitCode, 0);

        const Outcome set = call(
            {"export", in("kite.ripstop-run"), "-o", in("x.csv"), "--set", "settings.timeStep=1"});
        QCOMPARE(set.exitCode, 2);
        QVERIFY2(set.error.contains("--set"), qPrintable(set.error));
        QVERIFY(!QFile::exists(in("x.csv")));
    }

    // Two thirds of the file: a table that ends there, and a sentence.
    void exportsUpToTheDamage()
    {
        QTemporaryDir folder;
        const QString whole = folder.filePath("whole.ripstop-run");
        const QString table = folder.filePath("kite.csv");
        QCOMPARE(call({"run", scene("delta_kite"), "--seconds", "5", "--record", whole}).exitCode,
                 0);
        QFile file(whole);
        QVERIFY(file.resize(file.size() * 2 / 3));
        const Outcome outcome = call({"export", whole, "-o", table});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.error.contains("cut off after"), qPrintable(outcome.error));
        const auto lines = linesOf(table);
        const double last = lines[lines.size() - 2].split(',').first().toDouble();
        QVERIFY(last > 1.0 && last < 5.0);
    }
};

const RegisteredTest registered("test_export_recording", runWithCore<TestExportRecording>);

} // namespace ripstop::test_export_recording
#include "test_export_recording.moc"
