// What the command line says is so: standard output is a file that can fail (terminal/output.h),
// names are shown and not done, ends that no fabric can be in are named, and what is built can be
// read and does something.
#include "model/cli_call.h"
#include "registered_test.h"

#include <QTemporaryDir>

namespace ripstop::test_said {

namespace {

QStringList namesIn(const QString& folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
}

// Runs a command of the shell in which $CLI is the program.
Outcome shell(const QString& command)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("CLI", CLI_PROGRAM);
    process.setProcessEnvironment(environment);
    process.start("bash", {"-c", command});
    if (!process.waitForFinished(120000))
        return {-1, {}, process.errorString()};
    return {process.exitCode(), process.readAllStandardOutput(),
            QString(process.readAllStandardError())};
}

} // namespace

class TestSaid : public QObject
{
    Q_OBJECT

private slots:
    // --- standard output -----------------------------------------------------------------------

    void saysThatOutputIsLost_data()
    {
        QTest::addColumn<QString>("command");
        const QString rope = scene("rope");
        for (const QString& command :
             {QString("run %1 --seconds 0.1 --json"), QString("run %1 --seconds 0.1"),
              QString("info %1"), QString("info %1 --json"), QString("properties"),
              QString("properties --json"), QString("builders"), QString("builders rope"),
              QString("presets"), QString("presets --manual"), QString("builders --json"),
              QString("verify --list"), QString("sweep %1 --seconds 0.1"),
              QString("certify %1 --seconds 0.1"), QString("--help"), QString("run --help")})
            QTest::newRow(qPrintable(command)) << QString(command).replace("%1", rope);
    }

    void saysThatOutputIsLost()
    {
        QFETCH(QString, command);
        const Outcome full = shell("$CLI " + command + " > /dev/full");
        QVERIFY2(full.error.contains("No space left"), qPrintable(full.error));
        QCOMPARE(full.exitCode, 6);
        const Outcome closed = shell("$CLI " + command + " >&-");
        QVERIFY2(closed.error.contains("Standard output"), qPrintable(closed.error));
        QCOMPARE(closed.exitCode, 6);
        // the reader is gone before anything is written
        const Outcome gone =
            shell("{ sleep 0.2; $CLI " + command + "; } | true; exit ${PIPESTATUS[0]}");
        QCOMPARE(gone.exitCode, 6);
    }

    void aTableGoesThroughAPipe()
    {
        const Outcome outcome =
            shell("$CLI run " + scene("rope") + " --seconds 0.1 --csv /dev/stdout --json | cat");
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY(outcome.out.startsWith("# Ripstop"));
        const qsizetype end = outcome.out.indexOf("\n# end;"), json = outcome.out.indexOf("\n{");
        QVERIFY(end > 0 && json > end);
    }

    // - is the standard output, as of other programs: it has the table alone, and what people read
    // goes to the standard error.
    void aTableIsTheOutput()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("rope.csv");
        const QString run = "$CLI run " + scene("rope") + " --seconds 0.1 --csv ";
        QCOMPARE(shell(run + path).exitCode, 0);
        for (const QString form : {" | cat", " --json | cat"}) {
            const Outcome outcome = shell(run + "-" + form);
            QCOMPARE(outcome.exitCode, 0);
            QCOMPARE(outcome.out, contentOf(path));
            QVERIFY2(outcome.error.contains("hash"), qPrintable(outcome.error));
        }
        const Outcome two = shell(run + "- --tears -");
        QCOMPARE(two.exitCode, 2);
        QVERIFY(two.out.isEmpty() && two.error.contains("takes one table"));
    }

    // Times may have a unit, in every command, and are refused with another.
    void timesHaveUnits()
    {
        const auto hash = [](const QString& seconds) {
            return call({"run", scene("rope"), "--seconds", seconds, "--json"})
                .json()["hash"]
                .toString();
        };
        const QString plain = hash("0.3");
        QCOMPARE(plain.size(), 16);
        for (const char* seconds : {"0.3 s", "300ms", "1/200 min", "0,3 s"})
            QCOMPARE(hash(seconds), plain);
        QVERIFY(hash("0.2 s") != plain);
        const Outcome metres = call({"run", scene("rope"), "--seconds", "3 m"});
        QCOMPARE(metres.exitCode, 2);
        QVERIFY2(metres.error.contains("from 0 to 1e+09 s, not 3 m"), qPrintable(metres.error));
        const Outcome speed = call({"run", scene("rope"), "--settle", "1 m", "--seconds", "0.1"});
        QVERIFY2(speed.error.contains("is no speed"), qPrintable(speed.error));
        QCOMPARE(call({"run", scene("rope"), "--settle", "1 cm/s", "--seconds", "0.1"}).exitCode,
                 0);
    }

    // The shell has opened the file already, and goes on with it.
    void aTableGoesWhereStandardOutputGoes()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("all.txt");
        const Outcome outcome =
            shell("$CLI run " + scene("rope") + " --seconds 0.1 --csv /dev/stdout > " + path);
        QCOMPARE(outcome.exitCode, 0);
        const QByteArray text = contentOf(path);
        QVERIFY(text.startsWith("# Ripstop"));
        QVERIFY(text.indexOf("hash ") > text.indexOf("\n# end;"));
        QCOMPARE(namesIn(folder.path()), QStringList{"all.txt"});
    }

    void probesOfOneNameAreTwo()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        QByteArray text = contentOf(scene("delta_kite"));
        const QRegularExpression name("(\"type\": \"probe\",[^{}]*?\"name\": )\"[^\"]*\"");
        write(path, QString(text).replace(name, "\\1\"height\"").toUtf8());
        const qsizetype count = QString(text).count(name);
        QVERIFY(count >= 2);
        const Outcome outcome = call({"run", path, "--seconds", "0.1", "--json"});
        const QJsonObject probes = outcome.json()["probes"].toObject();
        QCOMPARE(probes.size(), count);
        QVERIFY(probes.contains("height") && probes.contains("height (2)"));
    }

    // What a title does to a terminal is shown, not done.
    void escapesAreShown()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        const Outcome built =
            call({"build", "rope", "--set", "settings.title=\x1b]0;mine\x07 r\u00e9seau \u009b2J",
                  "-o", path});
        QVERIFY2(built.exitCode == 0, qPrintable(built.error));
        const Outcome told = call({"info", path});
        QVERIFY2(told.out.contains("\\x1b]0;mine\\x07 r\u00e9seau \\x9b2J"), told.out);
        QVERIFY(!told.out.contains('\x1b'));
        QCOMPARE(call({"info", path, "--json"}).json()["title"].toString(),
                 QString("\x1b]0;mine\x07 r\u00e9seau \u009b2J"));
    }

    // --- ends that cannot be ---------------------------------------------------------------------

    void absurdEndsAreNamed_data()
    {
        QTest::addColumn<QByteArray>("item"); // to be added to a pendulum of 1 m
        QTest::addColumn<QStringList>("settings");
        QTest::addColumn<QString>("fragment");
        // 100 m from its pin, to which a rod of 1 m ties it: a strain of 99, where rubber breaks at
        // 10
        QTest::newRow("inside of a sphere")
            << QByteArray("{\"type\": \"collider\", \"id\": 40, \"name\": \"ball\", \"shape\": "
                          "\"sphere\", \"position\": [0, 1, 0], \"radius\": 100},")
            << QStringList() << "The strain of link 5";
        // farther than the earth is thick
        QTest::newRow("in space") << QByteArray()
                                  << QStringList{"--set", "#3.position=2e7, 1, 0", "--set",
                                                 "#4.position=2e7, 0, 0"}
                                  << "away from the origin";
        // the height of 1e305 kg has an energy of 1e306 J a metre, and doubles end at 1.8e308
        QTest::newRow("energies") << QByteArray() << QStringList{"--set", "#4.mass=1e308"}
                                  << "energies are not finite";
    }

    void absurdEndsAreNamed()
    {
        QFETCH(QByteArray, item);
        QFETCH(QStringList, settings);
        QFETCH(QString, fragment);
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        QByteArray text = contentOf(scene("pendulum"));
        text.replace("\"nextId\": 14", "\"nextId\": 50")
            .replace("\"items\": [", "\"items\": [" + item);
        write(path, text);
        const Outcome run = call(QStringList{"run", path, "--seconds", "0.1", "--json"} + settings);
        QVERIFY2(run.error.contains(fragment), qPrintable(run.error));
        QCOMPARE(run.exitCode, 7);
        QVERIFY(run.json()["absurd"].toArray().at(0).toString().contains(fragment));
        const Outcome sweep = call(QStringList{"sweep", path, "--seconds", "0.1"} + settings);
        QCOMPARE(sweep.exitCode, 7);
        QVERIFY2(sweep.out.contains(fragment.toUtf8()), sweep.out);
    }

    void usualEndsAreNot()
    {
        const Outcome run = call({"run", scene("pendulum"), "--seconds", "0.1", "--json"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.json()["absurd"].toArray().size(), 0);
    }

    // --- what is built -------------------------------------------------------------------------

    void refusesToBuildWhatItCannotRead_data()
    {
        QTest::addColumn<QString>("builder");
        QTest::addColumn<QString>("setting");
        QTest::newRow("a rod from a collider") << "rope"
                                               << "rope.links.from=1";
        QTest::newRow("a hand on the wind") << "delta_kite"
                                            << "hand.targets=1,2,3";
    }

    void refusesToBuildWhatItCannotRead()
    {
        QFETCH(QString, builder);
        QFETCH(QString, setting);
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        const Outcome built = call({"build", builder, "--set", setting, "-o", path});
        QCOMPARE(built.exitCode, 1);
        QVERIFY2(built.error.contains("could not be read again"), qPrintable(built.error));
        QCOMPARE(namesIn(folder.path()), QStringList());
    }

    void warnsOfWhatChangesNothing()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        const Outcome idle = call({"build", "parachute", "mouth=0.1", "pressure=0", "-o", path});
        QCOMPARE(idle.exitCode, 0);
        QVERIFY2(idle.error.contains("warning: mouth changes nothing"), qPrintable(idle.error));
        const Outcome busy = call({"build", "parachute", "mouth=0.1", "-o", path});
        QCOMPARE(busy.exitCode, 0);
        QCOMPARE(busy.error, QString()); // a new parachute has pressure
        const Outcome ideal = call({"build", "parachute", "cloth=ideal", "mouth=0.1", "-o", path});
        QCOMPARE(ideal.exitCode, 0);
        QVERIFY2(ideal.error.contains("warning: mouth changes nothing"), qPrintable(ideal.error));
    }

    // What the list of problems warns of in the window is said before a flight as well.
    // 100 kg on a cord that bears 405 N at its knots: it breaks, or nothing says that it does.
    void warnsOfWhatHoldsTooMuch()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        QCOMPARE(call({"build", "rope", "cord=liros_ltc45", "end_mass=100", "angle=0", "-o", path})
                     .exitCode,
                 0);
        const auto said = [&](const char* rule) {
            return call({"run", path, "--seconds", "0.5", "--set",
                         QStringLiteral("cord.tearRule=%1").arg(rule)})
                .error;
        };
        QVERIFY2(said("never").contains("times its strength"), qPrintable(said("never")));
        QVERIFY(!said("strength").contains("times its strength"));
        // a rule of one's own may be wide: then it is not said that there is none
        const Outcome wide = call({"run", path, "--seconds", "0.5", "--set", "cord.tearRule=force",
                                   "--set", "cord.tearLimit=1e6"});
        QVERIFY2(wide.exitCode == 0 && !wide.error.contains("times its strength"),
                 qPrintable(wide.error));
    }

    void warnsBeforeFlying()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.ripstop.json");
        // in a storm, finer cloth or a kite would ask for as many substeps as there may be
        const QStringList made{"build", "cloth", "cloth=ideal", "columns=10", "rows=10"};
        QCOMPARE(call(made + QStringList{"-o", path}).exitCode, 0);
        const Outcome quiet = call({"run", path, "--seconds", "0.01"});
        QCOMPARE(quiet.exitCode, 0);
        QCOMPARE(quiet.error, QString());
        const QString storm = "wind.velocity=1100, 0, 0"; // beyond the speed limit of 1 km/s
        const Outcome info = call({"info", path, "--set", storm, "--json"});
        const QString told = info.json()["problems"][0]["message"].toString();
        QVERIFY(!told.isEmpty());
        for (const QStringList& flown : {QStringList{"run", path, "--seconds", "0.01"},
                                         QStringList{"certify", path, "--seconds", "0.01"},
                                         QStringList{"sweep", path, "--seconds", "0.01", "--sweep",
                                                     "settings.timeStep=0.004"}}) {
            const Outcome warned = call(flown + QStringList{"--set", storm});
            QVERIFY2(warned.error.contains("ripstop-cli: warning: " + path + ": " + told),
                     qPrintable(warned.error));
        }
    }
};

const RegisteredTest registered("test_said", runWithCore<TestSaid>);

} // namespace ripstop::test_said
#include "test_said.moc"
