// Another language while a design is edited and flies: the window speaks it at once, and nothing
// that one has done is lost.
//
// Stages: what stands on the window in English, in French and in English again; what is kept; and
// what stays open.
#include "actions/preferences_dialog.h"
#include "app/screen_texts.h"
#include "document/document.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "editor/window_host.h"
#include "plots/plot_panel.h"
#include "scene/property.h"
#include "timeline/timeline.h"
#include "tools/pointing.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QPointer>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_language_switch {

namespace {

// A kite that has been edited and flies.
struct Desk
{
    Translation translation{Language::English};
    Document document;
    Selection selection{document};
    Player player{document};
    WindowHost host{document, selection, player, MainWindow::Memory::Ignore, translation};

    Desk()
    {
        if (document.open(SCENES_DIR "/delta_kite.ripstop.json"))
            qFatal("the sample is gone");
        host.window().showScene();
        host.window().show();
        selection.set({wind()});
        push({Message("Change %1", Message::word("Velocity")),
              {SetValues{&propertyOf<&Wind::velocity>(), {wind()}, {Vec3(0.0, 0.0, -7.5)}}}});
        push({Message("Change %1", Message::word("Velocity")),
              {SetValues{&propertyOf<&Wind::velocity>(), {wind()}, {Vec3(0.0, 0.0, -8.5)}}}});
        document.history().undo();
        run("byStrain");
        run("trails");
        run("toolLasso");
        host.window().docks().show("timeline");
        player.play();
        while (!player.frame() || player.frame()->time < 0.3)
            QTest::qWait(20);
    }

    void push(Edit edit) { document.push(std::move(edit)); }
    void run(const char* id) { host.window().actions()[id]->trigger(); }

    Id wind() const
    {
        for (const Entry& entry : document.scene().items)
            if (std::holds_alternative<Wind>(entry.item))
                return entry.id;
        qFatal("the sample has no wind");
    }

    // By the menu, as people do it; the window is another one then.
    void choose(const char* id)
    {
        const QPointer<MainWindow> before = &host.window();
        run(id);
        QTRY_VERIFY(before.isNull());
        QTest::qWait(200); // until labels that wait for a timer are there
    }

    QSet<QString> texts()
    {
        ScreenReader reader;
        reader.read(host.window());
        return reader.texts();
    }
};

QString title(Desk& desk, int step) { return desk.document.history().text(step); }

// What is left of one language among the texts of the other.
QStringList alikeOnBoth(QSet<QString> some, const QSet<QString>& others)
{
    QStringList left;
    for (const QString& text : some.intersect(others).subtract(alike()))
        if (!isContent(text)) {
            qWarning() << text; // a long list would be cut
            left << text;
        }
    return left;
}

} // namespace

class TestLanguageSwitch : public QObject
{
    Q_OBJECT

private slots:
    // Settings of its own, as tests that run beside this one look which language is kept.
    void initTestCase()
    {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_home.path());
    }
    void init() { QSettings().clear(); }

    void nothingIsLeftOfTheOtherLanguage()
    {
        Desk desk;
        const QSet<QString> english = desk.texts();
        QVERIFY(english.size() > 500);
        desk.choose("languageFrench");
        const QSet<QString> french = desk.texts();
        QCOMPARE(alikeOnBoth(english, french), QStringList());
        QCOMPARE(title(desk, 0), QString("Modifier Vitesse"));
        for (const char* menu : {"Thème", "Langue"})
            QVERIFY2(french.contains(menu), menu);
        QCOMPARE(desk.host.window().recordings().current()->name(), std::string("Simulation 1"));
        desk.choose("languageEnglish");
        QCOMPARE(title(desk, 0), QString("Change Velocity"));
        QCOMPARE(desk.host.window().recordings().current()->name(), std::string("Run 1"));
        QCOMPARE(alikeOnBoth(desk.texts(), french), QStringList());
    }

    void nothingIsLost()
    {
        Desk desk;
        Viewport& before = desk.host.window().viewport();
        Camera camera = before.camera();
        camera.azimuth = 1.25;
        before.look(camera);
        desk.host.window().resize(1200, 760);
        const std::vector<Id> selected = desk.selection.ids();
        const int steps = desk.document.history().count();
        const int step = desk.document.history().index();
        const Scene scene = desk.document.scene();
        const std::uint64_t run = desk.player.run();
        const auto recording = desk.host.window().recordings().current();
        const double time = desk.player.frame()->time;
        QVERIFY(recording);

        desk.choose("languageFrench");
        MainWindow& window = desk.host.window();
        QVERIFY(keptLanguage() == Language::French);
        QVERIFY(window.isVisible());
        QCOMPARE(window.size(), QSize(1200, 760));
        QCOMPARE(window.viewport().camera().azimuth, 1.25);
        QVERIFY(window.viewport().colorBy() == ColorBy::Strain);
        for (const char* id : {"byStrain", "trails", "toolLasso", "languageFrench"})
            QVERIFY2(window.actions()[id]->isChecked(), id);
        QVERIFY(window.viewport().pointing().hasTool());
        QVERIFY(!window.docks().panel<Timeline>().visibleRegion().isEmpty());

        QVERIFY(desk.selection.ids() == selected);
        QCOMPARE(desk.document.history().count(), steps);
        QCOMPARE(desk.document.history().index(), step);
        QVERIFY(desk.document.isModified());
        QVERIFY(desk.document.scene() == scene);
        QVERIFY(window.isWindowModified());

        QVERIFY(desk.player.isPlaying());
        QCOMPARE(desk.player.run(), run);
        QTRY_VERIFY(desk.player.frame()->time > time);
        QVERIFY(window.recordings().current() == recording);
        const History& history = window.docks().panel<PlotPanel>().history();
        QVERIFY(history.time().front() < time); // the curves have their beginning
        desk.document.history().redo();
        QCOMPARE(desk.document.history().index(), step + 1);
    }

    void aDesignWithoutANameHasNoneInEither()
    {
        Desk desk;
        desk.document.replace(Scene{});
        QVERIFY(desk.host.window().windowTitle().startsWith("untitled"));
        desk.choose("languageFrench");
        QVERIFY(desk.host.window().windowTitle().startsWith("sans titre"));
    }

    // The page from which the language was chosen stands there again, in the other one.
    void preferencesStayOpen()
    {
        Desk desk;
        desk.run("preferences");
        auto* dialog = desk.host.window().findChild<PreferencesDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        desk.choose("languageFrench");
        dialog = desk.host.window().findChild<PreferencesDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(dialog->windowTitle(), QString("Préférences"));
    }

private:
    QTemporaryDir m_home;
};

const RegisteredTest registered("test_language_switch", runWithView<TestLanguageSwitch>);

} // namespace ripstop::test_language_switch
#include "test_language_switch.moc"
