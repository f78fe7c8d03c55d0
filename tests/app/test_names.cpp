// Names that people give are shown as they are, whatever they look like: HTML, or the gap of a
// sentence.
//
// Every thing of a scene is called by the same name, and the window is looked through for labels,
// tips and menus that would make something else of it.
#include "app/window_shop.h"
#include "document/plain_text.h"
#include "views/inspector_form.h"
#include "views/small_scenes.h"

#include <QAbstractItemView>
#include <QLabel>
#include <QMenu>
#include <QtTest>

namespace ripstop::test_names {

namespace {

const QString given = QStringLiteral("<b>bold?</b> &amp; 100 %1");

Scene named()
{
    Scene scene = oneOfEverything();
    for (Entry& entry : scene.items)
        std::visit([](auto& item) { item.name = given.toStdString(); }, entry.item);
    return scene;
}

// Whether a text with the name, read as Qt reads it, has the characters of the name.
bool isWhole(const QString& text, Qt::TextFormat format)
{
    const bool isRich =
        format == Qt::RichText || (format == Qt::AutoText && Qt::mightBeRichText(text));
    return text.contains(isRich ? given.toHtmlEscaped() : given);
}

bool isAboutIt(const QString& text) { return text.contains("bold?"); }

QString faultIn(const QAbstractItemModel& model, const QModelIndex& parent)
{
    for (int row = 0; row < model.rowCount(parent); ++row) {
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QString tip = model.index(row, column, parent).data(Qt::ToolTipRole).toString();
            if (isAboutIt(tip) && !isWhole(tip, Qt::AutoText))
                return tip;
        }
        if (const QString below = faultIn(model, model.index(row, 0, parent)); !below.isEmpty())
            return below;
    }
    return {};
}

// The first text that would not be shown as it is, or nothing.
QString faultIn(const QWidget& window)
{
    for (const auto* label : window.findChildren<QLabel*>())
        if (isAboutIt(label->text()) && !isWhole(label->text(), label->textFormat()))
            return label->text();
    for (const auto* widget : window.findChildren<QWidget*>())
        if (isAboutIt(widget->toolTip()) && !isWhole(widget->toolTip(), Qt::AutoText))
            return widget->toolTip();
    for (const auto* view : window.findChildren<QAbstractItemView*>())
        if (view->model())
            if (const QString fault = faultIn(*view->model(), {}); !fault.isEmpty())
                return fault;
    for (const auto* action : window.findChildren<QAction*>())
        if (isAboutIt(action->text()) && !action->text().contains(inMenu(given)))
            return action->text();
    return {};
}

} // namespace

class TestNames : public QObject
{
    Q_OBJECT

private slots:
    // In inspector, outline, status bar, plots and sliders, whatever is selected.
    void areShownAsTheyAre()
    {
        WindowShop shop;
        shop.document.replace(named());
        shop.window.show();
        const auto labelled = [&] {
            const auto all = shop.window.findChildren<QLabel*>();
            return std::ranges::count_if(
                all, [](const QLabel* label) { return label->text().contains(given); });
        };
        for (const Id id : oneOfEachKind) {
            shop.selection.set({id});
            QTest::qWait(60); // ms, the status bar takes 50
            const QString fault = faultIn(shop.window);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
        shop.selection.set({Id{15}});
        QTRY_VERIFY(labelled() >= 2); // title and status bar at least
    }

    void areTheSameInTipsOfTheOutline()
    {
        WindowShop shop;
        shop.document.replace(named());
        int tips = 0;
        for (const auto* view : shop.window.findChildren<QAbstractItemView*>()) {
            if (!view->model())
                continue;
            const auto all = view->model()->match(view->model()->index(0, 0), Qt::DisplayRole,
                                                  given, -1, Qt::MatchExactly | Qt::MatchRecursive);
            for (const QModelIndex& index : all) {
                const QString tip = index.data(Qt::ToolTipRole).toString();
                QVERIFY2(!tip.contains("%2") && !tip.contains("%3"), qPrintable(tip));
                tips += tip.contains(given.toHtmlEscaped());
            }
        }
        QVERIFY(tips >= 8); // a part, a material, a group, ...
    }

    // The step that undo would take back has the name in it, with an ampersand that is no key.
    void stepsOfTheHistoryHaveThem()
    {
        WindowShop shop;
        shop.document.replace(named());
        shop.document.push({Message("Remove %1", given.toStdString()), {RemoveItem{Id{15}}}});
        QCOMPARE(shop.window.actions()["undo"]->text().count("&"), 1 + 2 * int(given.count('&')));
    }
};

const RegisteredTest registered("test_names", runWithView<TestNames>);

} // namespace ripstop::test_names
#include "test_names.moc"
