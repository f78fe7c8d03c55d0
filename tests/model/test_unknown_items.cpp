// Items of types and keys that this version does not know: kept where they are, named, and never
// in the way.
//
// Stages: a scene with two items of them, written, edited and written again; many of them; what
// points at one; then keys.
#include "model/scene_texts.h"
#include "registered_test.h"

#include "check/check.h"
#include "io/scene_file.h"

#include <QtTest>

namespace ripstop::test_unknown_items {

namespace {

QStringList problemsIn(const Scene& scene)
{
    QStringList said;
    for (const Finding& finding : problemsOf(scene))
        said << QString::fromStdString(finding.message.english());
    return said;
}

} // namespace

class TestUnknownItems : public QObject
{
    Q_OBJECT

private slots:
    // An item of a type that a later version may have stays where it is, whatever is in it.
    void unknownItemsSurvive()
    {
        const QString sail = "{\"type\": \"sail\", \"id\": 40, \"name\": \"jib\", \"cut\": [1, "
                             "-2.50, {\"id\": 70, \"b\": null}], \"c\": \"q\\\"\\n\"}";
        const QString mast = "{\"id\": 41, \"type\": \"mast\"}";
        const QString text = withItems(mast + ",\n{\"type\": \"wind\", \"id\": 5},\n" + sail
                                       + ",\n{\"type\": \"wind\", \"id\": 6, \"name\": \"b\"}");
        Result<Scene> scene = parseScene(text.toStdString(), "test");
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());
        QCOMPARE(scene->items.size(), 2u);
        QCOMPARE(std::uint32_t(scene->nextId), 71u); // above the ids within it, too
        const QStringList said = problemsIn(*scene);
        QVERIFY2(said.contains("Item 40 is of the type sail, which this version does not know; it "
                               "is kept as it is and does nothing."),
                 qPrintable(said.join('\n')));

        const auto placesIn = [&](const Scene& one) {
            const QString written = QString::fromStdString(sceneText(one));
            return std::vector{written.indexOf(mast), written.indexOf("\"id\": 5"),
                               written.indexOf(sail), written.indexOf("\"id\": 6")};
        };
        const auto before = placesIn(*scene);
        QVERIFY(before.front() > 0 && std::ranges::is_sorted(before));
        QVERIFY(*parseScene(sceneText(*scene), "again") == *scene);
        QCOMPARE(sceneText(*parseScene(sceneText(*scene), "again")), sceneText(*scene));

        // edited in between: what stood before it goes, and comes back
        const Scene original = *scene;
        const Edit back = apply(*scene, removal(*scene, {Id{5}}));
        const auto without = placesIn(*scene);
        QVERIFY(without[0] > 0 && without[1] < 0 && without[2] > 0);
        QVERIFY(parseScene(sceneText(*scene), "without"));
        (void)apply(*scene, back);
        QVERIFY(*scene == original);
        QCOMPARE(placesIn(*scene), before);

        QCOMPARE(takeId(*scene), Id{71});
        Scene other = original;
        other.unknownItems.pop_back();
        QVERIFY(!(other == original));
    }

    // As many as a file may hold cost no more than its bytes.
    void manyUnknownItems()
    {
        QByteArray lines;
        for (int i = 1; i < 60000; i += 3)
            lines += "{\"type\": \"wind\", \"id\": " + QByteArray::number(i)
                     + "}, {\"type\": \"sail\", \"id\": " + QByteArray::number(i + 1)
                     + "}, {\"type\": \"probe\", \"id\": " + QByteArray::number(i + 2)
                     + ", \"target\": " + QByteArray::number(i + 1) + "},\n";
        lines += "{\"type\": \"wind\", \"id\": 70000}";
        QElapsedTimer timer;
        timer.start();
        const auto scene = parseScene(withItems(lines).toStdString(), "test");
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());
        QCOMPARE(scene->unknownItems.size(), 20000u);
        const std::string text = sceneText(*scene);
        QVERIFY(*parseScene(text, "again") == *scene);
        QVERIFY(!problemsOf(*scene).empty());
        QVERIFY2(timer.elapsed() < 5000, qPrintable(QString::number(timer.elapsed())));
    }

    // What points at one is kept as well, and told of.
    void whatPointsAtAnUnknownItemIsKept()
    {
        const QString text = withItems("{\"type\": \"sail\", \"id\": 7},\n{\"type\": \"probe\", "
                                       "\"id\": 8, \"target\": 7}");
        const Result<Scene> scene = parseScene(text.toStdString(), "test");
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());
        QCOMPARE(findItem<Probe>(*scene, Id{8})->target, Id{7});
        const QStringList said = problemsIn(*scene);
        QVERIFY2(said.contains("Probe 8: target points at 7 of the type sail, which this version "
                               "does not know; choose another or remove it."),
                 qPrintable(said.join('\n')));
        QVERIFY(*parseScene(sceneText(*scene), "again") == *scene);
    }

    // A slip of the hand in a file would leave a number at its default without a word.
    void keysAreNamed()
    {
        QString text = withItems("{\"type\": \"wind\", \"id\": 3, \"gusts\": 1},\n{\"type\": "
                                 "\"part\", \"id\": 4, \"particles\": [{\"id\": 5, \"mas\": 2}, "
                                 "{\"id\": 6, \"mas\": 2}, {\"id\": 7}]}");
        text.replace("\"version\"", "\"author\": \"me\", \"settings\": {\"substepz\": 32}, "
                                    "\"version\"");
        const Result<Scene> scene = parseScene(text.toStdString(), "test");
        QVERIFY2(scene, scene ? "" : scene.message().english().c_str());
        const QStringList said = problemsIn(*scene);
        const auto unknown = [](const QString& where, const QString& key) {
            return where + ": this version does not know the key \"" + key
                   + "\"; it is kept as it is and does nothing.";
        };
        for (const QString& expected :
             {unknown("Settings", "substepz") + " Did you mean \"substeps\"?",
              unknown("File", "author"), unknown("Wind 3", "gusts"),
              unknown("Particle 5 and others, 2 in all", "mas") + " Did you mean \"mass\"?"})
            QVERIFY2(said.contains(expected), qPrintable(said.join('\n')));
        QVERIFY(*parseScene(sceneText(*scene), "again") == *scene);
    }
};

const RegisteredTest registered("test_unknown_items", runWithCore<TestUnknownItems>);

} // namespace ripstop::test_unknown_items
#include "test_unknown_items.moc"
