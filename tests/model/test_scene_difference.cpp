// What two designs differ in: that nothing is told of the same design, the right thing of a changed
// one, and a parameter in place of the rows that follow from it. The changes are made here, so the
// answers are known.
#include "author/scene_difference.h"
#include "builders/builder.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "registered_test.h"

#include "scene/path.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_scene_difference {

namespace {

Scene built(const char* name, const Parameters& parameters)
{
    return *build(*findBuilder(name), parameters);
}

Scene changed(Scene scene, const char* assignment)
{
    (void)apply(scene, *ripstop::assignment(scene, assignment));
    return scene;
}

QStringList sentences(const Scene& first, const Scene& second)
{
    QStringList list;
    for (const SceneDifference& difference : differencesOf(first, second))
        list << QString::fromStdString(difference.text.english());
    return list;
}

} // namespace

class TestSceneDifference : public QObject
{
    Q_OBJECT

private slots:
    void theSameSaysNothing()
    {
        const Scene kite = built("delta_kite", {});
        QCOMPARE(sentences(kite, kite), QStringList());
        Scene later = kite;
        (void)takeId(later); // an id that was used and given up
        QCOMPARE(sentences(kite, later), QStringList());
    }

    void aProperty_data()
    {
        QTest::addColumn<QString>("assignment");
        QTest::addColumn<QStringList>("expected");
        const auto row = [](const char* assignment, const char* expected) {
            QTest::newRow(assignment) << QString(assignment) << QStringList{QString(expected)};
        };
        row("wind.velocity=10, 0, 1.5", "wind: Velocity 0, 0, 0 -> 10, 0, 1.5 m/s");
        row("settings.timeStep=0.001", "Settings: Time step 4.16667 -> 1 ms");
        row("settings.title=Blanket", "Settings: Title none -> Blanket");
        row("sheet.particles.mass=0.25", "sheet, 2 particles: Mass 10 -> 250 g");
        row("#2.pinned=true", "sheet, particle 2: Pinned no -> yes");
        row("#2.position=3, 4, 0", "sheet, particle 2: moved by up to 5 m");
        row("sheet.links.restLength=2.5", "sheet, link 4: Rest length 1 -> 2.5 m");
        row("#4.material=7", "sheet, link 4: Material cloth -> cord");
        row("cloth.stiffness=100.00000001", "cloth: Stiffness 100 -> 100.00000001 N/m");
    }

    void aProperty()
    {
        QFETCH(QString, assignment);
        QFETCH(QStringList, expected);
        const Scene scene = small();
        QCOMPARE(sentences(scene, changed(scene, qPrintable(assignment))), expected);
    }

    void massesOfManyByAFactor()
    {
        const Scene scene = changed(small(), "#2.mass=0.02");
        Scene heavier = changed(scene, "#2.mass=0.03");
        heavier = changed(heavier, "#3.mass=0.015");
        QCOMPARE(sentences(scene, heavier), QStringList{"sheet, 2 particles: Mass x 1.5"});
    }

    void partsThatComeAndGo()
    {
        Scene with = small();
        Part patch;
        patch.name = "patch";
        patch.particles.push_back({.id = Id{40}});
        (void)apply(with, Edit{{}, {AddItem{1, {Id{41}, patch}}}});
        const QString what = ": patch (1 particles, 0 links, 0 panels)";
        QCOMPARE(sentences(small(), with), QStringList{"Part added" + what});
        QCOMPARE(sentences(with, small()), QStringList{"Part removed" + what});
    }

    // Masses are said as people say them, here as everywhere.
    void sizesAreSaidInReadableUnits()
    {
        Scene scene = changed(small(), "sheet.particles.mass=0");
        scene = changed(scene, "#2.mass=0.206257");
        const std::string size = sizeOf(scene).english();
        QVERIFY2(size.ends_with(" panels, 206.3 g"), size.c_str());
    }

    void rowsThatComeAndGo()
    {
        Scene more = small();
        (void)apply(more, Edit{{}, {AddRows{Id{1}, {{.id = Id{40}}}, {}, {}}}});
        const auto list = differencesOf(small(), more);
        QCOMPARE(list.size(), std::size_t(1));
        QCOMPARE(list.front().text.english(), std::string("sheet: particles added 1, removed 0"));
        QCOMPARE(list.front().inSecond, std::vector<Id>{Id{40}});
    }

    // A parameter, and the one thing outside the part that it decides.
    void aParameterInPlaceOfRows()
    {
        const Scene narrow = built("delta_kite", {{"span", 2.0}});
        const Scene wide = built("delta_kite", {{"span", 2.4}});
        QCOMPARE(sentences(narrow, wide), QStringList{"kite: span 2 -> 2.4 m"});
        const QStringList finer =
            sentences(narrow, built("delta_kite", {{"span", 2.0}, {"segments", 20}}));
        QCOMPARE(finer.first().left(14), QString("kite: segments"));
        QVERIFY2(finer.size() < 8, qPrintable(finer.join('\n')));
    }

    void theImportantFirst()
    {
        Scene scene = changed(small(), "settings.title=Blanket");
        scene = changed(scene, "settings.timeStep=0.001");
        scene = changed(scene, "wind.velocity=1, 0, 0");
        scene = changed(scene, "cloth.stiffness=50");
        scene = changed(scene, "#2.mass=1");
        QStringList heads;
        for (const QString& sentence : sentences(small(), scene))
            heads << sentence.section(':', 0, 0);
        QCOMPARE(heads,
                 (QStringList{"sheet, particle 2", "cloth", "wind", "Settings", "Settings"}));
    }

    // Exit codes are those of diff(1), and git is told 0 whatever it is.
    void fromTheCommandLine()
    {
        const QTemporaryDir folder;
        const QString a = folder.filePath("a.ripstop.json"), b = folder.filePath("b.ripstop.json");
        QVERIFY(!saveScene(small(), a.toStdString()));
        QVERIFY(!saveScene(changed(small(), "cloth.stiffness=50"), b.toStdString()));
        QCOMPARE(call({"diff", a, a}).exitCode, 0);
        QCOMPARE(call({"diff", a, a}).out, QByteArray());
        const Outcome differ = call({"diff", a, b});
        QCOMPARE(differ.exitCode, 1);
        QVERIFY(differ.out.endsWith("\ncloth: Stiffness 100 -> 50 N/m\n"));
        QCOMPARE(call({"diff", a, folder.filePath("c")}).exitCode, 2);
        QCOMPARE(call({"diff", a}).exitCode, 2);

        const QJsonObject json = call({"diff", a, b, "--json"}).json();
        QCOMPARE(json["same"].toBool(true), false);
        const QJsonObject first = json["differences"].toArray().first().toObject();
        QCOMPARE(first["key"].toString(), QString("stiffness"));
        QCOMPARE(first["from"].toDouble(), 100.0);
        QCOMPARE(first["to"].toDouble(), 50.0);

        const Outcome git = call({"diff", "kite", a, "1a2b", "100644", b, "3c4d", "100644"});
        QCOMPARE(git.exitCode, 0);
        QVERIFY(git.out.startsWith("--- a/kite\t"));
        const Outcome added = call({"diff", "kite", "/dev/null", ".", ".", b, "3c4d", "100644"});
        QVERIFY(added.out.contains("Part added: sheet (2 particles, 1 links, 0 panels)"));
    }

private:
    static Scene small()
    {
        Scene scene;
        Part sheet;
        sheet.name = "sheet";
        sheet.particles = {{.id = Id{2}}, {.id = Id{3}, .position = Vec3(1.0, 0.0, 0.0)}};
        sheet.links = {{.id = Id{4}, .from = Id{2}, .to = Id{3}, .material = Id{6}}};
        scene.items = {{Id{1}, sheet},
                       {Id{5}, Wind{}},
                       {Id{6}, Material{.name = "cloth"}},
                       {Id{7}, Material{.name = "cord"}}};
        scene.nextId = Id{50};
        return scene;
    }
};

const RegisteredTest registered("test_scene_difference", runPlain<TestSceneDifference>);

} // namespace ripstop::test_scene_difference
#include "test_scene_difference.moc"
