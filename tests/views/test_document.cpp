// The document, its history and the selection (document/document.h, document/selection.h).
//
// Stages: a table of edits of every kind, each of which has to be undone and redone to the same
// scene, alone and in a long history; what the history says; what is told of changes; files and
// what is remembered of them; the selection when things vanish; and the words for elements and
// their readings.
#include "document/document.h"
#include "views/run_with_widgets.h"

#include "compile/compile.h"
#include "document/measurement.h"
#include "document/selection.h"
#include "document/words.h"
#include "inspector/last_directions.h"
#include "inspector/subject.h"
#include "io/scene_file.h"
#include "simulation/simulation.h"
#include "small_scenes.h"
#include "views/inspector_form.h"

#include <QSignalSpy>
#include <QtTest>

namespace ripstop::test_document {

namespace {

// The names of an edit and a function that makes it from the scene as it is.
struct Case
{
    const char* name;
    Edit (*make)(const Scene& scene);
};

Edit addRowsEdit(const Scene& scene)
{
    const Id first = scene.nextId;
    const Id second{std::uint32_t(first) + 1};
    const Id third{std::uint32_t(first) + 2};
    Particle particle;
    particle.id = first;
    Panel panel;
    panel.id = third;
    panel.a = Id{2};
    panel.b = Id{3};
    panel.c = first;
    return {Message("Add"),
            {AddRows{Id{1}, {particle}, {rod(second, Id{2}, first, Id{9})}, {panel}}}};
}

Edit addItemEdit(const Scene& scene)
{
    return {Message("Add"), {AddItem{2, {scene.nextId, Wind{"gust"}}}}};
}

const Case cases[] = {
    {"one value", [](const Scene& s) { return setValue(s, Id{3}, "mass", 0.7); }},
    {"one value for many",
     [](const Scene&) {
         return Edit{
             Message("Set"),
             {SetValues{findProperty(Kind::Particle, "mass"), {Id{2}, Id{3}, Id{4}}, {0.7}}}};
     }},
    {"a value for each",
     [](const Scene&) {
         return Edit{Message("Set"),
                     {SetValues{findProperty(Kind::Particle, "mass"), {Id{2}, Id{4}}, {0.1, 0.2}}}};
     }},
    {"a setting", [](const Scene& s) { return setValue(s, settingsId, "sweeps", 31); }},
    {"an absent value", [](const Scene& s) { return setValue(s, Id{6}, "stiffness", 12.0); }},
    {"add an item", addItemEdit},
    {"add rows", addRowsEdit},
    {"remove a particle and what hangs on it", [](const Scene& s) { return removal(s, {Id{3}}); }},
    {"remove a link", [](const Scene& s) { return removal(s, {Id{6}}); }},
    {"remove a material in use", [](const Scene& s) { return removal(s, {Id{9}}); }},
    {"remove a part", [](const Scene& s) { return removal(s, {Id{1}}); }},
    {"remove everything",
     [](const Scene& s) {
         std::vector<Id> all;
         for (const Entry& entry : s.items)
             all.push_back(entry.id);
         return removal(s, all);
     }},
};

double massOf(const Document& document, Id id)
{
    return std::get<const Particle*>(*find(document.scene(), id))->mass;
}

} // namespace

class TestDocument : public QObject
{
    Q_OBJECT

private slots:
    // Steps of one property are told apart in the history by what they set it to.
    void theHistorySaysValues()
    {
        InspectorForm form;
        const auto told = [&] { return form.document.history().undoText(); };
        form.selection.set({Id{13}});
        form.type(form.line("velocity", 0), "7.5");
        QVERIFY2(told().startsWith("Set velocity of ") && told().contains(" to 7.5, ")
                     && told().endsWith(QStringLiteral("\u00a0m/s")),
                 qPrintable(told()));
        form.selection.set({Id{3}});
        form.type(form.line("mass"), "2 g");
        QVERIFY2(told().endsWith(QStringLiteral("to 2\u00a0g")), qPrintable(told()));
    }

    // The steps of a drag are one in the history, with the value that it ended at.
    void aDragSaysItsLastValue()
    {
        InspectorForm form;
        LastDirections directions;
        Subject subject(form.document, directions);
        subject.set(Kind::Particle, {Id{3}});
        const Property& mass = propertyOf<&Particle::mass>();
        const int gesture = form.document.beginGesture();
        for (const double kilograms : {0.1, 0.2, 0.3})
            subject.drag(mass, {kilograms}, gesture);
        QCOMPARE(form.document.history().count(), 1);
        const QString told = form.document.history().undoText();
        QVERIFY2(told.endsWith(QStringLiteral("to 300\u00a0g")), qPrintable(told));
    }

    void gestureUndoesInOneStep()
    {
        Document document;
        document.replace(oneOfEverything());
        const int gesture = document.beginGesture();
        for (const double mass : {0.02, 0.03, 0.04})
            document.drag(setValue(document.scene(), Id{3}, "mass", mass), gesture);
        QCOMPARE(document.history().count(), 1);
        QCOMPARE(massOf(document, Id{3}), 0.04);

        const int next = document.beginGesture(); // the same slider, pressed again
        document.drag(setValue(document.scene(), Id{3}, "mass", 0.05), next);
        QCOMPARE(document.history().count(), 2);
        document.history().undo();
        QCOMPARE(massOf(document, Id{3}), 0.04);
        document.history().undo();
        QCOMPARE(massOf(document, Id{3}), 0.01);
        document.history().redo();
        QCOMPARE(massOf(document, Id{3}), 0.04);
        document.history().redo();
        QCOMPARE(massOf(document, Id{3}), 0.05);
        QVERIFY(!document.history().canRedo());
    }

    void everyEditHasItsWayBack_data()
    {
        QTest::addColumn<int>("index");
        for (int i = 0; i < int(std::size(cases)); ++i)
            QTest::newRow(cases[i].name) << i;
    }

    void everyEditHasItsWayBack()
    {
        QFETCH(int, index);
        Document document;
        document.replace(oneOfEverything());
        const Scene before = document.scene();
        document.push(cases[index].make(before));
        const Scene after = document.scene();
        QVERIFY(after.items != before.items || after.settings != before.settings);
        for (int round = 0; round < 2; ++round) {
            document.history().undo();
            QVERIFY(document.scene().items == before.items);
            QVERIFY(document.scene().settings == before.settings);
            QVERIFY(document.scene().nextId >= before.nextId); // ids are never used twice
            document.history().redo();
            QVERIFY(document.scene() == after);
        }
    }

    // All of them behind each other, and all the way back.
    void longHistoryGoesBackToTheStart()
    {
        Document document;
        document.replace(oneOfEverything());
        std::vector<Scene> scenes{document.scene()};
        for (const int index : {0, 1, 2, 3, 4, 5, 6, 8, 7, 9, 11}) {
            document.push(cases[index].make(document.scene()));
            scenes.push_back(document.scene());
        }
        for (std::size_t i = scenes.size() - 1; i-- > 0;) {
            document.history().undo();
            QVERIFY(document.scene().items == scenes[i].items);
        }
        for (std::size_t i = 1; i < scenes.size(); ++i) {
            document.history().redo();
            QVERIFY(document.scene().items == scenes[i].items); // ids that were used stay used
        }
    }

    void changesAreTold()
    {
        Document document;
        document.replace(oneOfEverything());
        std::vector<std::string> told;
        connect(&document, &Document::changed, this,
                [&](const Edit& edit) { told.push_back(edit.label.english()); });
        document.push({Message("nothing"), {}});
        QVERIFY(told.empty());
        QCOMPARE(document.history().count(), 0);
        document.push(setValue(document.scene(), Id{3}, "mass", 1.0));
        document.history().undo();
        QCOMPARE(told, (std::vector<std::string>{"Set Mass", "Set Mass"}));
    }

    void filesRememberWhatIsSaved()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("sail \u00e9t\u00e9.ripstop.json");
        Document document;
        QSignalSpy fileChanges(&document, &Document::fileChanged);
        document.replace(oneOfEverything(), "sail");
        QCOMPARE(document.displayName(), QString("sail"));
        QVERIFY(document.file().isEmpty());
        QVERIFY(document.isModified()); // a design that stands in no file yet
        document.replace(Scene{});
        QVERIFY(!document.isModified());

        document.replace(oneOfEverything(), "sail");
        document.push(setValue(document.scene(), Id{3}, "mass", 0.25));
        QVERIFY(document.isModified());
        QVERIFY(!document.save(file));
        QVERIFY(!document.isModified());
        QCOMPARE(document.displayName(), QString("sail \u00e9t\u00e9.ripstop.json"));
        document.history().undo();
        QVERIFY(document.isModified());
        document.history().redo();
        QVERIFY(!document.isModified());
        QVERIFY(fileChanges.count() >= 5);

        Document other;
        QSignalSpy replacements(&other, &Document::replaced);
        QVERIFY(!other.open(file));
        QCOMPARE(replacements.count(), 1);
        QVERIFY(other.scene() == document.scene());
        QCOMPARE(other.file(), document.file());
    }

    void aBadFileChangesNothing()
    {
        const QTemporaryDir folder;
        const QString bad = folder.filePath("bad.ripstop.json");
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{ \"format\": \"ripstop-scene\", \"version\": 1, ");
        file.close();

        Document document;
        document.replace(oneOfEverything(), "sail");
        document.push(setValue(document.scene(), Id{3}, "mass", 0.25));
        const Scene before = document.scene();
        QSignalSpy replacements(&document, &Document::replaced);
        for (const QString& name : {bad, folder.filePath("missing.ripstop.json")}) {
            const auto failure = document.open(name);
            QVERIFY(failure && !failure->message.empty());
        }
        QCOMPARE(replacements.count(), 0);
        QVERIFY(document.scene() == before);
        QVERIFY(document.isModified() && document.history().canUndo());

        QVERIFY(document.save(folder.filePath("no/such/folder/x.ripstop.json")));
        QVERIFY(document.isModified()); // a failed save saves nothing
    }

    void selectionKeepsToWhatExists()
    {
        Document document;
        document.replace(oneOfEverything());
        Selection selection(document);
        QSignalSpy changes(&selection, &Selection::changed);
        selection.set({Id{6}, Id{3}, Id{3}, Id{99}, Id{9}});
        QCOMPARE(selection.ids(), (std::vector<Id>{Id{3}, Id{6}, Id{9}}));
        QCOMPARE(changes.count(), 1);
        selection.set({Id{9}, Id{6}, Id{3}});
        QCOMPARE(changes.count(), 1); // the same

        selection.remove({Id{6}});
        QVERIFY(!selection.contains(Id{6}) && selection.contains(Id{3}));
        selection.add({Id{6}});
        QVERIFY(selection.contains(Id{6}));

        document.push(removal(document.scene(), {Id{3}})); // the link 6 hangs on it
        QCOMPARE(selection.ids(), (std::vector<Id>{Id{9}}));
        document.replace(Scene{});
        QVERIFY(selection.ids().empty());
    }

    // A right triangle of 3, 4 and 5 m whose hypotenuse was 4 m long, one corner on the move, and
    // 12 N of air on its 6 m^2.
    void measurementsReadTheInstant()
    {
        auto layout = std::make_shared<Layout>();
        layout->particleId = {2, 3, 4};
        layout->links = {{5, LinkKind::Rod, 1, 2, 4.0}, {6, LinkKind::Rod, 0, 1, 3.0}};
        layout->panelId = {7};
        layout->panelCorners = {{0, 1, 2}};
        auto frame = std::make_shared<Frame>();
        frame->layout = layout;
        frame->position = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 4, 0)};
        frame->velocity = {Vec3(0, 3, 4), Vec3::Zero(), Vec3::Zero()};
        frame->strain = {0.25, 0.0};
        frame->tension = {8.0, -1.0};
        frame->torn = {0, 1};
        frame->panelLoad = {Vec3(0, 0, 12)};
        frame->gone = {0};
        const Measurement measurement = measurementOf(frame);
        Scene scene;
        const auto find = [&](const char* condition) {
            const auto ids = matching(scene, measurement, condition);
            return ids ? *ids : std::vector<Id>{settingsId};
        };
        using Ids = std::vector<Id>;
        QCOMPARE(find("speed = 5"), Ids{Id{2}});
        QCOMPARE(find("speed > 17.9 km/h"), Ids{Id{2}}); // 18
        QCOMPARE(find("particle.y > 399 cm"), Ids{Id{4}});
        QCOMPARE(find("y > 1.9"), (Ids{Id{4}, Id{5}})); // the middle of the link is at 2 m
        QCOMPARE(find("strain > 24 %"), Ids{Id{5}});
        QCOMPARE(find("strain < 24 %"), Ids{}); // the other one is torn
        QCOMPARE(find("tension = 8 N"), Ids{Id{5}});
        QCOMPARE(find("length = 5 m"), Ids{Id{5}});
        QCOMPARE(find("area = 6 m^2"), Ids{Id{7}});
        QCOMPARE(find("load = 2 Pa"), Ids{Id{7}});
        QCOMPARE(find("x > 0 and z = 0 and length > 1"), Ids{Id{5}});

        QCOMPARE(readingOf(*frame, Id{7}), QString("2\u00a0Pa")); // it carries no pull
        QCOMPARE(find("strain != 1 %"), Ids{Id{5}});
        frame->panelPull = {{.carries = true, .strain = 0.02}};
        QCOMPARE(find("strain > 1 %"), (Ids{Id{5}, Id{7}}));
        QVERIFY(readingOf(*frame, Id{7}).startsWith("2"));
    }

    void thingsAreNamed()
    {
        const Scene scene = oneOfEverything();
        QCOMPARE(describe(scene, {Id{2}, Id{3}, Id{4}}), QString("3 particles of sail"));
        QCOMPARE(describe(scene, {Id{5}}), QString("link 5 of sail"));
        QCOMPARE(describe(scene, {Id{9}}), QString("thread"));
        QCOMPARE(describe(scene, {Id{9}, Id{10}}), QString("2 materials"));
        QCOMPARE(describe(scene, {Id{2}, Id{5}, Id{6}, Id{13}}),
                 QString("1 particle, 2 links, 1 wind"));
        QCOMPARE(nameOf(scene, Id{77}), QString("#77"));
        QCOMPARE(compactNumber(1.0 / 240.0), QString("0.00416667"));
        QCOMPARE(compactNumber(0.1), QString("0.1"));
        QCOMPARE(compactNumber(5e-4), QString("0.0005"));
        QCOMPARE(compactNumber(40000.0), QString("40000"));
        QCOMPARE(compactNumber(1e-12), QString("1e-12"));
        QCOMPARE(compactNumber(-9.80665), QString("-9.80665"));
        QCOMPARE(choiceLabel("semi_implicit_euler"), QString("Semi implicit Euler"));
    }

    // Hooke: 100 N/m and 10 cm; nothing has moved yet.
    void readingsSayWhatAnElementDoes()
    {
        const QLocale before;
        QLocale::setDefault(QLocale::c());
        Scene scene = fallingPair();
        Part& part = std::get<Part>(*findItem(scene, Id{1}));
        part.particles[1].velocity = Vec3(3.0, 4.0, 0.0);
        part.links[0].kind = LinkKind::Spring;
        part.links[0].stiffness = 100.0;
        part.links[0].restLength = 0.9;
        const auto system = compile(scene);
        QVERIFY(system);
        const Simulation simulation(*system);
        const std::shared_ptr<const Frame> frame = simulation.frame();
        QCOMPARE(readingOf(*frame, Id{4}), QString("10\u00a0N · 11.1\u00a0%"));
        QCOMPARE(readingOf(*frame, Id{3}), QString("5\u00a0m/s"));
        QCOMPARE(readingOf(*frame, Id{1}), QString());
        QLocale::setDefault(before);
    }
};

const RegisteredTest registered("test_document", runWithWidgets<TestDocument>);

} // namespace ripstop::test_document
#include "test_document.moc"
