// What every action of the window owes to those who use it. Panels and dialogs are looked at by
// ./dev screens, which also says what is cut off or has no name.
#include "album/window_walk.h"
#include "app/window_shop.h"

#include <QToolBar>
#include <QToolButton>

using namespace ripstop;

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
};

int main(int argc, char** argv) { return runWithView<TestScreens>(argc, argv); }

#include "test_screens.moc"
