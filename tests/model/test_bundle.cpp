// A run for a paper: what is in its bundle, that it flies again to the same bits, and what is said
// when it does not.
//
// Stages: a bundle is written, flown again and compared; its command lines and its files are
// tried; then recordings; then what differs or is wrong is told; and writing is whole or not at
// all, also over an older bundle.
#include "bundle/bundle.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_bundle {

namespace {

QStringList filesIn(const QString& folder)
{
    return QDir(folder).entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

Outcome wrapped(const QString& of, const QString& target, const QStringList& more = {})
{
    return call(QStringList{"bundle", of, "-o", target} + more);
}

} // namespace

class TestBundle : public QObject
{
    Q_OBJECT

private slots:
    void fliesAgain_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("target");
        QTest::newRow("folder") << "delta_kite"
                                << "kite";
        QTest::newRow("zip") << "delta_kite"
                             << "kite.zip";
        QTest::newRow("a sheet that splits") << "split_sheet"
                                             << "sheet.zip";
    }

    void fliesAgain()
    {
        QFETCH(QString, scene);
        QFETCH(QString, target);
        QTemporaryDir folder;
        const QString path = folder.filePath(target);
        const Outcome made = wrapped(ripstop::scene(qPrintable(scene)), path, {"--seconds", "1"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        QCOMPARE(filesIn(folder.path()), QStringList{target});

        const Outcome flown = call({"run", path, "--threads", "2", "--json"});
        QVERIFY2(flown.exitCode == 0, qPrintable(flown.error));
        const Outcome direct =
            call({"run", ripstop::scene(qPrintable(scene)), "--seconds", "1", "--json"});
        QVERIFY(flown.json()["same"].toBool());
        QCOMPARE(flown.json()["hash"].toString(), direct.json()["hash"].toString());
        QCOMPARE(flown.json()["steps"].toInt(), direct.json()["steps"].toInt());
    }

    // Every command line of the README makes its file again, byte for byte.
    void commandLinesMakeTheFilesAgain()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite");
        const QString controls = folder.filePath("pull.csv");
        write(controls, "time (s),control,value (m)\n0.3,pitch,0.1\n");
        QCOMPARE(
            wrapped(scene("hang_glider"), path,
                    {"--seconds", "1", "--controls", controls, "--set", "settings.airDensity=1.1"})
                .exitCode,
            0);
        QDir bundle(path);
        QCOMPARE(filesIn(path),
                 (QStringList{"README.md", "controls.csv", "curves.svg", "manifest.json",
                              "probes.csv", "run.ripstop-run", "scene.ripstop.json"}));
        const QJsonObject manifest =
            QJsonDocument::fromJson(contentOf(bundle.filePath("manifest.json"))).object();
        const QString readme = contentOf(bundle.filePath("README.md"));
        QMap<QString, QByteArray> before;
        for (const char* name : {"probes.csv", "curves.svg", "run.ripstop-run"}) {
            before[name] = contentOf(bundle.filePath(name));
            QVERIFY(bundle.remove(name));
        }
        QCOMPARE(manifest["commands"].toArray().size(), 3);
        const QString here = QDir::currentPath();
        QDir::setCurrent(path);
        for (const QJsonValue& command : manifest["commands"].toArray()) {
            QVERIFY(readme.contains(command.toString()));
            QStringList words = command.toString().split(' ');
            QCOMPARE(words.takeFirst(), QString("ripstop-cli"));
            if (words != QStringList{"run", "."}) {
                const Outcome outcome = call(words);
                QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
            }
        }
        QDir::setCurrent(here);
        for (const QString& name : before.keys())
            QCOMPARE(contentOf(bundle.filePath(name)), before[name]);
        const QByteArray table = before["probes.csv"];
        QVERIFY(table.contains(manifest["hash_at_start"].toString().toUtf8()));
        QVERIFY(table.contains(manifest["hash_at_end"].toString().toUtf8()));
        QCOMPARE(call({"run", path}).exitCode, 0);
    }

    // What colliders name comes along, also after the original is gone.
    void bringsTheFilesThatTheSceneNames()
    {
        QTemporaryDir folder;
        const QString hill = folder.filePath("hill.pgm");
        write(hill, "P2\n2 2\n255\n0 10\n20 30\n");
        Result<Scene> flat = readScene(scene("pendulum").toStdString());
        Collider ground;
        ground.name = "hill";
        ground.shape = ColliderShape::HeightField;
        ground.file = "hill.pgm";
        const Id id = takeId(*flat);
        flat->items.push_back({id, ground});
        const QString file = folder.filePath("pendulum.ripstop.json");
        QVERIFY(!saveScene(*flat, file.toStdString()));
        const QString run = folder.filePath("pendulum.ripstop-run");
        QCOMPARE(call({"run", file, "--seconds", "0.5", "--record", run}).exitCode, 0);
        const QString ofScene = folder.filePath("scene.zip"), ofRun = folder.filePath("run.zip");
        const Outcome made = wrapped(file, ofScene, {"--seconds", "0.5"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const Outcome madeOfRun = wrapped(run, ofRun);
        QVERIFY2(madeOfRun.exitCode == 0, qPrintable(madeOfRun.error));
        QVERIFY(QFile::remove(hill));
        for (const QString& path : {ofScene, ofRun}) {
            const Outcome flown = call({"run", path});
            QVERIFY2(flown.exitCode == 0, qPrintable(flown.error));
        }
        for (const QString& lost : {file, run}) {
            const Outcome refused = wrapped(lost, folder.filePath("none.zip"));
            QCOMPARE(refused.exitCode, 1);
            QVERIFY2(refused.error.contains("hill.pgm"), qPrintable(refused.error));
        }
        QVERIFY(!QFile::exists(folder.filePath("none.zip")));
    }

    // They are no part of the flight, and found again beside the scene.
    void bringsPicturesOnFabric()
    {
        const QTemporaryDir folder;
        const QString run = folder.filePath("flag.ripstop-run");
        QCOMPARE(call({"run", scene("printed_flag"), "--seconds", "0.1", "--record", run}).exitCode,
                 0);
        for (const QString& of : {scene("printed_flag"), run}) {
            const QString path = folder.filePath("flag.zip");
            const Outcome made =
                wrapped(of, path, of == run ? QStringList() : QStringList{"--seconds", "0.1"});
            QVERIFY2(made.exitCode == 0, qPrintable(made.error));
            const auto bundle = openBundle(path.toStdString());
            QVERIFY(bundle);
            const Result<Scene> flag = readScene((bundle->folder / "scene.ripstop.json").string());
            QVERIFY(flag);
            int pictures = 0;
            for (const Entry& entry : flag->items)
                if (const auto* material = std::get_if<Material>(&entry.item);
                    material && !material->picture.empty()) {
                    ++pictures;
                    QVERIFY2(std::filesystem::exists(bundle->folder / material->picture),
                             material->picture.c_str());
                }
            QCOMPARE(pictures, 1);
        }
    }

    void aRecordingIsBundledAsItWasFlown()
    {
        QTemporaryDir folder;
        const QString run = folder.filePath("kite.ripstop-run");
        const QString path = folder.filePath("kite.zip");
        QCOMPARE(call({"run", scene("delta_kite"), "--seconds", "1", "--record", run, "--csv",
                       folder.filePath("kite.csv")})
                     .exitCode,
                 0);
        const Outcome made = wrapped(run, path);
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const auto bundle = openBundle(path.toStdString());
        QVERIFY(bundle);
        QCOMPARE(contentOf(QString::fromStdString((bundle->folder / "probes.csv").string())),
                 contentOf(folder.filePath("kite.csv")));
        const Outcome flown = call({"run", path});
        QVERIFY2(flown.exitCode == 0, qPrintable(flown.error));
        QCOMPARE(wrapped(run, path, {"--seconds", "3"}).exitCode, 2);
    }

    void saysWhatDiffers()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite");
        QCOMPARE(wrapped(scene("delta_kite"), path, {"--seconds", "0.5"}).exitCode, 0);
        const QString file = path + "/scene.ripstop.json";
        Result<Scene> edited = readScene(file.toStdString());
        edited->settings.airDensity *= 1.01;
        QVERIFY(!saveScene(*edited, file.toStdString()));
        const Outcome flown = call({"run", path, "--json"});
        QCOMPARE(flown.exitCode, 4);
        QVERIFY2(flown.error.contains("scene.ripstop.json"), qPrintable(flown.error));
        const QJsonObject difference = flown.json()["difference"].toObject();
        QCOMPARE(difference["step"].toInt(), 1); // in still air the first step differs
        QVERIFY(difference["particle"].isDouble());
    }

    void theManifestIsHeldToItsWord()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite");
        QCOMPARE(wrapped(scene("delta_kite"), path, {"--seconds", "0.2"}).exitCode, 0);
        const QString file = path + "/manifest.json";
        const QByteArray hash =
            QJsonDocument::fromJson(contentOf(file)).object()["hash_at_end"].toString().toUtf8();
        write(file, contentOf(file).replace(hash, "0123456789abcdef"));
        const Outcome flown = call({"run", path});
        QCOMPARE(flown.exitCode, 4);
        QVERIFY2(flown.error.contains("0123456789abcdef"), qPrintable(flown.error));
    }

    void whatIsWrongIsSaid_data()
    {
        QTest::addColumn<QString>("harm");
        QTest::addColumn<QString>("words");
        QTest::newRow("cut zip") << "cut"
                                 << "damaged or cut off";
        QTest::newRow("a changed byte") << "byte"
                                        << "damaged or cut off";
        QTest::newRow("no zip at all") << "text"
                                       << "damaged or cut off";
        QTest::newRow("a file is missing") << "missing"
                                           << "no run.ripstop-run in it";
        QTest::newRow("no manifest") << "manifest"
                                     << "no manifest.json";
        QTest::newRow("another manifest") << "other"
                                          << "no manifest of a bundle";
        QTest::newRow("a damaged recording") << "recording"
                                             << "cut off after";
        QTest::newRow("a scene that cannot be read") << "scene"
                                                     << "scene.ripstop.json";
    }

    void whatIsWrongIsSaid()
    {
        QFETCH(QString, harm);
        QFETCH(QString, words);
        QTemporaryDir folder;
        const bool isZip = harm == "cut" || harm == "byte" || harm == "text";
        const QString path = folder.filePath(isZip ? "kite.zip" : "kite");
        QCOMPARE(wrapped(scene("delta_kite"), path, {"--seconds", "0.5"}).exitCode, 0);
        QByteArray bytes = contentOf(path);
        if (harm == "cut")
            write(path, bytes.left(bytes.size() * 2 / 3));
        else if (harm == "byte")
            write(path,
                  bytes.replace(bytes.size() / 2, 1, QByteArray(1, bytes[bytes.size() / 2] ^ 1)));
        else if (harm == "text")
            write(path, "no zip");
        else if (harm == "missing")
            QVERIFY(QFile::remove(path + "/run.ripstop-run"));
        else if (harm == "manifest")
            QVERIFY(QFile::remove(path + "/manifest.json"));
        else if (harm == "other")
            write(path + "/manifest.json", "{}");
        else if (harm == "recording")
            QVERIFY(QFile::resize(path + "/run.ripstop-run",
                                  QFile(path + "/run.ripstop-run").size() * 2 / 3));
        else
            write(path + "/scene.ripstop.json", "{");
        const Outcome flown = call({"run", path});
        QCOMPARE(flown.exitCode, 1);
        QVERIFY2(flown.error.contains(words), qPrintable(flown.error));
    }

    void writesAllOrNothing_data()
    {
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("words");
        QTest::newRow("a file is in the place") << "taken"
                                                << "taken is a file";
        QTest::newRow("a folder of other things") << "full"
                                                  << "other things in it";
        QTest::newRow("a folder that is not there") << "no/where.zip"
                                                    << "where.zip";
        QTest::newRow("a place where nobody may write") << "/proc/kite"
                                                        << "/proc/kite";
        QTest::newRow("a folder called zip") << "folder.zip"
                                             << "is a folder";
    }

    void writesAllOrNothing()
    {
        QFETCH(QString, target);
        QFETCH(QString, words);
        QTemporaryDir folder;
        write(folder.filePath("taken"), "mine");
        QVERIFY(QDir(folder.path()).mkpath("full/mine") && QDir(folder.path()).mkdir("folder.zip"));
        const QStringList before = filesIn(folder.path());
        const QString path = target.startsWith('/') ? target : folder.filePath(target);
        const Outcome made = wrapped(scene("delta_kite"), path, {"--seconds", "0.1"});
        QCOMPARE(made.exitCode, 1);
        QVERIFY2(made.error.contains(words), qPrintable(made.error));
        QCOMPARE(filesIn(folder.path()), before);
        QCOMPARE(contentOf(folder.filePath("taken")), QByteArray("mine"));
    }

    // A cancel leaves the older bundle; a new one takes its place.
    void replacesAnOlderBundle_data()
    {
        QTest::addColumn<QString>("target");
        QTest::newRow("folder") << "kite";
        QTest::newRow("zip") << "kite.zip";
    }

    void replacesAnOlderBundle()
    {
        QFETCH(QString, target);
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath(target).toStdString();
        const Result<Scene> kite = readScene(scene("delta_kite").toStdString());
        BundleOrder order;
        order.seconds = 0.2;
        QVERIFY(!writeBundle(*kite, order, path).failure);
        order.seconds = 0.4;
        for (const double until : {0.1, 0.85, 0.95}) { // while it flies, saves, packs
            const auto written =
                writeBundle(*kite, order, path, [&](double share) { return share < until; });
            const bool isPacked = until > 0.9 && target == "kite"; // a rename is not cancelled
            QCOMPARE(!written.failure, isPacked);
            QCOMPARE(filesIn(folder.path()), QStringList{target});
            if (!isPacked)
                QVERIFY(std::abs(openBundle(path)->manifest.end - 0.2) < 0.01);
        }
        QVERIFY(!writeBundle(*kite, order, path).failure);
        QVERIFY(std::abs(openBundle(path)->manifest.end - 0.4) < 0.01);
        QCOMPARE(filesIn(folder.path()), QStringList{target});
    }

    // A flight that stops early is bundled as far as it came.
    void aFlightThatStops()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite.zip");
        const Outcome made = wrapped(scene("delta_kite"), path,
                                     {"--seconds", "5", "--set", "settings.speedLimit=1.5"});
        QCOMPARE(made.exitCode, 3);
        QVERIFY2(made.error.contains("stopped"), qPrintable(made.error));
        QCOMPARE(call({"run", path}).exitCode, 0);
    }
};

const RegisteredTest registered("test_bundle", runWithCore<TestBundle>);

} // namespace ripstop::test_bundle
#include "test_bundle.moc"
