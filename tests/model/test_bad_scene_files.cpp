// Files that are no scenes are refused with one sentence that names file, line, path and what to
// do.
//
// Stages: a table of flawed texts with the sentence that each must give; then files that are cut
// off, huge, or no files at all.
#include "model/scene_texts.h"
#include "registered_test.h"

#include "io/scene_file.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <chrono>

namespace ripstop::test_bad_scene_files {

class TestBadSceneFiles : public QObject
{
    Q_OBJECT

private slots:
    void badFiles_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("path");
        QTest::addColumn<QStringList>("fragments");

        const auto row = [](const char* name, const QString& text, int line, const char* path,
                            const QStringList& fragments) {
            QTest::newRow(name) << text.toUtf8() << line << QString(path) << fragments;
        };
        const QString links = "\"particles\": [{\"id\": 2}, {\"id\": 3}],\n\"links\": [\n";

        // clang-format off
        row("empty file", "", 1, "", {"is empty"});
        row("only white space", " \n\t\n", 1, "", {"is empty"});
        row("not JSON at all", "solid teapot\nfacet", 1, "", {"is not a scene", ".ripstop.json"});
        row("a list", "[1, 2]", 1, "", {"is not a scene"});
        row("an empty object", "{}", 1, "", {"is not a scene", "lacks", "ripstop-scene"});
        row("another format", "{\n\"format\": \"gltf\"}", 2, "format", {"must be \"ripstop-scene\""});
        row("no version", "{\"format\": \"ripstop-scene\"}", 1, "", {"version"});
        row("a newer version", "{\"format\": \"ripstop-scene\",\n\n\"version\": 2}", 3, "version", {"newer", "update Ripstop"});
        row("a newer version behind what it brought", "{\"format\": \"ripstop-scene\",\n\"items\": [{\"type\": \"rotor\"}],\n\"version\": 2}", 3, "version", {"newer"});
        row("version as a text", "{\"format\": \"ripstop-scene\", \"version\": \"1\"}", 1, "version", {"must be 1"});
        row("version zero", "{\"format\": \"ripstop-scene\", \"version\": 0}", 1, "version", {"must be 1"});

        row("cut off", withParticle("\"mass\": 1").left(120), 6, "items[0].particles", {"is not JSON", "restore"});
        row("a missing comma", withPart("\"name\": \"a\"\n\"shown\": true"), 6, "items[0]", {"is not JSON", "mend"});
        row("a comma too many", withPart("\"particles\": [{\"id\": 2},\n]"), 6, "items[0].particles", {"is not JSON"});
        row("a quotation mark missing", withPart("\"name\": \"sail,\n\"shown\": true"), 5, "items[0].name", {"is not JSON", "string"});
        row("a comment", withPart("// the sail\n\"name\": \"a\""), 5, "items[0]", {"is not JSON"});
        row("something behind the end", withItems("") + "\n{}", 7, "", {"is not JSON"});
        row("bytes that are not UTF-8", "", 0, "", {});

        row("not a number", withParticle("\"mass\": NaN"), 7, "items[0].particles[1].mass", {"finite number", "nan"});
        row("infinity", withParticle("\"mass\": Infinity"), 7, "items[0].particles[1].mass", {"finite number", "infinity"});
        row("minus infinity", withParticle("\"position\": [0, -Infinity, 0]"), 7, "items[0].particles[1].position", {"finite number", "-infinity"});
        row("a number beyond doubles", withParticle("\"mass\": 1e999"), 7, "items[0].particles[1].mass", {"finite number", "too large"});
        row("negative mass", withParticle("\n\"mass\": -1"), 8, "items[0].particles[1].mass", {"must be at least 0, not -1"});
        row("a text for a number", withParticle("\"mass\": \"1\""), 7, "items[0].particles[1].mass", {"must be a number, not \"1\""});
        row("null for a number", withParticle("\"mass\": null"), 7, "items[0].particles[1].mass", {"needs a value"});
        row("a list for a number", withParticle("\"mass\": [1]"), 7, "items[0].particles[1].mass", {"must be a number, not a list"});
        row("an object for a number", withParticle("\"mass\": {\"kg\": 1}"), 7, "items[0].particles[1].mass", {"must be a number, not an object"});
        row("a number for a switch", withParticle("\"pinned\": 1"), 7, "items[0].particles[1].pinned", {"must be true or false, not 1"});
        row("a list for a switch", withParticle("\"pinned\": []"), 7, "items[0].particles[1].pinned", {"must be true or false, not a list"});
        row("two numbers for a vector", withParticle("\"position\": [1, 2]"), 7, "items[0].particles[1].position", {"must be three numbers, not 2"});
        row("four numbers for a vector", withParticle("\"position\": [1, 2, 3, 4]"), 7, "items[0].particles[1].position[3]", {"fourth"});
        row("a text in a vector", withParticle("\"position\": [1, \"2\", 3]"), 7, "items[0].particles[1].position[1]", {"must be a number, not \"2\""});
        row("a number for a vector", withParticle("\"position\": 1"), 7, "items[0].particles[1].position", {"must be three numbers, not 1"});
        row("an object for a vector", withParticle("\"position\": {\"x\": 1}"), 7, "items[0].particles[1].position", {"must be three numbers, not an object"});
        row("a fraction of substeps", withItems("").replace("\"version\"", "\"settings\": {\n\"substeps\": 1.5}, \"version\""), 3, "settings.substeps", {"must be a whole number, not 1.5"});
        row("too many substeps", withItems("").replace("\"version\"", "\"settings\": {\n\"substeps\": 1e18}, \"version\""), 3, "settings.substeps", {"must be at most 10000, not 1e18"});
        row("no substeps", withItems("").replace("\"version\"", "\"settings\": {\n\"substeps\": 0}, \"version\""), 3, "settings.substeps", {"must be at least 1, not 0"});
        row("a time step of zero", withItems("").replace("\"version\"", "\"settings\": {\n\"timeStep\": 0}, \"version\""), 3, "settings.timeStep", {"must be at least"});
        row("line ends in a choice", withItems("").replace("\"version\"", "\"settings\": {\n\"integrator\": \"a\\nb\"}, \"version\""), 3, "settings.integrator", {"not \"a b\""});
        row("a misspelt choice", withItems("").replace("\"version\"", "\"settings\": {\n\"integrator\": \"verlt\"}, \"version\""), 3, "settings.integrator", {"must be one of explicit_euler", "not \"verlt\"", "did you mean \"verlet\"?"});
        row("a colour by name", withItems("{\"type\": \"material\", \"id\": 1,\n\"color\": \"red\"}"), 5, "items[0].color", {"#rrggbb"});
        row("a builder's parameter as text", withPart("\"parameters\": {\"span\":\n\"wide\"}"), 6, "items[0].parameters.span", {"must be a number, not \"wide\""});

        row("an item without a type", withItems("{\"id\": 1}"), 4, "items[0]", {"has no \"type\"", "part, material"});
        row("a type that is a number", withItems("{\"id\": 1,\n\"type\": 3}"), 5, "items[0].type", {"must be one of part"});
        row("a type without a letter", withItems("{\"id\": 1,\n\"type\": \"\"}"), 5, "items[0].type", {"must be one of part"});
        row("an unknown item without an id", withItems("{\"type\": \"sail\"}"), 4, "items[0]", {"has no \"id\""});
        row("an unknown item with a text as id", withItems("{\"type\": \"sail\",\n\"id\": \"7\"}"), 5, "items[0].id", {"from 1 to 4000000000"});
        row("the id of an unknown item twice", withItems("{\"type\": \"sail\", \"id\": 7},\n{\"type\": \"wind\", \"id\": 7}"), 5, "items[1].id", {"is used twice", "item of an unknown type in line 4"});
        row("an unknown item that breaks off", withItems("{\"type\": \"sail\", \"id\": 7,\n\"a\": [1}"), 5, "items[0].a", {"is not JSON"});
        row("an element as an item", withItems("{\"id\": 1, \"type\": \"particle\"}"), 4, "items[0].type", {"must be one of part"});
        row("an item that is a number", withItems("7"), 4, "items[0]", {"must be an object"});
        row("items that are no list", withItems("").replace("[", "{").replace("]", "}"), 3, "items", {"must be a list"});
        row("particles that are no list", withPart("\"particles\": 4"), 5, "items[0].particles", {"must be a list"});
        row("a particle that is a list", withPart("\"particles\": [[0, 0, 0]]"), 5, "items[0].particles[0]", {"must be an object"});
        row("settings that are a list", withItems("").replace("\"version\"", "\"settings\": [], \"version\""), 2, "settings", {"must be an object"});
        row("a key twice", withParticle("\"mass\": 1,\n\"mass\": 2"), 8, "items[0].particles[1].mass", {"is there twice"});
        row("a table twice", withPart("\"particles\": [],\n\"particles\": []"), 6, "items[0].particles", {"is there twice"});

        row("a particle without an id", withPart("\"particles\": [\n{\"mass\": 1}]"), 6, "items[0].particles[0]", {"has no \"id\""});
        row("an item without an id", withItems("\n{\"type\": \"wind\"}"), 5, "items[0]", {"has no \"id\""});
        row("the id zero", withItems("{\"type\": \"wind\", \"id\": 0}"), 4, "items[0].id", {"from 1 to 4000000000, not 0"});
        row("a negative id", withItems("{\"type\": \"wind\", \"id\": -3}"), 4, "items[0].id", {"not -3"});
        row("a fraction as id", withItems("{\"type\": \"wind\", \"id\": 1.5}"), 4, "items[0].id", {"not 1.5"});
        row("an id above the range", withItems("{\"type\": \"wind\", \"id\": 4294967295}"), 4, "items[0].id", {"not 4294967295"});
        row("an id beyond 64 bits", withItems("{\"type\": \"wind\", \"id\": 99999999999999999999999}"), 4, "items[0].id", {"from 1 to"});
        row("nextId out of range", withItems("").replace("\"version\"", "\"nextId\": 1e10, \"version\""), 2, "nextId", {"from 1 to"});
        row("an id twice in a table", withPart("\"particles\": [\n{\"id\": 2},\n{\"id\": 3},\n{\"id\": 2}]"), 8, "items[0].particles[2].id", {"used twice", "particle in line 6"});
        row("an id of an item and an element", withPart("\"particles\": [\n{\"id\": 1}]"), 6, "items[0].particles[0].id", {"used twice", "part in line 4"});

        row("a link to nowhere", withPart(links + "{\"id\": 4, \"from\": 2, \"to\": 3},\n{\"id\": 5, \"from\": 2,\n\"to\": 99}]"), 9, "items[0].links[1].to", {"points at 99", "does not exist"});
        row("a link to itself", withPart(links + "{\"id\": 4, \"from\": 2, \"to\": 2}]"), 7, "items[0].links[0]", {"two different particles"});
        row("a link with one end", withPart(links + "{\"id\": 4, \"from\": 2}]"), 7, "items[0].links[0]", {"two different particles"});
        row("a link to a link", withPart(links + "{\"id\": 4, \"from\": 2, \"to\": 4}]"), 7, "items[0].links[0].to", {"points at 4, which is a link", "a particle"});
        row("a panel with two corners", withPart("\"particles\": [{\"id\": 2}, {\"id\": 3}],\n\"panels\": [{\"id\": 4, \"a\": 2, \"b\": 3, \"c\": 3}]"), 6, "items[0].panels[0]", {"three different particles"});
        row("a material that is a particle", withPart(links + "{\"id\": 4, \"from\": 2, \"to\": 3, \"material\": 2}]"), 7, "items[0].links[0].material", {"is a particle", "a material"});
        row("a member of a group that is gone", withItems("{\"type\": \"wind\", \"id\": 1},\n{\"type\": \"group\", \"id\": 2, \"members\": [\n\n77]}"), 7, "items[1].members[0]", {"points at 77"});
        row("a list of ids with a text", withItems("{\"type\": \"group\", \"id\": 2, \"members\": [1, \"a\"]}"), 4, "items[0].members[1]", {"must be an id", "not \"a\""});
        row("a probe of nothing", withItems("{\"type\": \"probe\", \"id\": 2,\n\"target\": 9}"), 5, "items[0].target", {"points at 9"});

        row("a thousand brackets", withPart("\"x\": " + QString("[").repeated(1000)), 5, "items[0].x[0][0][0][0][0]...", {"nested deeper"});
        row("a hundred thousand brackets at the start", QString("[").repeated(100000), 1, "", {"is not a scene"});
        row("a hundred thousand braces", QString("{\"a\":").repeated(100000), 1, "a.a.a.a.a.a.a.a...", {"nested deeper"});
        // clang-format on
    }

    void badFiles()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, line);
        QFETCH(QString, path);
        QFETCH(QStringList, fragments);
        if (qstrcmp(QTest::currentDataTag(), "bytes that are not UTF-8") == 0) {
            text = withPart("\"name\": \"\x01\"").toUtf8();
            text.replace('\x01', "\xff\xfe");
            line = 5;
            path = "items[0].name";
            fragments = {"is not JSON", "UTF-8"};
        }

        const Result<Scene> scene = parseScene(text.toStdString(), "wing.ripstop.json");
        QVERIFY(!scene);
        const QString message = QString::fromStdString(scene.message().english());
        const QString start = QString("wing.ripstop.json, line %1%2")
                                  .arg(line)
                                  .arg(path.isEmpty() ? ": the file " : ", " + path);
        QVERIFY2(message.startsWith(start), qPrintable(message));
        for (const QString& fragment : fragments)
            QVERIFY2(message.contains(fragment), qPrintable(message));
        // one sentence of a length that can be read
        QVERIFY2(message.endsWith('.') && !message.contains('\n'), qPrintable(message));
        QVERIFY2(message.size() < 600, qPrintable(message));
    }

    void zerosBehindACutOffFile()
    {
        std::string text = withParticle("\"mass\": 1").toStdString();
        text.resize(100);
        text.append(1000, '\0'); // what a file system may leave after a power cut
        const Result<Scene> inside = parseScene(text, "wing");
        QVERIFY(!inside);
        QVERIFY2(inside.message().english().find("zero bytes") != std::string::npos,
                 inside.message().english().c_str());

        text = withItems("").toStdString();
        text.append(3, '\0');
        const Result<Scene> behind = parseScene(text, "wing");
        QVERIFY(!behind);
        QVERIFY2(behind.message().english().find("line 6") != std::string::npos,
                 behind.message().english().c_str());
    }

    // A gigabyte of zeros must be refused by its first byte.
    void gigabyteOfZeros()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("zeros.ripstop.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.resize(qint64(1) << 30)); // sparse
        file.close();

        const auto start = std::chrono::steady_clock::now();
        const Result<Scene> scene = readScene(path.toStdString());
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        QVERIFY(!scene);
        QVERIFY(scene.message().english().find("zeros.ripstop.json, line 1") != std::string::npos);
        QVERIFY(taken.count() < 1.0);
    }

    void whatIsNoFile_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("fragment");
        QTest::newRow("a folder") << SOURCE_DIR << "is a folder";
        QTest::newRow("nothing") << SOURCE_DIR "/nothing.ripstop.json"
                                 << "does not exist";
        QTest::newRow("below a file") << SOURCE_DIR "/CMakeLists.txt/a.ripstop.json"
                                      << "does not exist";
        QTest::newRow("endless zeros") << "/dev/zero"
                                       << "is not a scene";
        QTest::newRow("memory that nobody may read") << "/proc/self/mem"
                                                     << "cannot be read";
    }

    void whatIsNoFile()
    {
        QFETCH(QString, path);
        QFETCH(QString, fragment);
        const Result<Scene> scene = readScene(path.toStdString());
        QVERIFY(!scene);
        const QString message = QString::fromStdString(scene.message().english());
        QVERIFY2(message.startsWith(path) && message.contains(fragment), qPrintable(message));
    }
};

const RegisteredTest registered("test_bad_scene_files", runPlain<TestBadSceneFiles>);

} // namespace ripstop::test_bad_scene_files
#include "test_bad_scene_files.moc"
