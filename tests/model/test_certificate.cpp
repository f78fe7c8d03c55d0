// Which digits of a run hold.
//
// Stages: sequences whose limits are known, those that go nowhere, and their digits; falls and
// swings whose values are known from theory; motion that is chaotic; what cannot be certified; and
// the command.
#include "model/cli_call.h"
#include "model/sample_scenes.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "export/export_run.h"
#include "io/certificate_table.h"
#include "io/recording_file.h"
#include "run/certify.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_certificate {

namespace {

constexpr double g = 10.0; // m/s^2

// A weight that falls from 5 m in 1 substep of 0.01 s, and a probe of its height.
Scene fall(Integrator integrator)
{
    Scene scene;
    scene.settings.timeStep = 0.01;
    scene.settings.substeps = 1;
    scene.settings.integrator = integrator;
    scene.settings.airDensity = 0.0;
    scene.settings.gravity = Vec3(0.0, -g, 0.0);
    Part weights;
    const Id part = takeId(scene);
    const Id weight = takeId(scene);
    weights.particles.push_back({.id = weight, .position = Vec3(0.0, 5.0, 0.0), .mass = 2.0});
    scene.items.push_back({part, weights});
    const Id probe = takeId(scene);
    scene.items.push_back({probe, Probe{"height", Quantity::PositionY, weight}});
    return scene;
}

Certificate certified(const Scene& scene, double seconds)
{
    const auto certificate = certify(scene, seconds, {}, {});
    if (!certificate)
        qFatal("%s", certificate.message().english().c_str());
    return certificate->certificate;
}

QString contentOf(const std::filesystem::path& path)
{
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

bool isNear(double got, double expected, double tolerance)
{
    return std::abs(got - expected) <= tolerance;
}

} // namespace

class TestCertificate : public QObject
{
    Q_OBJECT

private slots:
    // q(h) = 3 + 0.4 h^p
    void findsTheOrder_data()
    {
        QTest::addColumn<double>("order");
        for (const double order : {0.7, 1.0, 2.0, 4.0})
            QTest::addRow("%g", order) << order;
    }
    void findsTheOrder()
    {
        QFETCH(double, order);
        const Convergence found = convergenceOf(
            {3.4, 3.0 + 0.4 * std::pow(0.5, order), 3.0 + 0.4 * std::pow(0.25, order)});
        QVERIFY(found.converges());
        QVERIFY(isNear(found.order, order, 1e-9));
        QVERIFY(isNear(found.limit, 3.0, 1e-9));
        QVERIFY(isNear(found.error, 1.25 * 0.4, 1e-9));
        QCOMPARE(found.digits, 1); // 3.4, and not 3
    }

    void goesNowhere()
    {
        const Convergence parts = convergenceOf({1.0, 2.0, 4.0});
        QVERIFY(!parts.converges());
        QCOMPARE(parts.error, 6.0);
        QCOMPARE(parts.digits, 0);
        const Convergence turns = convergenceOf({1.0, 1.5, 1.4});
        QVERIFY(!turns.converges());
        QCOMPARE(turns.error, 1.5);
        const Convergence rests = convergenceOf({0.3, 0.3, 0.3});
        QCOMPARE(rests.error, 0.0);
        QCOMPARE(rests.digits, 15);
        const Convergence noise = convergenceOf({1e-17, -2e-17, 5e-17}); // of rounding
        QCOMPARE(noise.digits, 15);
        const Convergence nothing = convergenceOf({Convergence::none, 1.0, 1.0});
        QCOMPARE(nothing.digits, 0);
    }

    // An error below half of the last digit leaves it as it is.
    void countsDigits()
    {
        const auto digits = [](double value, double error) {
            return convergenceOf({value, value + error / 3.0, value}).digits;
        };
        QCOMPARE(digits(123.456, 0.04), 4); // 123.5
        QCOMPARE(digits(1.0, 0.04), 2);
        QCOMPARE(digits(1.0, 0.06), 1);
        QCOMPARE(digits(0.0, 0.1), 0);
    }

    // Semi-implicit Euler falls by g t (t + h) / 2: of first order, to the limit g t^2 / 2.
    void aFallIsOfFirstOrder()
    {
        const double t = 0.5, h = 0.01;
        const Certificate certificate = certified(fall(Integrator::SemiImplicitEuler), t);
        QCOMPARE(certificate.probes.size(), std::size_t(1));
        const Convergence& height = certificate.probes[0].result;
        QVERIFY(!certificate.probes[0].ofMean);
        QVERIFY(isNear(height.order, 1.0, 1e-6));
        QVERIFY(isNear(height.value[0], 5.0 - 0.5 * g * t * (t + h), 1e-9));
        QVERIFY(isNear(height.limit, 5.0 - 0.5 * g * t * t, 1e-8));
        QVERIFY(isNear(height.error, 1.25 * 0.5 * g * t * h, 1e-8));

        // and so at every moment
        QCOMPARE(certificate.time.size(), std::size_t(51));
        for (std::size_t k = 1; k < certificate.time.size(); ++k)
            QVERIFY(isNear(certificate.probes[0].error[k], 1.25 * 0.5 * g * certificate.time[k] * h,
                           1e-8));
        QVERIFY(
            certificateTable(certificate).starts_with("time (s),height (m),height error (m)\n"));
    }

    // A recording has the certificate of its run, and so do its table and its figure.
    void goesWithTheRecording()
    {
        const double t = 0.5, h = 0.01;
        const auto made = certify(fall(Integrator::SemiImplicitEuler), t, {}, {});
        QVERIFY(made);
        const Certificate& certificate = made->certificate;
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        QVERIFY(!saveRecording(*made->flown, path / "fall.ripstop-run"));

        const auto opened = openRecording(path / "fall.ripstop-run");
        QVERIFY(opened);
        QVERIFY(opened->damage.empty());
        const auto kept = opened->recording->certificate();
        QVERIFY(kept);
        QCOMPARE(kept->time, certificate.time);
        QCOMPARE(kept->probes.size(), std::size_t(1));
        QCOMPARE(kept->probes[0].error, certificate.probes[0].error);
        QCOMPARE(kept->probes[0].result.order, certificate.probes[0].result.order);

        RecordedFrames frames(opened->recording);
        const ExportRange range{0.0, t, 1.0 / h};
        QVERIFY(!exportRun(frames, {}, range, path / "fall.csv"));
        const QStringList lines = contentOf(path / "fall.csv").split('\n');
        QVERIFY(lines[1].startsWith("time (s),height (m),height error (m)"));
        const QStringList last = lines[2 + 50].split(',');
        QVERIFY(isNear(last[0].toDouble(), t, 1e-12));
        QVERIFY(isNear(last[2].toDouble(), 1.25 * 0.5 * g * t * h, 1e-8));

        RecordedFrames again(opened->recording);
        QVERIFY(!exportRun(again, {}, range, path / "fall.svg"));
        QVERIFY(contentOf(path / "fall.svg").contains("fill-opacity"));
    }

    // The formula of a fall is exact for velocity Verlet.
    void aFallMayBeExact()
    {
        const Certificate certificate = certified(fall(Integrator::VelocityVerlet), 0.5);
        QVERIFY(certificate.probes[0].result.digits >= 12);
    }

    // 1 kg on an undamped line swings at sqrt(EA / (m L)) = 2 kHz for ever, which none of the
    // three runs can tell: it is dead after a second in all of them, and they agree on that to the
    // last digit. At 1 Hz it swings on, and is told.
    void whatDiesInAllRunsHoldsInNoDigit()
    {
        const auto tension = [](double frequency) {
            const double w = 2.0 * std::numbers::pi * frequency;
            const Scene scene = *build(*findBuilder("rope"), {{"cord", 0.0},
                                                              {"segments", 1.0},
                                                              {"length", 1.0},
                                                              {"density", 0.0},
                                                              {"end_mass", 1.0},
                                                              {"angle", 0.0},
                                                              {"axial", w * w}});
            const Certificate certificate = certified(scene, 1.0);
            return *std::ranges::find(certificate.probes, "tension", &CertifiedProbe::name);
        };
        const CertifiedProbe fast = tension(2000.0);
        QVERIFY(!fast.ofMean);
        QVERIFY(fast.result.digits >= 6);
        QVERIFY(!fast.holdsItsCourse());
        QCOMPARE(fast.digits(), 0);
        const CertifiedProbe slow = tension(1.0);
        QVERIFY(slow.holdsItsCourse());
        QCOMPARE(slow.digits(), slow.result.digits);
    }

    // What is certified holds the truth: the extension of a line of EA 100 kN under 65 kg, and the
    // height of a pendulum, both beside runs of 64 times as many substeps.
    void theErrorCoversTheTruth_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("probe");
        QTest::newRow("line") << "stretched_line"
                              << "end height";
        QTest::newRow("pendulum") << "pendulum"
                                  << "end height";
    }
    void theErrorCoversTheTruth()
    {
        QFETCH(QString, name);
        QFETCH(QString, probe);
        Scene fine = sample(name);
        const Certificate certificate = certified(fine, 1.0);
        fine.settings.substeps *= 64;
        Simulation simulation(*compile(fine));
        QVERIFY(simulation.runUntil(1.0));
        const double truth = ripstop::probe(simulation, probe.toStdString());
        const auto found =
            std::ranges::find(certificate.probes, probe.toStdString(), &CertifiedProbe::name);
        const Convergence& result = found->result;
        QVERIFY2(
            std::abs(result.value[0] - truth) <= result.error,
            qPrintable(
                QString("%1 +- %2, true is %3").arg(result.value[0]).arg(result.error).arg(truth)));
    }

    void saysWhyThereIsNone()
    {
        Scene bare = fall(Integrator::SemiImplicitEuler);
        bare.items.pop_back();
        const auto none = certify(bare, 1.0, {}, {});
        QVERIFY(!none);
        QVERIFY(QString::fromStdString(none.message().english()).contains("no probe"));

        const auto tooShort = certify(fall(Integrator::SemiImplicitEuler), 1e-9, {}, {});
        QVERIFY(!tooShort);
        QVERIFY(QString::fromStdString(tooShort.message().english()).contains("a time step"));

        const auto cancelled =
            certify(fall(Integrator::SemiImplicitEuler), 1.0, {}, [](double) { return false; });
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.message(), Message("Cancelled."));

        Scene wild = fall(Integrator::SemiImplicitEuler);
        wild.settings.speedLimit = 1.0;
        const auto stopped = certify(wild, 1.0, {}, {});
        QVERIFY(stopped);
        QVERIFY(stopped->certificate.probes.empty());
        QVERIFY(QString::fromStdString(stopped->stopped.english()).contains("above the limit"));
    }

    void theCommand()
    {
        const QString pendulum = scene("pendulum");
        const QTemporaryDir folder;
        const QString csv = folder.filePath("bands.csv");
        const Outcome outcome =
            call({"certify", pendulum, "--seconds", "1", "--json", "--csv", csv});
        QCOMPARE(outcome.exitCode, 0);
        const QJsonArray probes = outcome.json()["probes"].toArray();
        QVERIFY(!probes.isEmpty());
        QVERIFY(probes[0].toObject()["digits"].toInt() > 1);
        QVERIFY(QFile::exists(csv));
        const Outcome threads =
            call({"certify", pendulum, "--seconds", "1", "--json", "--threads", "2"});
        QCOMPARE(threads.out, outcome.out);
        QCOMPARE(call({"certify", pendulum, "--seconds", "1", "--digits", "9"}).exitCode, 5);
        const Outcome wild =
            call({"certify", pendulum, "--seconds", "1", "--set", "settings.speedLimit=0.01"});
        QCOMPARE(wild.exitCode, 3);
        QVERIFY2(wild.error.contains("above the limit"), qPrintable(wild.error));
        QCOMPARE(call({"certify", pendulum}).exitCode, 2);
        QCOMPARE(call({"certify", pendulum, "--seconds", "0"}).exitCode, 2);
        QCOMPARE(call({"certify", folder.filePath("no.json"), "--seconds", "1"}).exitCode, 1);
    }
};

const RegisteredTest registered("test_certificate", runWithCore<TestCertificate>);

} // namespace ripstop::test_certificate
#include "test_certificate.moc"
