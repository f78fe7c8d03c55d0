// The scene file: what is written comes back to the last bit, and a save is whole or not at all.
//
// Stages: every property and unknown keys are written and read; the text itself; then saving:
// links and permissions, full disks, pipes, scenes that could not be read again; and the time that
// a large file takes.
#include "model/files.h"
#include "model/scene_texts.h"
#include "registered_test.h"

#include "check/check.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "scene/property.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include <sys/resource.h>
#include <sys/stat.h>

namespace ripstop::test_scene_file {

namespace {

// Four particles, a link, a panel and one item of each kind, all with defaults.
Scene oneOfEach()
{
    Part part;
    part.particles = {{Id{11}}, {Id{12}}, {Id{13}}, {Id{16}}};
    part.links = {{Id{14}, Id{11}, Id{12}}};
    part.panels = {{Id{15}, Id{11}, Id{12}, Id{13}}};
    Scene scene;
    scene.items = {{Id{1}, part},   {Id{2}, Material()}, {Id{3}, Group()}, {Id{4}, Collider()},
                   {Id{5}, Wind()}, {Id{6}, Control()},  {Id{7}, Probe()}, {Id{8}, Plot()}};
    scene.nextId = Id{17};
    return scene;
}

Id idOfExample(Kind kind)
{
    constexpr std::array<std::uint32_t, kindCount> ids{0xffffffff, 11, 14, 15, 1, 2,
                                                       3,          4,  5,  6,  7, 8};
    return Id{ids[std::size_t(kind)]};
}

// Values that the property accepts, among them awkward ones.
std::vector<Value> valuesFor(const Property& property)
{
    std::vector<Value> values;
    if (!property.pointsAt.empty()) {
        std::vector<Id> fitting;
        for (int i = 1; i < kindCount; ++i)
            if (property.pointsAt.contains(Kind(i)))
                fitting.push_back(idOfExample(Kind(i)));
        if (std::holds_alternative<Id>(property.initial))
            // a particle that is no end and no corner yet
            return {Value(property.pointsAt.contains(Kind::Particle) ? Id{16} : fitting.front())};
        return {Value(fitting), Value(std::vector<Id>())};
    }
    const Value initial = property.optional ? Value(0.0) : property.initial;
    if (std::holds_alternative<bool>(initial))
        values = {true, false};
    else if (std::holds_alternative<int>(initial))
        values = {1, 2, 99};
    else if (std::holds_alternative<double>(initial))
        values = {0.0,  -0.0, 0.1,       1.0 / 3.0, 5e-324, 1e22, 1.7976931348623157e308,
                  0.05, 1e-5, 10.0 / 3.0};
    else if (std::holds_alternative<Vec3>(initial))
        values = {Vec3(0.1, -0.0, 1e-300), Vec3(-1.0 / 3.0, 2.0, 123456789.0)};
    else if (std::holds_alternative<NumberRows>(initial))
        values = {NumberRows{{0.0, -0.0, 1.0 / 3.0}, {45.5, 1e22, 5e-324}},
                  NumberRows{{-1.5, -0.0, 1.0 / 3.0, 1e22}, {45.5, 5e-324, 0.1, -2.0}}};
    else if (!property.choices.empty())
        for (const std::string_view choice : property.choices)
            values.emplace_back(std::string(choice));
    else if (property.key == "color")
        values = {"#00FF7f"};
    else
        values = {"", "Segelfl\u00fcgel \"No. 1\"\n\ttab \\ \x01 \U0001f680", "NaN", "#12"};
    if (property.optional)
        values.emplace_back(std::monostate());
    std::erase_if(values, [&](const Value& value) { return refusal(property, value).has_value(); });
    return values;
}

} // namespace

class TestSceneFile : public QObject
{
    Q_OBJECT

private slots:
    void everyPropertyComesBack_data()
    {
        QTest::addColumn<int>("row");
        const auto all = allProperties();
        for (std::size_t i = 0; i < all.size(); ++i)
            QTest::addRow("%s.%s", std::string(kindName(all[i].kind)).c_str(),
                          std::string(all[i].key).c_str())
                << int(i);
    }

    void everyPropertyComesBack()
    {
        QFETCH(int, row);
        const Property& property = allProperties()[std::size_t(row)];
        QVERIFY(!valuesFor(property).empty());
        for (const Value& value : valuesFor(property)) {
            Scene scene = oneOfEach();
            property.set(*find(scene, idOfExample(property.kind)), value);

            const std::string text = sceneText(scene);
            const Result<Scene> read = parseScene(text, "test");
            QVERIFY2(read, read ? "" : read.message().english().c_str());
            QVERIFY2(*read == scene, text.c_str());
            QCOMPARE(sceneText(*read), text); // zero and minus zero differ here
            const Value back = property.get(*find(*read, idOfExample(property.kind)));
            QCOMPARE(textFromValue(back), textFromValue(value));
        }
    }

    void goldenFileOfVersion1()
    {
        const auto file =
            std::filesystem::path(SOURCE_DIR "/tests/model/golden/scene_v1.ripstop.json");
        const Result<Scene> scene = readScene(file);
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());

        QCOMPARE(scene->settings.title, std::string("One of everything"));
        QCOMPARE(scene->settings.integrator, Integrator::Verlet);
        QCOMPARE(scene->settings.gravity, Vec3(0.0, -9.81, 0.0));
        QCOMPARE(scene->items.size(), std::size_t(7));
        QCOMPARE(scene->nextId, Id{40});
        const Part& sail = *findItem<Part>(*scene, Id{1});
        QCOMPARE(sail.builder, std::string("cloth"));
        QCOMPARE(sail.parameters, (std::map<std::string, double>{{"columns", 1}, {"width", 0.5}}));
        QCOMPARE(sail.particles.size(), std::size_t(4));
        QCOMPARE(sail.particles[1].velocity, Vec3(0.0, 0.0, 1.5));
        QVERIFY(sail.particles[0].pinned);
        QCOMPARE(sail.links[1].kind, LinkKind::Spring);
        QCOMPARE(sail.links[1].stiffness, std::optional(250.0));
        QVERIFY(!sail.links[0].stiffness);
        QCOMPARE(sail.links[2].compliance, std::optional(1e-6));
        QCOMPARE(sail.panels[0].c, Id{4});
        QCOMPARE(findItem<Material>(*scene, Id{20})->tearRule, TearRule::Strain);
        QCOMPARE(findItem<Group>(*scene, Id{21})->members, (std::vector{Id{2}, Id{3}, Id{5}}));
        QCOMPARE(findItem<Collider>(*scene, Id{22})->response, Response::Slide);
        QCOMPARE(findItem<Control>(*scene, Id{24})->keyMore, std::string("Right"));
        QCOMPARE(findItem<Probe>(*scene, Id{25})->target, Id{4});

        const Result<Scene> again = parseScene(sceneText(*scene), "again");
        QVERIFY(again);
        QVERIFY(*again == *scene);
    }

    void textIsStableAndTerse()
    {
        Scene scene = oneOfEach();
        const std::string text = sceneText(scene);
        QCOMPARE(sceneText(*parseScene(text, "test")), text);

        // one element per line, with nothing that equals its default
        const QStringList lines = QString::fromStdString(text).split('\n');
        QVERIFY(lines.contains("        {\"id\": 11},"));
        QVERIFY(lines.contains("        {\"id\": 14, \"from\": 11, \"to\": 12}"));
        QVERIFY(text.find("timeStep") == std::string::npos);

        scene = Scene();
        QVERIFY(*parseScene(sceneText(scene), "empty scene") == scene);
    }

    void unknownKeysSurvive_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("kept");

        const QString value =
            "{\"a\": [1, -2.50, 1e3, {\"b\": null}], \"c\": \"q\\\"\\n\", \"d\": {}, \"e\": []}";
        QTest::newRow("in the file")
            << withItems("").replace("\"version\"", "\"x y\": " + value + ", \"version\"")
            << "\"x y\": " + value;
        QTest::newRow("in the settings") << withItems("").replace(
            "\"version\"", "\"settings\": {\"humidity\": " + value + "}, \"version\"")
                                         << "\"humidity\": " + value;
        QTest::newRow("in an item")
            << withItems("{\"type\": \"wind\", \"id\": 1, \"gusts\": " + value + "}")
            << "\"gusts\": " + value;
        QTest::newRow("in a part") << withPart("\"layer\": " + value) << "\"layer\": " + value;
        QTest::newRow("in an element") << withParticle("\"batch\": " + value + ", \"mass\": 2")
                                       << "\"mass\": 2, \"batch\": " + value;
        QTest::newRow("before the id")
            << withPart("\"particles\": [{\"z\": 1, \"id\": 2, \"y\": 2}]")
            << "{\"id\": 2, \"z\": 1, \"y\": 2}";
        QTest::newRow("a number beyond 64 bits")
            << withPart("\"serial\": 123456789012345678901234567890")
            << "\"serial\": 123456789012345678901234567890";
        QTest::newRow("deep inside")
            << withPart("\"tree\": [[[[[[[[1]]]]]]]]") << "[[[[[[[[1]]]]]]]]";
    }

    void unknownKeysSurvive()
    {
        QFETCH(QString, text);
        QFETCH(QString, kept);
        const Result<Scene> scene = parseScene(text.toStdString(), "test");
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());
        const std::string written = sceneText(*scene);
        QVERIFY2(QString::fromStdString(written).contains(kept), written.c_str());
        QVERIFY(*parseScene(written, "again") == *scene);
        QCOMPARE(sceneText(*parseScene(written, "again")), written);
    }

    void readsWhatOthersWrite_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected"); // a piece of what we write instead

        QTest::newRow("a whole number as 4.0") << withItems("").replace(
            "\"version\"", "\"settings\": {\"substeps\": 7.0}, \"version\"")
                                               << "\"substeps\": 7";
        QTest::newRow("an absent value as null")
            << withPart("\"particles\": [{\"id\": 2}, {\"id\": 3}], \"links\": [{\"id\": 4, "
                        "\"from\": 2, \"to\": 3, \"stiffness\": null}]")
            << "{\"id\": 4, \"from\": 2, \"to\": 3}";
        QTest::newRow("elements out of order")
            << withPart("\"particles\": [{\"id\": 9}, {\"id\": 2}, {\"id\": 5, \"mass\": 1}]")
            << "{\"id\": 2},\n        {\"id\": 5, \"mass\": 1},\n        {\"id\": 9}";
        QTest::newRow("keys in order of the alphabet")
            << QString("{\"format\": \"ripstop-scene\", \"items\": [{\"id\": 3, \"kind\": "
                       "\"weight_shift\", \"type\": \"control\"}], \"version\": 1}")
            << "\"kind\": \"weight_shift\"";
        QTest::newRow("a mark before UTF-8")
            << QChar(0xfeff) + withItems("{\"type\": \"wind\", \"id\": 5}") // a text loses it
            << "\"id\": 5";
        QTest::newRow("nextId left out")
            << withItems("{\"type\": \"wind\", \"id\": 5}") << "\"nextId\": 6";
        QTest::newRow("nextId below an id")
            << withItems("{\"type\": \"wind\", \"id\": 5}")
                   .replace("\"version\"", "\"nextId\": 2, \"version\"")
            << "\"nextId\": 6";
        QTest::newRow("a free particle without mass")
            << withParticle("\"mass\": 0") << "\"mass\": 0";
        QTest::newRow("Windows line ends")
            << withParticle("\"mass\": 3").replace("\n", "\r\n") << "\"mass\": 3";
        QTest::newRow("the largest id")
            << withItems("{\"type\": \"wind\", \"id\": 4000000000}") << "\"nextId\": 4000000001";
    }

    void readsWhatOthersWrite()
    {
        QFETCH(QString, text);
        QFETCH(QString, expected);
        const Result<Scene> scene = parseScene(text.toStdString(), "test");
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());
        const std::string written = sceneText(*scene);
        QVERIFY2(QString::fromStdString(written).contains(expected), written.c_str());
    }

    void savesAndReads()
    {
        QTemporaryDir folder;
        const auto path = folder.filePath("a wing, \u00fcberarbeitet.ripstop.json").toStdString();
        const Scene scene = oneOfEach();
        QVERIFY(!saveScene(scene, path));
        QVERIFY(*readScene(path) == scene);

        Scene changed = scene;
        changed.settings.title = "second";
        QVERIFY(!saveScene(changed, path));
        QVERIFY(*readScene(path) == changed);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1); // nothing left behind
    }

    void keepsLinksAndPermissions()
    {
        QTemporaryDir folder;
        const QString target = folder.filePath("target.ripstop.json");
        const QString link = folder.filePath("link.ripstop.json");
        write(target, "old");
        QVERIFY(QFile::link(target, link));
        QVERIFY(QFile::setPermissions(target, QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(!saveScene(oneOfEach(), link.toStdString()));
        QVERIFY(QFileInfo(link).isSymLink());
        QVERIFY(contentOf(target).contains("ripstop-scene"));
        const auto kept = std::filesystem::status(target.toStdString()).permissions();
        QCOMPARE(kept, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }

    // A full disk: the limit on file sizes makes the write fail half-way.
    void failedSaveLeavesTheOldFile()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("wing.ripstop.json");
        write(path, "the old content");

        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit small{100, before.rlim_max};
        std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &small);
        const std::optional<Failure> failure = saveScene(oneOfEach(), path.toStdString());
        setrlimit(RLIMIT_FSIZE, &before);

        QVERIFY(failure);
        QVERIFY2(failure->message.english().find("was not saved") != std::string::npos,
                 failure->message.english().c_str());
        QCOMPARE(contentOf(path), QByteArray("the old content"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void savesNowhere_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("why");
        QTest::newRow("a folder that is missing") << "/nowhere/at all/wing.ripstop.json"
                                                  << "there is no folder /nowhere/at all; make it";
        QTest::newRow("a folder that nobody can write to") << "/proc/wing.ripstop.json"
                                                           << "was not saved: ";
        QTest::newRow("a folder instead of a file") << SOURCE_DIR << "was not saved: ";
    }

    void savesNowhere()
    {
        QFETCH(QString, path);
        QFETCH(QString, why);
        const std::optional<Failure> failure = saveScene(oneOfEach(), path.toStdString());
        QVERIFY(failure);
        const QString told = QString::fromStdString(failure->message.english());
        QVERIFY2(told.startsWith(path + ' ') && told.contains(why), qPrintable(told));
    }

    void longWorkAsksBefore()
    {
        QTemporaryDir folder;
        QVERIFY(!unwritable(folder.filePath("new.ripstop.json").toStdString()));
        QVERIFY(!unwritable("in_the_folder_where_one_is.ripstop.json"));
        QVERIFY(!unwritable("/dev/null"));
        QVERIFY(unwritable("/nowhere/at all/wing.ripstop.json"));
        QVERIFY(unwritable(SOURCE_DIR));
    }

    // A file never takes the place of a pipe or of /dev/null.
    void aPipeIsWrittenAsItIs()
    {
        QTemporaryDir folder;
        const std::string file = folder.filePath("pipe").toStdString();
        QCOMPARE(mkfifo(file.c_str(), 0600), 0);
        std::string read;
        std::thread reader([&] {
            std::ifstream in(file);
            std::getline(in, read);
        });
        const std::optional<Failure> failure = replaceFile(file, "kite\n");
        reader.join();
        QVERIFY(!failure);
        QCOMPARE(read, std::string("kite"));
        QVERIFY(std::filesystem::is_fifo(file));
    }

    void refusesToSaveWhatItCouldNotRead_data()
    {
        QTest::addColumn<double>("mass");   // kg
        QTest::addColumn<double>("height"); // m
        QTest::addColumn<QString>("fragment");
        QTest::newRow("not a number")
            << 1.0 << std::nan("") << "position of particle 12 must be three finite numbers";
        QTest::newRow("infinite mass")
            << HUGE_VAL << 0.0 << "mass of particle 12 must be a finite number";
        QTest::newRow("negative mass") << -1.0 << 0.0 << "mass of particle 12 must be at least 0";
    }

    // What cannot be read again must not replace a file that can.
    void refusesToSaveWhatItCouldNotRead()
    {
        QFETCH(double, mass);
        QFETCH(double, height);
        QFETCH(QString, fragment);
        QTemporaryDir folder;
        const QString path = folder.filePath("wing.ripstop.json");
        write(path, "the old content");
        Scene scene = oneOfEach();
        Particle& particle = std::get<Part>(scene.items[0].item).particles[1];
        particle.mass = mass;
        particle.position.y() = height;
        const std::optional<Failure> failure = saveScene(scene, path.toStdString());
        QVERIFY(failure);
        QVERIFY2(failure->message.english().find(fragment.toStdString()) != std::string::npos,
                 failure->message.english().c_str());
        QCOMPARE(contentOf(path), QByteArray("the old content"));
    }

    // Text of other programs may hold bytes that are no UTF-8; the file stays readable.
    void bytesThatAreNotUtf8BecomeQuestionMarks()
    {
        Scene scene;
        scene.settings.title = "a\xff\xc0\xaf\xed\xa0\x80z";
        const Result<Scene> read = parseScene(sceneText(scene), "test");
        QVERIFY(read);
        QCOMPARE(read->settings.title, std::string("a??????z"));
    }

    void manyElementsReadInOneBreath()
    {
        constexpr std::uint32_t count = 100000;
        Part part;
        for (std::uint32_t i = 0; i < count; ++i) {
            part.particles.push_back(
                {.id = Id{2 + i}, .position = Vec3(0.1 * i, 1.0 / (i + 1), 3.0)});
            if (i > 0)
                part.links.push_back({.id = Id{1 + count + i}, .from = Id{1 + i}, .to = Id{2 + i}});
        }
        Scene scene;
        scene.items = {{Id{1}, std::move(part)}};
        scene.nextId = Id{2 * count + 1};
        const std::string text = sceneText(scene);
        const auto start = std::chrono::steady_clock::now();
        const Result<Scene> read = parseScene(text, "test");
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        QVERIFY(read);
        QVERIFY(*read == scene);
        QVERIFY(taken.count()
                < 10.0); // 0.2 s on a fast machine; this is against a quadratic reader
    }
};

const RegisteredTest registered("test_scene_file", runPlain<TestSceneFile>);

} // namespace ripstop::test_scene_file
#include "test_scene_file.moc"
