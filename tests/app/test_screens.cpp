// What every action of the window owes to those who use it. Panels and dialogs are looked at by
// ./dev screens, which also says what is cut off or has no name.
#include "actions/mnemonics.h"
#include "album/window_walk.h"
#include "app/window_shop.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace ripstop::test_screens {

namespace {

QString letterOf(const QAction& entry) { return QKeySequence::mnemonic(entry.text()).toString(); }

} // namespace

class TestScreens : public QObject
{
    Q_OBJECT

private slots:
    void everyActionHasATextAndATipAndInABarAnIcon()
    {
        WindowShop shop;
        for (const QAction* action : shop.window.actions().all()) {
            QVERIFY(!WindowWalk::plain(action->text()).isEmpty());
            QVERIFY2(action->toolTip().contains(action->statusTip()), qPrintable(action->text()));
            QVERIFY2(action->statusTip().endsWith('.'), qPrintable(action->text()));
        }
        const std::vector<QAction*>& all = shop.window.actions().all();
        for (const QToolButton* button : shop.window.findChildren<QToolButton*>())
            if (QAction* action = button->defaultAction(); std::ranges::count(all, action) > 0) {
                QVERIFY2(!action->icon().isNull(), qPrintable(action->text()));
                QVERIFY2(!button->toolTip().isEmpty(), qPrintable(action->text()));
            }
    }

    void letterIsOfOneEntry()
    {
        QMenu menu;
        for (const char* text : {"&Copy", "&Cut", "Coarse && fine", "Cu&t and copy", "42", "&Copy"})
            menu.addAction(text);
        giveMnemonics(menu.actions());
        QStringList letters, texts;
        for (const QAction* entry : menu.actions()) {
            letters << letterOf(*entry);
            texts << entry->text();
        }
        QCOMPARE(texts, (QStringList{"&Copy", "C&ut", "Coarse && &fine", "Cu&t and copy", "&42",
                                     "C&opy"}));
        QCOMPARE(letters, (QStringList{"Alt+C", "Alt+U", "Alt+F", "Alt+T", "Alt+4", "Alt+O"}));
        giveMnemonics(menu.actions()); // nothing is left to do
        for (const QAction* entry : menu.actions())
            QCOMPARE(entry->text(), texts.takeFirst());
    }

    void lettersOfEveryMenuDiffer()
    {
        WindowShop shop;
        for (QMenu* menu : shop.window.findChildren<QMenu*>()) {
            emit menu->aboutToShow();
            QStringList letters;
            for (const QAction* entry : menu->actions())
                if (const QString letter = letterOf(*entry); !letter.isEmpty()) {
                    QVERIFY2(!letters.contains(letter),
                             qPrintable(menu->title() + ": " + entry->text()));
                    letters << letter;
                }
        }
    }
};

const RegisteredTest registered("test_screens", runWithView<TestScreens>);

} // namespace ripstop::test_screens
#include "test_screens.moc"
