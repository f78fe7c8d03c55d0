// Paths and assignments, as the command line's --set takes them.
//
// Stages: paths that are found and the nearest ones that are proposed for others; then assignments
// of numbers, vectors and texts, and those that are refused with a sentence.
#include "registered_test.h"
#include "scene/path.h"

#include <QtTest>

namespace ripstop::test_path {

namespace {

Scene sample()
{
    Part kite{"kite"};
    kite.particles = {{Id{11}}, {Id{12}}};
    kite.links = {{Id{13}, Id{11}, Id{12}}};
    kite.panels = {{Id{14}, Id{11}, Id{12}, Id{11}}};
    Part tail{"tail.left"};
    tail.particles = {{Id{15}}};
    Scene scene;
    scene.items = {{Id{1}, kite},
                   {Id{2}, tail},
                   {Id{3}, Wind{"wind"}},
                   {Id{4}, Material{"fabric"}},
                   {Id{5}, Wind{"upper wind"}}};
    scene.nextId = Id{16};
    return scene;
}

} // namespace

class TestPath : public QObject
{
    Q_OBJECT

private slots:
    void finds_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("property");
        QTest::addColumn<QList<quint32>>("targets");

        // clang-format off
        QTest::newRow("setting")          << "settings.timeStep"         << "settings.timeStep"  << QList<quint32>{quint32(settingsId)};
        QTest::newRow("item by name")     << "wind.velocity"             << "wind.velocity"      << QList<quint32>{3};
        QTest::newRow("name with blank")  << "upper wind.velocity"       << "wind.velocity"      << QList<quint32>{5};
        QTest::newRow("name with dot")    << "tail.left.shown"           << "part.shown"         << QList<quint32>{2};
        QTest::newRow("item by id")       << "#4.stiffness"              << "material.stiffness" << QList<quint32>{4};
        QTest::newRow("particle by id")   << "#12.mass"                  << "particle.mass"      << QList<quint32>{12};
        QTest::newRow("link by id")       << "#13.restLength"            << "link.restLength"    << QList<quint32>{13};
        QTest::newRow("panel by id")      << "#14.material"              << "panel.material"     << QList<quint32>{14};
        QTest::newRow("all particles")    << "kite.particles.mass"       << "particle.mass"      << QList<quint32>{11, 12};
        QTest::newRow("all links")        << "kite.links.restLength"     << "link.restLength"    << QList<quint32>{13};
        QTest::newRow("all panels")       << "kite.panels.material"      << "panel.material"     << QList<quint32>{14};
        QTest::newRow("dot, then table")  << "tail.left.particles.mass"  << "particle.mass"      << QList<quint32>{15};
        // clang-format on
    }

    void finds()
    {
        QFETCH(QString, path);
        QFETCH(QString, property);
        QFETCH(QList<quint32>, targets);
        const Result<Place> place = findPlace(sample(), path.toStdString());
        QVERIFY2(place, place ? "" : place.message().english().c_str());
        QCOMPARE(QString::fromStdString(std::string(kindName(place->property->kind)) + "."
                                        + std::string(place->property->key)),
                 property);
        QList<quint32> found;
        for (const Id id : place->targets)
            found << quint32(id);
        QCOMPARE(found, targets);
    }

    // A name that items share means the first that has the property, and paths of the others go by
    // their ids. Problems tell of names that two of a kind share (test_check).
    void namesThatAreShared()
    {
        Scene scene = sample();
        scene.items.push_back({Id{6}, Material{"kite"}});
        QCOMPARE(findPlace(scene, "kite.stiffness")->targets, std::vector{Id{6}});
        QCOMPARE(findPlace(scene, "kite.carrier")->targets, std::vector{Id{1}});
        scene.items.push_back({Id{7}, Material{"fabric"}});
        QCOMPARE(findPlace(scene, "fabric.stiffness")->targets, std::vector{Id{4}});
        QCOMPARE(pathOf(scene, Id{7}, propertyOf<&Material::stiffness>()),
                 std::string("#7.stiffness"));
        QCOMPARE(pathOf(scene, Id{4}, propertyOf<&Material::stiffness>()),
                 std::string("fabric.stiffness"));
    }

    void suggests_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("says");

        // clang-format off
        QTest::newRow("no dot")           << "timeStep"             << "write ITEM.PROPERTY";
        QTest::newRow("nothing")          << ""                     << "write ITEM.PROPERTY";
        QTest::newRow("misspelt key")     << "settings.timestep"    << "did you mean \"timeStep\"?";
        QTest::newRow("misspelt name")    << "wnd.velocity"         << "did you mean \"wind\"?";
        QTest::newRow("misspelt setting") << "setings.timeStep"     << "did you mean \"settings\"?";
        QTest::newRow("far from any key") << "wind.temperature"     << "there is name, kind, velocity";
        QTest::newRow("far from a name")  << "parachute.shown"      << "there is settings, kite, tail.left, wind, fabric, upper wind";
        QTest::newRow("key of elements")  << "kite.mass"            << "a part has no property \"mass\"";
        QTest::newRow("misspelt table")   << "kite.particle.mass"   << "has particles, links and panels, not \"particle\"";
        QTest::newRow("id not there")     << "#99.mass"             << "nothing in the scene has the id \"#99\"";
        QTest::newRow("id not a number")  << "#1x.mass"             << "nothing in the scene has the id \"#1x\"";
        QTest::newRow("id too large")     << "#99999999999.mass"    << "nothing in the scene has the id";
        QTest::newRow("empty key")        << "wind."                << "has no property \"\"";
        QTest::newRow("empty name")       << ".mass"                << "no item is called \"\"";
        // clang-format on
    }

    void suggests()
    {
        QFETCH(QString, path);
        QFETCH(QString, says);
        const Result<Place> place = findPlace(sample(), path.toStdString());
        QVERIFY(!place);
        const QString message = QString::fromStdString(place.message().english());
        QVERIFY2(message.contains(says), qPrintable(message));
    }

    void findsItemsOfAKind()
    {
        const Scene scene = sample();
        QCOMPARE(*findNamed(scene, Kind::Wind, "wind"), Id{3});
        QCOMPARE(*findNamed(scene, Kind::Wind, "#3"), Id{3});
        QCOMPARE(QString::fromStdString(findNamed(scene, Kind::Wind, "wnd").message().english()),
                 QString("no wind is called \"wnd\"; did you mean \"wind\"?"));
        QCOMPARE(QString::fromStdString(findNamed(scene, Kind::Part, "#3").message().english()),
                 QString("\"#3\" is a wind, not a part"));
        QCOMPARE(
            QString::fromStdString(findNamed(scene, Kind::Probe, "height").message().english()),
            QString("the scene has no probe"));
    }

    void assigns()
    {
        Scene scene = sample();
        const Result<Edit> edit = assignment(scene, "kite.particles.mass=0.25");
        QVERIFY(edit);
        QCOMPARE(edit->label.english(), std::string("Set Mass"));
        const Edit undo = apply(scene, *edit);
        for (const Particle& particle : findItem<Part>(scene, Id{1})->particles)
            QCOMPARE(particle.mass, 0.25);
        QCOMPARE(findItem<Part>(scene, Id{2})->particles[0].mass, Particle().mass);
        (void)apply(scene, undo);
        QVERIFY(scene == sample());
    }

    void assignsVectorsAndTexts()
    {
        Scene scene = sample();
        for (const char* text :
             {"wind.velocity=0, 0, -6", "settings.title=a = b", "#13.damping="}) {
            const Result<Edit> edit = assignment(scene, text);
            QVERIFY2(edit, edit ? "" : edit.message().english().c_str());
            (void)apply(scene, *edit);
        }
        QVERIFY(findItem<Wind>(scene, Id{3})->velocity == Vec3(0.0, 0.0, -6.0));
        QCOMPARE(scene.settings.title, std::string("a = b"));
        QVERIFY(!findItem<Part>(scene, Id{1})->links[0].damping);
    }

    void refusesAssignments_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");

        QTest::newRow("no value") << "wind.velocity"
                                  << "write PATH=VALUE";
        QTest::newRow("bad path") << "wnd.velocity=1, 2, 3"
                                  << "did you mean \"wind\"?";
        QTest::newRow("bad value") << "#11.mass=heavy"
                                   << "particle.mass must be a number";
        QTest::newRow("out of range") << "#11.mass=-1"
                                      << "must be at least 0";
        QTest::newRow("thousands, or decimals") << "#11.mass=7,000"
                                                << "must be written with 7000 or 7.000, as the "
                                                   "comma may mean either, not \"7,000\"";
        QTest::newRow("no text at all") << ""
                                        << "write PATH=VALUE";
    }

    void refusesAssignments()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Result<Edit> edit = assignment(sample(), text.toStdString());
        QVERIFY(!edit);
        QVERIFY2(QString::fromStdString(edit.message().english()).contains(says),
                 edit.message().english().c_str());
    }
};

const RegisteredTest registered("test_path", runPlain<TestPath>);

} // namespace ripstop::test_path
#include "test_path.moc"
