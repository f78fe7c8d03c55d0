// The kernels for any machine and those for AVX2 with FMA come to the same bits: each sample is
// flown with both, by the switch RIPSTOP_PLAIN (parallel/simd_pack.h).
#include "model/cli_call.h"
#include "parallel/simd_pack.h"
#include "registered_test.h"

#include <QDir>

namespace ripstop::test_plain_path {

namespace {

QString hashOf(const QString& scene, const char* plain)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("RIPSTOP_PLAIN", plain);
    process.setProcessEnvironment(environment);
    process.start(CLI_PROGRAM, {"run", scene, "--seconds", "0.1", "--threads", "1", "--json"});
    if (!process.waitForFinished(120000) || process.exitCode() != 0)
        return "not flown: " + process.readAllStandardError();
    return QJsonDocument::fromJson(process.readAllStandardOutput()).object()["hash"].toString();
}

} // namespace

class TestPlainPath : public QObject
{
    Q_OBJECT

private slots:
    void samplesHaveTheSameBits_data()
    {
        QTest::addColumn<QString>("scene");
        for (const QFileInfo& file : QDir(SCENES_DIR).entryInfoList({"*.ripstop.json"}))
            QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    }

    void samplesHaveTheSameBits()
    {
        QFETCH(QString, scene);
        const QString plain = hashOf(scene, "1");
        QCOMPARE(plain.size(), 16);
        QCOMPARE(hashOf(scene, "0"), plain);
    }

    // Otherwise both ways are one, and the comparison says nothing.
    void theSwitchSwitches()
    {
        if (!wideMachine)
            QSKIP("This machine, or this build, has one way only.");
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("RIPSTOP_PLAIN", "1");
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), {"test_plain_path", "--is-wide"});
        QVERIFY(process.waitForFinished(30000));
        QCOMPARE(process.exitCode(), 0);
    }
};

static int run(int argc, char** argv)
{
    if (argc == 2 && std::string_view(argv[1]) == "--is-wide")
        return wideMachine ? 1 : 0;
    return runWithCore<TestPlainPath>(argc, argv);
}

const RegisteredTest registered("test_plain_path", run);

} // namespace ripstop::test_plain_path
#include "test_plain_path.moc"
