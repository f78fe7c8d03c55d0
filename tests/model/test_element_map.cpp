// Numbers of elements as formulas of where they lie (select/element_map.h).
//
// Stages: places of particles, links and panels; what a link has of its material; pictures; undo;
// what is refused; and the command line.
#include "model/material_sheets.h"
#include "registered_test.h"

#include "io/scene_file.h"
#include "scene/path.h"
#include "select/element_map.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_element_map {

namespace {

// A link from (0, 0, 0) to (2, 4, 6), and a panel with a corner at (1, 0, 0) besides. Textures are
// (0, 0), (1, 1) and (0.5, 0).
// Ids: material 1, particles 2, 3, 4, link 5, panel 6, part 7.
Scene smallScene()
{
    Scene scene;
    Material cord;
    cord.name = "cord";
    cord.tearRule = TearRule::Force;
    cord.tearLimit = 200.0; // N
    Part part;
    part.name = "part";
    part.particles = {{.id = Id{2}},
                      {.id = Id{3}, .position = Vec3(2, 4, 6), .textureU = 1.0, .textureV = 1.0},
                      {.id = Id{4}, .position = Vec3(1, 0, 0), .textureU = 0.5}};
    part.links = {{.id = Id{5}, .from = Id{2}, .to = Id{3}, .material = Id{1}}};
    part.panels = {{.id = Id{6}, .a = Id{2}, .b = Id{3}, .c = Id{4}, .material = Id{1}}};
    scene.items = {{Id{1}, cord}, {Id{7}, part}};
    scene.nextId = Id{8};
    return scene;
}

double numberAt(const Scene& scene, const Property& property, Id id)
{
    return std::get<double>(property.get(*find(scene, id)));
}

} // namespace

class TestElementMap : public QObject
{
    Q_OBJECT

private slots:
    void placesAreMiddles()
    {
        Scene scene = smallScene();
        const Property& mass = propertyOf<&Particle::mass>();
        const Property& rest = propertyOf<&Link::restLength>();
        const Property& grain = propertyOf<&Panel::grain>();
        (void)apply(scene, mapped(scene, mass, {Id{2}, Id{3}}, "1 + x * y + z")->edit);
        QCOMPARE(numberAt(scene, mass, Id{2}), 1.0);
        QCOMPARE(numberAt(scene, mass, Id{3}), 15.0);
        (void)apply(scene, mapped(scene, rest, {Id{5}}, "x + 10 * y + 100 * z")->edit);
        QCOMPARE(numberAt(scene, rest, Id{5}), 1.0 + 20.0 + 300.0);
        (void)apply(scene, mapped(scene, grain, {Id{6}}, "3 * x + 60 * u + 3 * v")->edit);
        // a grain counts from the side ab, and the map from where the picture goes up: v = 1 at b
        // and 0 along a and c, so up is across ac
        const Vec3 ab(2, 4, 6), ac(1, 0, 0);
        const double up = 90.0 - std::acos(ab.normalized().dot(ac)) / M_PI * 180.0;
        NEAR(numberAt(scene, grain, Id{6}), std::fmod(180.0 - up + 34.0, 180.0), 1e-9);
    }

    // 200 N of the material, and half of that where it is worn. Then it is the link's own.
    void valueIsThatOfTheMaterial()
    {
        Scene scene = smallScene();
        const Scene before = scene;
        const Property& limit = propertyOf<&Link::tearLimit>();
        const auto made = mapped(scene, limit, {Id{5}}, "0.5 * value");
        QCOMPARE(made->count, std::size_t(1));
        QCOMPARE(made->most, 100.0);
        const Edit undo = apply(scene, made->edit);
        QCOMPARE(numberAt(scene, limit, Id{5}), 100.0);
        (void)apply(scene, mapped(scene, limit, {Id{5}}, "0.5 * value")->edit);
        QCOMPARE(numberAt(scene, limit, Id{5}), 50.0);
        (void)apply(scene, mapped(scene, limit, {Id{5}}, "2 * value")->edit);
        (void)apply(scene, undo);
        QVERIFY(scene == before);
    }

    // Black at the lower left, white at the upper right; the middle of the link lies half way.
    void picturesAreSeenAtTheTexture()
    {
        Scene scene = smallScene();
        HeightGrid picture;
        picture.columns = picture.rows = 2;
        picture.height = {0.5, 1.0, 0.0, 0.5}; // the upper row first
        const Property& mass = propertyOf<&Particle::mass>();
        (void)apply(scene, mapped(scene, mass, {Id{2}, Id{3}, Id{4}}, "1 + grey", &picture)->edit);
        QCOMPARE(numberAt(scene, mass, Id{2}), 1.0);
        QCOMPARE(numberAt(scene, mass, Id{3}), 2.0);
        QCOMPARE(numberAt(scene, mass, Id{4}), 1.25);
        const Property& rest = propertyOf<&Link::restLength>();
        (void)apply(scene, mapped(scene, rest, {Id{5}}, "grey", &picture)->edit);
        QCOMPARE(numberAt(scene, rest, Id{5}), 0.5);
    }

    // The same picture laid over particles at (0, 0, 0), (2, 4, 6) and (1, 0, 0) that have no
    // texture: along z and y, as x is the shortest side.
    void picturesLieOverWhatHasNoTexture()
    {
        Scene scene = smallScene();
        for (Particle& particle : std::get<Part>(scene.items.back().item).particles)
            particle.textureU = particle.textureV = 0.0;
        HeightGrid picture;
        picture.columns = picture.rows = 2;
        picture.height = {0.0, 1.0, 0.0, 1.0};
        const Property& strength = propertyOf<&Link::strengthFactor>();
        (void)apply(scene, mapped(scene, strength, {Id{5}}, "0.2 + 0.8 * grey", &picture)->edit);
        NEAR(numberAt(scene, strength, Id{5}), 0.6, 1e-12);
        const Property& mass = propertyOf<&Particle::mass>();
        (void)apply(scene, mapped(scene, mass, {Id{2}, Id{3}, Id{4}}, "grey", &picture)->edit);
        QCOMPARE(numberAt(scene, mass, Id{2}), 0.0);
        QCOMPARE(numberAt(scene, mass, Id{3}), 1.0);
        QCOMPARE(numberAt(scene, mass, Id{4}), 0.0);
    }

    void refusals_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("formula");
        QTest::addColumn<QString>("says");
        QTest::newRow("no number") << "kind"
                                   << "1"
                                   << "kind is no number";
        QTest::newRow("unknown name") << "restLength"
                                      << "x + w"
                                      << "asks for \"w\"";
        QTest::newRow("no formula") << "restLength"
                                    << "x +"
                                    << "";
        QTest::newRow("negative") << "restLength"
                                  << "-x"
                                  << "link 5 the formula gives -1";
        QTest::newRow("not finite") << "restLength"
                                    << "1 / (x - 1)"
                                    << "finite";
        QTest::newRow("1 / 0") << "restLength"
                               << "1 / 0"
                               << "finite";
        QTest::newRow("empty") << "restLength"
                               << " "
                               << "x, y, z, u, v, value, grey";
        QTest::newRow("no picture") << "restLength"
                                    << "grey"
                                    << "no picture";
    }
    void refusals()
    {
        QFETCH(QString, key);
        QFETCH(QString, formula);
        QFETCH(QString, says);
        const Scene scene = smallScene();
        const auto made = mapped(scene, *findProperty(Kind::Link, key.toStdString()), {Id{5}},
                                 formula.toStdString());
        QVERIFY(!made);
        const QString message = QString::fromStdString(made.message().english());
        QVERIFY2(message.contains(says), qPrintable(message));
    }

    // A formula may vanish or be endless where it is read, as long as it is none at the elements.
    void plainNumbersHaveNoUnits()
    {
        Scene scene = smallScene(); // the link is at x = 1
        const Property& rest = propertyOf<&Link::restLength>();
        for (const auto& [formula, length] : {std::pair("2 + 0 * x", 2.0),
                                              {"1 / (x - 0.5625)", 1.0 / 0.4375},
                                              {"4 - ln(x)", 4.0}}) {
            (void)apply(scene, mapped(scene, rest, {Id{5}}, formula)->edit);
            NEAR(numberAt(scene, rest, Id{5}), length, 1e-12);
        }
    }

    // The middle of the box around (0, 0, 0) and (2, 4, 6) is (1, 2, 3); its particles are a
    // half of its diagonal from there, and a fifth of its longest side is 1.2 m.
    void theFormulaToBeginWithIsInTheMiddle()
    {
        Scene scene = smallScene();
        const Property& mass = propertyOf<&Particle::mass>();
        auto& part = std::get<Part>(scene.items.back().item);
        part.particles[2].position = Vec3(1, 2, 3);
        for (Particle& particle : part.particles)
            particle.mass = 2.0;
        const std::vector<Id> all{Id{2}, Id{3}, Id{4}};
        (void)apply(scene, mapped(scene, mass, all, fadingSpot(scene, mass, all))->edit);
        NEAR(numberAt(scene, mass, Id{4}), 1.0, 1e-12);
        NEAR(numberAt(scene, mass, Id{2}), 2.0 - std::exp(-14.0 / 1.44), 1e-12);
        for (Particle& particle : part.particles)
            particle.position -= Vec3(1, 4, 4); // so that there is 0 and less than 0
        for (Particle& particle : part.particles)
            particle.mass = 2.0;
        (void)apply(scene, mapped(scene, mass, all, fadingSpot(scene, mass, all))->edit);
        NEAR(numberAt(scene, mass, Id{4}), 1.0, 1e-12);
        QVERIFY(fadingSpot(scene, mass, {}).empty());
    }

    void aMaterialThatNeverTearsHasNoValue()
    {
        Scene scene = smallScene();
        std::get<Material>(scene.items.front().item).tearRule = TearRule::Never;
        const auto made = mapped(scene, propertyOf<&Link::tearLimit>(), {Id{5}}, "value");
        QVERIFY(!made && made.message().english().find("never tears") != std::string::npos);
    }

    // Threads of 100 N that are worn to a fifth towards one side; diagonals stay as they are.
    void theCommandLineWearsASheet()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("sheet.ripstop.json");
        const QString out = folder.filePath("worn.ripstop.json");
        Scene scene = *build(*findBuilder("cloth"), sheet(8, 2, 0.3));
        QVERIFY(!saveScene(scene, file.toStdString()));
        const auto exitCode = [](const QStringList& arguments) {
            QProcess process;
            process.start(CLI_PROGRAM, arguments);
            return process.waitForFinished() ? process.exitCode() : -1;
        };
        const QStringList wear{"map",
                               file,
                               "sheet.links.tearLimit",
                               "-o",
                               out,
                               "--of",
                               "structural",
                               "--set",
                               "structural.tearRule=force",
                               "--set",
                               "structural.tearLimit=100"};
        QCOMPARE(exitCode(wear), 2); // which formula?
        QVERIFY(exitCode(wear + QStringList{"--formula", "value * z z"}) != 0);
        QCOMPARE(exitCode(wear + QStringList{"--formula", "value * (0.2 + 0.8 * u)"}), 0);
        const Result<Scene> read = readScene(out.toStdString());
        QVERIFY(read);
        std::size_t mappedLinks = 0;
        forEachPart(*read, [&](Id, const Part& part) {
            for (const Link& link : part.links) {
                const bool isStructural =
                    findItem<Material>(*read, link.material)->name == "structural";
                QCOMPARE(link.tearLimit.has_value(), isStructural);
                if (!isStructural)
                    continue;
                ++mappedLinks;
                const auto u = [&](Id id) { return findRow(part.particles, id)->textureU; };
                NEAR(*link.tearLimit, 100.0 * (0.2 + 0.4 * (u(link.from) + u(link.to))), 1e-12);
            }
        });
        QCOMPARE(mappedLinks, std::size_t(2 * 8 * 9));
    }
};

const RegisteredTest registered("test_element_map", runPlain<TestElementMap>);

} // namespace ripstop::test_element_map
#include "test_element_map.moc"
