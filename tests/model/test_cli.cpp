// ripstop-cli, called as scripts call it: exit codes, what goes to which stream, and its fields.
//
// Stages: exit codes and help; then each command by what it prints and writes (info, build, run,
// export, properties); divergence, tears, controls and the final scene; at the end an interrupt,
// and that the program links no window system.
#include "model/cli_call.h"
#include "registered_test.h"

#include "io/scene_file.h"
#include "scene/property.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <csignal>
#include <limits>

namespace ripstop::test_cli {

namespace {

// A free weight that falls, a pin that a control moves along x, and probes of both. One step is
// 0.01 s.
QByteArray smallScene()
{
    return "{\"format\": \"ripstop-scene\", \"version\": 1,\n"
           "\"settings\": {\"timeStep\": 0.01, \"substeps\": 1, \"airDensity\": 0},\n"
           "\"items\": [\n"
           "{\"type\": \"part\", \"id\": 1, \"name\": \"weights\", \"particles\": [\n"
           "{\"id\": 2, \"position\": [0, 5, 0], \"mass\": 2},\n"
           "{\"id\": 3, \"pinned\": true}]},\n"
           "{\"type\": \"control\", \"id\": 4, \"name\": \"slide\", \"targets\": [3], \"limit\": "
           "1, \"rate\": 10},\n"
           "{\"type\": \"probe\", \"id\": 5, \"name\": \"height\", \"target\": 2},\n"
           "{\"type\": \"probe\", \"id\": 6, \"name\": \"shift\", \"quantity\": \"position_x\", "
           "\"target\": 3},\n"
           "{\"type\": \"probe\", \"id\": 7, \"name\": \"glide\", \"quantity\": \"glide_ratio\", "
           "\"target\": 3}]}";
}

} // namespace

class TestCli : public QObject
{
    Q_OBJECT

private slots:
    void exitCodes_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QString>("fragment"); // of standard error

        const auto row = [](const char* name, const QStringList& arguments, int code,
                            const char* fragment) {
            QTest::newRow(name) << arguments << code << QString(fragment);
        };
        const QString kite = scene("delta_kite");
        // clang-format off
        row("nothing asked",              {},                                                       2, "subcommand");
        row("unknown command",            {"hover"},                                                2, "there are info, build");
        row("misspelt command",           {"exprt"},                                                2, "did you mean \"export\"?");
        row("no scene",                   {"info"},                                                 2, "SCENE");
        row("unknown option",             {"info", kite, "--jsn"},                                  2, "jsn");
        row("missing file",               {"info", "missing.ripstop.json", "--json"},               1, "missing.ripstop.json does not exist");
        row("a folder",                   {"info", SOURCE_DIR},                                     1, "is a folder");
        row("not a scene",                {"run", SOURCE_DIR "/CMakeLists.txt", "--seconds", "1"},  1, "CMakeLists.txt, line 1");
        row("no seconds",                 {"run", kite},                                            2, "seconds");
        row("negative seconds",           {"run", kite, "--seconds", "-1"},                         2, "seconds");
        row("seconds that are no number", {"run", kite, "--seconds", "ten"},                        2, "ten");
        row("seconds not a number",       {"run", kite, "--seconds", "nan"},                        2, "must be a number from 0");
        row("no threads",                 {"run", kite, "--seconds", "1", "--threads", "0"},        2, "threads");
        row("unknown item in --set",      {"run", kite, "--seconds", "1", "--set", "wnd.velocity=1"}, 2, "did you mean \"wind\"?");
        row("unknown property in --set",  {"run", kite, "--seconds", "1", "--set", "settings.substep=1"}, 2, "did you mean \"substeps\"?");
        row("value out of range",         {"run", kite, "--seconds", "1", "--set", "settings.substeps=0"}, 2, "at least 1");
        row("--set without a value",      {"run", kite, "--seconds", "1", "--set", "settings.substeps"}, 2, "PATH=VALUE");
        row("table into nowhere",         {"run", kite, "--seconds", "0.1", "--json", "--csv", "/nowhere/a.csv"}, 1, "/nowhere/a.csv");
        row("final scene into nowhere",   {"run", kite, "--seconds", "0.1", "--json", "--final", "/nowhere/a.ripstop.json"}, 1, "/nowhere/a.ripstop.json");
        row("tears into nowhere",         {"run", kite, "--seconds", "0.1", "--json", "--tears", "/nowhere/a.csv"}, 1, "/nowhere/a.csv");
        row("loads into nowhere",         {"run", kite, "--seconds", "0.1", "--json", "--loads", "/nowhere/a.csv"}, 1, "/nowhere/a.csv");
        row("recording into nowhere",     {"run", kite, "--seconds", "0.1", "--json", "--record", "/nowhere/a.ripstop-run"}, 1, "/nowhere/a.ripstop-run");
        row("final scene on a full disk", {"run", kite, "--seconds", "0.1", "--json", "--final", "/dev/full"}, 1, "/dev/full was not saved");
        row("recording on a full disk",   {"run", kite, "--seconds", "0.1", "--json", "--record", "/dev/full"}, 1, "/dev/full was not saved");
        row("missing controls",           {"run", kite, "--seconds", "1", "--json", "--controls", "missing.csv"}, 1, "missing.csv does not exist");
        row("unknown builder",            {"build", "delta_kit", "-o", "x"},                        2, "delta_kite");
        row("unknown parameter",          {"build", "rope", "segmens=3", "-o", "x"},                2, "did you mean \"segments\"?");
        row("parameter out of range",     {"build", "rope", "segments=-3", "-o", "x"},              2, "segments");
        row("parameter that is a word",   {"build", "rope", "segments=many", "-o", "x"},            2, "segments must be a number");
        row("parameter of another choice", {"build", "delta_kite", "cloth=silk", "-o", "x"},        2, "cloth must be one of ideal, ripstop_050");
        row("choice out of range",        {"build", "delta_kite", "cloth=99", "-o", "x"},           2, "cloth must be a whole number");
        row("parameter without value",    {"build", "rope", "segments", "-o", "x"},                 2, "KEY=VALUE");
        row("no output",                  {"build", "rope"},                                        2, "output");
        row("build into nowhere",         {"build", "rope", "-o", "/nowhere/rope.ripstop.json"},    1, "/nowhere/rope.ripstop.json");
        row("unknown builder listed",     {"builders", "balloon"},                                  2, "balloon");
        row("unknown export format",      {"export", kite, "-o", "kite.abc"},                       1, ".obj, .ply");
        row("export into nowhere",        {"export", kite, "-o", "/nowhere/kite.obj"},              1, "/nowhere/kite.obj");
        row("export backwards",           {"export", kite, "-o", "kite.pvd", "--from", "2", "--to", "1"}, 1, "end of the range");
        row("no such benchmark",          {"bench", "--filter", "zeppelin"},                        2, "zeppelin");
        // clang-format on
    }

    void exitCodes()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, exitCode);
        QFETCH(QString, fragment);
        const Outcome outcome = call(arguments);
        QVERIFY2(outcome.error.contains(fragment), qPrintable(outcome.error));
        QCOMPARE(outcome.exitCode, exitCode);
        // A run is reported even when the disk turns out to be full at its end.
        QCOMPARE(outcome.out.startsWith('{'), arguments.contains("/dev/full"));
    }

    void helpTeaches_data()
    {
        QTest::addColumn<QString>("command");
        for (const char* command :
             {"info", "build", "builders", "run", "export", "bench", "properties"})
            QTest::newRow(command) << command;
    }

    void helpTeaches()
    {
        QFETCH(QString, command);
        const Outcome outcome = call({command, "--help"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY(outcome.out.contains("Examples:\n  ripstop-cli " + command.toLatin1()));
    }

    // Counts of the papers' networks, validation page 1.4 to 1.6.
    void info_data()
    {
        QTest::addColumn<int>("particles");
        QTest::addColumn<int>("rods");
        QTest::addColumn<int>("panels");
        QTest::newRow("hang_glider") << 49 << 198 << 64;
        QTest::newRow("delta_kite") << 152 << 458 << 221;
    }

    void info()
    {
        QFETCH(int, particles);
        QFETCH(int, rods);
        QFETCH(int, panels);
        const QString file = scene(QTest::currentDataTag());
        const Outcome outcome = call({"info", file, "--json"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY(outcome.error.isEmpty());
        const QJsonObject info = outcome.json();
        QCOMPARE(info["particles"].toInt(), particles);
        QCOMPARE(info["rods"].toInt(), rods);
        QCOMPARE(info["links"].toInt(), info["rods"].toInt() + info["springs"].toInt());
        QCOMPARE(info["panels"].toInt(), panels);
        QVERIFY(info["mass"].toDouble() > 0.0);
        QCOMPARE(info["center_of_gravity"].toArray().size(), 3);
        QVERIFY(info["fabric_area"].toDouble() > 0.0);
        QVERIFY(info["problems"].isArray());

        const Outcome table = call({"info", file});
        QCOMPARE(table.exitCode, 0);
        QVERIFY(table.out.contains("particles           " + QByteArray::number(particles)));
    }

    // A unit right triangle of three particles: area 1/2, centre of gravity at a third.
    void infoWeighsAndMeasures()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("a triangle.ripstop.json");
        write(file, "{\"format\": \"ripstop-scene\", \"version\": 1, \"settings\": {\"substeps\": "
                    "2}, \"items\": [\n"
                    "{\"type\": \"part\", \"id\": 1, \"particles\": [{\"id\": 2, \"mass\": 0}, "
                    "{\"id\": 3, \"position\": [1, 0, 0], \"mass\": 2},\n"
                    "{\"id\": 4, \"position\": [0, 0, 3], \"mass\": 2}],\n"
                    "\"links\": [{\"id\": 5, \"kind\": \"spring\", \"from\": 3, \"to\": 4, "
                    "\"stiffness\": 400}],\n"
                    "\"panels\": [{\"id\": 6, \"a\": 2, \"b\": 3, \"c\": 4}]}]}");
        const QJsonObject info = call({"info", file, "--json"}).json();
        QCOMPARE(info["mass"].toDouble(), 4.0);
        QCOMPARE(info["fabric_area"].toDouble(), 1.5);
        QCOMPARE(info["center_of_gravity"].toArray(), (QJsonArray{0.5, 0.0, 1.5}));
        QCOMPARE(info["bounds"].toObject()["high"].toArray(), (QJsonArray{1.0, 0.0, 3.0}));
        // h = sqrt(2 m / k) = 0.1 s for a substep, twice that for a time step
        QVERIFY(std::abs(info["stable_substep"].toDouble() - 0.1) < 1e-12);
        QVERIFY(std::abs(info["stable_time_step"].toDouble() - 0.2) < 1e-12);
        QCOMPARE(info["limited_by"].toString(), QString("springs"));
        // the massless particle is a problem to be shown, and cannot be run
        const QJsonObject problem = info["problems"].toArray().first().toObject();
        QCOMPARE(problem["severity"].toString(), QString("error"));
        QCOMPARE(problem["id"].toInt(), 2);
        QVERIFY(problem["message"].toString().contains("mass"));
        const Outcome run = call({"run", file, "--seconds", "1", "--json"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.error.contains("a triangle.ripstop.json"), qPrintable(run.error));
    }

    void buildsWhatItIsToldTo()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("small kite.ripstop.json");
        const Outcome built =
            call({"build", "delta_kite", "segments=6", "-o", file, "--set",
                  "settings.title=Small, and light", "--set", "wind.velocity=1, 0, -2"});
        QVERIFY2(built.exitCode == 0, qPrintable(built.error));
        const Result<Scene> scene = readScene(file.toStdString());
        QVERIFY(scene);
        QCOMPARE(scene->settings.title, std::string("Small, and light"));
        for (const Entry& entry : scene->items) {
            if (const Wind* wind = std::get_if<Wind>(&entry.item))
                QCOMPARE(wind->velocity, Vec3(1.0, 0.0, -2.0));
            if (const Part* part = std::get_if<Part>(&entry.item))
                QCOMPARE(part->parameters.at("segments"), 6.0);
        }
    }

    // What one builds at first is of real materials; the papers' kite has 152 particles (1.5).
    void buildsOfRealMaterials()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("kite.ripstop.json");
        const auto madeOf = [&](QStringList more) {
            const Outcome built = call(QStringList{"build", "delta_kite", "-o", file} + more);
            Part part;
            if (const Result<Scene> scene = readScene(file.toStdString());
                built.exitCode == 0 && scene)
                forEachPart(*scene, [&](Id, const Part& found) { part = found; });
            return part;
        };
        QCOMPARE(madeOf({}).carrier, FabricKind::Panels);
        const Part papers = madeOf({"cloth=ideal"});
        QCOMPARE(papers.carrier, FabricKind::Threads);
        QCOMPARE(papers.particles.size(), std::size_t(152));
        QVERIFY(call({"builders", "delta_kite"}).out.contains("ripstop_075 "));
    }

    void builders()
    {
        const QJsonArray all = call({"builders", "--json"}).json()["builders"].toArray();
        QStringList names;
        for (const QJsonValue& builder : all)
            names << builder.toObject()["name"].toString();
        for (const char* name :
             {"cloth", "rope", "hang_glider", "delta_kite", "parachute", "stiffened_rod"})
            QVERIFY2(names.contains(name), name);
        const Outcome one = call({"builders", "delta_kite"});
        QCOMPARE(one.exitCode, 0);
        QVERIFY(one.out.contains("segments"));
    }

    // Free fall, exactly as the semi-implicit rule gives it: y = y0 - g h^2 n (n + 1) / 2.
    void run()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("fall.ripstop.json");
        const QString csv = folder.filePath("fall.csv");
        write(file, smallScene());
        const Outcome outcome = call({"run", file, "--seconds", "0.5", "--json", "--csv", csv});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        QVERIFY(outcome.error.isEmpty());
        const QJsonObject result = outcome.json();

        const double height = 5.0 - 9.80665 * 1e-4 * 50.0 * 51.0 / 2.0;
        const double speed = 9.80665 * 0.5;
        QCOMPARE(result["steps"].toInt(), 50);
        QVERIFY(std::abs(result["time"].toDouble() - 0.5) < 1e-12);
        const QJsonObject probes = result["probes"].toObject();
        QVERIFY(std::abs(probes["height"].toDouble() - height) < 1e-9);
        QVERIFY(probes["glide"].isNull()); // a pin does not glide
        QVERIFY(
            std::abs(result["energy"].toDouble() - 2.0 * (0.5 * speed * speed + 9.80665 * height))
            < 1e-9);
        QVERIFY(result["wall_seconds"].toDouble() > 0.0);
        QVERIFY(result["steps_per_second"].toDouble() > 0.0);
        QCOMPARE(result["hash"].toString().size(), 16);
        QCOMPARE(result["torn"].toInt(), 0);
        QCOMPARE(result["max_strain"].toDouble(), 0.0);
        QVERIFY(result["tears"].isArray());

        QStringList rows = QString(contentOf(csv)).trimmed().split('\n');
        QVERIFY(rows.takeFirst().startsWith("# Ripstop")); // with the hash of the start
        QVERIFY(rows.takeLast().contains(result["hash"].toString()));
        QCOMPARE(rows.size(), 1 + 51); // the design and each step
        QCOMPARE(rows[0], QString("time (s),height (m),shift (m),glide"));
        QCOMPARE(rows[1], QString("0,5,0,"));
        QVERIFY(std::abs(rows.back().section(',', 1, 1).toDouble() - height) < 1e-9);
    }

    void sameBitsEveryTime()
    {
        const auto hash = [](const QStringList& more) {
            return call(QStringList{"run", scene("torn_sheet"), "--seconds", "2.8", "--json"}
                        + more)
                .json()["hash"]
                .toString();
        };
        const QString first = hash({});
        QCOMPARE(first.size(), 16);
        QCOMPARE(hash({}), first);
        QCOMPARE(hash({"--threads", "2"}), first);
        QVERIFY(hash({"--set", "settings.viscosity=0.01"}) != first);
    }

    void tearsAreListed()
    {
        QTemporaryDir folder;
        const QString table = folder.filePath("a.csv");
        const QJsonObject result =
            call({"run", scene("torn_sheet"), "--seconds", "3", "--json", "--tears", table}).json();
        const QJsonArray tears = result["tears"].toArray();
        double before = 0.0;
        QCOMPARE(result["torn"].toInt(), int(tears.size()));
        for (const QJsonValue& value : tears) {
            const QJsonObject tear = value.toObject();
            QVERIFY(tear["time"].toDouble() >= std::exchange(before, tear["time"].toDouble()));
            QVERIFY(tear["link"].toInt() > 0);
            QVERIFY(tear["strain"].toDouble() > 0.0);
            QCOMPARE(tear["place"].toArray().size(), 3);
        }
        const QJsonArray front = result["tear_report"].toObject()["front"].toArray();
        QCOMPARE(QString(contentOf(table)).count('\n'), tears.size() + 1);
        QVERIFY(front.size() > 1);
    }

    // The kite of the sample is of materials with strengths; the paper's is not.
    void loadsAreListed()
    {
        QTemporaryDir folder;
        const QString table = folder.filePath("a.csv");
        const QJsonObject result =
            call({"run", scene("ripstop_kite"), "--seconds", "1", "--json", "--loads", table})
                .json();
        const QJsonObject loads = result["loads"].toObject();
        for (const char* of : {"moment", "run"}) {
            double before = std::numeric_limits<double>::infinity();
            QCOMPARE(loads[of].toArray().size(), 10);
            for (const QJsonValue& value : loads[of].toArray()) {
                const QJsonObject place = value.toObject();
                const double margin = place["margin"].toDouble();
                QVERIFY(margin <= std::exchange(before, margin));
                QCOMPARE(margin, place["load"].toDouble() / place["strength"].toDouble());
                QVERIFY(place["time"].toDouble() <= result["time"].toDouble());
                QCOMPARE(place["place"].toArray().size(), 3);
            }
        }
        const auto worst = [&](const char* of) {
            return loads[of].toArray()[0].toObject()["margin"].toDouble();
        };
        QVERIFY(worst("run") >= worst("moment"));
        QCOMPARE(QString(contentOf(table)).count('\n'), 1 + 10 + 10);
        const QJsonArray without = loads["without_strength"].toArray();
        QVERIFY(without.contains("frame")); // which is not of the library
        QVERIFY(!without.contains("line") && !without.contains("sail"));

        const Outcome bare =
            call({"run", scene("paper_kite"), "--seconds", "0.1", "--json", "--loads", table});
        QVERIFY(bare.json()["loads"].isNull());
        QVERIFY(
            bare.error.contains("No material of this scene has a strength for what it carries"));
        QCOMPARE(QString(contentOf(table)).count('\n'), 1);
    }

    void divergence()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("fall.ripstop.json");
        write(file, smallScene());
        const Outcome outcome =
            call({"run", file, "--seconds", "10", "--json", "--set", "settings.speedLimit=20"});
        QCOMPARE(outcome.exitCode, 3);
        QVERIFY(outcome.error.contains("particle 2"));
        const QJsonObject result = outcome.json();
        QVERIFY(result["stopped"].toBool());
        QVERIFY(result["message"].toString().contains("particle 2"));
        // it falls for 20 / g = 2.04 s until then, and the last good state is reported
        QVERIFY(std::abs(result["time"].toDouble() - 20.0 / 9.80665) < 0.011);

        const Outcome exported = call(
            {"export", file, "-o", folder.filePath("fall.csv"), "--set", "settings.speedLimit=20"});
        QCOMPARE(exported.exitCode, 3);
        QVERIFY(QFile::exists(folder.filePath("fall.csv")));
    }

    // The pin goes to 0.25 m at 0.1 s and back to -0.5 m at 0.3 s; 10 m/s is fast enough for both.
    void controls()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("fall.ripstop.json");
        const QString track = folder.filePath("track.csv");
        const QString csv = folder.filePath("out.csv");
        write(file, smallScene());
        write(track, "time (s),control,value (m)\n0.3, #4, -0.5\r\n\n0.1,slide,0.25\n");
        const Outcome outcome =
            call({"run", file, "--seconds", "0.5", "--json", "--controls", track, "--csv", csv});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        QCOMPARE(outcome.json()["probes"].toObject()["shift"].toDouble(), -0.5);
        const QStringList rows = QString(contentOf(csv)).split('\n');
        QCOMPARE(rows[1 + 10].section(',', 2, 2).toDouble(), 0.0); // at 0.1 s it is told to
        QCOMPARE(rows[1 + 20].section(',', 2, 2).toDouble(), 0.25);

        write(track, "0.1,slid,0.25\n");
        const Outcome wrong = call({"run", file, "--seconds", "1", "--controls", track});
        QCOMPARE(wrong.exitCode, 1);
        QVERIFY2(wrong.error.contains("track.csv, line 1")
                     && wrong.error.contains("did you mean \"slide\"?"),
                 qPrintable(wrong.error));
        write(track, "time,control,value\n0.1,slide\n");
        QVERIFY(call({"run", file, "--seconds", "1", "--controls", track})
                    .error.contains("line 2: write TIME,CONTROL,VALUE"));
    }

    // The final scene, as drawn, is the scene that was flown, once what a control draws stands.
    void finalScene()
    {
        QTemporaryDir folder;
        const QStringList torn{scene("torn_sheet"), "--set", "edge x.limit=0.14"};
        const QString file = folder.filePath("torn.ripstop.json");
        QCOMPARE(call(QStringList{"run", "--seconds", "3", "--final", file} + torn).exitCode, 0);
        const QString flown = folder.filePath("flown.ply");
        const QString drawn = folder.filePath("drawn.ply");
        QCOMPARE(call(QStringList{"export", "-o", flown, "--to", "3"} + torn).exitCode, 0);
        QCOMPARE(call({"export", file, "-o", drawn}).exitCode, 0);

        const auto geometry = [](const QString& path) {
            QStringList lines = QString(contentOf(path)).split('\n');
            QStringList kept;
            for (const QString& line : lines)
                if (!line.startsWith("comment") && line.count(' ') != 3) // not links: their loads
                    kept << line;
            return kept;
        };
        QCOMPARE(geometry(drawn), geometry(flown));
    }

    void exportsEveryFormat()
    {
        QTemporaryDir folder;
        for (const char* name :
             {"a kite.obj", "a kite.ply", "a kite.vtp", "a kite.csv", "a kite.pvd"}) {
            const QString path = folder.filePath(name);
            const Outcome outcome = call({"export", scene("delta_kite"), "-o", path, "--from",
                                          "0.05", "--to", "0.1", "--fps", "100"});
            QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
            QVERIFY(QFile::exists(path));
        }
        QCOMPARE(QDir(folder.filePath("a kite")).entryList(QDir::Files).size(), 6);
    }

    // The manual is committed so that the editor and the documentation can show it. Make it again:
    // ripstop-cli properties > resources/help/properties.md
    void manualIsUpToDate()
    {
        const Outcome outcome = call({"properties"});
        QCOMPARE(outcome.exitCode, 0);
        QCOMPARE(QString(outcome.out),
                 QString(contentOf(SOURCE_DIR "/resources/help/properties.md")));
        const QJsonArray rows = call({"properties", "--json"}).json()["properties"].toArray();
        QCOMPARE(std::size_t(rows.size()), allProperties().size());
    }

    void interruptEndsARunCleanly()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("pin.ripstop.json");
        write(file, smallScene());
        QProcess process;
        process.start(CLI_PROGRAM, {"run", file, "--seconds", "1e8", "--json", "--set",
                                    "settings.gravity=0, 0, 0", "--csv", folder.filePath("a.csv")});
        QVERIFY(process.waitForStarted());
        // what it writes has another name until it is whole
        const auto writes = [&] {
            return QDir(folder.path()).entryInfoList({"a.csv.*.part"}).value(0).size() > 0;
        };
        QVERIFY(QTest::qWaitFor(writes, 20000));
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitCode(), 130);
        const QJsonObject result =
            QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QVERIFY(result["interrupted"].toBool());
        QVERIFY(result["steps"].toInt() > 0);
    }

    // It must run where there is no window system.
    void linksNeitherQtNorVtk()
    {
        const QByteArray program = contentOf(CLI_PROGRAM);
        QVERIFY(program.size() > 100000);
        QVERIFY(!program.contains("libQt"));
        QVERIFY(!program.contains("libvtk"));
    }
};

const RegisteredTest registered("test_cli", runWithCore<TestCli>);

} // namespace ripstop::test_cli
#include "test_cli.moc"
