// Theme, layout and preferences by the menus.
//
// Stages: a theme is seen at once in window and view, and kept; the layout goes back to what it was
// at first; the dialog says what the menus say.
#include "actions/preferences_dialog.h"
#include "app/window_shop.h"
#include "files/run_files.h"
#include "theme/theme_choice.h"

#include <QComboBox>
#include <QDockWidget>
#include <QMenu>
#include <QPainter>
#include <QSettings>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOption>
#include <QToolBar>
#include <QtTest>

namespace ripstop::test_preferences {

namespace {

struct OpenWindow : WindowShop
{
    OpenWindow()
    {
        window.resize(1280, 800);
        window.show();
        window.files().open(SCENES_DIR "/delta_kite.ripstop.json");
        QTest::qWait(50); // until docks have their sizes
    }

    QMap<QString, QRect> places() const
    {
        QMap<QString, QRect> places;
        for (const auto* dock : window.findChildren<QDockWidget*>())
            if (!dock->visibleRegion().isEmpty())
                places[dock->objectName()] = dock->geometry();
        return places;
    }
};

int lightness() { return QApplication::palette().color(QPalette::Window).lightness(); }

// Of the middle of the upper edge of the view, where the sky is.
int skyOf(Viewport& viewport)
{
    const QImage image = viewport.image(Viewport::Overlays::Without);
    return image.pixelColor(image.width() / 2, 4).lightness();
}

QComboBox& listWith(const QDialog& dialog, const QString& entry)
{
    for (auto* list : dialog.findChildren<QComboBox*>())
        if (list->findText(entry) >= 0)
            return *list;
    qFatal("no list has %s", qPrintable(entry));
}

void chooseIn(QComboBox& list, const QString& entry)
{
    list.setCurrentText(entry);
    emit list.activated(list.currentIndex());
}

} // namespace

class TestPreferences : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }
    void cleanupTestCase()
    {
        QSettings().clear();
        applyThemeChoice(*qApp, ThemeChoice::Light);
    }

    void aThemeIsSeenAtOnceAndKept()
    {
        OpenWindow shop;
        QTRY_VERIFY(shop.player.frame() != nullptr);
        shop.run("themeDark");
        QVERIFY(lightness() < 128);
        QVERIFY(shop.window.palette().color(QPalette::Window).lightness() < 128);
        QTest::qWait(20);
        const int dark = skyOf(shop.viewport);
        QVERIFY(keptThemeChoice() == ThemeChoice::Dark);
        shop.run("themeLight");
        QVERIFY(lightness() > 128);
        QTest::qWait(20);
        QVERIFY2(skyOf(shop.viewport) > dark + 50, qPrintable(QString::number(dark)));
        QVERIFY(keptThemeChoice() == ThemeChoice::Light);
        WindowShop next;
        QVERIFY(next.window.actions()["themeLight"]->isChecked());
    }

    // The palette that was chosen before is not that of the desktop, which is light here.
    void theThemeOfTheDesktopIsFoundAgain()
    {
        applyThemeChoice(*qApp, ThemeChoice::Desktop);
        const int desktop = lightness();
        applyThemeChoice(*qApp, desktop < 128 ? ThemeChoice::Light : ThemeChoice::Dark);
        QVERIFY((lightness() < 128) != (desktop < 128));
        applyThemeChoice(*qApp, ThemeChoice::Desktop);
        QCOMPARE(lightness(), desktop);
    }

    // A menu is told from the panel that it opens over, in the dark as well.
    void menusHaveAnEdge()
    {
        for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark}) {
            applyThemeChoice(*qApp, theme);
            QMenu menu;
            menu.addAction("Select");
            menu.resize(menu.sizeHint());
            const QImage picture = menu.grab().toImage();
            const int edge = picture.pixelColor(0, picture.height() / 2).lightness();
            const int panel = qApp->palette().color(QPalette::Window).lightness();
            QVERIFY2(std::abs(edge - panel) > 25, qPrintable(QString::number(edge)));
        }
    }

    // A tool that is chosen has the accent of its theme, one under the mouse is grey: neither looks
    // like the other, nor like one that is at rest.
    void whatIsChosenDoesNotLookPointedAt()
    {
        const auto ground = [](QStyle::State state) {
            QImage picture(24, 24, QImage::Format_RGB32);
            picture.fill(qApp->palette().color(QPalette::Window));
            QPainter painter(&picture);
            QStyleOption option;
            option.rect = picture.rect();
            option.palette = qApp->palette();
            option.state = QStyle::State_Enabled | QStyle::State_AutoRaise | state;
            qApp->style()->drawPrimitive(QStyle::PE_PanelButtonTool, &option, &painter);
            return picture.pixelColor(12, 12);
        };
        for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark}) {
            applyThemeChoice(*qApp, theme);
            const QColor rest = ground({}), under = ground(QStyle::State_MouseOver),
                         chosen = ground(QStyle::State_On),
                         both = ground(QStyle::State_On | QStyle::State_MouseOver);
            const auto colorful = [](const QColor& color) { return color.blue() - color.red(); };
            QVERIFY(std::abs(under.lightness() - rest.lightness()) > 10);
            QVERIFY(std::abs(colorful(under) - colorful(rest)) < 5);
            QVERIFY(colorful(chosen) > colorful(under) + 30);
            QVERIFY(colorful(both) > colorful(chosen) + 10);
        }
    }

    void theLayoutGoesBackToTheFirst()
    {
        OpenWindow shop;
        const auto before = shop.places();
        QVERIFY(before.size() >= 3);
        auto* outline = shop.window.findChild<QDockWidget*>("outline");
        auto* inspector = shop.window.findChild<QDockWidget*>("inspector");
        auto* plots = shop.window.findChild<QDockWidget*>("plots");
        outline->close();
        inspector->setFloating(true);
        shop.window.addDockWidget(Qt::LeftDockWidgetArea, plots);
        shop.window.docks().show("timeline");
        QTest::qWait(20);
        QVERIFY(shop.places() != before);
        shop.run("resetLayout");
        QTRY_COMPARE(shop.places(), before);
    }

    void theDialogSaysWhatTheMenusSay()
    {
        OpenWindow shop;
        shop.run("themeLight");
        PreferencesDialog dialog(shop.window.actions(), shop.window.runFiles(), &shop.window);
        QComboBox& themes = listWith(dialog, "Dark");
        QCOMPARE(themes.currentText(), QString("Light"));
        chooseIn(themes, "Dark");
        QVERIFY(shop.window.actions()["themeDark"]->isChecked());
        QVERIFY(lightness() < 128);
        QComboBox& languages = listWith(dialog, "English");
        QCOMPARE(languages.currentText(), QString("System"));
        chooseIn(languages, "English");
        QVERIFY(shop.window.actions()["languageEnglish"]->isChecked());
        auto* memory = dialog.findChild<QSpinBox*>();
        QCOMPARE(memory->value(), 512);
        memory->setValue(256);
        QCOMPARE(RunFiles::memory(), 256);
    }
};

const RegisteredTest registered("test_preferences", runWithView<TestPreferences>);

} // namespace ripstop::test_preferences
#include "test_preferences.moc"
