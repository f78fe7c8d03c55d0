// What every panel, dialog, bar and action of the window owes to those who use it. What there is
// comes from the window itself.
#include "album/moments.h"

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
        for (const QAction* action : shop.window.findChildren<QAction*>()) {
            if (action->isSeparator() || action->objectName().isEmpty())
                continue;
            QVERIFY(!WindowWalk::plain(action->text()).isEmpty());
            QVERIFY2(action->toolTip().contains(action->statusTip()), qPrintable(action->text()));
            QVERIFY2(action->statusTip().endsWith('.'), qPrintable(action->text()));
        }
        for (const QToolButton* button : shop.window.findChildren<QToolButton*>())
            if (const QAction* action = button->defaultAction()) {
                QVERIFY2(!action->icon().isNull(), qPrintable(action->text()));
                QVERIFY2(!button->toolTip().isEmpty(), qPrintable(action->text()));
            }
    }

    // In every panel, dialog and bar: inputs have names, texts are not cut off, windows fit.
    void nothingIsCutOffOrNameless()
    {
        WindowShop shop;
        shop.window.show();
        QApplication::setActiveWindow(&shop.window); // Xvfb has no window manager to do it
        QStringList faults;
        QSet<QString> seen;
        showEverything(shop, [&](const QString& name, QWidget& inFront) {
            seen << name;
            for (const QString& fault : faultsOf(inFront))
                if (!faults.join('\n').contains(fault))
                    faults << name + ": " + fault;
            return true;
        });
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
        // an ellipsis promises that one is asked first
        for (const QAction* action : shop.window.actions().all())
            QVERIFY2(!action->text().contains(QChar(0x2026)) || seen.contains(action->objectName()),
                     qPrintable(action->objectName()));
    }
};

int main(int argc, char** argv) { return runWithView<TestScreens>(argc, argv); }

#include "test_screens.moc"
